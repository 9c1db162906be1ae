"""What of an order decides what a tracker finds: files by what they hold, and no others."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.batch.batches import QUICK
from tests.networks.small_networks import bright_rectangles, written


def digest_with(name: str, place: Path) -> str:
    return replace(QUICK, settings=((name, str(place)),)).tracking_digest()


@pytest.fixture
def network(tmp_path: Path) -> Path:
    return written(tmp_path, bright_rectangles(10, 20), decoder="yolo", classes=["person"])


def test_results_below_a_networks_folder_do_not_count(network: Path) -> None:
    before = digest_with("detections.model", network)
    (network.parent / "out").mkdir()
    (network.parent / "out" / "batch.sqlite").write_bytes(b"results")
    assert digest_with("detections.model", network) == before


@pytest.mark.parametrize("file", ["people.toml", "people.onnx"])
def test_a_networks_own_files_count(network: Path, file: str) -> None:
    before = digest_with("detections.model", network)
    with (network.parent / file).open("ab") as stream:
        stream.write(b"\n")
    assert digest_with("detections.model", network) != before


def test_a_network_that_is_mended_counts_as_another(network: Path) -> None:
    onnx = network.with_suffix(".onnx")
    held = onnx.read_bytes()
    onnx.unlink()
    before = digest_with("detections.model", network)
    onnx.write_bytes(held)
    assert digest_with("detections.model", network) != before


def test_a_detector_counts_by_itself(tmp_path: Path) -> None:
    detector = tmp_path / "parts.toml"
    detector.write_bytes(b"a detector")
    before = digest_with("detector", detector)
    (tmp_path / "other").write_bytes(b"of no account")
    assert digest_with("detector", detector) == before
