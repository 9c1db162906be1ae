"""Who leaves takes the id along: it does not go over to who stands or comes where they were."""

from __future__ import annotations

import numpy as np
import pytest
from people_of_three_blocks import FPS, GREEN_BROWN, RED_BLUE, SIZE, Blocks, observations, walking

from tracking.trackers import StepResult
from tracking.trackers.three_part import ThreePartSettings
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.tracker import Camera, PartTracker

APART, TOGETHER = Layout(3, 1), Layout(3, 3)
FRAMES, GONE = 90, 65


def _followed(people: list[Blocks], layout: Layout) -> list[StepResult]:
    settings = ThreePartSettings(max_particles=400)
    tracker = PartTracker(Camera(SIZE, FPS, None), settings, layout, 0)
    return [tracker.step(each) for each in observations(people, FRAMES)]


def _track_at(result: StepResult, person: Blocks) -> int:
    left, _ = person.left_top(result.frame)
    return int(result.tracks["track"][np.abs(result.tracks["left"] - left).argmin()])


@pytest.mark.parametrize("colours", [RED_BLUE, GREEN_BROWN], ids=["alike", "in other clothes"])
@pytest.mark.parametrize("layout", [APART, TOGETHER], ids=["apart", "together"])
def test_the_id_of_who_leaves_does_not_go_over_to_a_neighbour(
    layout: Layout, colours: tuple[tuple[int, int, int], ...]
) -> None:
    stays = Blocks(walking((255, 50), (0.0, 0.0)), colours)
    leaves = Blocks(walking((150, 62), (3.0, 0.0)), RED_BLUE)
    results = _followed([stays, leaves], layout)
    own = _track_at(results[12], stays)
    assert len(results[12].tracks["track"]) == 2
    assert {tuple(each.tracks["track"].tolist()) for each in results[GONE:]} == {(own,)}
