"""A piece of somebody beside them, as an arm or a bag held out: no second person."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from people_of_three_blocks import FPS, RED_BLUE, SIZE, Blocks, observations, seen_in, walking

from tracking.people.observation import Observation
from tracking.trackers.three_part import ThreePartSettings, births
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.tracker import Camera, PartTracker

FRAMES, COMES = 40, 12
PERSON = Blocks(walking((60.0, 60.0), (2.0, 0.0)), RED_BLUE)


def _with_a_piece_beside() -> Iterator[Observation]:
    """Somebody who walks, and later a region of a third of their height that goes along."""
    for seen in observations([PERSON], FRAMES):
        if seen.frame < COMES:
            yield seen
            continue
        left, top = (round(each) for each in PERSON.left_top(seen.frame))
        place = np.s_[top + 25 : top + 60, left + 42 : left + 56]
        regions, picture = seen.people.regions.copy(), seen.picture.copy()
        regions[place], picture[place] = 2, (30, 30, 200)
        yield replace(seen, people=seen_in(regions), picture=picture)


def _people_followed() -> int:
    tracker = PartTracker(
        Camera(SIZE, FPS, None), ThreePartSettings(max_particles=300), Layout(3, 1), 0
    )
    results = [tracker.step(seen) for seen in _with_a_piece_beside()]
    return len({int(track) for result in results for track in result.tracks["track"]})


def test_a_piece_beside_somebody_is_nobody() -> None:
    assert _people_followed() == 1


def test_without_leaving_pieces_out_it_is_somebody(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(births, "without_pieces", lambda free, *_: free)
    assert _people_followed() > 1
