"""The floor found by stereo, points, a pose and people."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tracking.calibration.floor import (
    FloorPoint,
    floor_by_distances,
    floor_by_people,
    floor_by_points,
    floor_by_pose,
    floor_by_stereo,
)
from tracking.calibration.floor.estimate import estimate_of
from tracking.calibration.floor.people import floor_of_people
from tracking.calibration.floor.walkers import PeopleSeen, axes_of_regions
from tracking.errors import CalibrationError
from tracking.geometry import Camera, Ground, View, ground_of_plane, ground_of_pose
from tracking.progress import Progress
from tracking.recording import open_recording
from tracking.synthesis import render_recording

CAMERA = Camera(
    np.array([[520.0, 0, 320], [0, 520.0, 240], [0, 0, 1]]),
    np.array([-0.1, 0.02, 0, 0, 0]),
    640,
    480,
)
GROUND = Ground(2.6, 28.0, 3.0)
VIEW = View(CAMERA, GROUND)
PLACES = np.array([[-1.5, 4.0], [1.5, 4.0], [2.0, 7.0], [-2.0, 7.0], [0.3, 5.5]])


@pytest.fixture(scope="module")
def lobby(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three people in a lobby, by two cameras."""
    return render_recording(tmp_path_factory.mktemp("clips") / "lobby", "lobby", 4.0, 3, 11)


def clicked(noise_px: float = 0.0) -> list[FloorPoint]:
    """Points on the floor, counted from a corner of the room that is turned by 20 degrees."""
    pixels = VIEW.pixel_from_world(np.column_stack((PLACES, np.zeros(len(PLACES)))))
    pixels += np.random.default_rng(1).normal(0, noise_px, pixels.shape)
    turn = np.deg2rad(20.0)
    matrix = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    places = PLACES @ matrix.T + (3.0, -8.0)
    return [FloorPoint(*pixel, *place) for pixel, place in zip(pixels, places, strict=True)]


def assert_near(ground: Ground, height: float, degrees: float, truth: Ground = GROUND) -> None:
    """The floor is as it should be, by a share of the height and some degrees."""
    assert ground.height_m == pytest.approx(truth.height_m, rel=height)
    assert ground.tilt_deg == pytest.approx(truth.tilt_deg, abs=degrees)
    assert ground.roll_deg == pytest.approx(truth.roll_deg, abs=degrees)


def test_stereo_finds_the_floor_of_busy_footage(lobby: Path) -> None:
    with open_recording(lobby) as recording:
        truth = recording.ground
        assert truth is not None
        found = floor_by_stereo(recording)
    assert_near(found.ground, 0.02, 0.5, truth)
    assert 0 < found.height_sigma_m < 0.1


def test_stereo_needs_two_calibrated_cameras(lobby: Path, tmp_path: Path) -> None:
    with open_recording(lobby / "left.mp4") as recording, pytest.raises(CalibrationError) as error:
        floor_by_stereo(recording)
    assert "two calibrated cameras" in str(error.value)


def test_points_with_places_give_the_floor_and_how_sure_it_is() -> None:
    assert_near(floor_by_points(CAMERA, clicked()).ground, 1e-4, 0.01)
    noisy = floor_by_points(CAMERA, clicked(1.5))
    assert_near(noisy.ground, 0.05, 2.0)
    assert abs(noisy.ground.height_m - GROUND.height_m) < 4 * noisy.height_sigma_m
    assert abs(noisy.ground.tilt_deg - GROUND.tilt_deg) < 4 * noisy.tilt_sigma_deg


def test_points_with_distances_between_them_give_the_floor() -> None:
    pixels = VIEW.pixel_from_world(np.column_stack((PLACES, np.zeros(len(PLACES)))))
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (4, 1)]
    known = [(i, j, float(np.linalg.norm(PLACES[i] - PLACES[j]))) for i, j in pairs]
    assert_near(floor_by_distances(CAMERA, pixels, known).ground, 0.01, 0.3)


@pytest.mark.parametrize(("rows", "why"), [([0, 1, 2], "4 or more"), ([0, 0, 1, 1], "on a line")])
def test_too_few_points_and_points_on_a_line_are_refused(rows: list[int], why: str) -> None:
    points = clicked()
    with pytest.raises(CalibrationError, match=why):
        floor_by_points(CAMERA, [points[row] for row in rows])


def test_a_mistyped_place_is_told() -> None:
    points = clicked()
    points[2] = FloorPoint(points[2].u, points[2].v, points[2].x_m + 4.0, points[2].y_m)
    found = floor_by_points(CAMERA, points)
    assert any("points are off" in str(note) for note in found.notes)


def poses() -> dict[str, object]:
    """The same pose in several conventions and forms."""
    rotation, centre = GROUND.world_from_camera
    turn, shift = rotation.T, -rotation.T @ centre
    whole = np.eye(4)
    whole[:3, :3], whole[:3, 3] = rotation, centre
    opengl = whole.copy()
    opengl[:3, :3] = rotation @ np.diag([1, -1, -1])
    return {
        "R and t": {"R": turn.tolist(), "t": shift.tolist()},
        "nested, mm": {"camera": {"R": turn.tolist(), "T": (1000 * shift).tolist()}},
        "world from camera": {"pose": whole.tolist()},
        "OpenGL": {"transform": opengl.ravel().tolist()},
        "plain numbers": "\n".join(" ".join(map(str, row)) for row in whole[:3]),
    }


@pytest.mark.parametrize("form", poses())
def test_a_pose_of_any_convention_gives_the_floor(form: str, tmp_path: Path) -> None:
    path = tmp_path / "pose.txt"
    content = poses()[form]
    path.write_text(content if isinstance(content, str) else json.dumps(content))
    assert_near(floor_by_pose(path, CAMERA).ground, 1e-4, 0.01)


@pytest.mark.parametrize(
    "text", ["", "nonsense", "{}", "1 2 3", '{"R": [[1,0,0],[0,1,0],[0,0,5]], "t": [0,0,1]}', "[[["]
)
def test_a_file_without_a_pose_is_refused_in_one_line(text: str, tmp_path: Path) -> None:
    path = tmp_path / "pose.json"
    path.write_text(text)
    with pytest.raises(CalibrationError) as error:
        floor_by_pose(path, CAMERA)
    assert "\n" not in str(error.value)


def walkers(people: int = 20) -> PeopleSeen:
    """Boxes and leans of people who walk through the room."""
    random = np.random.default_rng(2)
    boxes, frames, numbers, leans = [], [], [], []
    for person in range(people):
        begin, end = random.uniform((-2.5, 4.5), (2.5, 9.0), (2, 2))
        way = begin + np.linspace(0, 1, 20)[:, None] * (end - begin)
        box = VIEW.box_of_person(way, random.normal(1.73, 0.08), 0.5)
        foot, head = (
            VIEW.pixel_from_world(np.column_stack((way, np.full(20, z)))) for z in (0.3, 1.6)
        )
        inside = (box[:, :2] > 4).all(axis=1) & (box[:, :2] + box[:, 2:] < (636, 476)).all(axis=1)
        boxes.append(box[inside] + random.normal(0, 1.0, (inside.sum(), 4)))
        frames.append(np.flatnonzero(inside) + 30 * person)
        numbers.append(np.full(inside.sum(), person))
        leans.append(np.arctan2(*(foot - head)[inside].T) + random.normal(0, 0.02, inside.sum()))
    box, frame, number, lean = map(np.concatenate, (boxes, frames, numbers, leans))
    return PeopleSeen(box, frame, number, lean, np.full(len(box), 0.85)).select(np.arange(len(box)))


def test_people_of_usual_height_give_the_floor() -> None:
    found = floor_of_people(CAMERA, walkers())
    assert_near(found.ground, 0.06, 2.0)
    assert not found.notes


def test_people_without_known_leans_give_the_floor() -> None:
    seen = walkers()
    unknown = replace(seen, lean=np.full(len(seen.lean), np.nan))
    assert_near(floor_of_people(CAMERA, unknown).ground, 0.08, 3.0)


def test_boxes_of_groups_and_of_people_without_feet_are_no_people() -> None:
    seen, random = walkers(), np.random.default_rng(5)
    box = seen.box.copy()
    footless, doubled = np.array_split(random.permutation(len(box))[: len(box) // 3], 2)
    box[footless, 3] *= random.uniform(0.5, 0.85, len(footless))
    box[doubled, 2:] *= random.uniform(1.1, 1.5, (len(doubled), 1))
    assert_near(floor_of_people(CAMERA, replace(seen, box=box)).ground, 0.06, 2.0)


def test_few_people_make_a_doubtful_floor() -> None:
    found = floor_of_people(CAMERA, walkers(8))
    assert any("people are seen to walk alone" in str(note) for note in found.notes)


def test_a_silhouette_s_axis_is_how_it_leans() -> None:
    regions = np.zeros((80, 80), np.uint8)
    cv2.line(regions, (10, 10), (30, 70), 1, 5)
    cv2.circle(regions, (60, 40), 10, 2, -1)
    lean, slimness = axes_of_regions(regions, 2)
    assert lean[0] == pytest.approx(np.arctan2(20, 60), abs=0.02)
    assert slimness[0] > 0.9 > 0.1 > slimness[1]


def test_footage_of_nobody_says_that_people_are_missing(tmp_path: Path) -> None:
    folder = render_recording(tmp_path / "empty", "lobby", 1.0, 0, 3, size=(320, 240), cameras=1)
    with open_recording(folder) as recording, pytest.raises(CalibrationError) as error:
        floor_by_people(recording)
    assert "0 people" in str(error.value)


def test_a_camera_that_leans_within_its_error_looks_straight_down() -> None:
    lean = np.deg2rad(1.0)
    up = np.array([-np.sin(lean), 0.0, -np.cos(lean)])
    unsure, sure = (estimate_of(up, 3.0, "stereo", 0.01, sigma) for sigma in (1.0, 0.1))
    assert unsure.ground == Ground(3.0, 90.0, 0.0)
    assert sure.ground.tilt_deg == pytest.approx(89.0)


def test_a_plane_and_a_pose_are_the_ground_they_were_made_of() -> None:
    rotation, centre = GROUND.world_from_camera
    again = ground_of_plane(rotation[2], 2.6), ground_of_pose(rotation.T, -rotation.T @ centre)
    for ground in again:
        assert_near(ground, 1e-9, 1e-9)


class CancelledError(Exception):
    """The user has cancelled."""


def cancel_past(share: float) -> Progress:
    """A user who cancels once so much is done."""

    def tell(done: int, total: int) -> None:
        if done > share * total:
            raise CancelledError

    return tell


def test_the_search_of_the_plane_can_be_cancelled(lobby: Path) -> None:
    with open_recording(lobby) as recording, pytest.raises(CancelledError):
        floor_by_stereo(recording, cancel_past(0.8))  # all frames are read by then


@pytest.mark.parametrize("share", [0.1, 0.9])
def test_the_fit_to_people_can_be_cancelled(share: float) -> None:
    with pytest.raises(CancelledError):
        floor_of_people(CAMERA, walkers(), cancel_past(share))
