"""What others would do for a frame, timed on the same frames as the pipeline, on one thread.

`Primitives` and `OneCamera` are the library calls that a pipeline cannot do without, and nothing
else; `Obvious` is the way that comes to mind first. Each tells how long its parts took, decoding
aside.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Rectification
from tracking.recording import Recording, StereoFrame
from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines

T = TypeVar("T")
Picture = NDArray[np.uint8]
Floats = NDArray[np.float64]

_DISPARITIES = 64
_LEAST_REGION_PX = 150
"""Smaller regions are specks; people of these scenes have several times as many pixels."""
_BINS = (16, 4)
_POINTS = 300
_WINDOW_PX = 9
_ELAPSED_S, _SPREAD_M, _SIGMA_M, _GATE_M = 0.05, 0.06, 0.15, 0.9
"""Of the particle filters."""


class Timed:
    """Parts of work with the processor seconds each took.

    Attributes:
        spent_s: by part, of the frame looked at last.
    """

    def __init__(self) -> None:
        self.spent_s: dict[str, float] = {}

    def __call__(self, frame: StereoFrame, people: int) -> object:
        """One frame, in which so many people are followed."""
        raise NotImplementedError

    def _timed(self, part: str, work: Callable[..., T], *given: Any) -> T:
        begun = time.process_time()
        done = work(*given)
        self.spent_s[part] = self.spent_s.get(part, 0.0) + time.process_time() - begun
        return done


class Primitives(Timed):
    """The bare primitives of the pipeline: background, block matching, regions, histograms.

    The background is subtracted from both cameras in colour, as subtraction stereo has it, by MOG2
    without its search for shadows. StereoBM matches as the pipeline does: inside the box round the
    foreground, rows halved, only the disparities that people can have in the scene. Components of
    the left foreground and a histogram of each make the rest. Nobody is told apart, placed on the
    floor or followed.
    """

    def __init__(self, recording: Recording) -> None:
        super().__init__()
        self._rectification = _rectification(recording)
        self._least, self._count = _search(self._rectification)
        self._images = [cv2.createBackgroundSubtractorMOG2(detectShadows=False) for _ in range(2)]
        self._matcher = cv2.StereoBM.create(self._count, _WINDOW_PX)
        self._matcher.setMinDisparity(self._least)

    def __call__(self, frame: StereoFrame, people: int) -> object:
        """One frame; how many people are in view is no matter here."""
        del people
        self.spent_s = {}
        images = _rectified(self._rectification, frame)
        mask, _ = self._timed("subtraction", _subtracted, self._images, images)
        disparity = self._timed("matching", self._matched, images, mask)
        labels, stats, _ = self._timed("regions", _regions, mask)
        found = self._timed("histograms", _histograms, images[0], labels, stats, _large(stats))
        return disparity, found

    def _matched(self, images: tuple[Picture, Picture], mask: Picture) -> object:
        x, y, width, height = cv2.boundingRect(mask)
        if width == 0:
            return None
        before = self._least + self._count + _WINDOW_PX
        around = 2 * _WINDOW_PX
        rows = slice(max(0, y - around), y + height + around)
        cut = rows, slice(max(0, x - before), x + width + _WINDOW_PX)
        left, right = (
            _rows_halved(cv2.cvtColor(image[cut], cv2.COLOR_BGR2GRAY)) for image in images
        )
        return self._matcher.compute(left, right)


class OneCamera(Timed):
    """The bare primitives with one camera: MOG2 of its picture, and corners where they are needed.

    Args:
        corners: 300 points are followed from frame to frame, and found anew where they are lost.
    """

    def __init__(self, recording: Recording, *, corners: bool) -> None:
        super().__init__()
        del recording
        self._model = cv2.createBackgroundSubtractorMOG2(detectShadows=False)
        self._corners, self._points = corners, np.empty((0, 1, 2), np.float32)
        self._before: Picture | None = None

    def __call__(self, frame: StereoFrame, people: int) -> object:
        """One frame; how many people are in view is no matter here."""
        del people
        self.spent_s = {}
        mask = self._timed("subtraction", self._model.apply, frame.left)
        return self._timed("corners", self._follow, frame.left, mask) if self._corners else mask

    def _follow(self, image: Picture, mask: Picture) -> None:
        grey = np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), np.uint8)
        if self._before is not None and len(self._points):
            moved, found, _ = cv2.calcOpticalFlowPyrLK(self._before, grey, self._points, None)
            self._points = moved[found.ravel() == 1]
        if missing := _POINTS - len(self._points):
            more = cv2.goodFeaturesToTrack(grey, missing, 0.01, 5.0, mask=mask)
            if more is not None:
                self._points = np.concatenate((self._points, more))
        self._before = grey


class Obvious(Timed):
    """The obvious way: MOG2 with shadows on both cameras, SGBM, regions, filters.

    Everything is done on whole pictures at their full size. SGBM searches 64 disparities,
    more where people can have more, with the other parameters of OpenCV's own example. What is
    foreground and has a disparity is opened
    and cut into regions, each placed on the floor by its median disparity. A particle filter for
    each person (`PersonFilters`) then follows the nearest of them by place and colour.

    Args:
        particles: of each filter.
    """

    def __init__(self, recording: Recording, particles: int) -> None:
        super().__init__()
        self._rectification = _rectification(recording)
        least, count = _search(self._rectification)
        searched = max(count, _DISPARITIES)
        self._least = max(0, least + count - searched)
        self._images = [cv2.createBackgroundSubtractorMOG2(detectShadows=True) for _ in range(2)]
        self._matcher = cv2.StereoSGBM.create(
            self._least, searched, 5, P1=8 * 25, P2=32 * 25, disp12MaxDiff=1,
            uniquenessRatio=10, speckleWindowSize=100, speckleRange=32,
        )  # fmt: skip
        self._filters = PersonFilters(particles)

    def __call__(self, frame: StereoFrame, people: int) -> object:
        """One frame, in which so many people are followed."""
        self.spent_s = {}
        images = _rectified(self._rectification, frame)
        mask, there = self._timed("subtraction", _subtracted, self._images, images)
        disparity = self._timed("matching", self._matched, images)
        seen = self._timed("regions", self._placed, images[0], mask, there, disparity)
        return self._timed("filters", self._filters.step, seen, people)

    def _matched(self, images: tuple[Picture, Picture]) -> NDArray[np.int16]:
        left, right = (cv2.cvtColor(image, cv2.COLOR_BGR2GRAY) for image in images)
        return np.asarray(self._matcher.compute(left, right), np.int16)

    def _placed(
        self, left: Picture, mask: Picture, there: Picture, disparity: NDArray[np.int16]
    ) -> Seen:
        """Regions of what both cameras see as new, on the floor, with their colours."""
        known = np.asarray(cv2.compare(disparity, 16 * self._least, cv2.CMP_GE), np.uint8)
        labels, stats, centres = _regions(np.asarray(cv2.bitwise_and(mask, known), np.uint8))
        median = {k: _median(labels, stats[k], k, disparity) for k in _large(stats)}
        kept = [k for k in median if _both_see(there, centres[k], median[k])]
        u, v = centres[kept].T
        d = np.array([median[k] for k in kept])
        places = self._rectification.world_from_disparity(u, v, d)
        return Seen(places[:, :2], _histograms(left, labels, stats, kept))


def _rectification(recording: Recording) -> Rectification:
    assert recording.rectification is not None
    return recording.rectification


def _rectified(rectification: Rectification, frame: StereoFrame) -> tuple[Picture, Picture]:
    assert frame.right is not None
    return rectification.rectify(frame.left, frame.right)


def _subtracted(
    models: list[cv2.BackgroundSubtractorMOG2], images: tuple[Picture, Picture]
) -> tuple[Picture, Picture]:
    """Foreground of both cameras, 255, shadows left out."""
    left, right = (
        np.asarray(model.apply(image), np.uint8)
        for model, image in zip(models, images, strict=True)
    )
    return (
        np.asarray(cv2.compare(left, 255, cv2.CMP_EQ), np.uint8),
        np.asarray(cv2.compare(right, 255, cv2.CMP_EQ), np.uint8),
    )


def _rows_halved(image: cv2.typing.MatLike) -> cv2.typing.MatLike:
    size = (image.shape[1], -(-image.shape[0] // 2))
    return cv2.resize(image, size, interpolation=cv2.INTER_AREA)


def _regions(mask: Picture) -> tuple[NDArray[np.int32], NDArray[np.int32], NDArray[np.float64]]:
    """Labels, boxes with areas, and centres of connected regions, specks opened away."""
    opened = cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    _, labels, stats, centres = cv2.connectedComponentsWithStats(opened)
    return np.asarray(labels, np.int32), np.asarray(stats, np.int32), np.asarray(centres)


def _large(stats: NDArray[np.int32]) -> list[int]:
    """The regions that may be people; 0 is the background."""
    area = stats[:, cv2.CC_STAT_AREA]
    return [k for k in range(1, len(area)) if area[k] >= _LEAST_REGION_PX]


def _cut(row: NDArray[np.int32]) -> tuple[slice, slice]:
    x, y, width, height = row[:4].tolist()
    return slice(y, y + height), slice(x, x + width)


def _median(
    labels: NDArray[np.int32], row: NDArray[np.int32], label: int, disparity: NDArray[np.int16]
) -> float:
    """A region's median disparity, px."""
    box = _cut(row)
    return float(np.median(disparity[box][labels[box] == label])) / 16


def _both_see(there: Picture, centre: NDArray[np.float64], disparity: float) -> bool:
    """Whether the right camera sees something new where a region's middle should be."""
    u, v = round(float(centre[0]) - disparity), round(float(centre[1]))
    return 0 <= u < there.shape[1] and bool(there[v, u])


def _histograms(
    left: Picture,
    labels: NDArray[np.int32],
    stats: NDArray[np.int32],
    chosen: list[int],
) -> NDArray[np.float32]:
    """(chosen, bins) hue and saturation of some regions, rows summing to 1."""
    found = np.zeros((len(chosen), _BINS[0] * _BINS[1]), np.float32)
    for row, label in enumerate(chosen):
        box = _cut(stats[label])
        own = (labels[box] == label).view(np.uint8)
        colours = cv2.cvtColor(left[box], cv2.COLOR_BGR2HSV)
        counted = cv2.calcHist([colours], [0, 1], own, list(_BINS), [0, 180, 0, 256])
        found[row] = counted.ravel() / max(float(counted.sum()), 1.0)
    return found


def _search(rectification: Rectification) -> tuple[int, int]:
    """The least disparity of the floor, and how many there are up to the tallest person's head."""
    lines, settings = SightLines(rectification), StereoSettings()
    near, far = settings.nearest_m, settings.farthest_m
    least = int(lines.disparity_at_height(0.0, near, far).min())
    most = int(np.ceil(lines.disparity_at_height(settings.max_height_m, near, far).max()))
    return least, -(-(most - least + 1) // 16) * 16


@dataclass(frozen=True, slots=True)
class Seen:
    """Regions of a frame: places (k, 2) m on the floor, colours (k, bins) histograms."""

    place: Floats
    colour: NDArray[np.float32]


class PersonFilter:
    """Follows one person: predict, weigh by place and colour, estimate, resample.

    The particles of the one person are arrays: a loop over single particles would cost a hundred
    times as much, and nobody with NumPy at hand writes one.
    """

    def __init__(self, place: Floats, colour: NDArray[np.float32], particles: int) -> None:
        self._random = np.random.default_rng(0)
        self._particles = place + self._random.normal(0.0, 0.25, (particles, 2))
        self._velocity = np.zeros(2)
        self._colour = colour
        self.place = place

    def step(self, seen: Seen) -> None:
        """One frame: of the regions near by, the one most like this person."""
        count = len(self._particles)
        self._particles += self._velocity * _ELAPSED_S
        self._particles += self._random.normal(0.0, _SPREAD_M, (count, 2))
        weight = np.full(count, 1.0 / count)
        away = np.linalg.norm(seen.place - self.place, axis=1)
        if len(away) and away.min() < _GATE_M:
            alike = np.sqrt(self._colour * seen.colour).sum(axis=1)
            cost = 2.0 * away + np.sqrt(np.clip(1.0 - alike, 0.0, 1.0))
            k = int(np.where(away < _GATE_M, cost, np.inf).argmin())
            weight = self._weights(seen.place[k])
            self._colour = 0.97 * self._colour + 0.03 * seen.colour[k]
        before, self.place = self.place, weight @ self._particles
        self._velocity += 0.2 * ((self.place - before) / _ELAPSED_S - self._velocity)
        steps = (np.arange(count) + self._random.random()) / count
        chosen = np.searchsorted(np.cumsum(weight), steps).clip(max=count - 1)
        self._particles = self._particles[chosen]

    def _weights(self, place: Floats) -> Floats:
        squared = ((self._particles - place) ** 2).sum(axis=1)
        weight = np.exp(-0.5 * (squared - squared.min()) / _SIGMA_M**2)
        return np.asarray(weight / weight.sum())


class PersonFilters:
    """As many filters as there are people.

    Args:
        particles: of each.
    """

    def __init__(self, particles: int) -> None:
        self._particles = particles
        self._filters: list[PersonFilter] = []

    def step(self, seen: Seen, people: int) -> list[Floats]:
        """Where each person is; newcomers begin at a region, leavers are those followed longest."""
        del self._filters[: max(0, len(self._filters) - people)]
        for k in range(min(people - len(self._filters), len(seen.place))):
            self._filters.append(PersonFilter(seen.place[k], seen.colour[k], self._particles))
        for one in self._filters:
            one.step(seen)
        return [one.place for one in self._filters]
