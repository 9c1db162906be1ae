"""A right camera that fails or is late is noticed; what is well is left alone."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.people import stereo_watch
from tracking.people.motion_agreement import MotionAgreement, late_by, mean_of_four, thinned
from tracking.people.stereo_watch import StereoWatch, shows_nothing

Picture = NDArray[np.uint8]
FPS, SHIFT_PX = 20.0, 12


def side(frame: int, shift_px: int = 0, people: int = 3) -> Picture:
    """A grained scene past which people bob and stride, seen by one camera."""
    grain = np.random.default_rng(0).normal(110, 12, (240, 320))
    for k, speed in enumerate((2.0, -1.5, 1.0)[:people]):
        left = int(60 + 70 * k + speed * frame) % 240 + 30 - shift_px
        top = 40 + 20 * k + round(6 * np.sin(0.6 * frame + 2 * k))
        grain[top : top + 100, left : left + 24 + round(8 * np.sin(0.3 * frame + k))] = 40
    return np.repeat(grain.clip(0, 255).astype(np.uint8)[..., None], 3, axis=2)


def watched(late: int, frames: int = 60) -> StereoWatch:
    """A watch on cameras whose pictures are paired as they were recorded."""
    watch = StereoWatch(FPS)
    for k in range(10, 10 + frames):
        watch.look(k, side(k), side(k - late, SHIFT_PX))
    return watch


def followed(
    lates: Iterable[int], known: int = 0, told: int | None = None
) -> tuple[StereoWatch, list[int | None]]:
    """A watch whose lag the pairing follows; `lates`: the camera's lag in each frame."""
    watch = StereoWatch(FPS)
    watch.begin(known, told)
    paired, said = watch.pairing, []
    for k, late in enumerate(lates):
        watch.look(k, side(k), side(k + paired - late, SHIFT_PX), paired)
        said.append(watch.lag)
        paired = watch.pairing
    return watch, said


@pytest.mark.parametrize("late", [-2, 0, 1, 3])
def test_a_camera_that_is_a_little_late_is_found_to_be_so_many_frames(late: int) -> None:
    watch = watched(late)
    assert watch.lag == late
    assert not watch.failing
    assert bool(watch.notes()) == (late != 0)


def noisy(picture: Picture, seed: int) -> Picture:
    """As a sensor sees it in poor light."""
    grain = np.random.default_rng(seed).normal(0, 9, picture.shape)
    return np.asarray((picture + grain).clip(0, 255), np.uint8)


def flickering(picture: Picture, seed: int) -> Picture:
    """As it is under a lamp that another camera sees otherwise at the same instant."""
    return np.asarray((picture * (1 + 0.15 * np.sin(2.4 * seed))).clip(0, 255), np.uint8)


@pytest.mark.parametrize("late", [0, 2])
@pytest.mark.parametrize("disturbed", [noisy, flickering])
def test_what_differs_by_chance_between_the_cameras_hides_no_lag_and_makes_none(
    disturbed: Callable[[Picture, int], Picture], late: int
) -> None:
    watch = StereoWatch(FPS)
    for k in range(48):
        right = disturbed(side(k - late, SHIFT_PX), 1000 + 3 * k)
        watch.look(k, disturbed(side(k), 5 * k), right)
    assert watch.lag == late
    assert not watch.failing


@pytest.mark.parametrize("width", [159, 240, 640])
def test_pictures_of_any_width_are_smoothed_against_noise(width: int) -> None:
    noise = np.random.default_rng(3).normal(110, 12, (90, width, 3)).clip(0, 255)
    few = thinned(noise.astype(np.uint8))
    assert few.shape[1] in range(150, 320)
    assert few.std() < 0.6 * 12


def test_where_every_pixel_is_compared_it_is_the_mean_of_itself_and_its_neighbours() -> None:
    channel = np.array([[0, 40, 80], [80, 120, 160]], np.uint8)
    np.testing.assert_array_equal(
        mean_of_four(channel, 1), np.array([[60, 100, 120], [100, 140, 160]], np.uint8)
    )


def movement_of(lefts: Iterable[Picture], rights: Iterable[Picture]) -> MotionAgreement:
    """All the movement of two cameras that show these pictures."""
    movement = MotionAgreement(FPS)
    for left, right in zip(lefts, rights, strict=True):
        movement.add((thinned(left), thinned(right)))
    return movement


def test_where_one_camera_repeats_a_picture_the_movement_of_both_is_spread_over_both_frames() -> (
    None
):
    assert len(movement_of(map(side, range(4)), map(side, (0, 1, 1, 3)))) == 3
    count = MotionAgreement(FPS).span + 1
    rights = [side(k - (k == 2), SHIFT_PX) for k in range(count)]
    stretch = movement_of(map(side, range(count)), rights).stretch()
    assert stretch is not None
    for rows in stretch:
        assert (rows[1] == rows[2]).all()
    left, right = (rows.sum(axis=1) for rows in stretch)
    assert np.abs(left - right).max() < 0.25 * left.max()


@pytest.mark.parametrize("late", [-8, 8])
def test_people_who_come_and_go_leave_the_lag_of_a_late_camera_to_be_told(late: int) -> None:
    def seen(k: int, shift_px: int = 0) -> Picture:
        return side(k if k % 24 < 12 else 0, shift_px, people=3 if k % 24 < 12 else 0)

    movement = movement_of(map(seen, range(60)), [seen(k - late, SHIFT_PX) for k in range(60)])
    stretch = movement.stretch()
    assert stretch is not None
    assert late_by([stretch], movement.most_lag) == late


@pytest.mark.parametrize("late", [-15, -8, 6, 12, 15])
def test_a_lag_of_half_a_second_is_unknown_first_and_then_found(late: int) -> None:
    watch, said = followed([late] * 80)
    assert set(said) == {0, None, late}
    assert said[-20:] == [late] * 20
    assert "the lag is unknown" in watch.notes()[0]
    assert f"{abs(late)} frames late, found at frame" in watch.notes()[1]


def test_a_lag_that_is_known_before_is_told_and_stays() -> None:
    watch, said = followed([5] * 60, known=5)
    assert set(said) == {5}
    assert watch.notes() == (
        "the right camera is 5 frames late: images of the same instant are paired",
    )


@pytest.mark.parametrize("told", [30, -30, 60])
def test_a_lag_that_is_told_wrong_is_given_up_and_looked_for(told: int) -> None:
    watch, said = followed([3] * 200, known=told, told=told)
    assert said[0] == told
    assert said[-60:] == [3] * 60
    hint = f"recording.toml says {told}: leave `lag` out to have it looked for"
    assert watch.notes()[0].endswith("as recording.toml says: images are paired so")
    assert all(line.endswith(hint) for line in watch.notes()[1:])


def test_a_lag_that_is_told_and_true_stays() -> None:
    watch, said = followed([30] * 100, known=30, told=30)
    assert set(said) == {30}
    assert watch.notes() == (
        "the right camera is 30 frames late, as recording.toml says: images are paired so",
    )


def test_a_lag_that_is_told_and_that_footage_disproves_is_named() -> None:
    watch = StereoWatch(FPS)
    watch.begin(0, told=-12)
    assert watch.notes() == (
        "neither camera is late: images of the same instant are paired; recording.toml says -12: "
        "leave `lag` out to have it looked for",
    )


def test_a_lag_that_changes_is_found_anew() -> None:
    _, said = followed([5] * 60 + [-4] * 90, known=5)
    assert said[59] == 5
    assert said[-20:] == [-4] * 20


def test_a_lag_that_changes_all_the_time_is_unknown() -> None:
    lates = np.random.default_rng(2).integers(-12, 13, 100).tolist()
    watch, said = followed(lates)
    assert said[-60:] == [None] * 60
    assert len(watch.notes()) == 1


def test_a_lag_that_is_not_found_twice_on_end_is_not_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    finds = itertools.cycle([3, None, None])
    monkeypatch.setattr(stereo_watch, "late_by", lambda *_: next(finds))
    assert watched(3, 120).lag is None


def test_a_camera_that_freezes_fails_until_it_moves_again() -> None:
    watch = StereoWatch(FPS)
    failing = []
    for k in range(40):
        watch.look(k, side(k), side(15 if 15 <= k < 30 else k, SHIFT_PX))
        failing.append(watch.failing)
    assert not any(failing[:16])
    assert all(failing[18:30])
    assert not any(failing[30:])
    assert "frames 18 to 29" in watch.notes()[0]


def test_a_camera_that_is_no_longer_late_is_told_to_be_well() -> None:
    watch = watched(2)
    for k in range(70, 130):
        watch.look(k, side(k), side(k, SHIFT_PX))
    assert watch.lag == 0
    late, well = watch.notes()[1], watch.notes()[-1]
    assert "the right camera is 2 frames late" in late
    assert "both cameras show the same instant" in well


def test_a_camera_that_fails_again_and_again_is_told_in_a_few_lines() -> None:
    watch = StereoWatch(FPS)
    for k in range(30 * 8):
        right = side(k, SHIFT_PX) if k % 30 else np.zeros_like(side(k))
        watch.look(k, side(k), right)
    told = watch.notes()
    assert len(told) == 6
    assert told[-1] == "and 3 more times like this"


def test_a_black_half_is_a_failing_camera_at_once() -> None:
    right = side(1, SHIFT_PX)
    assert not shows_nothing(side(1), right)
    right[120:] = 0
    assert shows_nothing(side(1), right)


def test_a_scene_in_which_nothing_can_be_seen_tells_nothing() -> None:
    dark = np.zeros((240, 320, 3), np.uint8)
    assert not shows_nothing(dark, dark)
