"""No tracker looks for people outside of the region of interest."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tracking.pipeline import track
from tracking.recording import OpenOptions, open_recording
from tracking.synthesis import render_recording
from tracking.trackers import TRACKERS
from tracking.tracks import Columns

WIDTH, HEIGHT = 640.0, 480.0
LEFT_HALF = ((0.0, 0.0), (WIDTH / 2, 0.0), (WIDTH / 2, HEIGHT), (0.0, HEIGHT))
ALL_BUT_A_CORNER = ((20.0, 0.0), (WIDTH, 0.0), (WIDTH, HEIGHT), (0.0, HEIGHT), (0.0, 20.0))


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("recordings") / "lobby"
    render_recording(folder, "lobby", 8.0, 3, 12)
    return folder


@pytest.mark.parametrize("name", list(TRACKERS))
def test_people_are_tracked_within_the_region_alone(name: str, rendered: Path) -> None:
    run = _tracked(rendered, name, OpenOptions(look=(LEFT_HALF,)))
    middle = run["left"] + run["width"] / 2
    assert len(middle) > 20
    assert np.mean(middle < WIDTH / 2) > 0.95
    assert middle.max() < WIDTH / 2 + 30  # bodies are as wide


@pytest.mark.parametrize("name", list(TRACKERS))
def test_nobody_is_tracked_where_all_is_masked(name: str, rendered: Path) -> None:
    run = _tracked(rendered, name, OpenOptions(mask=(ALL_BUT_A_CORNER,)))
    assert len(run["track"]) == 0


def _tracked(folder: Path, name: str, options: OpenOptions) -> Columns:
    with open_recording(folder, options) as recording:
        assert recording.size == (WIDTH, HEIGHT)
        with track(recording, name) as work:
            for _ in work:
                pass
            return work.run().tracks
