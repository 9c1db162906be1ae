"""The ids that imported tracks get where they cannot keep, or shall not keep, the file's."""

from __future__ import annotations

import numpy as np

from tracking.errors import FormatError
from tracking.formats.row_rules import BOX
from tracking.tracks import LARGEST_NUMBER, Columns, TrackTable

_PLACE = ("x", "y")
_MOST_COMPARED = 1000
"""Rows of a track; one that is the same is enough, so these tell whether two tracks are one."""


def new_ids(rows: Columns, known: TrackTable | None) -> dict[int, int]:
    """Ids above those that are known, by the file's. Raises FormatError where too few are left."""
    highest = 0 if known is None else known.highest_track
    old = np.unique(rows["track"]).tolist()
    if highest + len(old) > LARGEST_NUMBER:
        raise FormatError(
            "there are no {count} ids left for new tracks; keep the file's ids", count=len(old)
        )
    return {track: highest + 1 + at for at, track in enumerate(old)}


def id_of_zero(rows: Columns, of_zero: int, known: TrackTable) -> int:
    """The id of a file's track 0 in a session that has tracks.

    It is the track that the file's track 0 became when it was imported before, told by a row that
    is the same; else an id that no track ever had, so that nobody else's track is replaced.

    Args:
        rows: of the file. of_zero: the id its track 0 has in them, above all others.

    Raises:
        FormatError: no id is left.
    """
    earlier = _same_track(rows, of_zero, known)
    new = max(of_zero, known.highest_track + 1) if earlier is None else earlier
    if new > LARGEST_NUMBER:
        raise FormatError("no id is left for track 0 of the file; number it anew")
    return new


def _same_track(rows: Columns, of_zero: int, known: TrackTable) -> int | None:
    """A track of the session, and none of the file's, that has a row of the file's track 0."""
    others = np.unique(rows["track"][rows["track"] != of_zero])
    own = np.flatnonzero(rows["track"] == of_zero)[:_MOST_COMPARED]
    for row in own.tolist():
        there = known.of_frame(int(rows["frame"][row]))
        names = BOX if np.isfinite(rows["left"][row]) else _PLACE
        same = np.logical_and.reduce([there[name] == rows[name][row] for name in names])
        found = np.setdiff1d(there["track"][same], others)
        if len(found):
            return int(found[0])
    return None
