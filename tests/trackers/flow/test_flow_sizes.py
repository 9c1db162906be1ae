"""Pictures whose width or height is odd: everything at half resolution means the same pixels."""

from __future__ import annotations

import numpy as np
import pytest
from flow_scenes import FPS, SIZE, drawn, floor_picture, frame_of, straight, tracked, view_of
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from tracking.geometry import Camera, View
from tracking.trackers import StepResult
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.half_resolution import double, half_size, halve
from tracking.trackers.flow.perception import FlowPerception
from tracking.trackers.flow.silhouettes import BODY, draw_cover, score_silhouettes

ODD = [(641, 481), (639, 479), (641, 480), (640, 479)]
WHOLE = view_of()
FRAMES = 24
WAYS = (straight((-1.6, 4.0), (0.9, 0.1), FRAMES), straight((1.5, 5.6), (-0.8, -0.3), FRAMES))


def view_with(size: tuple[int, int]) -> View:
    return View(Camera(WHOLE.camera.matrix, np.zeros(4), *size), WHOLE.ground)


def cut(picture: NDArray[np.uint8], size: tuple[int, int]) -> NDArray[np.uint8]:
    """A picture of another size, its first pixel where it was."""
    wider = np.pad(picture, ((0, 1), (0, 1), (0, 0)), mode="edge")
    return np.ascontiguousarray(wider[: size[1], : size[0]])


def mask_of(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What perception makes of a picture whose floor it has learnt."""
    perception = FlowPerception(FPS)
    empty = cut(floor_picture(), (picture.shape[1], picture.shape[0]))
    perception.learn([frame_of(0, empty)] * 2)
    return perception.observe(frame_of(0, picture)).mask


@pytest.mark.parametrize("size", ODD[:2])
def test_people_in_pictures_of_odd_sizes_are_followed(size: tuple[int, int]) -> None:
    pictures = [
        cut(
            drawn(floor_picture(), WHOLE, [(*way[n], 10 + who) for who, way in enumerate(WAYS)]),
            size,
        )
        for n in range(FRAMES)
    ]
    steps, _ = tracked(view_with(size), pictures, background=cut(floor_picture(), size))
    for way in WAYS:
        assert len({nearest(step, way) for step in steps[14:]}) == 1
    assert {len(step.tracks["track"]) for step in steps[14:]} == {2}


def nearest(step: StepResult, way: NDArray[np.float64]) -> int:
    """The track that is where somebody is, not far off."""
    away = np.hypot(step.tracks["x"] - way[step.frame, 0], step.tracks["y"] - way[step.frame, 1])
    assert away.min() < 0.35, step.frame
    return int(step.tracks["track"][away.argmin()])


@pytest.mark.parametrize("size", ODD)
def test_a_body_fills_the_foreground_as_well_whatever_the_size(size: tuple[int, int]) -> None:
    place = np.array([[0.4, 4.0]])
    picture = drawn(floor_picture(), WHOLE, [(0.4, 4.0, 10)])
    scores = []
    for of in (SIZE, size):
        floor = Floor(view_with(of))
        nobody = draw_cover(np.zeros((0, 2)), floor)
        scores.append(score_silhouettes(place, mask_of(cut(picture, of)), nobody, floor).score[0])
    assert scores[0] > 0.8
    assert scores[1] == pytest.approx(scores[0], abs=0.02)


@pytest.mark.parametrize("size", ODD)
def test_foreground_over_the_picture_is_as_large_and_lies_where_somebody_is(
    size: tuple[int, int],
) -> None:
    perception = FlowPerception(FPS)
    perception.learn([frame_of(0, cut(floor_picture(), size))] * 2)
    picture = cut(drawn(floor_picture(), WHOLE, [(0.4, 4.0, 10)]), size)
    seen = perception.observe(frame_of(0, picture))
    laid = seen.overlays.foreground
    assert laid.shape == picture.shape[:2]
    rows, columns = seen.mask.shape
    even = laid[: 2 * rows, : 2 * columns]
    for down, right in ((0, 0), (0, 1), (1, 0), (1, 1)):
        assert ((even[down::2, right::2] == 255) == (seen.mask == BODY)).all()


@given(st.integers(1, 40), st.integers(1, 40))
def test_every_size_is_halved_and_doubled_to_itself(width: int, height: int) -> None:
    picture = np.arange(height * width, dtype=np.uint8).reshape(height, width)
    half = halve(picture)
    assert half.shape[::-1] == half_size((width, height))
    assert double(half, (width, height)).shape == (height, width)


@given(st.integers(2, 40), st.integers(2, 40))
def test_a_pixel_at_half_resolution_is_the_mean_of_the_same_four(width: int, height: int) -> None:
    random = np.random.default_rng(width * 100 + height)
    picture = random.integers(0, 256, (height, width)).astype(np.uint8)
    columns, rows = half_size((width, height))
    fours = picture[: 2 * rows, : 2 * columns].reshape(rows, 2, columns, 2)
    assert np.abs(halve(picture) - fours.mean(axis=(1, 3))).max() <= 0.5
