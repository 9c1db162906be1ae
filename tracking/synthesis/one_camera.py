"""Scenes for trackers that look with one camera ([Waechter2013], [Yoneji2013])."""

from __future__ import annotations

from tracking.synthesis import situations
from tracking.synthesis.specs import PassageSpec, SceneSpec, WallSpec
from tracking.synthesis.surroundings import CEILING_LAMP, LIGHT_STONE, SKYLIGHT, STONE, VINYL

_OFFICE_FOCAL = 490.0 / 640.0
"""Sees 3.5 x 4.7 m of the floor from 3.6 m above it."""

_OFFICE_M = (-2.35, -1.76, 2.35, 1.76)


def _office(name: str, title: str, people: int, seconds: float) -> SceneSpec:
    """An office floor seen from its ceiling."""
    return SceneSpec(
        name,
        f"{title}, straight down, 3.6 m",
        3.6,
        90.0,
        _OFFICE_M,
        VINYL,
        CEILING_LAMP,
        people=people,
        seconds=seconds,
        uniform="red and brown",
        fps=15.0,
        cameras=1,
        focal=_OFFICE_FOCAL,
        scenario=name,
    )


def _walls(passage: PassageSpec) -> tuple[WallSpec, ...]:
    """The walls of a passage, beside its near mouth and of the cross passage behind it."""
    half, along = passage.half_width_m, (passage.near_m, passage.far_m)
    return (
        WallSpec("x", -half, span_m=along),
        WallSpec("x", half, span_m=along),
        WallSpec("y", passage.near_m, span_m=(-float("inf"), -half)),
        WallSpec("y", passage.near_m, span_m=(half, float("inf"))),
        WallSpec("y", passage.far_m + 3.0, "brick"),
    )


_LANE = PassageSpec(1.5, 4.4, 11.0, both_ways=False, bunches=(4, 9))
_TWO_WAY = PassageSpec(2.2, 4.4, 11.0, both_ways=True, bunches=(1, 3))
_ONE_BY_ONE = tuple(
    _office(f"situation-{n}", f"Hard situation {n} of 15", situations.people_in(n), 13.0)
    for n in range(1, situations.COUNT + 1)
)

ONE_CAMERA_SCENES = (
    _office("marks", "One person stands on ten marks", 1, 92.0),
    _office("marks-walking", "One person walks from mark to mark", 1, 24.0),
    _office("marks-pairs", "Two people stand on pairs of marks", 2, 51.0),
    _office(
        "situations",
        "Fifteen hard situations",
        sum(scene.people for scene in _ONE_BY_ONE),
        2.0 + situations.COUNT * 12.0,
    ),
    *_ONE_BY_ONE,
    SceneSpec(
        "lane",
        "A crowded lane, 2.2 m, 20 degrees",
        2.2,
        20.0,
        (-1.0, 5.0, 1.0, 9.0),
        STONE,
        CEILING_LAMP,
        walls=_walls(_LANE),
        people=56,
        seconds=60.0,
        fps=10.0,
        cameras=1,
        passage=_LANE,
    ),
    SceneSpec(
        "two-way",
        "A crowded passage both ways, 1.9 m, 11 degrees",
        1.9,
        11.0,
        (-1.7, 5.0, 1.7, 9.0),
        LIGHT_STONE,
        SKYLIGHT,
        walls=_walls(_TWO_WAY),
        people=60,
        seconds=60.0,
        fps=10.0,
        cameras=1,
        passage=_TWO_WAY,
    ),
)
