"""What a view can draw of the spheroid tracker: outlines, the region of evaluation, the ramp."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import FlatView, View, standing_ellipses
from tracking.trackers.shared.overlays import (
    Bodies,
    EvaluationOverlay,
    RegionOfEvaluation,
    TrackerOverlays,
)
from tracking.trackers.spheroid.perception import SpheroidPerception
from tracking.trackers.spheroid.settings import SpheroidSettings

Floats = NDArray[np.float64]

USUAL_RADIUS_M = 0.25
"""Minor semi-axes of a person's spheroid ([Waechter2013] 3.2.1)."""
REGION_SCALE = 2.0
"""Of the region of evaluation, in sizes of the person's spheroid."""


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


def _outlines(view: View, settings: SpheroidSettings, bodies: Bodies, points: int) -> Floats:
    return outlines(view, bodies.xy, _heights(bodies, settings), settings.radius_m, points)


def _region(
    view: View, settings: SpheroidSettings, person: Bodies, others: Bodies
) -> RegionOfEvaluation:
    return region_of_evaluation(
        view,
        person.xy[0],
        float(_heights(person, settings)[0]),
        others.xy,
        _heights(others, settings),
        settings.radius_m,
        scale=settings.region_scale,
    )


def _heights(bodies: Bodies, settings: SpheroidSettings) -> Floats:
    """(n,) m: as estimated, else a newcomer's."""
    return np.where(np.isfinite(bodies.height_m), bodies.height_m, settings.tentative_height_m)


def _ramp(fps: float, view: View, settings: SpheroidSettings) -> SpheroidPerception:
    return SpheroidPerception(fps, view, settings.foreground, settings.ramp)


SPHEROID_OVERLAYS = TrackerOverlays(
    outlines=_outlines, evaluation=EvaluationOverlay("paper", _region), ramp=_ramp
)
