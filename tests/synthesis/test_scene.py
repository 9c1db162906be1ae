"""Rendered frames against their truth."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from tracking.synthesis import SCENES, Scene, SceneTruth, Surfaces
from tracking.synthesis.rig import BASELINE_M


def _with_people(scene: Scene) -> tuple[int, SceneTruth]:
    """The first of some frames in which three people are whole in the picture."""
    width, height = scene.rig.size
    for number in range(80, scene.frames, 10):
        _, truth = scene.frame(number)
        low, high = truth.box[:, :2], truth.box[:, :2] + truth.box[:, 2:]
        whole = (low > 1).all(axis=1) & (high < (width - 2, height - 2)).all(axis=1)
        if whole.sum() >= 3:
            return number, truth
    raise AssertionError("nobody came")


def test_equal_seeds_give_equal_pictures_in_any_order(plaza: Scene) -> None:
    again = Scene(plaza.spec, people=8, seed=3, seconds=12.0, size=plaza.rig.size)
    later, later_truth = again.frame(150)
    earlier, _ = again.frame(90)
    first, _ = plaza.frame(90)
    second, second_truth = plaza.frame(150)
    assert np.array_equal(earlier.left, first.left)
    assert np.array_equal(later.left, second.left)
    assert later.right is not None
    assert second.right is not None
    assert np.array_equal(later.right, second.right)
    assert np.array_equal(later_truth.box, second_truth.box)


def test_other_seeds_give_other_people(plaza: Scene) -> None:
    other = Scene(plaza.spec, people=8, seed=4, seconds=1.0, size=(64, 48))
    here, there = plaza.cast.figures.height_m, other.cast.figures.height_m
    assert not np.allclose(here, there)


def test_nobody_is_seen_in_the_first_two_seconds(plaza: Scene) -> None:
    for number in (0, 13, 26, 39):
        assert len(plaza.frame(number)[1]) == 0


def test_empty_frames_differ_by_noise_alone(plaza: Scene) -> None:
    one, two = (plaza.frame(number)[0].left.astype(float) for number in (0, 30))
    assert 0.5 < (one - two).std() < 4.0
    assert abs((one - two).mean()) < 0.05


def test_the_right_camera_is_a_little_darker(plaza: Scene) -> None:
    frame, _ = plaza.frame(0)
    assert frame.right is not None
    assert 0.95 < frame.right.mean() / frame.left.mean() < 0.995


@pytest.mark.parametrize("scene_name", ["plaza", "pillars"])
def test_boxes_fit_what_is_drawn(scene_name: str, request: pytest.FixtureRequest) -> None:
    scene: Scene = request.getfixturevalue(scene_name)
    number, truth = _with_people(scene)
    surfaces = scene.surfaces(number)
    checked = 0
    for row in np.flatnonzero(truth.visibility > 0.995):
        rows, columns = np.nonzero(surfaces.track == truth.track[row])
        drawn = np.array([columns.min(), rows.min(), columns.max(), rows.max()])
        left, top, width, height = truth.box[row]
        assert drawn == pytest.approx([left, top, left + width, top + height], abs=1.6)
        checked += 1
    assert checked


def test_floor_positions_lie_between_the_feet(plaza: Scene) -> None:
    number, truth = _with_people(plaza)
    standing = np.column_stack((truth.position, np.zeros(len(truth))))
    pixels = plaza.rig.view.pixel_from_world(standing)
    left, top = truth.part_box[:, 2, :2].T - 2.0
    right, bottom = (truth.part_box[:, 2, :2] + truth.part_box[:, 2, 2:]).T + 2.0
    assert ((pixels[:, 0] > left) & (pixels[:, 0] < right)).all()
    assert ((pixels[:, 1] > top) & (pixels[:, 1] < bottom)).all()
    assert number > 0


def test_parts_lie_in_the_box_and_their_pixels_make_up_the_visible_share(plaza: Scene) -> None:
    number, truth = _with_people(plaza)
    low, high = truth.box[:, :2], truth.box[:, :2] + truth.box[:, 2:]
    part_low = truth.part_box[..., :2]
    part_high = part_low + truth.part_box[..., 2:]
    assert (part_low >= low[:, None] - 1e-9).all()
    assert (part_high <= high[:, None] + 1e-9).all()
    surfaces = plaza.surfaces(number)
    for row, track in enumerate(truth.track):
        seen = np.count_nonzero(surfaces.track == track)
        assert truth.part_pixels[row].sum() == pytest.approx(seen, rel=0.15, abs=8)
    assert ((truth.visibility >= 0) & (truth.visibility <= 1)).all()


def test_the_head_is_above_the_torso_and_that_above_the_legs(pillars: Scene) -> None:
    _, truth = _with_people(pillars)
    middle = truth.part_box[..., 1] + truth.part_box[..., 3] / 2
    assert (np.diff(middle, axis=1) > 0).all()


def test_pillars_hide_people(pillars: Scene) -> None:
    least = 1.0
    for number in range(80, pillars.frames, 8):
        _, truth = pillars.frame(number)
        inside = truth.box[:, 0] > 0
        inside &= truth.box[:, 0] + truth.box[:, 2] < pillars.rig.size[0]
        inside &= (truth.box[:, 1] > 0) & (truth.visibility < 1)
        least = min(least, truth.visibility[inside].min(initial=1.0))
    assert least < 0.5


def _disparity_of_match(
    left: np.ndarray, right: np.ndarray, column: int, row: int, near: float
) -> float:
    """Where the surroundings of a left pixel are found in the right picture, to a fraction."""
    reach, half = 4, 3
    patch = left[row - half : row + half + 1, column - half : column + half + 1]
    start = column - round(near)
    strip = right[row - half : row + half + 1, start - half - reach : start + half + reach + 1]
    score = cv2.matchTemplate(strip, patch, cv2.TM_CCOEFF_NORMED)[0]
    best = int(score.argmax())
    if score[best] < 0.9 or not 0 < best < len(score) - 1:
        return np.nan
    a, b, c = score[best - 1 : best + 2]
    shift = best - reach + 0.5 * (a - c) / (a - 2 * b + c)
    return column - (start + shift)


def test_the_cameras_see_people_at_the_disparity_of_their_distance() -> None:
    scene = Scene(SCENES["lobby"], people=6, seed=2, seconds=6.0)
    number, _ = _with_people(scene)
    frame, _ = scene.frame(number)
    surfaces = scene.surfaces(number)
    assert frame.right is not None
    left, right = (cv2.cvtColor(i, cv2.COLOR_BGR2GRAY) for i in (frame.left, frame.right))
    solid = cv2.erode((surfaces.track > 0).astype(np.uint8), np.ones((11, 11)))
    rows, columns = np.nonzero(solid)
    chosen = np.random.default_rng(0).choice(len(rows), 300)
    errors = []
    for row, column in zip(rows[chosen], columns[chosen], strict=True):
        truth = float(surfaces.disparity_px[row, column])
        if 12 < column - truth < 620 and 8 < row < 470:
            errors.append(_disparity_of_match(left, right, int(column), int(row), truth) - truth)
    known = np.array(errors)[np.isfinite(errors)]
    assert len(known) > 60
    assert abs(np.median(known)) < 0.1
    assert np.median(np.abs(known)) < 0.25


def test_disparity_is_that_of_where_people_stand(plaza: Scene) -> None:
    number, truth = _with_people(plaza)
    surfaces: Surfaces = plaza.surfaces(number)
    for track, position in zip(truth.track, truth.position, strict=True):
        disparity = surfaces.disparity_px[surfaces.track == track]
        reach = plaza.rig.focal_px * BASELINE_M / disparity
        points = np.array([[*position, 0.0], [*position, 1.9]])
        low, high = sorted(plaza.rig.left_camera_points(points)[:, 2])
        assert (reach > low - 0.8).all()
        assert (reach < high + 0.8).all()


def test_shadows_darken_the_floor_beside_people(plaza: Scene) -> None:
    number, _ = _with_people(plaza)
    empty = plaza.frame(0)[0].left.astype(float).sum(axis=2)
    now = plaza.frame(number)[0].left.astype(float).sum(axis=2)
    floor = cv2.dilate((plaza.surfaces(number).track > 0).astype(np.uint8), np.ones((3, 3))) == 0
    ratio = cv2.blur(now, (3, 3)) / cv2.blur(empty, (3, 3))
    assert np.count_nonzero(ratio[floor] < 0.8) > 200
    assert np.quantile(ratio[floor], 0.99) < 1.06


def test_uniforms_are_of_one_colour() -> None:
    scene = Scene(SCENES["uniforms"], people=2, seed=1, seconds=1.0, size=(64, 48))
    one, two = (
        texels[: 320 * 256].reshape(320, 256, 3) for texels in np.split(scene.cast.textures, 2)
    )
    legs = slice(140, 240), slice(0, 90)
    assert np.abs(one[legs].mean(axis=(0, 1)) - two[legs].mean(axis=(0, 1))).max() < 0.02


def test_a_frame_beyond_the_end_is_refused(plaza: Scene) -> None:
    with pytest.raises(IndexError, match="240"):
        plaza.frame(plaza.frames)


def test_a_scene_without_people_stays_empty() -> None:
    spec = replace(SCENES["square"], seconds=3.0)
    scene = Scene(spec, people=0, seed=1, size=(160, 120))
    frame, truth = scene.frame(50)
    assert len(truth) == 0
    assert not scene.surfaces(50).track.any()
    assert frame.left.shape == (120, 160, 3)


@pytest.mark.parametrize("name", sorted(n for n, spec in SCENES.items() if not spec.scenario))
def test_people_come_into_view_in_every_scene(name: str) -> None:
    scene = Scene(SCENES[name], people=6, seed=1, seconds=10.0, size=(96, 72))
    times = np.arange(3.0, 10.0)
    numbers = [int(second * scene.fps) for second in times]
    seen = {int(track) for number in numbers for track in scene.frame(number)[1].track}
    assert len(seen) >= 3
