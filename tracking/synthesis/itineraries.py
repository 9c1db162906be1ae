"""Who comes when, from where, and past which points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.synthesis.rig import Rig
from tracking.synthesis.specs import SceneSpec, WallSpec

EMPTY_S = 2.0
"""The first seconds show nobody, so that a background can be learned."""

_OUTWARD = {"left": (-1.0, 0.0), "right": (1.0, 0.0), "near": (0.0, -1.0), "far": (0.0, 1.0)}
_STEP_M = 0.15
_OUT_OF_VIEW_M = 0.3
_FARTHEST_STEPS = 200
_WALL_GAP_M = 0.45


@dataclass(frozen=True, slots=True, eq=False)
class Itinerary:
    """What one person is up to.

    Attributes:
        start_s: when the person sets off, outside the view.
        points: (k, 2) floor positions in metres: start, places to pass, end.
        pauses_s: (k,) how long the person stands at each.
        speed_m_s: how fast the person likes to walk.
    """

    start_s: float
    points: Floats
    pauses_s: Floats
    speed_m_s: float


def plan_itineraries(
    spec: SceneSpec, rig: Rig, people: int, seconds: float, rng: np.random.Generator
) -> tuple[Itinerary, ...]:
    """Itineraries of all people of a recording, by the time they set off.

    Every second person crosses the way of the one before, at about the same time.
    """
    starts = _starts(people, seconds, rng)
    plans: list[Itinerary] = []
    for index in range(people):
        meeting = plans[-1] if index % 2 else None
        plans.append(_plan(spec, rig, float(starts[index]), meeting, rng))
    return tuple(plans)


def _starts(people: int, seconds: float, rng: np.random.Generator) -> Floats:
    """Times to set off, evenly spread with some chance; the last ones still get to be seen."""
    last = max(seconds - 6.0, EMPTY_S + 0.4 * max(seconds - EMPTY_S, 0.0))
    late = rng.uniform(0.0, 0.9, people)
    late[:1] = 0.0
    slots = (np.arange(people) + late) / max(people, 1)
    return EMPTY_S + slots * (last - EMPTY_S)


def _plan(
    spec: SceneSpec,
    rig: Rig,
    start_s: float,
    meeting: Itinerary | None,
    rng: np.random.Generator,
) -> Itinerary:
    entrance = str(rng.choice(spec.entrances))
    others = [side for side in spec.entrances if side != entrance]
    # Now and then somebody turns round and leaves where they came from.
    leaving = entrance if rng.random() < 0.12 else str(rng.choice(others))
    places = [_place(spec, rng) for _ in range(1 + int(rng.integers(0, 3)))]
    if meeting is not None:
        places[0] = meeting.points[1] + rng.uniform(-0.3, 0.3, 2)
    first = _out_of_view(spec, rig, places[0], entrance, rng)
    last = _out_of_view(spec, rig, places[-1], leaving, rng)
    pauses = np.where(
        rng.random(len(places)) < spec.pauses, rng.uniform(*spec.pause_s, len(places)), 0.0
    )
    return Itinerary(
        start_s,
        np.array([first, *places, last]),
        np.concatenate(([0.0], pauses, [0.0])),
        float(np.clip(rng.normal(1.2, 0.2), 0.7, 1.6)),
    )


def _place(spec: SceneSpec, rng: np.random.Generator) -> Floats:
    """A point of the area that is not in a pillar."""
    left, near, right, far = spec.area_m
    while True:
        point = rng.uniform((left, near), (right, far))
        if all(np.hypot(*(point - (x, y))) > r + 0.6 for x, y, r in spec.pillars_m):
            return np.asarray(point, float)


def _out_of_view(
    spec: SceneSpec, rig: Rig, towards: Floats, side: str, rng: np.random.Generator
) -> Floats:
    """A floor position on one side of the area at which nothing of a person is seen."""
    along = np.array(_OUTWARD[side])
    across = along[::-1] * rng.uniform(-1.0, 1.0)
    point = clear_of_walls(spec, towards + across)
    for _ in range(_FARTHEST_STEPS):
        point = point + along * _STEP_M
        box = rig.view.box_of_person(point[None], 2.1, 1.0)[0]
        if not rig.sees(box):
            break
    return clear_of_walls(spec, point + along * _OUT_OF_VIEW_M)


def clear_of_walls(spec: SceneSpec, points: Floats) -> Floats:
    """Positions (..., 2) moved off the scene's walls: in front of endless ones."""
    points = points.copy()
    for wall in spec.walls:
        axis = 0 if wall.axis == "x" else 1
        if wall.ends:
            points[..., axis] = _off_wall(wall, points[..., axis], points[..., 1 - axis])
        elif wall.place_m > 0:
            points[..., axis] = np.minimum(points[..., axis], wall.place_m - _WALL_GAP_M)
        else:
            points[..., axis] = np.maximum(points[..., axis], wall.place_m + _WALL_GAP_M)
    return points


def _off_wall(wall: WallSpec, across: Floats, along: Floats) -> Floats:
    """Coordinates across a wall that ends, moved off its nearer side."""
    gap = across - wall.place_m
    beside = (along > wall.span_m[0]) & (along < wall.span_m[1]) & (np.abs(gap) < _WALL_GAP_M)
    return np.where(beside, wall.place_m + np.where(gap < 0, -1, 1) * _WALL_GAP_M, across)
