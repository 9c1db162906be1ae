"""Finished runs of people followed by one camera."""

from __future__ import annotations

from dataclasses import replace

import pytest
from linked_runs import FPS, VIEW, Stretch, run_of, straight

from tracking.trackers import tracker_named

WAY = straight((-2, 6), (2, 6.5), 120)


@pytest.mark.parametrize(("paper", "people"), [(False, {1}), (True, {1, 2})])
def test_who_is_lost_for_a_moment_keeps_the_id_but_not_in_runs_as_published(
    paper: bool, people: set[int]
) -> None:
    run = run_of(Stretch(1, 0, WAY[:55]), Stretch(2, 65, WAY[65:]), frames=120)
    run = replace(run, tracker="spheroid", settings={"smooth": True, "paper": paper})
    finished = tracker_named("spheroid").finisher.finish(run, VIEW, FPS, None)
    assert set(finished.tracks["track"].tolist()) == people
