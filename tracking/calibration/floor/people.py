"""The floor from people who walk over it, seen by one camera: heights give the metre."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares, linear_sum_assignment

from tracking.arrays import Floats
from tracking.calibration.floor.estimate import FloorEstimate, check_above, estimate_of
from tracking.errors import CalibrationError
from tracking.geometry import Camera, Ground, View
from tracking.people import SingleCameraPerception
from tracking.progress import Progress, no_progress
from tracking.recording import Recording
from tracking.tracks.boxes import overlaps
from tracking.translation import Message, msg

_LEAST_SQUARES: Any = least_squares
"""Its stubs take no plain floats and functions."""
USUAL_HEIGHT_M = 1.73
"""Mean body height of grown-ups, with 3 cm of shoes."""
_HEIGHT_SD = 0.053
"""Of body heights, as a share (9 cm)."""
_BODY_WIDTH_M = 0.5
_BOX_ERROR, _BREADTH_ERROR = 0.02, 0.3
"""Of heights and widths of boxes, as shares: strides, limbs and shadows."""
_PLACINGS, _FARTHEST_M = 3, 200.0
"""Rounds in which feet are placed; nobody is seen farther away."""
_LOOKS = 600
"""Frames looked at, at most."""
_LOOK_EVERY_S = 0.15
_MOST_BOXES, _SEARCHED = 1200, 300
"""Boxes that count in the end, and that a floor is searched by."""
_FEWEST_PEOPLE, _FEWEST_AREAS = 4, 4
"""Passages, and cells of the image (of 4 x 4) that people stand in."""
_FEW_BOXES, _MOST_AGREE = 100, 0.6
"""Boxes that a floor must explain, and their share of all, so that it is not doubtful."""
_SHORTEST_PASSAGE = 5
"""Boxes of somebody: fewer show no change with the place."""
_SAME_OVERLAP = 0.25
"""Boxes of one person from one look to the next have this in common at least."""
_SLIMMEST, _WIDEST = 0.15, 0.9
"""Width over height of a box of one person."""
_LOWEST_SHARE = 0.06
"""Of the image's height: lower boxes say too little."""
_STARTS_DEG = (5.0, 20.0, 40.0, 60.0, 80.0)
_STEADY, _TALLEST, _SELECTIONS = 0.04, 0.2, 3
"""Change of a person's height on the way that is still one person's, and how far from the usual one
people are, as shares; rounds of choosing them by the floor found so far."""
_STEP = 1e-4
_ROLL_SD_RAD = float(np.deg2rad(4.0))
_MOUNTED_M, _MOUNTED_SD = 4.0, 0.7
"""How cameras are mounted, as far as people do not tell: level, and between head height and a first
floor (deviation of the height's logarithm)."""
_BOOTSTRAPS = 8

Boxes = Floats  # (n, 4) left, top, width, height in px as recorded


@dataclass(frozen=True, slots=True)
class PeopleSeen:
    """Boxes of single people in an image, and where they were seen.

    Attributes:
        box: (n, 4) px. frame: (n,). person: (n,) number of the passage, from 0.
    """

    box: Boxes
    frame: NDArray[np.intp]
    person: NDArray[np.intp]

    def select(self, rows: NDArray[np.intp]) -> PeopleSeen:
        """Those at these rows."""
        return PeopleSeen(self.box[rows], self.frame[rows], self.person[rows])


def floor_by_people(recording: Recording, progress: Progress = no_progress) -> FloorEstimate:
    """The floor on which people of usual height stand, of a calibrated camera.

    People are found by the foreground alone and followed from look to look. Whoever walks keeps a
    height of their own, which is 1.73 m give or take 9 cm: the floor is the one on which drawn
    bodies fill the boxes, wherever they stand.

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
    return floor_of_people(recording.calibration.left, people_seen(recording, progress))


def people_seen(recording: Recording, progress: Progress = no_progress) -> PeopleSeen:
    """Boxes of people who stand alone and whole in the left image."""
    perception = SingleCameraPerception(recording.fps, looked_at=recording.looked_at)
    samples = np.linspace(0, recording.frame_count - 1, min(20, recording.frame_count))
    perception.learn([recording.read(int(number)) for number in np.unique(samples.astype(int))])
    every = max(1, round(_LOOK_EVERY_S * recording.fps), recording.frame_count // _LOOKS)
    passages = _Passages()
    for frame in recording.frames():
        if frame.number % every:
            continue
        people = perception.observe(frame).people
        good = _single(people.box, recording.size) & ~people.truncated
        passages.add(frame.number, people.box[good])
        progress(frame.number + 1, recording.frame_count)
    return passages.long_ones()


class _Passages:
    """Boxes linked from look to look by what they have in common."""

    def __init__(self) -> None:
        self._box, self._person = np.zeros((0, 4)), np.zeros(0, np.intp)
        self._count = 0
        self._kept: list[tuple[int, int, Floats]] = []

    def add(self, frame: int, box: Boxes) -> None:
        """The boxes (n, 4) of the next look."""
        shared = overlaps(self._box[:, None], box[None])
        before, now = linear_sum_assignment(shared, maximize=True)
        same = shared[before, now] >= _SAME_OVERLAP
        before, now = before[same], now[same]
        person = np.full(len(box), -1)
        person[now] = self._person[before]
        new = person < 0
        person[new] = self._count + np.arange(int(new.sum()))
        self._count += int(new.sum())
        self._box, self._person = box, person
        self._kept += [(frame, int(own), one) for own, one in zip(person, box, strict=True)]

    def long_ones(self) -> PeopleSeen:
        """Those seen often enough."""
        frame = np.array([row[0] for row in self._kept], np.intp)
        person = np.array([row[1] for row in self._kept], np.intp)
        box = np.array([row[2] for row in self._kept]).reshape(-1, 4)
        often = np.bincount(person, minlength=1)[person] >= _SHORTEST_PASSAGE
        seen = PeopleSeen(box, frame, person).select(np.flatnonzero(often))
        return PeopleSeen(seen.box, seen.frame, np.unique(seen.person, return_inverse=True)[1])


def _single(box: Boxes, size: tuple[int, int]) -> NDArray[np.bool_]:
    """(n,) boxes of the shape of one person, away from the image's edge."""
    width, height = size
    left, top, wide, tall = box.T
    margin = 3.0
    inside = (left > margin) & (top > margin) & (left + wide < width - margin)
    inside &= top + tall < height - margin
    shape = wide / np.maximum(tall, 1e-6)
    return np.asarray(
        inside & (tall > _LOWEST_SHARE * height) & (shape > _SLIMMEST) & (shape < _WIDEST)
    )


def floor_of_people(camera: Camera, seen: PeopleSeen) -> FloorEstimate:
    """The floor on which people of usual height fill these boxes.

    Raises:
        CalibrationError: too few boxes, or all at one place.
    """
    box = seen.box
    if len(box) > _MOST_BOXES:
        seen = seen.select(np.linspace(0, len(box) - 1, _MOST_BOXES).astype(int))
        box = seen.box
    foot = np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))
    cells = np.unique((foot * 4 // camera.size).astype(int).clip(0, 3), axis=0)
    people = len(np.unique(seen.person))
    if people < _FEWEST_PEOPLE or len(cells) < _FEWEST_AREAS:
        raise CalibrationError(
            "floor: {count} people are seen to walk alone, in {areas} parts of the image; longer "
            "footage with people in more places is needed, or points on the floor",
            count=people,
            areas=len(cells),
        )
    state = _fitted(camera, _thinned(seen))
    for _ in range(_SELECTIONS):
        state = _fitted(camera, _thinned(_steady(camera, seen, state)), [state])
    every, seen = len(seen.box), _steady(camera, seen, state)
    notes = _notes(len(seen.box), every)
    state = _fitted(camera, seen, [state])
    seen = _thinned(seen)
    ground = _ground(state)
    check_above(ground.height_m)
    spread = _bootstrap(camera, seen, state)
    # The mean height of few people may differ from that of all.
    share = float(np.hypot(spread[2], _HEIGHT_SD / np.sqrt(people)))
    lean_deg = float(np.rad2deg(np.hypot(spread[0], spread[1]) / np.sqrt(2)))
    up = np.array(ground.world_from_camera[0][2])
    return estimate_of(up, ground.height_m, "people", share * ground.height_m, lean_deg, notes)


def _notes(agree: int, every: int) -> tuple[Message, ...]:
    """What makes a floor doubtful: few boxes, or many that it does not explain."""
    if agree >= max(_FEW_BOXES, _MOST_AGREE * every):
        return ()
    return (
        msg(
            "only {agree} boxes of people, of {every}, agree with this floor: look at the grid "
            "before you trust it, or click points on the floor",
            agree=agree,
            every=every,
        ),
    )


def _fitted(camera: Camera, seen: PeopleSeen, starts: Sequence[Floats] | None = None) -> Floats:
    """(3,) tilt and roll in rad, and the logarithm of the height in m."""
    starts = _starts() if starts is None else starts
    fits = [
        _LEAST_SQUARES(
            lambda state: _misses(camera, seen, state),
            start,
            diff_step=_STEP,
            bounds=([-0.5, -0.6, np.log(0.3)], [np.pi / 2, 0.6, np.log(50.0)]),
        )
        for start in starts
    ]
    return np.asarray(min(fits, key=lambda fit: fit.cost).x)


def _thinned(seen: PeopleSeen) -> PeopleSeen:
    """As many boxes as are looked at in a search; each passage keeps its share."""
    every = max(1, len(seen.box) // _SEARCHED)
    return seen.select(np.arange(0, len(seen.box), every))


def _starts() -> list[Floats]:
    return [np.array([np.deg2rad(tilt), 0.0, np.log(4.0)]) for tilt in _STARTS_DEG]


def _ground(state: Floats) -> Ground:
    tilt, roll, height = state
    return Ground(float(np.exp(height)), float(np.rad2deg(tilt)), float(np.rad2deg(roll)))


def _misses(camera: Camera, seen: PeopleSeen, state: Floats) -> Floats:
    """By how many deviations a floor misses: (n,) heights, (n,) widths, (people,), (2,) mounting.

    Heights and widths are those of drawn people beside their boxes. Each passage has a height of
    its own; next come how far these are from the usual one, and the mounting from usual ones.
    """
    view = View(camera, _ground(state))
    left, top, wide, tall = seen.box.T
    ends = np.column_stack((left + wide / 2, top + tall))
    foot, ok = ends, np.ones(len(ends), bool)
    # Bodies lean away from the middle of the image: feet are where drawn boxes end as those seen.
    for _ in range(_PLACINGS):
        xy = view.floor_from_pixel(foot)
        ok &= np.isfinite(xy).all(axis=1) & (np.hypot(*xy.T) < _FARTHEST_M)
        drawn = view.box_of_person(np.where(ok[:, None], xy, 1.0), USUAL_HEIGHT_M, _BODY_WIDTH_M)
        ok &= np.isfinite(drawn).all(axis=1)
        drawn_ends = np.column_stack((drawn[:, 0] + drawn[:, 2] / 2, drawn[:, 1] + drawn[:, 3]))
        foot = np.where(ok[:, None], foot + ends - drawn_ends, ends)
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(ok, np.log(tall / drawn[:, 3]), 1.0).clip(-1.0, 1.0)
        breadth = np.where(ok, np.log(wide / drawn[:, 2]), 1.0).clip(-1.0, 1.0)
    own, number = _own_heights(ratio, seen.person)
    often = np.bincount(number)[number]
    # A passage is one look at a body, however many frames it has.
    weight = np.sqrt(_SHORTEST_PASSAGE / often)
    misses = ((ratio - own[number]) / _BOX_ERROR, breadth / _BREADTH_ERROR)
    # Boxes are wrong now and then, and passages of two who walk as one: Cauchy's loss.
    sure = [weight * _cauchy(miss) for miss in misses]
    mounting = state[1] / _ROLL_SD_RAD, (state[2] - np.log(_MOUNTED_M)) / _MOUNTED_SD
    return np.concatenate((*sure, _cauchy(own / _HEIGHT_SD), mounting))


def _cauchy(miss: Floats) -> Floats:
    return np.asarray(np.sign(miss) * np.sqrt(np.log1p(miss**2)))


def _steady(camera: Camera, seen: PeopleSeen, state: Floats) -> PeopleSeen:
    """Those whose height hardly changes as they walk, and is one of people."""
    misses = _misses(camera, seen, state)[: len(seen.box)]
    number = np.unique(seen.person, return_inverse=True)[1]
    often = np.bincount(number)
    weight = np.sqrt(_SHORTEST_PASSAGE / often)[number]
    raw = np.sqrt(np.expm1(np.minimum((misses / weight) ** 2, 20.0))) * _BOX_ERROR
    off = np.array([np.median(raw[number == own]) for own in range(len(often))])
    own = _misses(camera, seen, state)[2 * len(seen.box) : -2]
    height = np.sqrt(np.expm1(np.minimum(own**2, 20.0))) * _HEIGHT_SD
    good = (off < _STEADY) & (height < _TALLEST)
    return seen.select(np.flatnonzero(good[number])) if good.sum() >= _FEWEST_PEOPLE else seen


def _own_heights(ratio: Floats, person: NDArray[np.intp]) -> tuple[Floats, NDArray[np.intp]]:
    """(people,) logarithm of each one's height over the usual one, and (n,) whose each box is."""
    _, number = np.unique(person, return_inverse=True)
    order = np.lexsort((ratio, number))
    starts = np.flatnonzero(np.diff(number[order], prepend=-1))
    counts = np.diff(np.append(starts, len(order)))
    own = ratio[order][starts + counts // 2]
    return own * _HEIGHT_SD**2 / (_HEIGHT_SD**2 + _BOX_ERROR**2 / _SHORTEST_PASSAGE), number


def _bootstrap(camera: Camera, seen: PeopleSeen, state: Floats) -> Floats:
    """(3,) standard deviations by drawing people again."""
    random = np.random.default_rng(0)
    numbers = np.unique(seen.person)
    found = []
    for _ in range(_BOOTSTRAPS):
        drawn = random.choice(numbers, len(numbers))
        rows = [np.flatnonzero(seen.person == number) for number in drawn]
        again = seen.select(np.concatenate(rows))
        person = np.repeat(np.arange(len(rows)), [len(own) for own in rows])
        found.append(_fitted(camera, PeopleSeen(again.box, again.frame, person), [state]))
    return np.asarray(np.std(found, axis=0))
