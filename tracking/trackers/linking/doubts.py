"""Track splitting: a track is cut where an identity switch is likely, to be linked anew."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.linking.encounters import NEAR_M, Encounters
from tracking.trackers.linking.seen_rows import Flags, SeenRows, is_after_gap, is_track_start

_GAP_S = 0.25
"""Somebody unseen for so long may be somebody else when seen again."""
_APART_S = 0.5
"""Two meetings of the same two people less than this apart are one."""
_LEAST_PIECE_S = 0.25
"""Doubts closer together are one."""


class Doubt:
    """Why another person may begin at a row."""

    NONE = 0
    TRACK = 1  # the tracker's track begins
    LOST = 2  # nothing was seen for a while, or far away
    MET = 3  # close to somebody else, or who was is lost or found


def find_doubts(seen: SeenRows, meetings: Encounters, fps: float) -> NDArray[np.uint8]:
    """(n,) whether another person may begin at a row that was seen, and why: see `Doubt`."""
    first = is_track_start(seen)
    found = is_after_gap(seen, _GAP_S, fps) & ~first
    doubt = np.where(first, Doubt.TRACK, np.where(found, Doubt.LOST, Doubt.NONE)).astype(np.uint8)
    least = round(_LEAST_PIECE_S * fps)
    for row in _encounter_rows(seen, meetings, first | found, fps):
        if not doubt[max(row - least, 0) : row + least].any():
            doubt[row] = Doubt.MET
    return doubt


def _encounter_rows(seen: SeenRows, meetings: Encounters, ends: Flags, fps: float) -> list[int]:
    """Rows of both people of each meeting: where they were closest, and where one was found."""
    rows = []
    start = {int(t): i for i, t in reversed(list(enumerate(seen.track.tolist())))}
    stop = {int(t): i + 1 for i, t in enumerate(seen.track.tolist())}
    for stretch in meetings.stretches(round(_APART_S * fps)):
        frames, distance_m = meetings.frame[stretch], meetings.distance_m[stretch]
        closest = int(frames[distance_m.argmin()])
        spans = [
            slice(start[t], stop[t]) for t in meetings.pair[stretch.start].tolist() if t in start
        ]
        around = int(frames[0]), int(frames[-1]) + 1
        times = {closest} if distance_m.min() < NEAR_M else set()
        for span in spans:
            inside = slice(*(span.start + np.searchsorted(seen.frame[span], around)))
            found = np.flatnonzero(ends[inside]) + inside.start
            times |= set(seen.frame[found].tolist())
            times |= {int(seen.frame[i - 1]) + 1 for i in found.tolist() if i > span.start}
        for span in spans:
            at = span.start + np.searchsorted(seen.frame[span], sorted(times))
            rows += [int(i) for i in at if span.start < i < span.stop]
    return rows
