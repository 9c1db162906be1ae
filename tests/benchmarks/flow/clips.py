"""The recordings on which counts are measured."""

from __future__ import annotations

from dataclasses import dataclass

from tests.benchmarks.rendered_clips import Clip
from tracking.synthesis import SCENES
from tracking.tracks import CountingLine, Region

_SCENES = ("lane", "two-way")
_NEAR_M, _FAR_M = 5.0, 9.0
_LINES_M = (5.5, 7.0, 8.5)


@dataclass(frozen=True, slots=True)
class Counted:
    """A rendered scene and where people are counted in it.

    Attributes:
        clip: the scene.
        region: of the floor in which people are summed, as in the paper.
        lines: across the passage; forward is away from the camera.
    """

    clip: Clip
    region: Region
    lines: tuple[CountingLine, ...]


def _counted(scene: str, seed: int) -> Counted:
    passage = SCENES[scene].passage
    assert passage is not None
    half = passage.half_width_m
    corners = ((-half, _NEAR_M), (half, _NEAR_M), (half, _FAR_M), (-half, _FAR_M))
    lines = tuple(CountingLine(f"{y:g} m", (half, y), (-half, y)) for y in _LINES_M)
    return Counted(Clip(scene, seed), Region("passage", corners), lines)


TUNED = tuple(_counted(scene, 5101) for scene in _SCENES)
"""For choosing settings; never reported."""

REPORTED = tuple(_counted(scene, seed) for scene in _SCENES for seed in (5201, 5202))
"""Nothing was chosen on these."""
