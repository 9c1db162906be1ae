"""The catalogue of scenes that can be rendered."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from tracking.synthesis.specs import FloorSpec, LampSpec, SceneSpec, WallSpec

_STONE = FloorSpec((0.6, 0.6), (0.50, 0.46, 0.42))
_LIGHT_STONE = FloorSpec((0.8, 0.8), (0.55, 0.52, 0.47), variation=0.05)
_SLABS = FloorSpec((0.9, 0.6), (0.40, 0.375, 0.34), 0.10, 0.20, staggered=True)
_PAVERS = FloorSpec((0.4, 0.2), (0.36, 0.30, 0.26), 0.14, 0.18, staggered=True)
_ASPHALT = FloorSpec((0.0, 0.0), (0.20, 0.20, 0.205), 0.0, 0.30)
_VINYL = FloorSpec((0.5, 0.5), (0.42, 0.43, 0.40), 0.03, 0.08)

_SKYLIGHT = LampSpec((0.45, -0.25, -1.0), (0.52, 0.50, 0.46), (0.45, 0.47, 0.50), 0.09)
_CEILING_LAMP = LampSpec((-0.35, -0.30, -1.0), (0.50, 0.47, 0.42), (0.47, 0.48, 0.50), 0.10)
_SUN = LampSpec((0.75, -0.40, -1.0), (0.66, 0.62, 0.53), (0.34, 0.38, 0.44), 0.035)
_HIGH_SUN = LampSpec((-0.55, 0.25, -1.0), (0.64, 0.61, 0.54), (0.36, 0.39, 0.45), 0.04)

_SCENES = (
    SceneSpec(
        "lobby",
        "Lobby, 2.4 m, 30 degrees",
        2.4,
        30.0,
        (-2.6, 3.2, 2.6, 9.0),
        _LIGHT_STONE,
        _SKYLIGHT,
        walls=(WallSpec("y", 11.5),),
        people=18,
    ),
    SceneSpec(
        "plaza",
        "Plaza, 6.4 m, 60 degrees",
        6.4,
        60.0,
        (-2.8, 1.6, 2.8, 7.0),
        _SLABS,
        _SUN,
        entrances=("left", "right", "near", "far"),
        people=20,
        pauses=0.4,
    ),
    SceneSpec(
        "square",
        "Square, 5.9 m, 40 degrees",
        5.9,
        40.0,
        (-4.0, 4.5, 4.0, 12.0),
        _PAVERS,
        _HIGH_SUN,
        entrances=("left", "right", "near"),
        walls=(WallSpec("y", 17.5, "brick"),),
        people=20,
    ),
    SceneSpec(
        "indoor",
        "Indoors, 2.3 m, 30 degrees",
        2.3,
        30.0,
        (-2.4, 3.2, 2.4, 7.5),
        _VINYL,
        _CEILING_LAMP,
        walls=(WallSpec("y", 9.5),),
        people=14,
    ),
    SceneSpec(
        "outdoor",
        "Outdoors, 8.3 m, 50 degrees",
        8.3,
        50.0,
        (-4.5, 3.5, 4.5, 12.0),
        _ASPHALT,
        _SUN,
        entrances=("left", "right", "near", "far"),
        people=22,
    ),
    SceneSpec(
        "uniforms",
        "Everybody in one colour, 2.4 m, 30 degrees",
        2.4,
        30.0,
        (-2.6, 3.2, 2.6, 9.0),
        _STONE,
        _CEILING_LAMP,
        walls=(WallSpec("y", 11.5),),
        people=14,
        uniform=True,
    ),
    SceneSpec(
        "pillars",
        "Pillars in the way, 3.0 m, 30 degrees",
        3.0,
        30.0,
        (-3.2, 4.0, 3.2, 9.5),
        _LIGHT_STONE,
        _SKYLIGHT,
        walls=(WallSpec("y", 12.5),),
        pillars_m=((-1.5, 5.2, 0.22), (1.7, 5.2, 0.22), (0.1, 8.4, 0.22)),
    ),
    SceneSpec(
        "ceiling",
        "Straight down, 3.6 m",
        3.6,
        90.0,
        (-1.6, -1.1, 1.6, 1.1),
        _VINYL,
        _CEILING_LAMP,
        entrances=("left", "right", "near", "far"),
        people=10,
    ),
    SceneSpec(
        "corridor",
        "A crowded corridor, 3.6 m, 40 degrees",
        3.6,
        40.0,
        (-1.5, 3.6, 1.5, 9.5),
        _STONE,
        _CEILING_LAMP,
        entrances=("near", "far"),
        walls=(WallSpec("x", -2.1), WallSpec("x", 2.1)),
        people=26,
        pauses=0.1,
    ),
    SceneSpec(
        "walkway",
        "A walkway for body parts, 3.0 m, 30 degrees",
        3.0,
        30.0,
        (-2.6, 4.6, 2.6, 8.6),
        _SLABS,
        _SUN,
        walls=(WallSpec("y", 13.0, "brick"),),
        people=5,
        seconds=12.0,
        pauses=0.15,
        contrasting=True,
        size_px=(720, 480),
    ),
    SceneSpec(
        "crouching",
        "People who crouch and bend, 3.0 m, 30 degrees",
        3.0,
        30.0,
        (-2.2, 4.8, 2.2, 8.2),
        _SLABS,
        _SUN,
        walls=(WallSpec("y", 13.0, "brick"),),
        people=4,
        seconds=18.0,
        pauses=1.0,
        pause_s=(2.4, 4.0),
        stoops=1.0,
        contrasting=True,
        size_px=(720, 480),
    ),
)

SCENES: Mapping[str, SceneSpec] = MappingProxyType({scene.name: scene for scene in _SCENES})
"""Scenes by name, the papers' camera set-ups among them ([Kawashita2012], [Kawashita2014],
[ZhaoLee2009])."""
