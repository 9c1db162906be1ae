"""From recorded frames to people: rendered ones against truth, real ones by eye."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from tracking.errors import RecordingError
from tracking.geometry import Camera, Ground, Rectification, StereoCalibration
from tracking.people import Observation, StereoPerception
from tracking.people.detection_source import FrameDetections
from tracking.recording import Recording, open_recording
from tracking.recording.frame import StereoFrame

Floats = NDArray[np.float64]
LEARNT_FROM = 12


def prepared(recording: Recording) -> StereoPerception:
    """Perception that knows the background, as the pipeline makes it."""
    assert recording.rectification is not None
    assert recording.ground is not None
    perception = StereoPerception(recording.rectification, recording.ground, recording.fps)
    numbers = np.linspace(0, recording.frame_count - 1, LEARNT_FROM).astype(int)
    perception.learn([recording.read(int(n)) for n in numbers])
    return perception


def observed(folder: Path, start: int, stop: int) -> Iterator[Observation]:
    with open_recording(folder) as recording:
        perception = prepared(recording)
        for frame in recording.frames(start, stop):
            yield perception.observe(frame)


def truth_of(folder: Path) -> dict[int, Floats]:
    """Frame (from 0) to rows left, top, width, height, x, y of people seen well enough."""
    rows = np.loadtxt(folder / "truth.txt", delimiter=",")
    rows = rows[rows[:, 6] == 1]
    rows[:, 2:4] -= 1
    return {int(n) - 1: rows[rows[:, 0] == n][:, [2, 3, 4, 5, 7, 8]] for n in np.unique(rows[:, 0])}


def overlap(one: Floats, other: Floats) -> float:
    low = np.maximum(one[:2], other[:2])
    high = np.minimum(one[:2] + one[2:], other[:2] + other[2:])
    shared = float(np.prod(np.maximum(high - low, 0)))
    return shared / (float(np.prod(one[2:]) + np.prod(other[2:])) - shared)


def compare(folder: Path, start: int, stop: int) -> tuple[float, float, float, float]:
    """Recall, precision, mean floor error in metres and share of boxes that overlap by half."""
    truth = truth_of(folder)
    wanted = found = 0
    errors: list[float] = []
    overlaps: list[float] = []
    for seen in observed(folder, start, stop):
        real = truth.get(seen.frame, np.zeros((0, 6)))
        wanted, found = wanted + len(real), found + len(seen.people)
        apart = np.hypot(
            *(real[:, None, 4:] - seen.people.position[None, :, :2]).transpose(2, 0, 1)
        )
        for i, j in zip(*linear_sum_assignment(np.minimum(apart, 0.6)), strict=True):
            if apart[i, j] < 0.6:
                errors.append(float(apart[i, j]))
                overlaps.append(overlap(real[i, :4], seen.people.box[j]))
    half = float(np.mean(np.array(overlaps) >= 0.5))
    return len(errors) / wanted, len(errors) / found, float(np.mean(errors)), half


@pytest.mark.parametrize(("name", "recall"), [("rendered-lobby", 0.93), ("rendered-plaza", 0.85)])
def test_people_come_out_where_they_are(shared_data: Path, name: str, recall: float) -> None:
    reached, precision, error_m, half = compare(shared_data / name, 260, 360)
    assert reached > recall
    assert precision > 0.95
    assert error_m < 0.10
    assert half > 0.9


def test_the_empty_lobby_holds_nobody(shared_data: Path) -> None:
    assert all(len(o.people) == 0 for o in observed(shared_data / "rendered-lobby", 0, 30))


@pytest.fixture(scope="module")
def below_the_camera(shared_data: Path) -> dict[int, Observation]:
    """Every second frame of real footage: nobody at first, then a passage from left to right."""
    with open_recording(shared_data / "overhead-real") as recording:
        perception = prepared(recording)
        frames = [*range(140, 170, 2), *range(232, 262, 2)]
        return {n: perception.observe(recording.read(n)) for n in frames}


def test_a_real_passage_below_the_camera_is_one_person_all_the_way(
    below_the_camera: dict[int, Observation],
) -> None:
    people = [seen.people for n, seen in below_the_camera.items() if n >= 232]
    alone = [seen.position[0, 0] for seen in people if len(seen) == 1]
    assert len(alone) > 0.85 * len(people)
    assert np.all(np.diff(alone[::3]) > 0)


def test_hard_shadows_and_sun_flecks_are_nobody(
    below_the_camera: dict[int, Observation],
) -> None:
    assert sum(len(seen.people) for n, seen in below_the_camera.items() if n < 200) == 0


def test_the_same_frames_give_the_same_people(shared_data: Path) -> None:
    folder = shared_data / "rendered-lobby"
    for one, other in zip(observed(folder, 300, 304), observed(folder, 300, 304), strict=True):
        np.testing.assert_array_equal(one.people.position, other.people.position)
        np.testing.assert_array_equal(one.people.regions, other.people.regions)


def test_overlays_have_the_size_of_the_recording(shared_data: Path) -> None:
    with open_recording(shared_data / "overhead-real") as recording:
        assert recording.rectification is not None
        assert recording.ground is not None
        perception = StereoPerception(recording.rectification, recording.ground, recording.fps)
        for frame in recording.frames(60, 63):
            seen = perception.observe(frame)
        width, height = recording.size
        assert seen.overlays.foreground.shape == (height, width)
        assert seen.overlays.disparity is not None
        assert seen.overlays.disparity.shape == (height, width)
        assert seen.people.regions.shape == (height, width)
        assert set(np.unique(seen.overlays.foreground)) <= {0, 127, 255}


def test_people_who_stand_for_most_of_the_time_are_not_learnt(shared_data: Path) -> None:
    with open_recording(shared_data / "rendered-lobby") as recording:
        assert recording.rectification is not None
        assert recording.ground is not None
        perception = StereoPerception(recording.rectification, recording.ground, recording.fps)
        standing = recording.read(300)
        passing = [recording.read(n) for n in (0, 120, 480, 540, 599)]
        perception.learn([standing] * 8 + passing)
        seen = perception.observe(standing).people.position[:, :2]
    real = truth_of(shared_data / "rendered-lobby")[300][:, 4:]
    apart_m = np.linalg.norm(real[:, None] - seen[None], axis=2)
    assert (apart_m.min(axis=1) < 0.4).mean() > 0.8
    assert (apart_m.min(axis=0) < 0.4).all()


def test_a_frame_without_a_right_camera_is_refused(shared_data: Path) -> None:
    with open_recording(shared_data / "rendered-lobby") as recording:
        perception = prepared(recording)
        left = recording.read(0).left
    with pytest.raises(RecordingError, match="no right camera"):
        perception.observe(StereoFrame(0, 0.0, left, None))


def rig(width: int, height: int) -> Rectification:
    """Two cameras that are alike, 20 cm from each other."""
    matrix = np.array([[float(width), 0, width / 2], [0, float(width), height / 2], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), width, height)
    calibration = StereoCalibration(camera, camera, np.eye(3), np.array([-0.2, 0, 0]))
    return Rectification(calibration, Ground(2.4, 30.0))


@pytest.mark.parametrize(
    ("size", "least"),
    [((24, 16), 19), ((18, 24), 19), ((640, 3), 19), ((1, 1), 19), ((1000, 36), 38)],
)
def test_pictures_too_small_to_be_matched_are_refused(size: tuple[int, int], least: int) -> None:
    with pytest.raises(RecordingError, match=f"{size[0]} x {size[1]} px .* {least} x {least}: ch"):
        StereoPerception(rig(*size), Ground(2.4, 30.0), 20.0)


def test_the_smallest_pictures_that_can_be_matched_are_observed() -> None:
    perception = StereoPerception(rig(24, 19), Ground(2.4, 30.0), 20.0)
    random = np.random.default_rng(0)
    for n in range(4):
        left, right = random.integers(0, 255, (2, 19, 24, 3)).astype(np.uint8)
        assert len(perception.observe(StereoFrame(n, n / 20, left, right)).people) == 0


def test_while_the_right_camera_is_black_the_left_one_places_people(shared_data: Path) -> None:
    truth = truth_of(shared_data / "rendered-plaza")
    with open_recording(shared_data / "rendered-plaza") as recording:
        perception = prepared(recording)
        errors: list[float] = []
        wanted = found = 0
        for frame in recording.frames(300, 320):
            assert frame.right is not None
            black = StereoFrame(frame.number, frame.time_s, frame.left, np.zeros_like(frame.right))
            seen = perception.observe(black if frame.number < 316 else frame).people
            apart = np.hypot(
                *(truth[frame.number][:, None, 4:] - seen.position[None, :, :2]).transpose(2, 0, 1)
            )
            wanted, found = wanted + len(apart), found + len(seen)
            errors += [e for e in apart.min(axis=1).tolist() if e < 0.6]
    assert len(errors) > 0.8 * wanted
    assert found < 1.05 * wanted
    assert np.mean(errors) < 0.2
    (note,) = perception.notes
    assert note.startswith("the right camera shows nothing new in frames 300 to 315: people are")


class _NoDetections:
    """Boxes of one frame of each camera; notes which frames are asked for."""

    detections_only = True

    def __init__(self) -> None:
        self.left: list[int] = []
        self.right: list[int] = []

    def of(self, frame: int) -> FrameDetections:
        self.left.append(frame)
        return FrameDetections(np.zeros((0, 4)), np.zeros(0))

    def of_right(self, frame: int) -> FrameDetections:
        self.right.append(frame)
        return FrameDetections(np.zeros((0, 4)), np.zeros(0))


def test_boxes_of_a_late_camera_are_those_of_its_own_frame() -> None:
    source = _NoDetections()
    perception = StereoPerception(rig(320, 240), Ground(2.4, 30.0), 15.0, boxes=source)
    image = np.full((240, 320, 3), 90, np.uint8)
    perception.learn([StereoFrame(0, 0.0, image, image)])
    perception.overlays(StereoFrame(20, 2.0, image, image, right_lag=5))
    perception.overlays(StereoFrame(21, 2.1, image, image, right_lag=None))
    assert source.left == [20, 21]
    assert source.right == [25]


def test_whom_no_box_shows_is_not_learnt_as_background() -> None:
    perception = StereoPerception(rig(320, 240), Ground(2.4, 30.0), 5.0, boxes=_NoDetections())
    empty = np.full((240, 320, 3), 90, np.uint8)
    person = empty.copy()
    person[80:200, 140:180] = 220
    perception.learn([StereoFrame(0, 0.0, empty, empty)])
    for number in range(10):
        left, _ = perception.subtract(person, person)
        perception.observe(StereoFrame(number, number / 5.0, person, person))
    assert np.abs(left.background.astype(int) - empty).max() <= 1
