"""People on a floor without pictures: exact positions made into detections as a camera errs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, View
from tracking.people import Detections
from tracking.trackers import Observation, Overlays

FPS = 20.0
BINS = 16


def view(height_m: float = 4.0, tilt_deg: float = 40.0) -> View:
    """A VGA camera over the floor."""
    matrix = np.array([[520.0, 0.0, 319.5], [0.0, 520.0, 239.5], [0.0, 0.0, 1.0]])
    return View(Camera(matrix, np.zeros(5), 640, 480), Ground(height_m, tilt_deg))


@dataclass(frozen=True)
class Walker:
    """Somebody whose place is known in every frame; NaN where not there.

    Attributes:
        path: (frames, 2) m. hue: bin of the clothes' colour.
    """

    path: NDArray[np.float64]
    hue: int = 0


def straight(start: Sequence[float], velocity: Sequence[float], frames: int) -> NDArray[np.float64]:
    """A path at constant velocity: (frames, 2) m."""
    return np.asarray(start) + np.arange(frames)[:, None] / FPS * np.asarray(velocity)


@dataclass(frozen=True)
class Errors:
    """What the simulated camera gets wrong.

    Attributes:
        noise_m: of positions, close by; grows with the square of the range by `noise_range`.
        missed: share of people not seen. merged_below_m: people closer to each other come out as
            one merged region. false_alarms: expected number a frame. colour: of histograms.
    """

    noise_m: float = 0.03
    noise_range: float = 0.001
    missed: float = 0.0
    merged_below_m: float = 0.0
    false_alarms: float = 0.0
    colour: float = 0.1


def observations(
    walkers: Sequence[Walker], seed: int = 0, errors: Errors | None = None
) -> Iterator[Observation]:
    """A frame after the other, as a perception would see the walkers."""
    random = np.random.default_rng(seed)
    errors = errors or Errors()
    for frame in range(len(walkers[0].path)):
        there = [w for w in walkers if np.isfinite(w.path[frame]).all()]
        people = _seen(there, frame, random, errors)
        yield Observation(frame, frame / FPS, people, Overlays(np.zeros((1, 1), np.uint8), None))


def _seen(
    walkers: Sequence[Walker], frame: int, random: np.random.Generator, errors: Errors
) -> Detections:
    xy = np.array([w.path[frame] for w in walkers]).reshape(-1, 2)
    hue = np.array([w.hue for w in walkers], int)
    seen = random.random(len(xy)) >= errors.missed
    xy, hue = xy[seen], hue[seen]
    xy, hue, merged = _merged(xy, hue, errors.merged_below_m)
    count = random.poisson(errors.false_alarms)
    wrong = np.column_stack((random.uniform(-3, 3, count), random.uniform(3, 10, count)))
    xy, hue = np.concatenate((xy, wrong)), np.concatenate((hue, random.integers(0, BINS, count)))
    merged = np.concatenate((merged, np.zeros(count, bool)))
    sigma = errors.noise_m + errors.noise_range * np.square(xy).sum(axis=1)
    return detections(
        xy + random.normal(size=xy.shape) * sigma[:, None], hue, merged, random, errors
    )


def _merged(
    xy: NDArray[np.float64], hue: NDArray[np.int64], below_m: float
) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.bool_]]:
    """Pairs closer than `below_m` become one region in their middle."""
    keep, merged = np.ones(len(xy), bool), np.zeros(len(xy), bool)
    for a in range(len(xy)):
        for b in range(a + 1, len(xy)):
            if keep[a] and keep[b] and np.hypot(*(xy[a] - xy[b])) < below_m:
                xy[a], keep[b], merged[a] = (xy[a] + xy[b]) / 2, False, True
    return xy[keep], hue[keep], merged[keep]


def detections(
    xy: NDArray[np.float64],
    hue: NDArray[np.int64],
    merged: NDArray[np.bool_],
    random: np.random.Generator,
    errors: Errors,
) -> Detections:
    """People seen at these places."""
    count = len(xy)
    colour = np.full((count, BINS), 0.01)
    colour[np.arange(count), hue] += 1.0
    colour += np.abs(random.normal(size=colour.shape)) * errors.colour
    colour = (colour / colour.sum(axis=1, keepdims=True)).astype(np.float32)
    return Detections(
        box=view().box_of_person(xy, 1.7, 0.5),
        position=np.column_stack((xy, np.full(count, 0.9))),
        size=np.tile((0.5, 1.7), (count, 1)),
        merged=merged,
        truncated=np.zeros(count, bool),
        upper=colour,
        lower=colour,
        middle=colour,
        regions=np.zeros((1, 1), np.int32),
        clothes=_clothes(hue),
        from_detector=np.zeros(len(hue), bool),
    )


def _clothes(hue: NDArray[np.int64]) -> NDArray[np.float32]:
    """(n, 2, 3) CIELAB of middling lightness; each hue bin has its own direction of a and b."""
    angle = hue * 2 * np.pi / BINS
    lab = np.stack((np.full(len(hue), 50.0), 40 * np.cos(angle), 40 * np.sin(angle)), axis=1)
    return np.repeat(lab[:, None], 2, axis=1).astype(np.float32)
