"""The frames where two people may have changed over."""

from __future__ import annotations

import numpy as np

from app.core.tracks.edit_context import EditContext
from tracking.editing import SwapFrame, propose_swap_frames
from tracking.errors import EditError
from tracking.tracks import CORRECTED_COLUMNS, Columns, TrackTable

_MOST = 4
_LEAST_LIKELY = 0.01
_ABOUT_AS_LIKELY = 0.5
"""Of frames that are at least so likely, measured by the likeliest, the nearest comes first."""
_REACH_FRAMES = 1000
"""Looked at to either side of the user's frame first, so that hours cost no more than minutes."""


def find_swap_candidates(
    on: EditContext, track: int, other: int, near: int, flagged: tuple[int, int] | None = None
) -> tuple[SwapFrame, ...]:
    """The likeliest first, of those about as likely the nearest.

    flagged: half-open range of frames of a review item; the likeliest frame in it comes first.
    Nothing where the two cannot be compared: the plan says why.
    Both are compared within half a minute or so; only where they are not both there, anywhere.
    """
    window = max(0, near - _REACH_FRAMES), near + _REACH_FRAMES
    try:
        close = _two_of(on.table, (track, other), window)
        both_there = _stand_together(close, track, other)
        table = close if both_there else _two_of(on.table, (track, other), None)
        signals = _within(on.signals, window) if both_there else on.signals
        found = propose_swap_frames(table, track, other, near, signals, _MOST, flagged)
    except EditError:
        return ()
    low, high = flagged or (0, 0)
    if low <= found[0].frame < high:
        return (found[0], *_worth_telling(found[1:]))
    return nearest_of_likely(found, near)


def nearest_of_likely(found: tuple[SwapFrame, ...], near: int) -> tuple[SwapFrame, ...]:
    """The nearest of those about as likely as the likeliest, then the rest worth telling."""
    least = _ABOUT_AS_LIKELY * found[0].likelihood
    likely = [one for one in found if one.likelihood >= least]
    first = min(likely, key=lambda one: abs(one.frame - near))
    return (first, *_worth_telling(tuple(one for one in found if one is not first)))


def _worth_telling(found: tuple[SwapFrame, ...]) -> tuple[SwapFrame, ...]:
    """Those that are not all too unlikely."""
    return tuple(one for one in found if one.likelihood >= _LEAST_LIKELY)


def _stand_together(table: TrackTable, track: int, other: int) -> bool:
    """Whether both stand in some frame."""
    if track not in table or other not in table:
        return False
    frames = table.frames_of_track(track), table.frames_of_track(other)
    return len(np.intersect1d(*frames, assume_unique=True)) > 0


def _two_of(
    table: TrackTable, tracks: tuple[int, int], window: tuple[int, int] | None
) -> TrackTable:
    """The rows of two tracks, in some frames or all, as a table of their own."""
    start, end = window if window is not None else (0, None)
    parts = [table.of_track(track, start, end) for track in tracks]
    rows = {name: np.concatenate([part[name] for part in parts]) for name in CORRECTED_COLUMNS}
    order = np.lexsort((rows["track"], rows["frame"]))
    return TrackTable({name: column[order] for name, column in rows.items()})


def _within(signals: Columns | None, window: tuple[int, int]) -> Columns | None:
    """The signals of some frames; they stand by frame."""
    if signals is None:
        return None
    low, high = np.searchsorted(signals["frame"], window)
    return {name: column[low:high] for name, column in signals.items()}
