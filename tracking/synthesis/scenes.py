"""The catalogue of scenes that can be rendered."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType


@dataclass(frozen=True, slots=True)
class FloorSpec:
    """What the floor is laid with.

    Attributes:
        tile_m: width and depth of a tile; (0, 0) is a floor without joints, e.g. asphalt.
        colour: red, green, blue in 0..1, linear.
        variation: how much whole tiles differ from each other, as a share of the brightness.
        grain: strength of the fine texture, as a share of the brightness.
        staggered: every other row is shifted by half a tile, as bricks are.
    """

    tile_m: tuple[float, float]
    colour: tuple[float, float, float]
    variation: float = 0.06
    grain: float = 0.12
    staggered: bool = False


@dataclass(frozen=True, slots=True)
class WallSpec:
    """A vertical wall across the view or along it.

    Attributes:
        axis: "y": the wall stands at y = place_m and faces the camera; "x": at x = place_m.
        place_m: where it stands.
        kind: "plaster" or "brick".
    """

    axis: str
    place_m: float
    kind: str = "plaster"


@dataclass(frozen=True, slots=True)
class LampSpec:
    """The light of a scene: a far lamp and the light from all around.

    Attributes:
        towards: world direction in which the lamp's light travels; z negative.
        direct, ambient: brightness of the two, red, green, blue; they add up to about 1.
        softness_m: how soft the shadow of a head is on the floor.
    """

    towards: tuple[float, float, float]
    direct: tuple[float, float, float]
    ambient: tuple[float, float, float]
    softness_m: float = 0.05


@dataclass(frozen=True, slots=True)
class SceneSpec:
    """A scene: where the camera hangs, what it looks at, who comes by.

    Attributes:
        name, title: as typed and as shown.
        height_m, tilt_deg: the left camera over the floor.
        area_m: left, near, right, far of the floor where people walk to.
        entrances: sides of the area where people come in and go: left, right, near, far.
        people, seconds: what is rendered unless told otherwise.
        pillars_m: x, y, radius of round pillars that hide people.
        uniform: everybody wears the same colours.
        pauses: share of waypoints at which people stop for a while.
        pause_s: the shortest and the longest such stop.
        stoops: share of the longer stops in which people crouch or bend down and stand up again.
        contrasting: nobody's trousers have about the colour of the top.
        size_px: width and height of the pictures unless told otherwise.
    """

    name: str
    title: str
    height_m: float
    tilt_deg: float
    area_m: tuple[float, float, float, float]
    floor: FloorSpec
    lamp: LampSpec
    entrances: tuple[str, ...] = ("left", "right")
    walls: tuple[WallSpec, ...] = ()
    pillars_m: tuple[tuple[float, float, float], ...] = ()
    people: int = 16
    seconds: float = 30.0
    uniform: bool = False
    pauses: float = 0.3
    pause_s: tuple[float, float] = (0.8, 3.5)
    stoops: float = 0.0
    contrasting: bool = False
    size_px: tuple[int, int] = (640, 480)


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
