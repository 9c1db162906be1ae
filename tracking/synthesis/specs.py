"""What a scene is made of: floor, walls, light, camera and who comes by."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


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
        span_m: from where to where it goes along the other axis. What ends somewhere hides who
            walks behind it; an endless wall stands behind everybody.
    """

    axis: str
    place_m: float
    kind: str = "plaster"
    span_m: tuple[float, float] = (-np.inf, np.inf)

    @property
    def ends(self) -> bool:
        """Whether one can walk round it."""
        return bool(np.isfinite(self.span_m).any())


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
class PassageSpec:
    """A passage along the view, between a cross passage at its far end and open floor at its near.

    Attributes:
        half_width_m: from the middle, x = 0, to each wall.
        near_m, far_m: y of its two ends.
        both_ways: people walk towards the camera and away from it, mostly on their right; else
            towards it only.
        bunches: the fewest and the most people who come at once.
    """

    half_width_m: float
    near_m: float
    far_m: float
    both_ways: bool
    bunches: tuple[int, int]


@dataclass(frozen=True, slots=True)
class SceneSpec:
    """A scene: where the camera hangs, what it looks at, who comes by.

    Attributes:
        name, title: as typed and as shown.
        height_m, tilt_deg, roll_deg: the left camera over the floor, as `Ground` has them.
        area_m: left, near, right, far of the floor where people walk to.
        entrances: sides of the area where people come in and go: left, right, near, far.
        people, seconds: what is rendered unless told otherwise.
        pillars_m: x, y, radius of round pillars that hide people.
        uniform: the colours everybody wears, "navy" or "red and brown"; empty: their own.
        pauses: share of waypoints at which people stop for a while.
        pause_s: the shortest and the longest such stop.
        stoops: share of the longer stops in which people crouch or bend down and stand up again.
        contrasting: nobody's trousers have about the colour of the top.
        size_px: width and height of the pictures unless told otherwise.
        fps, cameras: frames a second and how many cameras, unless told otherwise.
        focal: focal length as a share of the picture's width; unless told otherwise the stereo
            papers' 3.8 mm lens at VGA.
        scenario: what people do, one of `scenarios`; empty: they come by as they like.
        passage: where people walk instead of to places in the area.
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
    uniform: str = ""
    pauses: float = 0.3
    pause_s: tuple[float, float] = (0.8, 3.5)
    stoops: float = 0.0
    contrasting: bool = False
    size_px: tuple[int, int] = (640, 480)
    roll_deg: float = 0.0
    fps: float = 20.0
    cameras: int = 2
    focal: float = 510.0 / 640.0
    scenario: str = ""
    passage: PassageSpec | None = None
