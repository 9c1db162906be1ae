"""Planner that moves a person on the floor; the picture follows."""

from __future__ import annotations

import numpy as np

from tracking.editing.boxes.floor_boxes import (
    body_heights,
    body_positions,
    boxes_of,
    fits,
    move_bodies,
    places_of,
)
from tracking.editing.boxes.interpolation import How, Way
from tracking.editing.boxes.keyframes import key_row_change, put_by_hand, standing_row
from tracking.editing.core.change import Change
from tracking.errors import EditError
from tracking.geometry import View
from tracking.tracks import Box, Columns, TrackTable
from tracking.translation import msg


def plan_drag(
    table: TrackTable,
    track: int,
    frame: int,
    position_m: tuple[float, float],
    view: View,
    *,
    how: How | None = None,
    fps: float | None = None,
) -> Change:
    """Put a person elsewhere on the floor; the row becomes a keyframe.

    The box in the left picture goes along as a body of the same height would, keeping how it
    differed from that body's; the height is told from the box and the place as they were. The
    right picture needs nothing: what it shows is drawn from the place on the floor. Interpolated
    stretches beside the frame follow in the same change.

    Args:
        table, track, frame: whom and when.
        position_m: x, y on the floor in metres.
        view: the left camera over its floor.
        how, fps: of the stretches beside it and of velocities.

    Raises:
        EditError: the track does not stand in the frame, or the place cannot be in the picture.
    """
    row = standing_row(table, track, frame)
    if not np.isfinite(position_m).all():
        raise EditError(
            "place {position_m} is none; x and y in metres are needed", position_m=position_m
        )
    box = _box_at(view, row, position_m)
    put_by_hand(row, box, position_m)
    text = msg("Drag {track} on the floor in frame {frame}", track=track, frame=frame)
    return key_row_change(table, row, Way(how, view, fps), ("drag", text))


def _box_at(view: View, row: Columns, position_m: tuple[float, float]) -> Box:
    """The box of a row's person at another place. Raises EditError where it is not to be seen."""
    boxes, places = boxes_of(row), places_of(row)
    heights = body_heights(view, places, boxes)
    if not np.isfinite(places).all():
        places = body_positions(view, boxes, heights)
    there = np.array([position_m], float)
    box = move_bodies(view, there, heights, np.nan_to_num(fits(view, places, heights, boxes)))[0]
    if not (np.isfinite(box).all() and (box[2:] > 0).all()):
        x, y = position_m
        raise EditError(
            "place {x:.2f}, {y:.2f} m lies behind the camera; drag to one before it", x=x, y=y
        )
    left, top, width, height = box.tolist()
    return left, top, width, height
