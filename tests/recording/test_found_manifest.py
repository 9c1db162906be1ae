"""A recording.toml without sources, in a folder of another program."""

from __future__ import annotations

from pathlib import Path

import pytest
from small_recordings import write_images

from tracking.errors import RecordingError
from tracking.recording import OpenOptions
from tracking.recording.locate import locate
from tracking.recording.manifest import Manifest


def _oak(folder: Path, other: str) -> Path:
    for side in ("left", other):
        write_images(folder / side, range(2))
    (folder / "calib.json").write_text('{"cameraData": []}')
    return folder


def _located(folder: Path, text: str) -> Manifest:
    (folder / "recording.toml").write_text(text)
    return locate(folder, OpenOptions()).manifest


def test_the_lag_counts_where_a_right_camera_is_found(tmp_path: Path) -> None:
    manifest = _located(_oak(tmp_path, "right"), "[right]\nlag = 2\n")
    assert (manifest.right, manifest.right_lag) == ("right", 2)


def test_the_scale_counts_where_depth_is_found(tmp_path: Path) -> None:
    manifest = _located(_oak(tmp_path, "depth"), "[depth]\nscale = 0.002\n")
    assert (manifest.depth, manifest.depth_scale_m) == ("depth", 0.002)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('[right]\ntopic = "/r"\n', "[right] topic counts beside [left] alone"),
        ('[depth]\nsource = "x/*.png"\n', "[depth] source counts beside [left] alone"),
        ("[depth]\nscale = 0.01\n", "[depth] scale is of depth images"),
    ],
)
def test_what_needs_sources_is_refused_without(text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(RecordingError) as refused:
        _located(_oak(tmp_path, "right"), text)
    assert words in str(refused.value)


def test_the_lag_is_refused_where_no_right_camera_is_found(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="none was found"):
        _located(_oak(tmp_path, "depth"), "[right]\nlag = 2\n")
