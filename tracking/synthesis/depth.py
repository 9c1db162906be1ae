"""How far away everything is that the left camera of a scene sees."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Float32s
from tracking.synthesis.painter import FINE
from tracking.synthesis.rig import BASELINE_M, Rig
from tracking.synthesis.scenery import depth_of_scenery
from tracking.synthesis.specs import SceneSpec
from tracking.synthesis.truth import Surfaces


def depth_without_people(spec: SceneSpec, rig: Rig, still: Float32s | None) -> Float32s:
    """(height, width) m along the optical axis of floor, walls and pillars, at pixel centres.

    Args:
        spec, rig: whose floor and walls, and who looks.
        still: inverse depth at `FINE` samples a pixel of what people can be behind, 0 elsewhere;
            None: nothing.
    """
    depth = depth_of_scenery(spec, rig)
    if still is None:
        return depth
    height, width = depth.shape
    nearest = still.reshape(height, FINE, width, FINE).max(axis=(1, 3))
    with np.errstate(divide="ignore"):
        return np.asarray(np.minimum(depth, 1.0 / nearest), np.float32)


def with_people(depth: Float32s, people: Surfaces, rig: Rig) -> Float32s:
    """The depth with people before it; what is of nobody stays."""
    seen = np.isfinite(people.disparity_px)
    result = depth.copy()
    result[seen] = rig.focal_px * BASELINE_M / people.disparity_px[seen]
    return result
