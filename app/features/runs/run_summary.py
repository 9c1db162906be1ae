"""What a tracker did that has come to its end, in words: how many tracks, other ids, where kept."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from app.core.i18n import count_text, joined_text, sentence, tr
from app.core.keymap import in_brackets, key_or_title
from tracking.session import Session
from tracking.tracks import Columns, Run, row_keys
from tracking.translation import Message, msg


@dataclass(frozen=True, slots=True)
class RunSummary:
    """A run beside what was seen of it while the tracker was at work.

    Finishing looks over the recording as a whole: ids may be others afterwards.

    Attributes:
        tracker: by name. frames: half-open range that was tracked; asked: that was to be.
        tracks: ids there are now. seen: ids there were on the way; changed: of these, how many
            are others now, or gone, wherever their person was seen.
        why: the tracker could not go on; "": it came to its end, or was stopped.
        nobody: why there may be no track; None: there are some, or nobody knows.
    """

    tracker: str
    frames: tuple[int, int]
    asked: tuple[int, int]
    tracks: int
    seen: int
    changed: int
    why: str = ""
    nobody: Message | None = None

    @classmethod
    def of(
        cls, run: Run, on_the_way: Sequence[Columns], asked: tuple[int, int], why: str = ""
    ) -> RunSummary:
        """Compare a run with the rows a tracker gave on the way, in pieces (`TRACK_COLUMNS`)."""
        now = row_keys(run.tracks["frame"], run.tracks["track"])
        ids: set[int] = set()
        changed: set[int] = set()
        for rows in on_the_way:
            track = rows["track"]
            lost = ~np.isin(row_keys(rows["frame"], track), now) & ~rows["predicted"].astype(bool)
            ids |= set(np.unique(track).tolist())
            changed |= set(np.unique(track[lost]).tolist())
        tracks = len(np.unique(run.tracks["track"]))
        return cls(run.tracker, run.frames, asked, tracks, len(ids), len(changed), why)

    @property
    def early(self) -> Message:
        """That the tracker could not go on, and why."""
        count, whole = (stop - start for start, stop in (self.frames, self.asked))
        return msg(
            "{tracker} ended after {n} of {all} frames: {why}.",
            tracker=self.tracker,
            n=count,
            all=whole,
            why=self.why,
        )

    @property
    def _frames_text(self) -> str:
        if self.why:
            return tr(self.early)
        count, whole = (stop - start for start, stop in (self.frames, self.asked))
        if self.frames != self.asked:
            return tr(
                "Stopped early: tracked {n} of {all} frames with {tracker}.",
                n=count,
                all=whole,
                tracker=self.tracker,
            )
        return count_text(
            count,
            "Tracked {n} frame with {tracker}.",
            "Tracked {n} frames with {tracker}.",
            tracker=self.tracker,
        )

    @property
    def _found_text(self) -> str:
        if self.nobody is not None and not self.tracks:
            return sentence(self.nobody)
        return count_text(self.tracks, "Found {n} track.", "Found {n} tracks.")

    @property
    def _ids_text(self) -> str:
        return count_text(
            self.changed,
            "Ids were then corrected over the whole recording: {n} of the {seen} ids you saw "
            "while it was tracked has changed or is gone.",
            "Ids were then corrected over the whole recording: {n} of the {seen} ids you saw "
            "while it was tracked have changed or are gone.",
            seen=self.seen,
        )

    def words(self, kept: str) -> str:
        """All of it in one paragraph; `kept`: where the run is."""
        ids = [self._ids_text] if self.changed else []
        return joined_text(" ", (self._frames_text, self._found_text, *ids, kept))


def meanwhile(session: Session) -> str:
    """What can be done while a further run is made, and what becomes of the corrected tracks."""
    said = tr(
        "Another run is being tracked. Move the playhead or play to see and correct your own "
        "tracks meanwhile; Follow shows the new run again."
    )
    return joined_text(" ", (said, describe_coming_run(session)))


def describe_coming_run(session: Session) -> str:
    """What becomes of the corrected tracks when a run ends; "" where no run made them."""
    before = session.adopted_run
    if len(session.history):
        return tr("The corrected tracks stay as they are; the new result is kept beside them.")
    if before is None:
        return ""
    return tr(
        "No track has been edited: at its end the new run takes the place of the corrected tracks "
        "of run {before}, which stay under Runs{key}; unless you look at your own tracks then, or "
        "it has fewer frames.",
        before=before,
        key=in_brackets("tracks.runs"),
    )


def list_tracking_notes(session: Session) -> list[str]:
    """What was told when the tracks that are corrected were made, a line each."""
    run = session.corrected_run
    notes = run.notes if run is not None else ()
    return [tr("During tracking: {note}", note=note) for note in notes]


def describe_first_run() -> str:
    """Where the first run of a recording is kept."""
    return tr(
        "The result is on disk and ready to be corrected. Save{key} gives it a file of your own.",
        key=in_brackets("file.save"),
    )


def describe_added_first_run(number: int) -> str:
    """Where the first run of a session is kept that was begun without one."""
    return tr(
        "Kept as run {n}; you now correct its tracks. The next Save{key} writes it to "
        "the session's file.",
        n=number,
        key=in_brackets("file.save"),
    )


def describe_replacement(number: int, before: int) -> str:
    """Where a run is kept whose tracks took the place of others that nobody had corrected."""
    return tr(
        "Kept as run {n}; you now correct its tracks. Those of run {before} stay under Runs{key}.",
        n=number,
        before=before,
        key=in_brackets("tracks.runs"),
    )


def describe_further_run(number: int) -> str:
    """Where a run is kept that did not replace the corrected tracks."""
    return tr(
        "Kept as run {n}, and the corrected tracks stay as they are. Compare it or "
        "take from it under Runs{key}.",
        n=number,
        key=in_brackets("tracks.runs"),
    )


def describe_compared_run(number: int) -> str:
    """Where a run is kept that was made to put corrected tracks right."""
    return tr(
        "Kept as run {n}; nothing has changed yet. Tick the differences to take: they are one "
        "edit, which {undo} undoes.",
        undo=key_or_title("edit.undo"),
        n=number,
    )
