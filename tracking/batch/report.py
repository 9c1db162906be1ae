"""The page on a batch: every recording with what became of it, those to look at first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import timedelta
from pathlib import Path
from urllib.parse import quote

from tracking.atomic_output import replacing
from tracking.batch.ledger import Ledger, Row
from tracking.batch.outcome import Outcome, State
from tracking.batch.publication import REPORT, SCORE_PAGE
from tracking.errors import OutputError
from tracking.translation import Message, count_msg, msg

PAGE = "index.html"
KIND = "trackwright batch"
MOST_PICTURED = 400
"""So many images a page has; they are in it, and a browser has to hold them."""
_SHOWN = ("MOTA", "IDF1", "HOTA")


@dataclass(frozen=True, slots=True)
class Line:
    """A recording as the page shows it.

    Attributes:
        name: of it. state: see `State`. why: of what is not done. notes: what else to know.
        image: a JPEG image; None: none is shown. page: the address of its score; "": it has none.
        cells: what the columns hold.
    """

    name: str
    state: str
    why: Message
    notes: tuple[Message, ...]
    image: bytes | None
    page: str
    cells: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Reported:
    """What the page is on: the recordings in the order shown, and images by their names."""

    rows: tuple[Row, ...]
    images: Mapping[str, bytes]


def read_reported(ledger: Ledger) -> Reported:
    """What a ledger knows now. Raises OutputError."""
    rows = tuple(sorted(ledger.rows(), key=lambda row: _urgency(row.outcome)))
    return Reported(rows, ledger.thumbnails([row.name for row in rows[:MOST_PICTURED]]))


def write_batch_report(
    ledger: Ledger, out: Path, missing: Mapping[str, tuple[State, Message]] | None = None
) -> Path:
    """Write the page on all that the ledger knows; see `write_page`."""
    return write_page(read_reported(ledger), out, missing)


def write_page(
    reported: Reported, out: Path, missing: Mapping[str, tuple[State, Message]] | None = None
) -> Path:
    """Write the page on a batch; gives its path.

    Args:
        missing: words that meant no recording, and what became of them.

    Raises:
        OutputError: it cannot be written.
    """
    from tracking.pages import render  # brings NumPy, which resuming does without

    rows = reported.rows
    lines = [_line(row, reported.images.get(row.name)) for row in rows]
    lines = [*_missing_lines(missing or {}), *lines]
    page = report_path(out)
    folder = page.parent
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        raise OutputError(
            "cannot make folder {folder}: {reason}", folder=folder, reason=error.strerror
        ) from error
    text = render(
        "batch/report.html",
        title=msg("Batch in {folder}", folder=out.resolve().name),
        kind=KIND,
        groups=_groups(lines),
        cards=_cards(lines, rows),
        columns=_columns(),
        unpictured=_unpictured(len(rows) - MOST_PICTURED),
    )
    with replacing(page) as stream:
        stream.write(text)
    return page


def _unpictured(count: int) -> Message:
    """What is told where not all have an image."""
    if count <= 0:
        return Message()
    return count_msg(
        count, "{n} more recording has no image here.", "{n} more recordings have no image here."
    )


def report_path(out: Path) -> Path:
    """Where the page of an output folder stands."""
    return out / REPORT / PAGE


def suspicion(outcome: Outcome) -> float:
    """0 to 1, about which share of the rows is wrong: by the score, else as it is expected."""
    if not outcome.people:
        return 1.0
    score = outcome.score or {}
    known = score.get("IDF1")
    if isinstance(known, (int, float)):
        return 1.0 - float(known)
    return outcome.review_rows or 0.0


def _urgency(outcome: Outcome) -> tuple[int, float]:
    """Failed ones come first, then what was skipped, then by suspicion."""
    order = (State.FAILED, State.SKIPPED, State.DONE).index(outcome.state)
    return order, -suspicion(outcome) if outcome.is_done else 0.0


def _missing_lines(missing: Mapping[str, tuple[State, Message]]) -> list[Line]:
    return [Line(name, str(state), why, (), None, "", ()) for name, (state, why) in missing.items()]


def _line(row: Row, image: bytes | None) -> Line:
    outcome = row.outcome
    page = f"{quote(row.name)}/{SCORE_PAGE}" if outcome.is_done and outcome.page else ""
    notes = (*outcome.notes, *((msg("corrected since"),) if outcome.corrected else ()))
    return Line(
        row.name,
        str(outcome.state),
        outcome.why,
        notes if outcome.is_done else (),  # else they are of the time before
        image,
        page,
        _cells(outcome),
    )


def _columns() -> tuple[Message, ...]:
    scored = tuple(Message(name) for name in _SHOWN)
    return (
        *(msg("people"), msg("length"), msg("tracker"), *scored),
        *(msg("likely wrong"), msg("seconds of work")),
    )


def _cells(outcome: Outcome) -> tuple[str, ...]:
    if not outcome.is_done:
        return ()
    score = outcome.score or {}
    length = str(timedelta(seconds=round(outcome.frames / outcome.fps))) if outcome.fps else ""
    wrong = "" if outcome.review_rows is None else f"{outcome.review_rows:.0%}"
    return (
        *(str(outcome.people), length, outcome.tracker),
        *(_share(score.get(name)) for name in _SHOWN),
        *(wrong, f"{outcome.seconds:.1f}"),
    )


def _share(value: object) -> str:
    return f"{value:.3f}" if isinstance(value, (int, float)) else ""


def _groups(lines: Sequence[Line]) -> dict[str, list[Line]]:
    titles = {
        State.FAILED: msg("Failed"),
        State.SKIPPED: msg("Skipped"),
        State.DONE: msg("Done, suspicious ones first"),
    }
    found = {title: [one for one in lines if one.state == state] for state, title in titles.items()}
    return {title: members for title, members in found.items() if members}


def _cards(lines: Sequence[Line], rows: Sequence[Row]) -> list[tuple[Message, str]]:
    counts = {state: sum(one.state == state for one in lines) for state in State}
    done = [row.outcome for row in rows if row.outcome.is_done]
    known = [one.score.get("IDF1") for one in done if one.score]
    scores = [score for score in known if isinstance(score, (int, float))]
    cards = [
        (msg("recordings"), str(len(lines))),
        (msg("done"), str(counts[State.DONE])),
        (msg("failed"), str(counts[State.FAILED])),
        (msg("skipped"), str(counts[State.SKIPPED])),
        (msg("people"), str(sum(one.people for one in done))),
    ]
    if scores:
        cards.append((msg("mean IDF1"), f"{sum(scores) / len(scores):.3f}"))
    return cards
