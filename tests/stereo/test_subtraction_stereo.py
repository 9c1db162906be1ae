"""Range inside the foreground, and nowhere else."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, Rectification, StereoCalibration
from tracking.stereo import STEP, SightLines, StereoSettings, SubtractionStereo

WIDTH, HEIGHT = 320, 240
BODY = (slice(30, 100), slice(140, 190))
Grey = NDArray[np.uint8]


@pytest.fixture(scope="module")
def rectification() -> Rectification:
    matrix = np.array([[255.0, 0, 161], [0, 255, 119], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), WIDTH, HEIGHT)
    shift = np.array([-0.12, 0, 0])
    return Rectification(StereoCalibration(camera, camera, np.eye(3), shift), Ground(2.4, 30.0))


@pytest.fixture(scope="module")
def lines(rectification: Rectification) -> SightLines:
    return SightLines(rectification)


def dots(seed: int) -> Grey:
    random = np.random.default_rng(seed)
    rough = random.integers(20, 235, (HEIGHT // 3, WIDTH // 3)).astype(np.uint8)
    return np.asarray(cv2.resize(rough, (WIDTH, HEIGHT), interpolation=cv2.INTER_CUBIC), np.uint8)


def seen_from_the_right(left: Grey, disparity_px: float) -> Grey:
    shift = np.array([[1, 0, -disparity_px], [0, 1, 0]], np.float32)
    return np.asarray(cv2.warpAffine(left, shift, (WIDTH, HEIGHT), flags=cv2.INTER_CUBIC), np.uint8)


def mask(columns: slice) -> Grey:
    shown = np.zeros((HEIGHT, WIDTH), np.uint8)
    shown[BODY[0], columns] = 255
    return shown


@pytest.mark.parametrize("disparity_px", [6.0, 6.4, 8.25])
def test_disparity_is_found_to_a_tenth_of_a_pixel(lines: SightLines, disparity_px: float) -> None:
    left = dots(5)
    found = SubtractionStereo(lines).match(
        left, seen_from_the_right(left, disparity_px), mask(BODY[1]), mask(slice(125, 190))
    )
    inside = found[BODY[0].start // STEP : BODY[0].stop // STEP, BODY[1].start // STEP : 95]
    assert np.isfinite(inside).mean() > 0.8
    assert abs(float(np.nanmedian(inside)) - disparity_px) < 0.1


def test_outside_the_foreground_there_is_no_range(lines: SightLines) -> None:
    left = dots(5)
    found = SubtractionStereo(lines).match(
        left, seen_from_the_right(left, 7), mask(BODY[1]), mask(slice(125, 190))
    )
    found[mask(BODY[1])[::STEP, ::STEP] > 0] = np.nan
    assert not np.isfinite(found).any()


def test_nothing_matches_what_the_right_camera_sees_as_background(lines: SightLines) -> None:
    left = dots(5)
    found = SubtractionStereo(lines).match(
        left, seen_from_the_right(left, 7), mask(BODY[1]), mask(slice(10, 60))
    )
    assert not np.isfinite(found).any()


def test_light_that_changes_on_a_fixed_thing_has_no_range(lines: SightLines) -> None:
    left = dots(5)
    right = seen_from_the_right(left, 16)
    stereo = SubtractionStereo(lines)
    stereo.learn_scene(left, right)
    found = stereo.match(left // 2, right // 2, mask(BODY[1]), mask(slice(100, 190)))
    assert not np.isfinite(found).any()


def test_a_person_in_front_of_a_ranged_scene_keeps_the_range(lines: SightLines) -> None:
    left, person = dots(5), dots(6)
    stereo = SubtractionStereo(lines)
    stereo.learn_scene(left, seen_from_the_right(left, 5))
    found = stereo.match(
        person, seen_from_the_right(person, 16), mask(BODY[1]), mask(slice(100, 190))
    )
    assert np.isfinite(found).sum() > 500


def person_before(
    scene: Grey,
    person: Grey,
    lines: SightLines,
    lower_px: int = 0,
    spread_px: float = 0.0,
    dark: int = 0,
) -> NDArray[np.float32]:
    """Disparity in a person 12 px away before a scene 6 px away, seen by an imperfect right camera.

    Args:
        dark: so many times the scene is looked at again, and lies in the dark.
    """

    def as_right(side: Grey) -> Grey:
        lower = np.roll(side, lower_px, axis=0)
        blurred = cv2.GaussianBlur(lower, (0, 0), spread_px) if spread_px else lower
        return np.asarray(blurred, np.uint8)

    stereo = SubtractionStereo(lines)
    stereo.learn_scene(scene, as_right(seen_from_the_right(scene, 6)))
    for _ in range(dark):
        stereo.learn_scene(np.zeros_like(scene), np.zeros_like(scene))
    there = np.roll(mask(slice(125, 190)), lower_px, axis=0)
    found = stereo.match(person, as_right(seen_from_the_right(person, 12)), mask(BODY[1]), there)
    return found[BODY[0].start // STEP : BODY[0].stop // STEP, BODY[1].start // STEP : 95]


@pytest.mark.parametrize("lower_px", [-1, 1, 3])
def test_a_right_camera_that_sees_lower_or_higher_gives_the_range_of_level_ones(
    lines: SightLines, lower_px: int
) -> None:
    inside = person_before(dots(5), dots(6), lines, lower_px)
    assert (np.abs(inside - 12) < 0.25).mean() > 0.95
    assert np.isfinite(inside[[0, -1]]).mean() > 0.9  # the mask is moved, too


@pytest.mark.parametrize("imperfect", [{"lower_px": 3}, {"spread_px": 2.0}])
def test_what_is_known_of_the_cameras_outlasts_a_time_in_the_dark(
    lines: SightLines, imperfect: dict[str, Any]
) -> None:
    inside = person_before(dots(5), dots(6), lines, **imperfect, dark=16)
    assert (np.abs(inside - 12) < 0.25).mean() > 0.95


def test_a_first_scene_that_told_nothing_is_followed_by_another_look(lines: SightLines) -> None:
    scene, person = dots(5), dots(6)
    there = [
        np.roll(seen_from_the_right(side, px), 3, axis=0) for side, px in ((scene, 6), (person, 12))
    ]
    stereo = SubtractionStereo(lines)
    stereo.learn_scene(np.zeros_like(scene), np.zeros_like(scene))
    stereo.learn_scene(scene, there[0])
    right_mask = np.roll(mask(slice(125, 190)), 3, axis=0)
    found = stereo.match(person, there[1], mask(BODY[1]), right_mask)
    assert np.isfinite(found).sum() > 500


def test_a_right_camera_out_of_focus_gives_the_range_of_sharp_ones(lines: SightLines) -> None:
    inside = person_before(dots(5), dots(6), lines, spread_px=2.0)
    assert (np.abs(inside - 12) < 0.25).mean() > 0.95


def test_no_foreground_gives_no_range(lines: SightLines) -> None:
    nobody = np.zeros((HEIGHT, WIDTH), np.uint8)
    assert not np.isfinite(SubtractionStereo(lines).match(dots(5), dots(5), nobody, nobody)).any()


@pytest.mark.parametrize(
    ("height", "window_px"), [(242, 9), (246, 9), (240, 11), (240, 31), (64, 31), (19, 9)]
)
@pytest.mark.parametrize("row", [0, 2, -2, -1])
def test_foreground_at_the_upper_and_lower_edge_alone_is_matched_with_any_window(
    height: int, window_px: int, row: int
) -> None:
    matrix = np.array([[255.0, 0, 161], [0, 255, height / 2], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), WIDTH, height)
    rig = StereoCalibration(camera, camera, np.eye(3), np.array([-0.12, 0, 0]))
    lines = SightLines(Rectification(rig, Ground(2.4, 30.0)))
    stereo = SubtractionStereo(lines, StereoSettings(window_px=window_px))
    side, everywhere = dots(5)[np.arange(height) % HEIGHT], np.full((height, WIDTH), 255, np.uint8)
    low = np.zeros_like(everywhere)
    low[row, 100:200] = 255
    stereo.learn_scene(side, side)
    found = stereo.match(side, side, low, everywhere)
    assert found.shape == (-(-height // STEP), WIDTH // STEP)
    assert not np.isfinite(found[low[::STEP, ::STEP] == 0]).any()


@settings(max_examples=40, deadline=None)
@given(u=st.integers(0, WIDTH - 1), v=st.integers(0, HEIGHT - 1), disparity=st.floats(1.5, 40))
def test_sight_lines_agree_with_the_rectification(u: int, v: int, disparity: float) -> None:
    matrix = np.array([[255.0, 0, 161], [0, 255, 119], [0, 0, 1]])
    right = matrix.copy()
    right[0, 2] = 158.0
    cameras = [Camera(m, np.zeros(5), WIDTH, HEIGHT) for m in (matrix, right)]
    rig = Rectification(
        StereoCalibration(cameras[0], cameras[1], np.eye(3), np.array([-0.2, 0, 0])),
        Ground(3.0, 50.0, 4),
    )
    lines = SightLines(rig)
    whole = disparity + lines.offset
    depth = lines.depth(np.array([whole], np.float32))
    point = lines.centre + depth[0] * lines.rays[v, u]
    wanted = rig.world_from_disparity(np.array([u]), np.array([v]), np.array([whole]))[0]
    np.testing.assert_allclose(point, wanted, rtol=1e-3, atol=1e-3)


def test_a_shrunken_picture_has_the_same_rays(rectification: Rectification) -> None:
    whole, half = SightLines(rectification), SightLines(rectification, 2)
    between = whole.rays.reshape(HEIGHT // 2, 2, WIDTH // 2, 2, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(half.rays, between, atol=1e-5)
    assert half.focal_baseline == pytest.approx(whole.focal_baseline / 2)


def test_the_floor_has_the_disparity_of_the_floor(
    rectification: Rectification, lines: SightLines
) -> None:
    place = np.array([[0.4, 3.0, 0.0]])
    u, v = np.rint(rectification.rectified_from_world(place)[0]).astype(int)
    floor = lines.disparity_at_height(0.0, 0.5, 50.0)
    assert floor[v, u] == pytest.approx(rectification.disparity_from_world(place)[0], abs=0.1)
