"""How fast spheroids are judged and people followed by them, on one core."""

from __future__ import annotations

import cv2
import numpy as np

from tests.benchmarks.timing import Stopwatch, least_ms
from tracking.geometry import Camera, FlatView, Ground, View, standing_ellipses
from tracking.recording.frame import StereoFrame
from tracking.trackers.spheroid import SpheroidPerception, SpheroidSettings
from tracking.trackers.spheroid.hypotheses import SpheroidPeople, begin_people
from tracking.trackers.spheroid.hypothesis_scores import JudgedFrame, count_covering
from tracking.trackers.spheroid.tracker import SpheroidTracker
from tracking.trackers.spheroid.weights import judge_and_weigh, silhouettes

PEOPLE = (1, 5, 10, 20)
HYPOTHESES = 300
FPS = 20.0
_ROUNDS = 40
_FRAMES, _WARM = 80, 20


def measure() -> dict[str, float | None]:
    """Milliseconds of processor time, the best of several rounds, and frames a second.

    `likelihoods_ms_k`: of the weights of k people with 300 hypotheses each at 640x480.
    `fps`: perception and tracker together with ten people in the picture, decoded frames in.
    `ms_a_person` and `linear_r2`: slope of the likelihoods' cost over the people, and how well a
    straight line fits it.
    """
    cv2.setNumThreads(1)
    found = {people: _likelihoods_ms(people) for people in PEOPLE}
    slope, start = np.polyfit(PEOPLE, list(found.values()), 1)
    fitted = start + slope * np.array(PEOPLE)
    measured = np.array(list(found.values()))
    spread = float(((measured - measured.mean()) ** 2).sum())
    return {
        **{f"likelihoods_ms_{people}": ms for people, ms in found.items()},
        "ms_a_person": float(slope),
        "linear_r2": 1.0 - float(((measured - fitted) ** 2).sum()) / spread,
        "fps": _fps(10),
    }


def _view() -> View:
    matrix = np.array([[520.0, 0.0, 319.5], [0.0, 520.0, 239.5], [0.0, 0.0, 1.0]])
    return View(Camera(matrix, np.zeros(5), 640, 480), Ground(6.4, 60.0))


def _places(people: int) -> np.ndarray:
    """(people, 2) m, a net in view."""
    across = np.linspace(-2.4, 2.4, 5)
    ahead = np.linspace(1.6, 6.4, max(1, -(-people // 5)))
    net = np.array([(x, y) for y in ahead for x in across])
    return net[:people]


def _likelihoods_ms(people: int) -> float:
    flat = FlatView(_view())
    settings = SpheroidSettings(particles=HYPOTHESES)
    random = np.random.default_rng(5101)
    mean = np.column_stack((_places(people), np.zeros((people, 2))))
    track = np.arange(1, people + 1, dtype=np.int32)
    tall = np.full(people, 1.72)
    followed = begin_people(track, mean, tall, 0.05, HYPOTHESES, (0.12, 0.3), random)
    ramp = random.integers(0, 256, flat.size[::-1], dtype=np.uint8)
    counted = np.ones(ramp.shape, bool)

    def weigh() -> SpheroidPeople:
        own = silhouettes(followed, flat, settings)
        evidence = JudgedFrame(ramp, counted, count_covering(ramp.shape, own))
        return judge_and_weigh(followed, evidence, flat, settings)[0]

    return least_ms(weigh, _ROUNDS)


def _fps(people: int) -> float:
    view = _view()
    perception = SpheroidPerception(FPS, view)
    settings = SpheroidSettings(particles=HYPOTHESES)
    tracker = SpheroidTracker(perception, settings, perception.flat.covered, 0)
    frames = _walking(view, people)
    perception.learn([frames[0]])
    watch, followed = Stopwatch(), 0
    for frame in frames[1:]:
        if frame.number == _WARM:
            watch, followed = Stopwatch(), 0
        with watch:
            result = tracker.step(perception.observe(frame))
        followed += len(result.tracks["track"])
    counted = _FRAMES - _WARM
    if followed < 0.9 * people * counted:
        raise RuntimeError(f"only {followed / counted:.1f} of {people} people were followed")
    return counted / watch.total_s


def _walking(view: View, people: int) -> list[StereoFrame]:
    """An empty frame and others in which people walk on the spot, a little to and fro."""
    flat = FlatView(view)
    random = np.random.default_rng(5102)
    floor = random.integers(110, 160, (48, 64, 3)).astype(np.uint8)
    floor = np.asarray(cv2.resize(floor, (640, 480), interpolation=cv2.INTER_NEAREST))
    colours = random.integers(0, 90, (people, 3))
    frames = [StereoFrame(0, 0.0, floor, None)]
    for number in range(1, _FRAMES):
        picture = floor.copy()
        sway = 0.25 * np.sin(0.3 * number + np.arange(people))
        xy = _places(people) + np.column_stack((sway, np.zeros(people)))
        outlines = standing_ellipses(flat.projection, xy, np.full(people, 1.72), 0.22)
        for outline, colour in zip(outlines.polygons(40), colours, strict=True):
            corners = np.rint(outline).astype(np.int32)
            cv2.fillPoly(picture, [corners], [int(part) for part in colour])
        noise = random.integers(-3, 4, picture.shape, dtype=np.int16)
        seen = np.clip(picture + noise, 0, 255).astype(np.uint8)
        frames.append(StereoFrame(number, number / FPS, seen, None))
    return frames
