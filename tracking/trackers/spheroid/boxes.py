"""Boxes in the picture as recorded: drawn from what is seen of people, else from spheroids."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.geometry import Ellipses, FlatView
from tracking.people.boxes import standing_boxes
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople
from tracking.trackers.spheroid.hypothesis_scores import (
    JudgedFrame,
    bounds,
    enlarge,
    others_cover,
    silhouette,
)
from tracking.tracks.boxes import boxes_of_corners, corners_of_boxes, corners_through

BODY_WIDTH_M = 0.46
"""Of a body as the picture shows it, arms and stride included."""
_REACH = 1.35
"""Arms and feet reach out of a silhouette, but not beyond one so much larger."""
_FOREGROUND = 110
_FEWEST_PX = 2
"""Rows and columns with fewer pixels at a body's ends are specks."""
_WHOLE, _INSIDE, _COVERED = 0.9, 0.98, 0.5
"""Shares in sight, in the picture and of foreground from which a body's box is measured."""
_FARTHEST = 0.4
"""A side measured farther off than this share of the box is somebody else's or a shadow."""
_MEMORY_S = 0.5


@dataclass(frozen=True, slots=True, eq=False)
class ReportedBoxes:
    """What is shown of the people.

    Attributes:
        box: (people, 4) left, top, width, height px as recorded.
        outline: (people, 4) by what their sides differ from usual boxes, in sizes of these.
    """

    box: Floats
    outline: Floats


def draw_boxes(
    people: SpheroidPeople,
    outlines: Ellipses,
    judged: JudgedFrame,
    flat: FlatView,
    elapsed_s: float,
) -> ReportedBoxes:
    """Boxes of everybody, and what was learnt of how they differ from usual ones.

    Spheroids leave out arms and feet and are too broad at the head; boxes that people draw do not.
    So the sides are those of the foreground around a silhouette, where a person is seen whole, and
    what they differ by from a usual body's is remembered for when he is not.

    Args:
        outlines: (people) the silhouettes of `judged`'s cover.
    """
    usual = corners_of_boxes(standing_boxes(flat.view, people.xy, people.height, BODY_WIDTH_M))
    size = np.tile(usual[:, 2:] - usual[:, :2], 2)
    whole = (people.shown > _WHOLE) & (people.inside > _INSIDE) & (people.coverage > _COVERED)
    off = np.full((len(people), 4), np.nan)
    rows = np.flatnonzero(whole)
    if len(rows):
        measured = _measure(outlines[rows], judged)
        seen = corners_through(
            lambda sides: [flat.recorded_from_flat(side) for side in sides], measured
        )
        off[rows] = (seen - usual[rows]) / size[rows]
    good = np.abs(np.nan_to_num(off, nan=9.0)).max(axis=1) < _FARTHEST
    share = 1.0 - np.exp(-max(elapsed_s, 1e-3) / _MEMORY_S)
    share = np.where(people.age_s < _MEMORY_S, np.maximum(share, 0.3), share)
    change = np.where(good[:, None], np.nan_to_num(off) - people.outline, 0.0)
    outline = people.outline + share[:, None] * change
    shown = np.where(good[:, None], np.nan_to_num(off), outline)
    corners = usual + shown * size
    return ReportedBoxes(boxes_of_corners(corners), outline)


def _measure(outlines: Ellipses, judged: JudgedFrame) -> Floats:
    """(people, 4) left, top, right, bottom flat px of the foreground of each; NaN for none."""
    wide = enlarge(outlines, _REACH)
    shape = judged.ramp.shape
    reach, own = wide.polygons(40), outlines.polygons(40)
    boxes = np.column_stack(bounds(outlines, shape))
    found = np.full((len(outlines.u), 4), np.nan)
    for k, (left, top, right, bottom) in enumerate(zip(*bounds(wide, shape), strict=True)):
        part = np.s_[top:bottom, left:right]
        size = (bottom - top, right - left)
        others = others_cover(judged.cover, (left, top, right, bottom), own[k], boxes[k])
        body = (judged.ramp[part] > _FOREGROUND) & (others == 0)
        body &= silhouette(size, reach[k], left, top) > 0
        columns = np.flatnonzero(body.sum(axis=0) >= _FEWEST_PX)
        rows = np.flatnonzero(body.sum(axis=1) >= _FEWEST_PX)
        if len(columns) and len(rows):
            found[k] = columns[0], rows[0], columns[-1] + 1, rows[-1] + 1
            found[k] += (left, top, left, top)
    return found - 0.5
