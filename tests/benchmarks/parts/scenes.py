"""Scenes for training alone: people as other cameras see them, so that a detector learns those too.

What was learnt from one camera at 3 m is wrong about people seen from high above, from afar or from
the height of their eyes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from tracking.synthesis import SCENES, SceneSpec

_WALKWAY = SCENES["walkway"]
_SECONDS = 14.0


def _elsewhere(name: str, scene: SceneSpec, people: int) -> SceneSpec:
    return replace(scene, name=name, title=f"For training: {name}", seconds=_SECONDS, people=people)


_SCENES = (
    _elsewhere("hall", replace(SCENES["lobby"], stoops=0.3), 7),
    _elsewhere("court", SCENES["square"], 9),
    _elsewhere("car-park", SCENES["outdoor"], 9),
    _elsewhere(
        "street",
        replace(
            _WALKWAY,
            height_m=7.0,
            tilt_deg=17.0,
            area_m=(-6.0, 11.0, 6.0, 22.0),
            walls=(),
            pauses=0.3,
            contrasting=False,
            size_px=(768, 576),
        ),
        10,
    ),
    _elsewhere(
        "pavement",
        replace(
            _WALKWAY,
            height_m=1.7,
            tilt_deg=4.0,
            area_m=(-2.6, 4.5, 2.6, 8.5),
            contrasting=False,
            size_px=(640, 480),
        ),
        6,
    ),
    _elsewhere(
        "balcony",
        replace(_WALKWAY, height_m=4.5, tilt_deg=38.0, area_m=(-2.8, 3.6, 2.8, 8.2)),
        6,
    ),
)

ELSEWHERE: Mapping[str, SceneSpec] = MappingProxyType({scene.name: scene for scene in _SCENES})
