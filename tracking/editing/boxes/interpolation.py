"""Rows between two others: along straight lines in the picture, or walking over the floor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.editing.boxes.floor_boxes import (
    SIDES,
    body_heights,
    body_positions,
    boxes_of,
    fits,
    move_bodies,
    places_of,
)
from tracking.editing.core.selection import Rows, select_rows
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import Columns, Source

How = Literal["linear", "floor"]
Numbers = NDArray[np.intp]

_SAME_PX = 1e-6


@dataclass(frozen=True, slots=True)
class Way:
    """How rows between two others come about.

    Attributes:
        how: "linear": boxes and places on straight lines. "floor": at constant velocity over the
            floor, boxes from there as the camera sees them. None: as a stretch was before; a new
            one over the floor where the view and both places are known, else linear.
        view: the left camera over its floor; None: unknown.
        fps: frames a second, for velocities; None: unknown, they are NaN.

    Raises:
        EditError: "floor" without a view, or another word.
    """

    how: How | None = None
    view: View | None = None
    fps: float | None = None

    def __post_init__(self) -> None:
        if self.how not in (None, "linear", "floor"):
            raise EditError(
                "interpolation {how!r} is none; choose 'linear' or 'floor'", how=self.how
            )
        if self.how == "floor" and self.view is None:
            raise EditError(
                "interpolation along the floor needs a calibrated recording with its floor; "
                "interpolate linearly instead"
            )


def interpolate(
    ends: Columns, at: Numbers, frames: NDArray[np.int32], way: Way, straight: NDArray[np.bool_]
) -> Rows:
    """The rows of the given frames, each between two rows that stand fast.

    Args:
        ends: rows of one track, by frame.
        at: (n,) for each frame the end before it; the one after it is the next.
        frames: (n,).
        way: how.
        straight: (n,) of a way that leaves it open: these are linear.

    Returns:
        `CORRECTED_COLUMNS`; visibility is that of the end before, confidence the lower of both.

    Raises:
        EditError: the floor is asked for, and nothing tells where an end stands on it.
    """
    rows = select_rows(ends, at)
    rows["frame"] = np.asarray(frames, np.int32)
    rows["source"][:], rows["predicted"][:] = Source.INTERPOLATED, False
    rows["confidence"] = np.fmin(ends["confidence"][at], ends["confidence"][at + 1])
    span = (ends["frame"][at + 1] - ends["frame"][at]).astype(np.float64)
    share = (frames - ends["frame"][at]) / span
    _write(rows, _between(boxes_of(ends), at, share), _between(places_of(ends), at, share))
    places = places_of(ends)
    if way.view is not None and way.how != "linear":
        if way.how == "floor":
            places = _known_places(ends, places, way.view)
            straight = np.zeros(len(frames), np.bool_)
        _walk(rows, ends, places, at, share, way.view, straight)
    velocity = (places[at + 1] - places[at]) / span[:, None] * (way.fps or np.nan)
    rows["vx"], rows["vy"] = velocity.T.copy()
    return rows


def was_straight(ends: Columns, at: Numbers, rows: Columns) -> NDArray[np.bool_]:
    """(n,) whether each row lies in a stretch whose boxes run straight between its ends.

    What stands still runs both ways, and is not said to be straight.
    """
    boxes = boxes_of(ends)
    span = ends["frame"][at + 1] - ends["frame"][at]
    share = (rows["frame"] - ends["frame"][at]) / span
    off = np.abs(_between(boxes, at, share) - boxes_of(rows)).max(axis=1)
    moving = np.abs(np.diff(boxes, axis=0)).max(axis=1) > _SAME_PX
    farthest = np.zeros(len(boxes))
    np.maximum.at(farthest, at, np.nan_to_num(off, nan=np.inf))
    return np.asarray((farthest[at] <= _SAME_PX) & moving[at])


def _walk(
    rows: Rows,
    ends: Columns,
    places: Floats,
    at: Numbers,
    share: Floats,
    view: View,
    straight: NDArray[np.bool_],
) -> None:
    """Write the rows that go over the floor: those that are not straight and can be seen there."""
    boxes = boxes_of(ends)
    heights = body_heights(view, places, boxes)
    fit = fits(view, places, heights, boxes)
    walked = _between(places, at, share)
    height = _between(heights[:, None], at, share)[:, 0]
    seen = move_bodies(view, walked, height, _between(fit, at, share))
    walks = np.asarray(np.isfinite(seen).all(axis=1), np.bool_) & ~straight
    chosen = walks[:, None]
    _write(rows, np.where(chosen, seen, boxes_of(rows)), np.where(chosen, walked, places_of(rows)))


def _known_places(ends: Columns, places: Floats, view: View) -> Floats:
    """The ends' places (k, 2), where unknown told from their boxes."""
    unknown = np.asarray(~np.isfinite(places).all(axis=1), np.bool_)
    if not unknown.any():
        return places
    boxes = boxes_of(ends)
    seen = body_positions(view, boxes, body_heights(view, places, boxes))
    places = np.where(unknown[:, None], seen, places)
    lost = ~np.isfinite(places).all(axis=1)
    if lost.any():
        frame = ends["frame"][int(np.argmax(lost))]
        raise EditError(
            "track {track}: no floor is seen below its box in frame {frame}; interpolate "
            "linearly instead",
            track=ends["track"][0],
            frame=frame,
        )
    return places


def _between(values: Floats, at: Numbers, share: Floats) -> Floats:
    """(n, c) of the values (k, c) of ends."""
    first, second = values[at], values[at + 1]
    return np.asarray(first + (second - first) * share[:, None])


def _write(rows: Rows, boxes: Floats, places: Floats) -> None:
    for name, column in zip((*SIDES, "x", "y"), np.hstack([boxes, places]).T, strict=True):
        rows[name] = column.copy()
