"""Every tracker is given the boxes that its settings name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tracking.errors import FormatError
from tracking.people.box_bodies import in_boxes
from tracking.pipeline import track
from tracking.recording import Recording, open_recording
from tracking.synthesis import render_recording
from tracking.trackers import TRACKERS, parse_settings
from tracking.tracks import Columns


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("recordings") / "square"
    render_recording(folder, "lobby", 8.0, 3, 12)
    return folder


@pytest.mark.parametrize("name", list(TRACKERS))
def test_a_tracker_reads_the_detections_that_its_settings_name_beside_the_recording(
    name: str, rendered: Path
) -> None:
    spec = TRACKERS[name]
    with open_recording(rendered) as recording:
        settings = parse_settings(spec, {"detections.file": "missing.txt"})
        with (
            track(recording, name, settings, frames=(0, 2)) as work,
            pytest.raises(FormatError, match="missing"),
        ):
            next(work)


@pytest.fixture(scope="module")
def with_truth(rendered: Path) -> Path:
    """The recording with the true boxes beside it, as a detector would tell them."""
    truth = np.loadtxt(rendered / "truth.txt", delimiter=",", ndmin=2)
    none, sure = np.full(len(truth), -1.0), np.full(len(truth), 0.9)
    told = np.column_stack((truth[:, 0], none, truth[:, 2:6], sure))
    np.savetxt(rendered / "told.txt", told, fmt="%.2f", delimiter=",")
    return rendered


@pytest.mark.parametrize("name", list(TRACKERS))
def test_with_boxes_alone_nobody_is_found_where_no_box_is(name: str, with_truth: Path) -> None:
    (with_truth / "nobody.txt").write_text("1,-1,2,2,3,6,0.9\n")
    with open_recording(with_truth) as recording:
        run = _tracked(recording, name, "nobody.txt", "only")
    assert len(run["track"]) == 0


@pytest.mark.parametrize("name", list(TRACKERS))
def test_with_boxes_alone_people_are_tracked_where_boxes_are(name: str, with_truth: Path) -> None:
    with open_recording(with_truth) as recording:
        run = _tracked(recording, name, "told.txt", "only")
    truth = np.loadtxt(with_truth / "truth.txt", delimiter=",", ndmin=2)
    box = np.column_stack([run[side] for side in ("left", "top", "width", "height")]).astype(float)
    middle = box[:, :2] + box[:, 2:] / 2
    on_somebody = [
        in_boxes(one[None], truth[truth[:, 0] == frame + 1, 2:6])[0]
        for frame, one in zip(run["frame"], middle, strict=True)
    ]
    assert 0.6 < len(box) / len(truth) < 1.4
    assert np.mean(on_somebody) > 0.4  # by chance it is less than 0.1


def _tracked(recording: Recording, name: str, file: str, use: str) -> Columns:
    settings = parse_settings(TRACKERS[name], {"detections.file": file, "detections.use": use})
    with track(recording, name, settings) as work:
        for _ in work:
            pass
        return work.run().tracks
