"""People on their ways: smooth walks in which nobody walks through anybody else."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

from tracking.arrays import Floats
from tracking.synthesis.itineraries import Itinerary, clear_of_walls
from tracking.synthesis.specs import SceneSpec

CLOSEST_M = 0.5
"""No two people's floor positions come nearer to each other than this."""

_KEPT_M = 0.62  # what the steps below keep, so that smoothing cannot go under CLOSEST_M
_COMFORT_M = 0.95
_LOOK_AHEAD_S = 2.5
_TURNS_RAD = np.deg2rad([0.0, 12.0, -12.0, 27.0, -27.0, 48.0, -48.0, 75.0, -75.0])
_SPEED_SHARES = np.array([1.0, 0.65, 0.3, 0.0])
_ACCELERATION_M_S2 = 1.8
_TURNING_RAD_S = 2.6
_PATIENCE_S = 9.0
_SMOOTHING_FRAMES = 2.5


@dataclass(frozen=True, slots=True, eq=False)
class PlannedWalk:
    """One person's way over the floor, a row each frame.

    Attributes:
        first_frame: frame of the first row.
        position: (n, 2) world metres.
        heading: (n,) radians, 0 along world x, counter-clockwise; unwrapped.
    """

    first_frame: int
    position: Floats
    heading: Floats

    @property
    def frames(self) -> range:
        """Frames in which the person is on the floor, seen or not."""
        return range(self.first_frame, self.first_frame + len(self.position))


def walk(
    spec: SceneSpec, plans: tuple[Itinerary, ...], frames: int, fps: float
) -> tuple[PlannedWalk | None, ...]:
    """The walks of all itineraries over `frames` frames; None for who never sets off."""
    crowd = _Crowd(spec, plans, 1.0 / fps)
    states = np.full((frames, len(plans), 3), np.nan)
    for frame in range(frames):
        crowd.step(frame / fps)
        states[frame, crowd.on_floor, :2] = crowd.position[crowd.on_floor]
        states[frame, crowd.on_floor, 2] = crowd.heading[crowd.on_floor]
    return tuple(_walk_of(states[:, person]) for person in range(len(plans)))


def _walk_of(states: Floats) -> PlannedWalk | None:
    present = np.flatnonzero(np.isfinite(states[:, 0]))
    if not len(present):
        return None
    rows = states[present[0] : present[-1] + 1]
    position = gaussian_filter1d(rows[:, :2], _SMOOTHING_FRAMES, axis=0, mode="nearest")
    heading = gaussian_filter1d(np.unwrap(rows[:, 2]), _SMOOTHING_FRAMES, mode="nearest")
    return PlannedWalk(int(present[0]), position, heading)


class _Crowd:
    """Everybody's state while the walks are made, a row per person."""

    def __init__(self, spec: SceneSpec, plans: tuple[Itinerary, ...], step_s: float) -> None:
        self._spec, self._plans, self._step_s = spec, plans, step_s
        count = len(plans)
        self.position = np.array([plan.points[0] for plan in plans]).reshape(count, 2)
        towards = np.array([plan.points[1] - plan.points[0] for plan in plans]).reshape(count, 2)
        self.heading = np.arctan2(towards[:, 1], towards[:, 0])
        self.on_floor = np.zeros(count, np.bool_)
        self._speed = np.zeros(count)
        self._goal = np.ones(count, int)
        self._goal_since_s = np.zeros(count)
        self._stands_until_s = np.zeros(count)
        self._gone = np.zeros(count, np.bool_)

    def step(self, now_s: float) -> None:
        """Move everybody by one frame; `on_floor` says who is there afterwards."""
        self._admit(now_s)
        active = np.flatnonzero(self.on_floor)
        if not len(active):
            return
        wish = np.array([self._wish(person, now_s) for person in active])
        velocity = self._avoiding(active, wish)
        self._turn_and_go(active, velocity, wish)
        self._push_apart(active)

    def _admit(self, now_s: float) -> None:
        """Let those set off whose time has come and whose place is free."""
        for person, plan in enumerate(self._plans):
            if self.on_floor[person] or self._gone[person] or now_s < plan.start_s:
                continue
            there = self.position[self.on_floor]
            gaps = np.hypot(*(there - self.position[person]).T)
            if (gaps > 1.1).all():
                self.on_floor[person] = True
                self._speed[person] = plan.speed_m_s
                self._goal_since_s[person] = now_s

    def _wish(self, person: np.intp, now_s: float) -> Floats:
        """The velocity a person would like, were nobody else there."""
        plan = self._plans[person]
        gap = plan.points[self._goal[person]] - self.position[person]
        distance = float(np.hypot(*gap))
        last = self._goal[person] == len(plan.points) - 1
        stops = plan.pauses_s[self._goal[person]] > 0
        late = now_s - self._goal_since_s[person] > _PATIENCE_S + distance / plan.speed_m_s
        # Who finds the place taken makes do with one beside it; nobody vanishes within view.
        taken = distance < 1.3 and self._speed[person] < 0.45
        if distance < (0.3 if stops or last else 0.6) or ((late or taken) and not last):
            self._arrive(person, now_s, last)
        if now_s < self._stands_until_s[person]:
            return np.zeros(2)
        speed = min(plan.speed_m_s, 0.25 + 1.3 * distance) if stops else plan.speed_m_s
        return np.asarray(gap / max(distance, 1e-6) * speed)

    def _arrive(self, person: np.intp, now_s: float, last: bool) -> None:
        plan = self._plans[person]
        self._goal_since_s[person] = now_s
        if last:
            self.on_floor[person] = False
            self._gone[person] = True
            return
        pause_s = plan.pauses_s[self._goal[person]]
        self._stands_until_s[person] = now_s + pause_s
        self._goal_since_s[person] += pause_s
        self._goal[person] += 1

    def _avoiding(self, active: NDArray[np.intp], wish: Floats) -> Floats:
        """The velocity nearest to the wish that keeps clear of people and pillars."""
        options = _options(wish, self.heading[active])
        place, velocity, comfort = self._obstacles(active)
        gap = place[None] - self.position[active][:, None]
        relative = options[:, :, None] - velocity[None, None]
        closing = (relative * gap[:, None]).sum(-1) / np.maximum((relative**2).sum(-1), 1e-6)
        when = np.clip(closing, 0.0, _LOOK_AHEAD_S)
        closest = np.linalg.norm(gap[:, None] - relative * when[..., None], axis=-1)
        lack = np.maximum(comfort - closest, 0.0)
        danger = 4.0 * lack**2 / (when + 0.35)
        own = np.arange(len(active))
        danger[own, :, own] = 0.0
        cost = np.linalg.norm(options - wish[:, None], axis=-1) + danger.sum(-1)
        return np.asarray(options[own, cost.argmin(axis=1)])

    def _obstacles(self, active: NDArray[np.intp]) -> tuple[Floats, Floats, Floats]:
        """Place, velocity and distance to keep of everybody (first) and the pillars."""
        heading, speed = self.heading[active], self._speed[active]
        velocity = np.column_stack((np.cos(heading), np.sin(heading))) * speed[:, None]
        pillars = np.array(self._spec.pillars_m).reshape(-1, 3)
        return (
            np.concatenate((self.position[active], pillars[:, :2])),
            np.concatenate((velocity, np.zeros((len(pillars), 2)))),
            np.concatenate((np.full(len(active), _COMFORT_M), pillars[:, 2] + 0.55)),
        )

    def _turn_and_go(self, active: NDArray[np.intp], velocity: Floats, wish: Floats) -> None:
        """Walk straight ahead, turning and changing speed as fast as people do."""
        speed = np.linalg.norm(velocity, axis=1)
        aim = np.where(speed[:, None] > 0.05, velocity, wish)
        turn = np.arctan2(aim[:, 1], aim[:, 0]) - self.heading[active]
        turn = (turn + np.pi) % (2 * np.pi) - np.pi
        turn[np.linalg.norm(aim, axis=1) < 0.05] = 0.0
        # One does not stride on while turning round.
        speed *= np.clip(np.cos(turn), 0.15, 1.0)
        most = _TURNING_RAD_S * self._step_s
        self.heading[active] += np.clip(0.35 * turn, -most, most)
        change = _ACCELERATION_M_S2 * self._step_s
        now = self._speed[active]
        self._speed[active] = now + np.clip(speed - now, -2 * change, change)
        heading, pace = self.heading[active], self._speed[active] * self._step_s
        moved = np.column_stack((np.cos(heading), np.sin(heading))) * pace[:, None]
        self.position[active] = clear_of_walls(self._spec, self.position[active] + moved)

    def _push_apart(self, active: NDArray[np.intp]) -> None:
        """Part those who came too close after all; done until nobody is."""
        place = self.position[active]
        for _ in range(60):
            gap = place[:, None] - place[None]
            distance = np.linalg.norm(gap, axis=-1) + np.eye(len(active)) * 9.0
            lack = np.maximum(_KEPT_M - distance, 0.0)
            if not lack.any():
                break
            push = gap / np.maximum(distance, 1e-6)[..., None] * lack[..., None] * 0.52
            place = clear_of_walls(self._spec, self._off_pillars(place + push.sum(axis=1)))
        self.position[active] = self._off_pillars(place)

    def _off_pillars(self, place: Floats) -> Floats:
        for x, y, radius in self._spec.pillars_m:
            gap = place - (x, y)
            distance = np.maximum(np.linalg.norm(gap, axis=1), 1e-6)
            place = (
                place + gap / distance[:, None] * np.maximum(radius + 0.35 - distance, 0.0)[:, None]
            )
        return place


def _options(wish: Floats, heading: Floats) -> Floats:
    """Velocities (n, k, 2) to choose from: the wish, turned and slowed."""
    speed = np.linalg.norm(wish, axis=1)
    towards = np.where(speed > 0.05, np.arctan2(wish[:, 1], wish[:, 0]), heading)
    angle = towards[:, None, None] + _TURNS_RAD[None, :, None]
    size = speed[:, None, None] * _SPEED_SHARES[None, None, :]
    turned = np.stack((np.cos(angle) * size, np.sin(angle) * size), axis=-1)
    return turned.reshape(len(wish), -1, 2)
