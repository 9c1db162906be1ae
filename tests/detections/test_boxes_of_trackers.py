"""Every tracker is given the boxes that its settings name."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracking.errors import FormatError
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.synthesis import render_recording
from tracking.trackers import TRACKERS, parse_settings


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("recordings") / "square"
    render_recording(folder, "square", 1.0, 1, 11)
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
