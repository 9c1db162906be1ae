"""A project's list in words."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from datetime import timedelta
from pathlib import Path

from app.core.i18n import N_, count_text, joined_text, sentence, strip_full_stop, tr
from app.core.scenes.review_words import COUNTED, decided_text, risk_figures, risk_text
from app.features.project.scene import Mood, ProjectScene, RecordingRow, Sortable
from tracking.batch.watch import WorkedOn
from tracking.project import ProjectList, ProjectRow, SessionFacts, next_to_review, worth_of

COLUMNS = (
    N_("Recording"),
    N_("Length"),
    N_("Frames"),
    N_("People"),
    N_("Decided"),
    N_("Reviewed"),
    N_("Errors left"),
    N_("IDF1"),
    N_("State"),
    N_("Worked on by"),
)
HINTS = (
    "",
    N_("Length of the footage, h:min:s"),
    N_("Frames that are tracked or labelled, of all"),
    N_("Tracks in the session"),
    N_("Share of the review items that are decided or in reviewed ranges"),
    N_("Share of the boxes in reviewed ranges or where decided review items are shown"),
    COUNTED,
    N_("IDF1 against the ground truth beside the recording"),
    "",
    N_("Who edited the session last; who has it open now"),
)
NUMBERS = frozenset({1, 2, 3, 4, 5, 6, 7})
"""Columns that hold numbers."""
NEXT_RULE = N_(
    "Opens the recording where a review is expected to find most identity errors for each minute: "
    "the errors expected at its review items, divided by the minutes that these show and half a "
    "minute for opening it. Recordings that somebody has open are left out."
)
_NOTHING = -1.0


def scene_of(
    found: ProjectList | None,
    folder: Path,
    reading: float | None,
    works: Mapping[Path, WorkedOn] | None = None,
    left: Collection[Path] = (),
) -> ProjectScene:
    """The page of a project.

    Args:
        found: None while the folder is looked through for the first time.
        reading: see `ProjectScene`. works: what workers of a batch do now, by the recording.
        left: recordings that this batch has still to do; what an earlier one said of them is past.
    """
    title, place = folder.name or str(folder), str(folder)
    if found is None:
        return ProjectScene(title, place, empty=tr("Looking through the folder..."))
    found = replace(found, rows=tuple(_without_past(row, left) for row in found.rows))
    seeking = any(not one.reading.of_session for one in found.wanted)
    rows = tuple(
        _row(row, _now(row, works or {}, left), _detail(row, folder, seeking=seeking))
        for row in found.rows
    )
    best = next_to_review(found.rows)
    return ProjectScene(
        title,
        place,
        rows,
        _summary(found.rows),
        _next_text(best) if best is not None else _nothing_next(found.rows),
        best.name if best is not None else "",
        reading,
        tuple(sentence(note) for note in found.notes),
        "" if rows else _empty(),
    )


def _empty() -> str:
    return tr(
        "No recordings or sessions are in this folder. Recordings are videos, folders with a "
        "recording.toml, and folders of images; put some here, or open another folder."
    )


def _without_past(row: ProjectRow, left: Collection[Path]) -> ProjectRow:
    """A row without what a batch said of it before one that has it still to do."""
    waits = row.recording is not None and row.recording.path in left
    return replace(row, batch=None) if waits and row.batch is not None else row


def _now(
    row: ProjectRow, works: Mapping[Path, WorkedOn], left: Collection[Path]
) -> tuple[str, Mood]:
    """The state of a row; what a batch at work does with it goes before all else."""
    if row.recording is not None:
        work = works.get(row.recording.path)
        if work is not None:
            return _working(work), Mood.GOOD
        if row.recording.path in left:
            return tr("Waiting"), Mood.QUIET
    return _state(row)


def _row(row: ProjectRow, now: tuple[str, Mood], detail: str) -> RecordingRow:
    state, mood = now
    facts = _facts(row)
    cells: tuple[tuple[str, Sortable], ...] = (
        _length(row),
        _frames(facts),
        _count(facts.people if facts is not None else None),
        _share(facts.decided_share if facts is not None else None),
        _share(facts.reviewed_rows if facts is not None and facts.rows else None),
        _errors(facts),
        _score(facts),
        (state, state.casefold()),
        _who(row),
    )
    return RecordingRow(
        row.name,
        detail,
        mood,
        tuple(text for text, _ in cells),
        (row.name.casefold(), *(order for _, order in cells)),
        "\n".join(_tip(row)),
        row.path,
        row.recording.path if row.recording is not None else None,
        _image_key(row),
    )


def _image_key(row: ProjectRow) -> tuple[str, ...]:
    files = [one.file for one in row.sessions if one.facts is not None]
    stamps = [file.stamp for file in files[:1]]
    if row.recording is not None and row.facts is not None:
        stamps.append(row.recording.stamp)
    return (row.name, *stamps)


def _facts(row: ProjectRow) -> SessionFacts | None:
    """What is known of the session that is shown; None: nothing."""
    session = row.session
    return session.facts if session is not None and session.is_readable else None


def _state(row: ProjectRow) -> tuple[str, Mood]:
    if row.problem:
        failed = row.batch is not None and not row.batch.is_done and row.problem == row.batch.why
        if not failed:
            return tr("Cannot be read"), Mood.BAD
        return (tr("Failed"), Mood.BAD) if row.batch is None else _batch_state(row)
    if not row.is_read:
        return tr("Being read"), Mood.QUIET
    facts = _facts(row)
    if facts is None:
        return tr("Not tracked"), Mood.QUIET
    if facts.hand_made:
        return (tr("Labelled by hand") if facts.rows else tr("Empty session")), Mood.PLAIN
    if not facts.items_left:
        return tr("All decided"), Mood.GOOD
    if facts.decided or facts.edits:
        return tr("In review"), Mood.PLAIN
    return tr("Tracked"), Mood.PLAIN


def _working(work: WorkedOn) -> str:
    stage = strip_full_stop(sentence(tr(work.stage)))
    return stage if work.share is None else tr("{stage} {share:.0%}", stage=stage, share=work.share)


def _batch_state(row: ProjectRow) -> tuple[str, Mood]:
    state = str(row.batch.state) if row.batch is not None else ""
    return (tr("Skipped"), Mood.QUIET) if state == "skipped" else (tr("Failed"), Mood.BAD)


def _detail(row: ProjectRow, folder: Path, *, seeking: bool) -> str:
    """The line below the name: a reason first, else which session is shown.

    seeking: recordings are still being read, and the images of one may be those of a session.
    """
    if row.problem:
        places = [folder if row.recording is None else row.recording.path, folder]
        text = sentence(row.problem)
        for place in places:  # the row says where it is
            text = text.replace(f"{place}{os.sep}", "")
        return text
    session = row.session
    if session is None:
        return tr("no session")
    if session.note:
        return sentence(session.note)
    if row.recording is None:
        if seeking or session.facts is None:
            return tr("looking for its recording")
        return tr("its recording is not in this folder")
    more = len(row.sessions) - 1
    if not more:
        return session.path.name
    others = count_text(more, "and {n} more session", "and {n} more sessions")
    return f"{session.path.name} {others}"


def _length(row: ProjectRow) -> tuple[str, Sortable]:
    facts = row.facts if row.facts is not None and not row.facts.problem else _facts(row)
    seconds = facts.length_s if facts is not None else None
    if seconds is None:
        return "", _NOTHING
    return str(timedelta(seconds=round(seconds))), seconds


def _count(count: int | None) -> tuple[str, Sortable]:
    return ("", _NOTHING) if count is None else (str(count), float(count))


def _share(share: float | None) -> tuple[str, Sortable]:
    return ("", _NOTHING) if share is None else (f"{share:.0%}", share)


def _frames(facts: SessionFacts | None) -> tuple[str, Sortable]:
    if facts is None:
        return "", _NOTHING
    done, frames = facts.frames_done, max(facts.frames, facts.frames_done)
    text = str(done) if done == frames else tr("{n} of {all}", n=done, all=frames)
    return text, done / max(frames, 1)


def _errors(facts: SessionFacts | None) -> tuple[str, Sortable]:
    left = facts.errors if facts is not None else None
    return ("", _NOTHING) if left is None else (risk_figures(left), left.mean)


def _score(facts: SessionFacts | None) -> tuple[str, Sortable]:
    if facts is None or facts.idf1 is None:
        return "", _NOTHING
    return f"{facts.idf1:.3f}", facts.idf1


def _who(row: ProjectRow) -> tuple[str, Sortable]:
    """Who has a session of it open; else who edited the one that is shown last."""
    holders = [tr(one.holder) for one in row.sessions if one.holder]
    facts = _facts(row)
    last = facts.authors[-1] if facts is not None and facts.authors else ""
    if not holders:
        return last, last.casefold() or "\uffff"
    text = tr("open: {who}", who=holders[0])
    if last:
        text = tr("{name}, {opened}", name=last, opened=text)
    return text, text.casefold()


def _tip(row: ProjectRow) -> Iterator[str]:
    yield row.name
    if row.problem:
        yield sentence(row.problem)
    for one in row.sessions:
        facts = one.facts
        if facts is None or facts.problem:
            continue
        words = [one.path.name, facts.tracker]
        words.append(count_text(facts.edits, "{n} edit", "{n} edits"))
        if facts.authors:
            words.append(joined_text(", ", facts.authors))
        yield "  \u00b7  ".join(filter(None, words))
        if facts.errors is not None:
            if items := facts.decided + facts.items_left:
                yield decided_text(facts.decided, items, facts.reviewed_rows)
            yield risk_text(facts.errors)
        if facts.mota is not None:
            yield tr("MOTA {mota:.3f}", mota=facts.mota)
        if facts.not_scored:
            yield tr("Not scored: {why}", why=facts.not_scored)
        if one.note:
            yield sentence(one.note)


def _summary(rows: tuple[ProjectRow, ...]) -> str:
    states = Counter(mood for _, mood in map(_state, rows))
    tracked = sum(_facts(row) is not None for row in rows)
    words = [
        count_text(len(rows), "{n} recording", "{n} recordings"),
        count_text(tracked, "{n} tracked or labelled", "{n} tracked or labelled"),
        count_text(states[Mood.GOOD], "{n} reviewed", "{n} reviewed"),
    ]
    if states[Mood.BAD]:
        words.append(count_text(states[Mood.BAD], "{n} with a problem", "{n} with a problem"))
    return "  \u00b7  ".join(words)


def _next_text(row: ProjectRow) -> str:
    """Which is next, what a review of it takes, and what is left in it."""
    facts = _facts(row)
    assert facts is not None
    assert facts.errors is not None
    left = count_text(
        facts.items_left,
        "{name}: {n} review item left, {time} min to watch.",
        "{name}: {n} review items left, {time} min to watch.",
        name=row.name,
        time=_minutes(facts.minutes_left),
    )
    return f"{left} {risk_text(facts.errors)}"


def _minutes(minutes: float) -> str:
    """Minutes and seconds, at least one: "0:12"."""
    whole, seconds = divmod(max(1, round(60.0 * minutes)), 60)
    return f"{whole}:{seconds:02d}"


def _nothing_next(rows: tuple[ProjectRow, ...]) -> str:
    if not rows:
        return ""
    if not all(row.is_read for row in rows):
        return tr("Recordings are still being read")
    if all(_facts(row) is None for row in rows):
        return tr("No recording is tracked yet: open one and track it, or run a batch")
    if any(worth_of(row) for row in rows):
        return tr("Others have all recordings open that are left to review")
    return tr("Nothing is left to review")
