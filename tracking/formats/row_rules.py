"""What makes a row of tracks impossible, whatever format it comes from."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import LARGEST_NUMBER, Columns, Source
from tracking.translation import msg

MAX_FRAME = 10_000_000
"""More than four days at 25 frames a second; beyond it a number is a mistake, not a frame."""

MAX_PIXELS = 1e7
MAX_METRES = 1e6
MAX_SPEED_M_S = 1e4
MAX_SHARE = 1e6
"""Confidences of some tools are no shares of 1; beyond this they are none of anything."""

BOX = ("left", "top", "width", "height")
_SOURCES = (Source.TRACKER, Source.PERSON, Source.INTERPOLATED)

Mask = NDArray[np.bool_]


def broken_rules(rows: Columns, least_track: int = 1) -> Iterator[tuple[Mask, str]]:
    """Marks of the rows that break a rule, and the rule; each may rely on those before it.

    Args:
        rows: `frame` (from 0) and `track`, and any other columns; NaN where unknown.
        least_track: the least id: 1, or 0 where ids are only labels.
    """
    frame, track = (np.asarray(rows[name], np.float64) for name in ("frame", "track"))
    yield (
        ~(np.isfinite(frame) & np.isfinite(track)),
        msg("the frame or the id is not a finite number"),
    )
    yield (frame % 1 != 0) | (track % 1 != 0), msg("frame and id must be whole numbers")
    yield (
        (frame < 0) | (frame >= MAX_FRAME),
        msg("the frame number is not one of {max_frame} frames", max_frame=MAX_FRAME),
    )
    what = msg("a positive number") if least_track else msg("0 or a positive number")
    yield track < least_track, msg("the id is not {what}", what=what)
    yield (
        track > LARGEST_NUMBER,
        msg("the id is too large; the largest is {largest}", largest=LARGEST_NUMBER),
    )
    yield _any(np.isinf(column) for column in rows.values()), msg("a value is not a finite number")
    yield from _box_rules(rows)
    yield from _limit_rules(rows)
    if "x" in rows and "y" in rows:
        yield np.isnan(rows["x"]) != np.isnan(rows["y"]), msg("only one of x and y is given")
    if "source" in rows:
        source = np.asarray(rows["source"], np.float64)
        yield ~(np.isnan(source) | np.isin(source, _SOURCES)), msg("the source is not 0, 1 or 2")
    yield repeated(frame, track), msg("its id stands twice in this frame")


def repeated(frame: NDArray[np.float64], track: NDArray[np.float64]) -> Mask:
    """Rows whose frame and id stood together in an earlier row."""
    order = np.lexsort((track, frame))
    same = (np.diff(frame[order]) == 0) & (np.diff(track[order]) == 0)
    found = np.zeros(len(frame), bool)
    found[order[1:]] = same
    return found


def _box_rules(rows: Columns) -> Iterator[tuple[Mask, str]]:
    if not all(name in rows for name in BOX):
        return
    box = [np.asarray(rows[name], np.float64) for name in BOX]
    unknown = [np.isnan(side) for side in box]
    whole = np.logical_and.reduce(unknown)
    yield _any(unknown) & ~whole, msg("a part of the box is missing")
    yield _any(np.abs(side) > MAX_PIXELS for side in box), msg("the box lies outside any image")
    yield (box[2] < 0) | (box[3] < 0), msg("the box has a negative size")


def _limit_rules(rows: Columns) -> Iterator[tuple[Mask, str]]:
    """Numbers that are larger than any of their kind."""
    too_far = msg("the place is farther than {max_metres:g} m away", max_metres=MAX_METRES)
    too_fast = msg("the speed is beyond {max_speed_m_s:g} m/s", max_speed_m_s=MAX_SPEED_M_S)
    no_share = msg("the confidence or visibility is no such number")
    for names, most, reason in (
        (("x", "y", "z"), MAX_METRES, too_far),
        (("vx", "vy"), MAX_SPEED_M_S, too_fast),
        (("confidence", "visibility"), MAX_SHARE, no_share),
    ):
        held = [name for name in names if name in rows]
        if held:
            yield _any(np.abs(rows[name]) > most for name in held), reason


def _any(masks: Iterator[Mask] | list[Mask]) -> Mask:
    found: Mask = np.logical_or.reduce(list(masks))
    return found
