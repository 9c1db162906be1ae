"""What is done with a finished run of the three-part trackers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tracking.formats import read_mot
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.scoring import FloorMatch, ScoringTable, score
from tracking.settings import settings_from
from tracking.synthesis import render_recording
from tracking.trackers import tracker_named
from tracking.tracks import Run

TRACKER = "three-part"


@pytest.fixture(scope="module")
def walkway(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four people behind each other's backs, half as large as usual for speed."""
    folder = tmp_path_factory.mktemp("clips") / "square"
    return render_recording(folder, "square", 9.0, 8, 7, size=(320, 240), cameras=1)


def run_with(folder: Path, **settings: bool) -> Run:
    """The tracker's run with these settings."""
    chosen = settings_from(tracker_named(TRACKER).settings_type, settings)
    with open_recording(folder) as recording, track(recording, TRACKER, chosen, 3) as work:
        for _ in work:
            pass
        return work.run()


def test_linked_runs_are_nearer_to_the_truth(walkway: Path) -> None:
    truth = ScoringTable.from_columns(read_mot(walkway / "truth.txt"), dont_cares=True)
    linked, live = (run_with(walkway, smooth=smooth) for smooth in (True, False))
    better, worse = (
        score(truth, ScoringTable.from_columns(run.tracks), FloorMatch(0.5)).as_json()
        for run in (linked, live)
    )
    assert better["IDF1"] > worse["IDF1"]
    assert set(np.unique(linked.parts["track"])) <= set(np.unique(linked.tracks["track"])) | {0}


def test_as_published_the_run_is_what_was_tracked(walkway: Path) -> None:
    runs = [run_with(walkway, reidentify=False, smooth=smooth) for smooth in (True, False)]
    for name, column in runs[0].tracks.items():
        np.testing.assert_array_equal(column, runs[1].tracks[name])
