"""Numbers of PedPy 1.5.1, kept for where it is not installed; `pedpy_numbers` makes them."""

from __future__ import annotations

import numpy as np
import pytest
from pedpy_numbers import FPS, FRAME_STEP, LINE, SEEDS, SQUARE
from walks import crowd

from tracking.counting import CountingLine, Region, occupancy, passages

NUMBERS = {
    11: (5, 5, 13.666666666666664, 57.378984485523155),
    12: (3, 3, 11.777777777777779, 69.16352488475681),
    13: (8, 7, 30.77777777777778, 66.7647979351095),
}


@pytest.mark.parametrize("seed", SEEDS)
def test_counts_are_those_that_pedpy_gave(seed: int) -> None:
    columns = crowd(seed)
    line = CountingLine("line", *LINE)
    found = passages(columns, FPS, [line])
    last = np.zeros(columns["track"].max() + 1, int)
    np.maximum.at(last, columns["track"], columns["frame"])
    found = found.rows(found.frame < last[found.track])  # PedPy leaves a track's last step out
    region = Region("square", SQUARE)
    (square,) = occupancy(columns, FPS, [region], step_s=1 / FPS, frame_step=FRAME_STEP)
    crossings, people, density, speed = NUMBERS[seed]
    assert (len(found), len(np.unique(found.track))) == (crossings, people)
    assert square.density.sum() == pytest.approx(density, abs=1e-9)
    assert np.nansum(square.mean_speed) == pytest.approx(speed, abs=1e-9)
