"""The floor from people who walk over it, seen by one camera: heights give the metre.

Bodies stand upright, are about as high as people are, and keep their height as they walk. A box is
either of such a body, or of something else: a group, a body with its shadow or without its feet.
Floor and classes are found together by expectation maximization, from coarse to fine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import least_squares

from tracking.arrays import Flags, Floats
from tracking.calibration.floor.estimate import FloorEstimate, check_above, estimate_of
from tracking.calibration.floor.walkers import PeopleSeen, people_seen
from tracking.errors import CalibrationError
from tracking.geometry import Camera, Ground, View
from tracking.progress import Progress, no_progress, stage_of
from tracking.recording import Recording
from tracking.translation import Message, count_msg, msg

_LEAST_SQUARES: Any = least_squares
"""Its stubs take no plain floats and functions."""
USUAL_HEIGHT_M = 1.73
"""Mean body height of grown-ups, with 3 cm of shoes."""
_HEIGHT_SD = 0.053
"""Of body heights, as a share (9 cm)."""
_BODY_WIDTH_M, _BODY_WIDTH_SD = 0.5, 0.15
"""Mean width of bodies in motion, and how well it is known, as a share: clothes, arms and lenses
differ from footage to footage."""
_BOX_SD, _BREADTH_SD, _LEAN_SD_RAD = 0.015, 0.25, float(np.deg2rad(2.5))
"""Of boxes of one person: heights and widths, as shares, and the axes of slim silhouettes."""
_COARSE, _FINER, _COARSE_LEAN = 8.0, 0.7, 4.0
"""Errors are taken so many times as large at first, of leans at most so, and less by this factor
in each round."""
_ROUNDS, _INNER_ROUNDS, _STEPS = 12, 3, 4
_OTHERS = 0.3
"""Share of boxes that are of something else, before anything is known, and where floors are
compared."""
_OTHERS_RANGE = 0.05, 0.6
_OTHERS_DENSITY = 1.0 / (1.0 * 1.5 * np.deg2rad(60.0))
"""Of boxes of something else: even over heights, widths and leans."""
_ROUNDEST = 0.1
"""Least slimness that counts: rounder silhouettes have no axis to speak of."""
_LOW_M, _HIGH_M = 0.3, 1.6
"""Of the axis of a body."""
_PLACINGS, _FARTHEST_M = 2, 200.0
"""Rounds in which feet are placed; nobody is seen farther away."""
_MOST_BOXES, _WHOLE_LOOKS = 200, 5
"""Boxes that a floor is searched by. Looks at somebody that count in full: those after them see
the same body with the same errors."""
_FEWEST_PEOPLE, _FEWEST_AREAS = 4, 4
"""Passages, and cells of the image (of 4 x 4) that people stand in."""
_FEW_PEOPLE, _MOST_AGREE = 12, 0.6
"""Passages that tell a floor well, and share of boxes that it explains: below it is doubtful."""
_STARTS_DEG = (5.0, 20.0, 40.0, 60.0, 80.0)
_BESIDE_DEG = (-6.0, -3.0, 3.0, 6.0)
_BESIDE_COARSE, _BESIDE_ROUNDS, _SEARCHES, _SAME_COST = 2.0, 6, 3, 1.0
"""Tilts beside the best floor that are tried, too: from afar, boxes without feet pull a floor away
from where it fits the others exactly."""
_STEP = 1e-4
_ROLL_SD_RAD = float(np.deg2rad(4.0))
_MOUNTED_M, _MOUNTED_SD = 4.0, 0.7
"""How cameras are mounted, as far as people do not tell: level, and between head height and a first
floor (deviation of the height's logarithm)."""
_LEAST, _MOST = [-0.5, -0.6, np.log(0.3), -0.5], [np.pi / 2, 0.6, np.log(50.0), 0.5]
_BOOTSTRAPS = 8
_LOOKING, _FITTED = 0.5, 0.8
"""Shares of the time when people are seen, and, of the rest, when the floor is fitted to them."""

State = Floats
"""(4,) tilt and roll in rad, logarithms of the height in m and of the bodies' width over 0.5 m."""


@dataclass(frozen=True, slots=True)
class _Misses:
    """How far boxes are from bodies on a floor: (n,) logarithms of heights and widths, leans."""

    tall: Floats
    wide: Floats
    lean: Floats


@dataclass(frozen=True, slots=True)
class _Fit:
    """A floor with what it explains.

    Attributes:
        state: the floor. cost: negative logarithm of its probability. single: (n,) probability
            that a box is of one whole body of usual height.
    """

    state: State
    cost: float
    single: Floats


def floor_by_people(recording: Recording, progress: Progress = no_progress) -> FloorEstimate:
    """The floor on which people of usual height stand, of a calibrated camera.

    People are found by the foreground alone and followed from look to look. Whoever walks keeps a
    height of their own, which is 1.73 m give or take 9 cm, and stands upright: the floor is the
    one on which drawn bodies fill the boxes and lean as people do, wherever they stand.

    Raises:
        CalibrationError: the camera is not calibrated, or too few people are seen.
        RecordingError: a frame cannot be read.
    """
    if recording.calibration is None:
        raise CalibrationError(
            "{path}: the floor by people needs a calibrated camera; give its calibration",
            option="--calibration",
            path=recording.path,
        )
    seen = people_seen(recording, stage_of(progress, 0.0, _LOOKING))
    return floor_of_people(recording.calibration.left, seen, stage_of(progress, _LOOKING, 1.0))


def floor_of_people(
    camera: Camera, seen: PeopleSeen, progress: Progress = no_progress
) -> FloorEstimate:
    """The floor on which people of usual height fill these boxes.

    Raises:
        CalibrationError: too few boxes, or all at one place.
    """
    _check(camera, seen)
    seen = seen.select(np.arange(0, len(seen.box), max(1, len(seen.box) // _MOST_BOXES)))
    bodies = _Bodies(camera, seen)
    fits = bodies.fits(stage_of(progress, 0.0, _FITTED))
    best = min(fits, key=lambda fit: fit.cost)
    ground = _ground(best.state)
    check_above(ground.height_m)
    drawn = bodies.bootstrap(best, stage_of(progress, _FITTED, 1.0))
    spread = np.hypot(drawn, _ambiguity(fits))
    people = len(np.unique(seen.person))
    # The mean height of few people may differ from that of all.
    share = float(np.hypot(spread[2], _HEIGHT_SD / np.sqrt(people)))
    lean_deg = float(np.rad2deg(np.hypot(spread[0], spread[1]) / np.sqrt(2)))
    up = np.array(ground.world_from_camera[0][2])
    notes = _notes(best.single > 0.5, people)
    return estimate_of(up, ground.height_m, "people", share * ground.height_m, lean_deg, notes)


def _check(camera: Camera, seen: PeopleSeen) -> None:
    box = seen.box
    foot = np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))
    cells = np.unique((foot * 4 // camera.size).astype(int).clip(0, 3), axis=0)
    people = len(np.unique(seen.person))
    if people < _FEWEST_PEOPLE or len(cells) < _FEWEST_AREAS:
        raise CalibrationError(
            "floor: {people} to walk alone, in {areas} of the image; longer footage with people "
            "in more places is needed",
            "or give points on the floor",
            option="--points",
            people=count_msg(people, "{n} person is seen", "{n} people are seen"),
            areas=count_msg(len(cells), "{n} part", "{n} parts"),
        )


def _notes(agree: Flags, people: int) -> tuple[Message, ...]:
    """What makes a floor doubtful: few people, or many boxes that it does not explain."""
    if agree.mean() < _MOST_AGREE:
        return (
            msg(
                "only {agree} boxes of people, of {every}, agree with this floor: look at the grid "
                "before you trust it, or click points on the floor",
                agree=int(agree.sum()),
                every=len(agree),
            ),
        )
    if people < _FEW_PEOPLE:
        return (
            msg(
                "only {people} people are seen to walk alone and whole: look at the grid before "
                "you trust it, give longer footage, or click points on the floor",
                people=people,
            ),
        )
    return ()


def _ambiguity(fits: list[_Fit]) -> Floats:
    """(4,) standard deviations between floors that explain the boxes about as well."""
    cost = np.array([fit.cost for fit in fits])
    weight = np.exp(cost.min() - cost)
    states = np.array([fit.state for fit in fits])
    off = states - states[int(cost.argmin())]
    return np.asarray(np.sqrt((weight[:, None] * off**2).sum(axis=0) / weight.sum()))


def _ground(state: State) -> Ground:
    tilt, roll, height = state[:3]
    return Ground(float(np.exp(height)), float(np.rad2deg(tilt)), float(np.rad2deg(roll)))


class _Bodies:
    """Boxes of people, and how a floor explains them."""

    def __init__(self, camera: Camera, seen: PeopleSeen) -> None:
        self._camera = camera
        self._seen = seen
        looks = np.bincount(seen.person)[seen.person]
        self._weight = np.minimum(1.0, np.sqrt(_WHOLE_LOOKS / looks))
        known = np.isfinite(seen.lean)
        self._lean = np.where(known, seen.lean, 0.0)
        self._axis_sd = _LEAN_SD_RAD / np.clip(np.where(known, seen.slimness, 0), _ROUNDEST, 1.0)
        self._known = known

    def fits(self, progress: Progress) -> list[_Fit]:
        """Floors from several starts, and from beside the best of them."""
        usual = np.array([0.0, 0.0, np.log(_MOUNTED_M), 0.0])
        starts = [usual + _tilted(degrees) for degrees in _STARTS_DEG]
        found: list[_Fit] = []
        most = len(starts) + _SEARCHES * len(_BESIDE_DEG)
        for start in starts:
            progress(len(found), most)
            found.append(self._fit(start, _COARSE, _ROUNDS))
        for _ in range(_SEARCHES):
            best = min(found, key=lambda fit: fit.cost)
            for degrees in _BESIDE_DEG:
                progress(len(found), most)
                found.append(self._beside(best.state, degrees))
            if min(fit.cost for fit in found) > best.cost - _SAME_COST:
                break
        return found

    def _beside(self, state: State, degrees: float) -> _Fit:
        """The floor from this far beside a state on, people being as tall as usual."""
        start = np.clip(state + _tilted(degrees), _LEAST, _MOST)
        start[2] -= float(np.median(self._misses(start).tall))
        return self._fit(np.clip(start, _LEAST, _MOST), _BESIDE_COARSE, _BESIDE_ROUNDS)

    def _fit(self, state: State, coarse: float, rounds: int) -> _Fit:
        """The floor from a state on, by expectation maximization, from coarse to fine."""
        others = _OTHERS
        misses = self._misses(state)
        own = self._medians(misses.tall)
        for _ in range(rounds):
            for _ in range(_INNER_ROUNDS):
                single = self._expect(misses, own, coarse, others)[0]
                own = self._own_heights(misses.tall, single, coarse)
            state = self._maximize(state, single, coarse)
            misses = self._misses(state)
            single = self._expect(misses, own, coarse, others)[0]
            share = 1.0 - float(np.average(single, weights=self._weight))
            others = float(np.clip(share, *_OTHERS_RANGE))
            coarse = max(1.0, coarse * _FINER)
        own = self._own_heights(misses.tall, single, 1.0)
        single, probability = self._expect(misses, own, 1.0, _OTHERS)
        cost = -float(self._weight @ probability) + 0.5 * float(np.square(_mounting(state)).sum())
        return _Fit(state, cost, single)

    def bootstrap(self, fit: _Fit, progress: Progress) -> Floats:
        """(4,) standard deviations of a floor by drawing people again."""
        random = np.random.default_rng(0)
        count = int(self._seen.person.max()) + 1
        states = []
        for done in range(_BOOTSTRAPS):
            progress(done, _BOOTSTRAPS)
            drawn = np.bincount(random.integers(0, count, count), minlength=count)
            states.append(self._maximize(fit.state, fit.single * drawn[self._seen.person], 1.0))
        return np.asarray(np.std(states, axis=0))

    def _maximize(self, state: State, single: Floats, coarse: float) -> State:
        """The floor that suits the boxes of single bodies best."""
        share = np.sqrt(single * self._weight)
        leans = share * self._known / (self._axis_sd * min(coarse, _COARSE_LEAN))

        def weighed(state: State) -> Floats:
            misses = self._misses(state)
            own = self._own_heights(misses.tall, single, coarse)
            tall = share * (misses.tall - own[self._seen.person]) / (_BOX_SD * coarse)
            wide = share * misses.wide / _BREADTH_SD
            return np.concatenate(
                (tall, wide, leans * misses.lean, own / _HEIGHT_SD, _mounting(state))
            )

        fit = _LEAST_SQUARES(
            weighed, state, diff_step=_STEP, bounds=(_LEAST, _MOST), max_nfev=_STEPS
        )
        return np.asarray(fit.x)

    def _expect(
        self, misses: _Misses, own: Floats, coarse: float, others: float
    ) -> tuple[Floats, Floats]:
        """(n,) probability of being one body, and (n,) logarithm of that of the box.

        Args:
            own: (people,) logarithms of heights over the usual one. coarse: factor of errors.
            others: share of boxes of something else.
        """
        person = self._seen.person
        # All boxes of somebody share in how unusual the height is.
        looks = np.bincount(person, self._weight)[person]
        off = np.square(own[person] / _HEIGHT_SD) / np.maximum(looks, 1.0)
        box_sd, axis_sd = _BOX_SD * coarse, self._axis_sd * min(coarse, _COARSE_LEAN)
        off += np.square((misses.tall - own[person]) / box_sd)
        off += np.square(misses.wide / _BREADTH_SD) + np.square(misses.lean / axis_sd) * self._known
        one = (1.0 - others) * np.exp(-0.5 * off)
        one /= (2 * np.pi) ** 1.5 * box_sd * _BREADTH_SD * axis_sd
        every = one + others * _OTHERS_DENSITY
        return np.asarray(one / every), np.asarray(np.log(every))

    def _own_heights(self, tall: Floats, single: Floats, coarse: float) -> Floats:
        """(people,) logarithm of each one's height over the usual one, known beforehand to 9 cm."""
        weight = single * self._weight / (_BOX_SD * coarse) ** 2
        person = self._seen.person
        total = np.bincount(person, weight) + 1.0 / _HEIGHT_SD**2
        return np.asarray(np.bincount(person, weight * tall) / total)

    def _medians(self, tall: Floats) -> Floats:
        """(people,) medians of what boxes are over what they should be."""
        person = self._seen.person
        return np.array([np.median(tall[person == own]) for own in range(int(person.max()) + 1)])

    def _misses(self, state: State) -> _Misses:
        """How far the boxes are from those of bodies drawn on a floor.

        Bodies lean away from the middle of the image: feet are where drawn boxes end as those
        seen.
        """
        view = View(self._camera, _ground(state))
        width_m = _BODY_WIDTH_M * float(np.exp(state[3]))
        wide, tall = self._seen.box[:, 2:].T
        ends = _ends(self._seen.box)
        foot, ok = ends, np.ones(len(ends), bool)
        for _ in range(_PLACINGS):
            xy = view.floor_from_pixel(foot)
            ok &= np.isfinite(xy).all(axis=1) & (np.hypot(*xy.T) < _FARTHEST_M)
            xy = np.where(ok[:, None], xy, 1.0)
            drawn = view.box_of_person(xy, USUAL_HEIGHT_M, width_m)
            ok &= np.isfinite(drawn).all(axis=1)
            foot = np.where(ok[:, None], foot + ends - _ends(drawn), ends)
        upright = _upright(view, xy)
        ok &= np.isfinite(upright)
        with np.errstate(invalid="ignore", divide="ignore"):
            ratio = np.where(ok, np.log(tall / drawn[:, 3]), 1.0).clip(-1.0, 1.0)
            breadth = np.where(ok, np.log(wide / drawn[:, 2]), 1.0).clip(-1.0, 1.0)
        off = np.where(ok, (self._lean - upright + np.pi / 2) % np.pi - np.pi / 2, 1.0)
        return _Misses(ratio, breadth, off)


def _tilted(degrees: float) -> State:
    return np.array([np.deg2rad(degrees), 0.0, 0.0, 0.0])


def _mounting(state: State) -> Floats:
    """(3,) by how many deviations a floor and its bodies are unusual."""
    return np.array(
        (
            state[1] / _ROLL_SD_RAD,
            (state[2] - np.log(_MOUNTED_M)) / _MOUNTED_SD,
            state[3] / _BODY_WIDTH_SD,
        )
    )


def _ends(box: Floats) -> Floats:
    """(n, 2) where boxes end below, px."""
    return np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))


def _upright(view: View, xy: Floats) -> Floats:
    """(n,) rad between bodies that stand at places (n, 2) m and the image's vertical."""
    low, high = (
        view.pixel_from_world(np.column_stack((xy, np.full(len(xy), z_m))))
        for z_m in (_LOW_M, _HIGH_M)
    )
    return np.asarray(np.arctan2(*(low - high).T))
