"""Track extension, backwards and forwards, over detections without a track."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from tracking.geometry import View
from tracking.trackers.linking.gap_rows import expect_visibility
from tracking.trackers.linking.seen_rows import Flags, Floats, may_have_walked
from tracking.tracks.boxes import overlaps
from tracking.tracks.columns import (
    SIDES,
    TRACK_COLUMNS,
    Columns,
    boxes_of,
    merged_rows,
    places_of,
    typed,
)
from tracking.tracks.run import Run

Rows = NDArray[np.intp]

_GAP_S = 0.2
"""So long somebody may go undetected on the way in or out."""
_OVERLAP = 0.4
"""Boxes of one person, so short a time apart, have this share in common at least."""


@dataclass(frozen=True, slots=True)
class _Ends:
    """Where people begin, or end, while they reach farther: one row a person.

    Attributes:
        row: (k,) of the run's tracks. frame: (k,). place: (k, 2) m. box: (k, 4) px.
    """

    row: Rows
    frame: NDArray[np.int64]
    place: Floats
    box: Floats


def extend_ends(run: Run, free: Flags, view: View | None, fps: float) -> Run:
    """The run with its people from when they were first detected until they were last.

    A tracker waits until it is sure that somebody is there, and tells nothing before. Afterwards
    it is known: detections that nobody has, one frame after the other before a person's first row
    or behind the last one, are theirs where boxes and places go on.

    Args:
        free: (detections,) whom the tracker gave to nobody; what it gave to somebody and is in
            doubt stays nobody's.
        view: the camera the boxes were seen by; None: no floor is known, and boxes alone tell.
        fps: frames a second.
    """
    found = [_chain(run, free, fps, back, placed=view is not None) for back in (True, False)]
    row, detection = np.concatenate(found, axis=1)
    taken, first = np.unique(detection, return_index=True)
    return _add_rows(run, row[first], taken, view) if len(taken) else run


def extend_ends_in_pixels(run: Run, fps: float) -> Run:
    """`extend_ends` where no floor is known, over the detections that the tracker gave to nobody.

    Args:
        fps: frames a second.
    """
    return extend_ends(run, run.detections["track"] == 0, None, fps)


def _chain(run: Run, unnamed: Flags, fps: float, back: bool, *, placed: bool) -> Rows:
    """(2, k) a row at that end of a person's track, and a detection that is this person's too."""
    seen, way = run.detections, -1 if back else 1
    needed = ("x", "y", *SIDES) if placed else SIDES
    free = np.isfinite(np.stack([seen[name] for name in needed])).all(axis=0)
    free = np.flatnonzero(free & unnamed)
    ends, gap, found = _ends(run.tracks, back), round(_GAP_S * fps) + 1, []
    for rows in _frames(seen["frame"][free], back):
        elapsed = way * (int(seen["frame"][free[rows[0]]]) - ends.frame)
        near = np.flatnonzero((elapsed > 0) & (elapsed <= gap))
        if len(near) == 0:
            continue
        one, other = _match(ends, near, seen, free[rows], elapsed[near] / fps)
        found += list(zip(ends.row[one].tolist(), other.tolist(), strict=True))
        ends.frame[one] = seen["frame"][other]
        ends.place[one], ends.box[one] = places_of(seen, other), boxes_of(seen, other)
    return np.array(found, np.intp).reshape(-1, 2).T


def _frames(frame: NDArray[np.integer], back: bool) -> Iterator[Rows]:
    """The rows of each frame, frames (n,) being sorted; from the last one on if `back`."""
    starts = np.flatnonzero(np.diff(frame, prepend=-1))
    parts = np.split(np.arange(len(frame)), starts[1:]) if len(starts) else []
    yield from reversed(parts) if back else parts


def _ends(tracks: Columns, back: bool) -> _Ends:
    """Everybody's first row, or last one, if it was measured."""
    order = np.lexsort((tracks["frame"], tracks["track"]))
    border = np.diff(tracks["track"][order]) != 0
    outer = np.append(True, border) if back else np.append(border, True)
    row = order[outer[: len(order)]]
    row = row[~tracks["predicted"][row] & (tracks["track"][row] > 0)]
    frame = tracks["frame"][row].astype(np.int64)
    return _Ends(row, frame, places_of(tracks, row), boxes_of(tracks, row))


def _match(
    ends: _Ends, near: Rows, seen: Columns, detection: Rows, elapsed_s: Floats
) -> tuple[Rows, Rows]:
    """Who goes on as which detection of a frame, by how much boxes have in common.

    Places that are known must be within a walk of each other.
    """
    place, box = places_of(seen, detection), boxes_of(seen, detection)
    common = overlaps(ends.box[near, None], box[None])
    for k, (end, time_s) in enumerate(zip(near.tolist(), elapsed_s.tolist(), strict=True)):
        step = place - ends.place[end]
        too_far = np.isfinite(step).all(axis=1) & ~may_have_walked(step, place, time_s)
        common[k, too_far] = 0.0
    one, other = linear_sum_assignment(common, maximize=True)
    good = common[one, other] >= _OVERLAP
    return near[one[good]], detection[other[good]]


def _add_rows(run: Run, row: Rows, detection: Rows, view: View | None) -> Run:
    """The run with a row more for each of these detections, like the person's own rows (k,)."""
    seen, tracks = run.detections, run.tracks
    added = {name: tracks[name][row] for name in TRACK_COLUMNS}
    for name in ("frame", "x", "y", *SIDES):
        added[name] = seen[name][detection]
    added = dict(typed(added, TRACK_COLUMNS))
    whole, order = merged_rows(tracks, added)
    if view is not None:
        expect_visibility(whole, order >= len(tracks["frame"]), view)
    track = seen["track"].copy()
    track[detection] = added["track"]
    return replace(
        run,
        tracks=whole,
        detections={**seen, "track": track},
        associations=_add_unknown(run.associations, added),
        signals=_add_unknown(run.signals, added) if _has_all(run.signals, tracks) else run.signals,
    )


def _has_all(signals: Columns, tracks: Columns) -> bool:
    """Whether something was noticed of every row."""
    return len(signals["frame"]) == len(tracks["frame"])


def _add_unknown(columns: Columns, added: Columns) -> Columns:
    """The columns with rows of people who were added, of whom nothing else is known."""
    unknown = np.full(len(added["frame"]), np.nan)
    more = {
        name: (added[name] if name in ("frame", "track") else unknown).astype(column.dtype)
        for name, column in columns.items()
    }
    return merged_rows(columns, more)[0]
