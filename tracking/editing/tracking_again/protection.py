"""What a person touched or marked as reviewed, and what no tracker may therefore overwrite."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags
from tracking.editing.core.change import Stretches, no_rows, no_stretches
from tracking.editing.core.selection import stack_rows
from tracking.editing.log.history import Entry, History
from tracking.editing.log.traces import NO_TRACE, Placed, Trace
from tracking.editing.tracking_again.coverage import Coverage
from tracking.tracks import LARGEST_NUMBER, Columns, Labels, Source, TrackTable, row_keys

Integers = NDArray[np.integer]

MARGIN_S = 0.5
"""What is protected on either side of the cut of an edit "from here on"."""
_MARGIN_FRAMES = 10
"""The same where nobody knows how long a frame is."""
_ALL = 0


@dataclass(frozen=True, slots=True, eq=False)
class Protection:
    """Where the corrected table stays as it is, whatever a tracker says.

    Attributes:
        stretches: (k, 3) int64 track (0: all), start, end of half-open ranges of frames, sorted,
            those of one track apart from each other. The track keeps its rows there, and where it
            has none, it gets none.
        deleted: `CORRECTED_COLUMNS` of rows that people deleted, sorted by frame: nobody new
            begins where one of them stood.
    """

    stretches: Stretches = field(default_factory=no_stretches)
    deleted: Columns = field(default_factory=no_rows)

    def covers(self, track: Integers, frame: Integers) -> Flags:
        """(n,) whether each track is protected in each frame."""
        return self._inside(track, frame) | self._inside(np.zeros_like(track), frame)

    def of_track(self, track: int) -> NDArray[np.int64]:
        """(k, 2) start and end of what is protected of a track, the stretches of all included."""
        own = self.stretches[np.isin(self.stretches[:, 0], (track, _ALL))].copy()
        own[:, 0] = track
        return join_stretches(own)[:, 1:]

    def _inside(self, track: Integers, frame: Integers) -> Flags:
        begins = row_keys(self.stretches[:, 0], self.stretches[:, 1])
        place = np.searchsorted(begins, row_keys(track, frame), side="right") - 1
        if not len(begins):
            return np.zeros(len(frame), bool)
        found = self.stretches[place]
        return np.asarray((place >= 0) & (found[:, 0] == track) & (frame < found[:, 2]))


def find_protected(
    table: TrackTable, labels: Labels, history: History, *, fps: float | None = None
) -> Protection:
    """What tracking again never overwrites.

    The rule, in the words of who corrects:
        - what I drew, moved or had interpolated stays (rows of source person and interpolated);
        - what I marked as reviewed stays, of one track or of all;
        - where I drew parts of a body, that body stays;
        - a range or a frame that I edited stays, as that edit left it: swapped, given to another
          track, marked as occluded; two tracks that I merged stay one where the second one was;
        - what I deleted stays away: the track gets no rows there, none after it either where it
          ended there, and nobody new begins where the deleted rows stood;
        - a swap or a split "from here on" stays about its cut, half a second on either side. What
          comes later is what tracking again is asked for; so it is not protected;
        - what was taken from a run is a tracker's word, not mine. Mark it as reviewed to keep it.
    Names and labels are never touched at all. Where an edit later handed rows to another track,
    their protection went with them. Edits that were undone protect nothing.

    Args:
        fps: frames a second; without it the margin is ten frames.
    """
    margin = _MARGIN_FRAMES if fps is None else max(1, round(MARGIN_S * fps))
    edited, deleted = _edited(history, margin)
    absent = _absent(stack_rows(deleted), table)
    said = (_reviewed(labels), _parts_drawn(labels))
    parts = (edited, _emptied(absent, table), _drawn(table), *said)
    return Protection(join_stretches(np.concatenate(parts)), absent)


def edits_in_force(history: History) -> Iterator[Entry]:
    """The edits of people that count, oldest first: none taken back, nor what took it back."""
    return (entry for entry in history.in_force if entry.kind != "take")


def join_stretches(stretches: Stretches) -> Stretches:
    """(k, 3) sorted, with stretches of one track that overlap or touch made one."""
    if not len(stretches):
        return no_stretches()
    ordered = stretches[np.lexsort((stretches[:, 1], stretches[:, 0]))]
    # Ends that only grow, track by track: a later track's numbers are all above an earlier one's.
    _, number = np.unique(ordered[:, 0], return_inverse=True)
    base = number.astype(np.int64) << 32
    reach = np.maximum.accumulate(base + ordered[:, 2])
    first = np.append(True, base[1:] + ordered[1:, 1] > reach[:-1])
    start = np.flatnonzero(first)
    last = np.append(start[1:], len(ordered)) - 1
    return np.column_stack((ordered[start, :2], reach[last] - base[last]))


def stretches_of(track: Integers, frame: Integers) -> Stretches:
    """(k, 3) the consecutive frames of each track as stretches."""
    one = np.column_stack((track, frame, frame.astype(np.int64) + 1)).astype(np.int64)
    return join_stretches(one)


def _edited(history: History, margin: int) -> tuple[Stretches, list[Columns]]:
    """The stretches that edits protect, and the rows they deleted."""
    covered, deleted = Coverage(), []
    for entry in edits_in_force(history):
        trace = history.trace(entry.id)
        if trace is NO_TRACE:
            continue
        covered.hand(trace.handed)
        for track in trace.cut:
            covered.add(track, max(entry.frame - margin, 0), entry.frame + margin)
        for part in trace.placed if trace.cut else _put_down(trace):
            covered.add(*part)
        if len(trace.gone["frame"]):
            deleted.append(trace.gone)
    return covered.stretches, deleted


def _put_down(trace: Trace) -> Iterator[Placed]:
    """All stretches an edit handed to tracks, or put down in them."""
    for _, track, start, end in trace.handed:
        yield track, start, end
    yield from trace.placed


def _absent(deleted: Columns, table: TrackTable) -> Columns:
    """The deleted rows whose places in the table are still empty."""
    back = np.zeros(len(deleted["frame"]), bool)
    for track in np.unique(deleted["track"]).tolist():
        mine = deleted["track"] == track
        back[mine] = np.isin(deleted["frame"][mine], table.frames_of_track(track))
    return {name: column[~back] for name, column in deleted.items()}


def _emptied(absent: Columns, table: TrackTable) -> Stretches:
    """Where deletions keep tracks away: without end where nothing stands after them."""
    stretches = stretches_of(absent["track"], absent["frame"])
    ends = np.array([table.frame_range(track)[1] for track in stretches[:, 0].tolist()], np.int64)
    final = stretches[:, 1] >= ends if len(ends) else np.zeros(0, bool)
    stretches[final, 2] = LARGEST_NUMBER
    return stretches


def _drawn(table: TrackTable) -> Stretches:
    """Where people drew, moved or interpolated rows."""
    mine = table.by_track(("source",))["source"] != Source.TRACKER
    if not mine.any():
        return no_stretches()
    rows = table.by_track(("track", "frame"))
    return stretches_of(rows["track"][mine], rows["frame"][mine])


def _reviewed(labels: Labels) -> Stretches:
    ranges = [(seen.track, seen.start, seen.end) for seen in labels.reviewed]
    return np.array(ranges, np.int64).reshape(-1, 3)


def _parts_drawn(labels: Labels) -> Stretches:
    drawn = [
        (frame, track)
        for (frame, track, _), part in labels.parts.items()
        if part.source == "person"
    ]
    frame, track = np.array(drawn, np.int64).reshape(-1, 2).T
    return stretches_of(track, frame)
