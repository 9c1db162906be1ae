"""Two people who stand close together, seen from above."""

from __future__ import annotations

import numpy as np
from people_of_one_colour import Body, followed, frames_of, places, standing, view


def test_two_who_stand_close_together_from_the_start_are_two_tracks() -> None:
    seen_by = view()
    pair = [Body(standing((0.35, 0.55), 25)), Body(standing((0.8, 0.85), 25))]
    last = followed(seen_by, frames_of(seen_by, pair))[-1]
    found = places(last)
    assert len(found) == 2
    assert np.abs(np.sort(found[:, 0]) - (0.35, 0.8)).max() < 0.12
