"""People standing on the floor, seen in the left picture: boxes from places and back.

A body is the model of `tracking.people`; a box drawn by a person or a tracker never is exactly
that body's. What it differs by (its fit) is kept as a share of the body's size, so that a box
carried elsewhere keeps its likeness and one carried nowhere stays what it was.
"""

from __future__ import annotations

import numpy as np

from tracking.arrays import Floats
from tracking.geometry import View
from tracking.people.boxes import standing_boxes
from tracking.tracks import Box, Columns
from tracking.tracks.boxes import boxes_of_corners, corners_of_boxes

SIDES = ("left", "top", "width", "height")
USUAL_HEIGHT_M = 1.75
_BODY_WIDTH_M = 0.5
_HEIGHTS_M = (0.5, 2.3)
_STEP_M = 0.02
_HEIGHT_ROUNDS, _PLACE_ROUNDS = 3, 9
_STEEP_DEG = 60.0
"""Tilted more, a camera sees people from above."""


def boxes_of(rows: Columns) -> Floats:
    """(n, 4) left, top, width, height of rows."""
    return np.column_stack([np.asarray(rows[name], np.float64) for name in SIDES])


def places_of(rows: Columns) -> Floats:
    """(n, 2) x, y of rows in metres on the floor; NaN where unknown."""
    return np.column_stack([np.asarray(rows[name], np.float64) for name in ("x", "y")])


def body_boxes(view: View, places: Floats, heights_m: Floats) -> Floats:
    """(n, 4) boxes of bodies of these heights at floor places; NaN where behind the camera."""
    return standing_boxes(view, places, heights_m, _BODY_WIDTH_M)


def standing_box(view: View, position_m: tuple[float, float], height_m: float) -> Box:
    """The box of one person standing somewhere; NaN where in part behind the camera."""
    place = np.array([position_m], float)
    left, top, width, height = body_boxes(view, place, np.array([height_m]))[0].tolist()
    return left, top, width, height


def body_heights(view: View, places: Floats, boxes: Floats) -> Floats:
    """(n,) m: the height with which a body at each place suits its box best, by least squares.

    Within what people measure; the usual height where place or box are unknown.
    """
    heights = np.full(len(places), USUAL_HEIGHT_M)
    wanted = corners_of_boxes(boxes)
    for _ in range(_HEIGHT_ROUNDS):
        here = corners_of_boxes(body_boxes(view, places, heights))
        slope = (corners_of_boxes(body_boxes(view, places, heights + _STEP_M)) - here) / _STEP_M
        with np.errstate(divide="ignore", invalid="ignore"):
            better = (slope * (wanted - here)).sum(axis=1) / np.square(slope).sum(axis=1)
        heights = np.clip(heights + np.nan_to_num(better, posinf=0.0, neginf=0.0), *_HEIGHTS_M)
    return np.where(np.isfinite(wanted).all(axis=1), heights, USUAL_HEIGHT_M)


def fits(view: View, places: Floats, heights_m: Floats, boxes: Floats) -> Floats:
    """(n, 4) how far each edge of a box is off its body's, as shares of the body's size."""
    bodies = body_boxes(view, places, heights_m)
    return np.asarray(
        (corners_of_boxes(boxes) - corners_of_boxes(bodies)) / np.tile(bodies[:, 2:], 2)
    )


def move_bodies(view: View, places: Floats, heights_m: Floats, fit: Floats) -> Floats:
    """(n, 4) boxes of bodies at other places, with the fit they had."""
    bodies = body_boxes(view, places, heights_m)
    edges = corners_of_boxes(bodies) + fit * np.tile(bodies[:, 2:], 2)
    return boxes_of_corners(edges)


def body_positions(
    view: View, boxes: Floats, heights_m: Floats, off_px: Floats | None = None
) -> Floats:
    """(n, 2) m: the floor places from which bodies stand on the boxes' lower edge, at its middle.

    Seen from above the lower edge may be a head's; the middle of the box takes its part there.
    off_px: (n, 2) how far the boxes' foot stands off the bodies'; None: not at all.
    NaN where no floor is seen below the box, as above the horizon.
    """
    wanted = _foot(view, boxes) - (0.0 if off_px is None else off_px)
    aim = wanted
    places = view.floor_from_pixel(aim)
    for _ in range(_PLACE_ROUNDS):
        aim = aim + wanted - _foot(view, body_boxes(view, places, heights_m))
        places = view.floor_from_pixel(aim)
    return places


def body_position(view: View, box: Box, height_m: float = USUAL_HEIGHT_M) -> tuple[float, float]:
    """The floor place of the person whose box it is, in metres; NaN where none is seen there."""
    places = body_positions(view, np.array([box], float), np.array([height_m]))
    return float(places[0, 0]), float(places[0, 1])


def position_after_move(
    view: View, old_box: Floats, old_place: Floats, box: Floats
) -> tuple[float, float]:
    """The floor place after a box (4,) moved: the foot keeps standing in the box as it stood.

    From the box alone where the old place (2,) is unknown; NaN where no floor is seen there.
    """
    old_boxes, boxes, places = old_box[None], box[None], old_place[None]
    heights = body_heights(view, places, old_boxes)
    off = _foot(view, old_boxes) - _foot(view, body_boxes(view, places, heights))
    off_px = np.nan_to_num(off / old_boxes[:, 2:] * boxes[:, 2:])
    x, y = body_positions(view, boxes, heights, off_px)[0].tolist()
    return x, y


def _foot(view: View, boxes: Floats) -> Floats:
    """(n, 2) where boxes show their person's feet: the middle of the lower edge, or higher."""
    steep = (view.ground.tilt_deg - _STEEP_DEG) / (90.0 - _STEEP_DEG)
    return np.asarray(boxes[:, :2] + boxes[:, 2:] * (0.5, 1.0 - 0.5 * max(steep, 0.0)))
