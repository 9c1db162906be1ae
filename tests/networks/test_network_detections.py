"""Boxes of a network for frames of two cameras, one of which may be late."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from small_networks import SIZE, bright_rectangles, model

from tracking.detections import DetectionSettings
from tracking.networks.network_detections import NetworkDetections
from tracking.recording import StereoFrame

KEYS = {"decoder": "yolo", "classes": ["person"], "head": "v8", "min_score": 0.6}


def picture(left: int, top: int) -> np.ndarray:
    """A bright rectangle of 20 x 40 px on black."""
    drawn = np.zeros((2 * SIZE, 2 * SIZE, 3), np.uint8)
    drawn[top : top + 40, left : left + 20] = 255
    return drawn


@pytest.fixture
def source(tmp_path: Path) -> Iterator[NetworkDetections]:
    """A network that looks at both cameras."""
    settings = DetectionSettings(model="people.toml", max_overlap=0.3)
    read = model(tmp_path, bright_rectangles(10, 20), **KEYS)
    made = NetworkDetections(read, settings, both=True)
    yield made
    made.close()


def test_the_right_picture_is_of_its_own_frame(source: NetworkDetections) -> None:
    source.look(StereoFrame(5, 0.2, picture(32, 40), picture(64, 56), right_lag=2))
    (left,), right = source.of(5).box, source.of_right(7)
    assert left == pytest.approx((32, 40, 20, 40), abs=9)
    assert right is not None
    assert right.box[0] == pytest.approx((64, 56, 20, 40), abs=9)
    assert source.of_right(5) is None
    assert [one.count for one in source.inputs] == [2]


def test_a_right_camera_that_shows_another_instant_is_not_looked_at(
    source: NetworkDetections,
) -> None:
    source.look(StereoFrame(5, 0.2, picture(32, 40), picture(64, 56), right_lag=None))
    assert len(source.of(5)) == 1
    assert source.of_right(5) is None
    assert "1 box in 1 picture," in source.notes[0]


def test_finding_nobody_is_warned_of(source: NetworkDetections) -> None:
    source.look(StereoFrame(0, 0.0, np.zeros((64, 64, 3), np.uint8), None))
    assert len(source.of(0)) == 0
    assert source.notes[0].startswith("warning: people.toml (network test network) found nobody")


def test_who_is_outside_of_the_region_is_not_found(tmp_path: Path) -> None:
    looked_at = np.zeros((2 * SIZE, 2 * SIZE), np.uint8)
    looked_at[:, SIZE:] = 255
    read = model(tmp_path, bright_rectangles(10, 20), **KEYS)
    settings = DetectionSettings(model="people.toml", max_overlap=0.3)
    made = NetworkDetections(read, settings, both=False, looked_at=looked_at)
    try:
        made.look(StereoFrame(0, 0.0, picture(16, 40), None))
        assert len(made.of(0)) == 0
        made.look(StereoFrame(1, 0.1, picture(SIZE + 16, 40), None))
        assert len(made.of(1)) == 1
    finally:
        made.close()
