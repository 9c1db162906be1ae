"""Pictures as a network wants them, against an independent reference in double precision."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.networks.letterbox import Placement, network_input
from tracking.networks.network_spec import NetworkSpec

_SIZES = [(640, 480), (1277, 719), (97, 211), (1920, 1080)]
_MEAN, _STD = (0.485, 0.456, 0.406), (0.229, 0.224, 0.225)


def _spec(**keys: Any) -> NetworkSpec:
    return NetworkSpec("yolo", (320, 256), 1, (0,), **keys)


def _along(size: int, scaled: int) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    place = (np.arange(scaled) + 0.5) * size / scaled - 0.5
    low = np.floor(place)
    low_at, high_at = (np.clip(at, 0, size - 1).astype(int) for at in (low, low + 1))
    return low_at, high_at, place - low


def _reference(picture: NDArray[np.uint8], spec: NetworkSpec) -> NDArray[np.float64]:
    """What is to come out, as textbooks have it; (3, height, width)."""
    height, width = picture.shape[:2]
    wide, high = spec.size_px
    if spec.fit == "letterbox":
        scale = min(wide / width, high / height)
        whole = round if spec.align == "centre" else int
        scaled = whole(width * scale), whole(height * scale)
    else:
        scaled = spec.size_px
    top, bottom, down = _along(height, scaled[1])
    left, right, across = _along(width, scaled[0])
    rows = picture.astype(float)
    rows = rows[top] * (1 - down)[:, None, None] + rows[bottom] * down[:, None, None]
    part = rows[:, left] * (1 - across)[None, :, None] + rows[:, right] * across[None, :, None]
    x, y = ((wide - scaled[0]) // 2, (high - scaled[1]) // 2) if spec.align == "centre" else (0, 0)
    whole_picture = np.full((high, wide, 3), float(spec.pad))
    whole_picture[y : y + scaled[1], x : x + scaled[0]] = part
    if spec.channels == "rgb":
        whole_picture = whole_picture[:, :, [2, 1, 0]]
    return ((whole_picture / spec.divide_by - spec.mean) / spec.std).transpose(2, 0, 1)


@pytest.mark.parametrize("size", _SIZES)
@pytest.mark.parametrize(
    "keys",
    [
        {},
        {"align": "corner", "channels": "bgr", "pad": 0.0},
        {"fit": "stretch", "mean": _MEAN, "std": _STD},
    ],
)
def test_a_picture_is_the_references_within_a_ten_thousandth(
    size: tuple[int, int], keys: dict[str, Any]
) -> None:
    spec = _spec(**keys)
    noise = np.random.default_rng(1).integers(0, 256, (size[1], size[0], 3), np.uint8)
    batch, _ = network_input([noise, noise[::-1]], spec)
    for made, picture in zip(batch, (noise, noise[::-1]), strict=True):
        assert np.abs(made - _reference(picture, spec)).max() < 1e-4


@pytest.mark.parametrize("keys", [{}, {"align": "corner"}, {"fit": "stretch"}])
@pytest.mark.parametrize("size", _SIZES)
def test_a_box_of_the_input_comes_back_to_where_it_lies_in_the_picture(
    size: tuple[int, int], keys: dict[str, Any]
) -> None:
    placement = Placement.of(size, _spec(**keys))
    (wide, high), (left, top) = placement.scaled_px, (placement.left, placement.top)
    whole = np.array([[left, top, left + wide, top + high]], float)
    assert placement.to_picture(whole) == pytest.approx(np.array([[0, 0, *size]], float))
