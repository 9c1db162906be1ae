"""What tells shadows from bodies is the same for a part as for the whole."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from tracking.foreground import in_size
from tracking.foreground.light_and_chroma import BackgroundChroma, LightAndChroma, even_box, halve


@pytest.mark.parametrize("size", [(62, 46), (93, 40), (31, 23)])
def test_each_pixel_of_another_size_is_that_of_the_nearest_place(size: tuple[int, int]) -> None:
    picture = np.random.default_rng(0).integers(0, 256, (23, 31)).astype(np.uint8)
    wanted = cv2.resize(picture, size, interpolation=cv2.INTER_NEAREST)
    np.testing.assert_array_equal(in_size(picture, size), wanted)


def test_the_look_of_a_part_of_a_background_is_that_of_the_part() -> None:
    random = np.random.default_rng(1)
    looks = BackgroundChroma()
    mask = np.zeros((41, 57), np.uint8)
    mask[7:33, 11:40] = 255
    box = even_box(mask)
    assert box is not None
    for _ in range(2):
        background = random.integers(0, 256, (41, 57, 3)).astype(np.uint8)
        part, wanted = looks.within(background, box), LightAndChroma.of(halve(background[box]))
        for name in LightAndChroma.__slots__:
            np.testing.assert_allclose(getattr(part, name), getattr(wanted, name), rtol=1e-6)
