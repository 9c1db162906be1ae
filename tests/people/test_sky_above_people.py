"""What moves in the sky before a camera that nobody calibrated: above the people's horizon."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from tracking.people import SingleCameraPerception, single_camera
from tracking.recording import StereoFrame

FPS = 10.0
WIDTH, HEIGHT = 320, 240
HORIZON, CAMERA_IN_BODIES = 70, 2.0
"""Row of the horizon, and how much higher the camera is than people are tall."""
FEET = (110, 128, 150, 172, 196, 222)
SECONDS = 20.0
FLAG = (14, 16, 40)
"""Top, width and height px of a flag that is carried along a roof, above the horizon."""
CARRIED = range(30, 60)


def frame(number: int) -> StereoFrame:
    """People who cross at six distances, and the flag in the sky."""
    random = np.random.default_rng(7)
    image = random.integers(120, 150, (HEIGHT, WIDTH, 3)).astype(np.uint8)
    for row, foot in enumerate(FEET):
        tall = (foot - HORIZON) / CAMERA_IN_BODIES
        middle = (37 * row + (2.0 + 0.5 * row) * number) % WIDTH
        _paint(image, middle, foot - tall, 0.3 * tall, tall)
    if number in CARRIED:
        _paint(image, (3.0 * number) % WIDTH, *FLAG)
    return StereoFrame(number, number / FPS, image, None)


def _paint(image: np.ndarray, middle: float, top: float, width: float, height: float) -> None:
    left = round(middle - width / 2)
    columns = slice(max(left, 0), max(left + round(width), 0))
    image[round(top) : round(top + height), columns] = (60, 40, 220)


def _seen(perception: SingleCameraPerception) -> Iterator[int]:
    """How many regions each frame shows in the sky, after the background was learnt."""
    numbers = np.linspace(0, SECONDS * FPS - 5, 15).astype(int).tolist()
    perception.learn([frame(n) for n in numbers], [frame(n + 4) for n in numbers])
    for number in CARRIED:
        box = perception.observe(frame(number)).people.box
        yield int((box[:, 1] + box[:, 3] < HORIZON).sum())


def test_what_moves_in_the_sky_is_nobody() -> None:
    perception = SingleCameraPerception(FPS)
    assert sum(_seen(perception)) <= 2
    assert perception.notes


def test_without_the_horizon_it_is_somebody(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(single_camera, "fit_horizon", lambda _: None)
    assert sum(_seen(SingleCameraPerception(FPS))) > 20
