"""`doctor`: one document, mends that are named, and wrong input in one line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.synthesis import SCENES, render_recording


@pytest.fixture(scope="module")
def too_high(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording whose camera is said to hang a tenth higher than it does."""
    folder = tmp_path_factory.mktemp("doctor") / "lobby"
    render_recording(folder, SCENES["lobby"], 3.0, 3, 11)
    manifest = folder / "recording.toml"
    text = manifest.read_text(encoding="utf-8")
    height = next(line for line in text.splitlines() if line.startswith("height"))
    high = f"height = {float(height.split('=')[1]) * 1.1}"
    manifest.write_text(text.replace(height, high), encoding="utf-8")
    return folder


def test_one_document_names_findings_with_cost_and_checks(
    trackwright: Trackwright, too_high: Path, tmp_path: Path
) -> None:
    asked = ("--json", "--pictures", tmp_path / "shown")
    status, printed, _ = trackwright("doctor", too_high, *asked)
    assert status == 0
    document = json.loads(printed)
    (finding,) = document["findings"]
    assert finding["code"] == "scale"
    assert finding["fixable"]
    assert 0.2 < finding["cost_m"] < 1.0
    assert {"title", "evidence", "fix"} <= set(finding)
    assert "floor" in document["checked"]
    assert (tmp_path / "shown" / "scale.png").is_file()


def test_a_code_that_was_not_found_is_a_usage_error(
    trackwright: Trackwright, too_high: Path
) -> None:
    before = (too_high / "recording.toml").read_bytes()
    status, printed, said = trackwright("doctor", too_high, "--mend", "ground-roll")
    assert (status, printed) == (2, "")
    assert "scale" in said
    assert (too_high / "recording.toml").read_bytes() == before


def test_a_recording_that_is_not_there_ends_in_one_line(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    status, printed, said = trackwright("doctor", tmp_path / "none", "--json")
    assert (status, printed) == (1, "")
    assert len(said.strip().splitlines()) == 1


def test_without_a_recording_the_installation_is_checked(trackwright: Trackwright) -> None:
    status, printed, _ = trackwright("doctor", "--json")
    assert status == 0
    document = json.loads(printed)
    assert {"python", "cv2", "qt"} <= set(document["checked"])
    assert "python" not in {finding["code"] for finding in document["findings"]}
