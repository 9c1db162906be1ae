"""What the window draws of the spheroid tracker: outlines, the region of evaluation, the ramp."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import FlatView, View, standing_ellipses
from tracking.recording.frame import StereoFrame
from tracking.trackers.spheroid.perception import SpheroidPerception

Floats = NDArray[np.float64]

USUAL_RADIUS_M = 0.25
"""Minor semi-axes of a person's spheroid ([Waechter2013] 3.2.1)."""
REGION_SCALE = 2.0
"""Of the region of evaluation, in sizes of the person's spheroid."""


@dataclass(frozen=True, slots=True, eq=False)
class RegionOfEvaluation:
    """Where one person's hypotheses are judged.

    Attributes:
        outline: (points, 2) px of the left picture as recorded; what lies inside counts.
        masked: (others, points, 2) px; what lies inside of these does not.
    """

    outline: Floats
    masked: Floats


def outlines(
    view: View,
    xy: Floats,
    height_m: Floats,
    radius_m: float = USUAL_RADIUS_M,
    points: int = 32,
    scale: float = 1.0,
) -> Floats:
    """Outlines of people's spheroids, or of hypotheses, all at once: (n, points, 2) px.

    Args:
        view: the camera over its floor.
        xy: (n, 2) m on the floor. height_m: (n,) or a single height of all.
        radius_m: minor semi-axes. points: along each outline. scale: of the spheroids.

    Returns:
        Closed polygons in px of the left picture as recorded, the lens's distortion in them; they
        may reach out of the picture. NaN for who is not wholly in front of the camera.
    """
    flat = FlatView(view)
    xy = np.asarray(xy, float).reshape(-1, 2)
    tall = np.broadcast_to(np.asarray(height_m, float), xy.shape[:1])
    drawn = standing_ellipses(flat.projection, xy, tall, radius_m, scale).polygons(points)
    return flat.recorded_from_flat(drawn.reshape(-1, 2)).reshape(drawn.shape)


def region_of_evaluation(
    view: View,
    xy: Floats,
    height_m: float,
    others_xy: Floats,
    others_height_m: Floats,
    radius_m: float = USUAL_RADIUS_M,
    points: int = 64,
    scale: float = REGION_SCALE,
) -> RegionOfEvaluation:
    """The region a hypothesis at a person's place is judged in as published, the others masked.

    Args:
        view: the camera over its floor.
        xy: (2,) m where the person is. height_m: of the person.
        others_xy: (others, 2) m where the others are. others_height_m: (others,).
        radius_m: minor semi-axes of everybody. points: along each outline.
        scale: of the region, in sizes of the person's spheroid.
    """
    own = np.asarray(xy, float).reshape(1, 2)
    outline = outlines(view, own, np.array([height_m]), radius_m, points, scale)[0]
    masked = outlines(view, others_xy, others_height_m, radius_m, points)
    return RegionOfEvaluation(outline, masked)


def ramp_picture(perception: SpheroidPerception, frame: StereoFrame) -> NDArray[np.uint8]:
    """(height, width) uint8: the ramp B times 255, in px of the left picture as recorded.

    Args:
        perception: one that has learnt its background; frames come in any order.
    """
    return perception.ramp_picture(frame)
