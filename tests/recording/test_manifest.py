"""recording.toml: read, written, refused."""

from __future__ import annotations

import errno
import os
import string
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.errors import OutputError, RecordingError
from tracking.geometry import Ground
from tracking.recording import (
    Manifest,
    format_manifest,
    parse_manifest,
    read_manifest,
    write_manifest,
)
from tracking.recording.image_pairs import LAYOUTS
from tracking.recording.region_of_interest import RegionOfInterest

SOURCES = st.text(string.ascii_letters + "/*.é", min_size=1, max_size=12)
GROUNDS = st.none() | st.builds(
    Ground, st.floats(0.1, 100), st.floats(-90, 90), st.floats(-180, 180)
)
OUTLINES = st.lists(
    st.lists(st.tuples(*2 * [st.floats(-1e5, 1e5)]), min_size=3, max_size=5).map(tuple), max_size=2
).map(tuple)
COMMON = {
    "name": st.text(max_size=20),
    "left": SOURCES,
    "fps": st.none() | st.floats(0.01, 1000),
    "calibration": st.lists(SOURCES, max_size=2).map(tuple),
    "ground": GROUNDS,
    "region": st.builds(RegionOfInterest, OUTLINES, OUTLINES),
}
LAGS = st.none() | st.integers(-60, 60)
MANIFESTS = st.one_of(
    st.builds(Manifest, **COMMON),
    st.builds(Manifest, right=SOURCES, right_lag=LAGS, **COMMON),
    st.builds(
        Manifest,
        right_lag=LAGS,
        layout=st.sampled_from(LAYOUTS),
        first=st.sampled_from(["left", "right"]),
        **COMMON,
    ),
)


def parsed(text: str) -> Manifest:
    return parse_manifest(text, "recording.toml", "folder")


@given(MANIFESTS)
@settings(deadline=None)
def test_a_formatted_manifest_reads_back_as_it_was(manifest: Manifest) -> None:
    assert parsed(format_manifest(manifest)) == manifest


def test_the_contracts_example_is_read() -> None:
    manifest = parsed(
        'format = 1\nname = "Lobby, camera 3"\nfps = 20.0\n'
        '[left]\nsource = "left.mp4"\n[right]\nsource = "right.mp4"\n'
        '[calibration]\nfile = ["intrinsics.yml", "extrinsics.yml"]\n'
        "[ground]\nheight = 2.4\ntilt = 30\n"
    )
    assert manifest == Manifest(
        "Lobby, camera 3",
        "left.mp4",
        "right.mp4",
        fps=20.0,
        calibration=("intrinsics.yml", "extrinsics.yml"),
        ground=Ground(2.4, 30.0),
    )


@pytest.mark.parametrize(("lag", "problem"), [("61", "-60 to 60"), ("1.5", "a whole number")])
def test_a_lag_that_cannot_be_is_refused(lag: str, problem: str) -> None:
    with pytest.raises(RecordingError, match=rf"recording.toml: \[right\] lag must be {problem}"):
        parsed(f'[left]\nsource = "a.mp4"\n[right]\nsource = "b.mp4"\nlag = {lag}\n')


def test_one_video_with_both_cameras_lies_side_by_side_with_the_left_camera_first_unless_told() -> (
    None
):
    manifest = parsed('[stereo]\nsource = "both.mp4"\n')
    assert (manifest.layout, manifest.first) == ("side-by-side", "left")
    manifest = parsed('[stereo]\nsource = "both.mp4"\nlayout = "top-bottom"\nfirst = "right"\n')
    assert (manifest.layout, manifest.first) == ("top-bottom", "right")


def test_keys_that_mean_nothing_are_kept_to_be_told() -> None:
    manifest = parsed('colour = 1\n[left]\nsource = "a.mp4"\nfsp = 3\n')
    assert manifest.unknown == ("colour", "left.fsp")


LEFT = '[left]\nsource = "a.mp4"\n'


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("format = 2\n" + LEFT, "format 2"),
        ("name = 3\n" + LEFT, "name must be a text"),
        ("fps = -1\n" + LEFT, "fps"),
        ("fps = nan\n" + LEFT, "fps"),
        ("fps = true\n" + LEFT, "fps must be a number"),
        ('fps = "fast"\n' + LEFT, "fps must be a number"),
        ("", "left is missing"),
        ("left = 3\n", "left must be a table"),
        ("[left]\n", r"\[left\] source is missing"),
        ("[left]\nsource = 3\n", r"\[left\] source must be a text"),
        (LEFT + '[stereo]\nsource = "b.mp4"\n', "keep one"),
        (
            '[stereo]\nsource = "b.mp4"\nlayout = "diagonal"\n',
            "side-by-side, top-bottom, row-interleaved, frame-sequential",
        ),
        ('[stereo]\nsource = "b.mp4"\nfirst = "middle"\n', "left, right"),
        (LEFT + "[calibration]\nfile = []\n", "one file name"),
        (LEFT + '[calibration]\nfile = ["a", "b", "c"]\n', "one file name"),
        (LEFT + "[calibration]\nfile = [1]\n", "one file name"),
        (LEFT + "[calibration]\n", "one file name"),
        (LEFT + "[ground]\nheight = 2.0\n", "tilt is missing"),
        (LEFT + "[ground]\nheight = 2.0\ntillt = 30\n", "tilt is missing; 'tillt' stands there"),
        (LEFT + "[ground]\nheight = -2.0\ntilt = 30\n", "make no floor"),
        (LEFT + '[ground]\nheight = "high"\ntilt = 30\n', "height must be a number"),
        (f"fps = 1{'0' * 400}\n" + LEFT, "fps must be a number"),
        (LEFT + f"[ground]\nheight = 1{'0' * 400}\ntilt = 30\n", "height must be a number"),
        ('[left]\nsource = "a\\u0000.mp4"\n', "zero character"),
        (f'[left]\nsource = "{"a" * 5000}"\n', "longer than the name of any file"),
        (f'[left]\nsource = "{"a/" * 2500}b.mp4"\n', "longer than the name of any file"),
        (f'[left]\nsource = "a.mp4"\n[calibration]\nfile = "{"a" * 300}"\n', "one file name"),
        (LEFT + '[calibration]\nfile = "a\\u0000"\n', "one file name"),
        ("[left\n", "not readable as TOML.*; correct it there$"),
        ("fps = 0\n" + LEFT, "fps must be 0.001 to 10000 frames per second"),
        ("fps = 1e-300\n" + LEFT, "fps must be 0.001 to 10000 frames per second"),
        ("fps = 1e99\n" + LEFT, "fps must be 0.001 to 10000 frames per second"),
        (LEFT + "[ground]\nheight = 1e-300\ntilt = 30\n", "in metres, 0.01 to 1000"),
        (LEFT + "[ground]\nheight = 1e99\ntilt = 30\n", "in metres, 0.01 to 1000"),
        (LEFT + "[ground]\nheight = 3e5\ntilt = 30\n", "height is 300000 m; give"),
        ("a = " + "[" * 5000, "not readable as TOML"),
    ],
)
def test_a_wrong_manifest_is_refused_in_one_line_that_names_the_key(text: str, says: str) -> None:
    with pytest.raises(RecordingError, match=says) as caught:
        parsed(text)
    assert "\n" not in str(caught.value)
    assert str(caught.value).startswith("recording.toml")


def test_a_manifest_is_written_beside_its_files_and_read_from_there(tmp_path: Path) -> None:
    manifest = Manifest("Hall", "left.mp4", "right.mp4", fps=20.0)
    write_manifest(tmp_path, manifest)
    assert [file.name for file in tmp_path.iterdir()] == ["recording.toml"]
    assert read_manifest(tmp_path) == manifest


def test_without_a_name_the_folder_lends_its_own(tmp_path: Path) -> None:
    (tmp_path / "recording.toml").write_text(LEFT)
    assert read_manifest(tmp_path).name == tmp_path.name


def test_a_manifest_that_is_missing_too_large_or_no_text_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="cannot be read"):
        read_manifest(tmp_path)
    (tmp_path / "recording.toml").write_text("#" * 100_000)
    with pytest.raises(RecordingError, match="larger than"):
        read_manifest(tmp_path)
    (tmp_path / "recording.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(RecordingError, match="UTF-8"):
        read_manifest(tmp_path)


def test_a_manifest_that_cannot_take_its_place_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(OutputError, match="No space"):
        write_manifest(tmp_path, Manifest("Hall", "left.mp4"))
    assert not list(tmp_path.iterdir())


def test_a_manifest_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    with pytest.raises(OutputError):
        write_manifest(tmp_path / "missing", Manifest("Hall", "left.mp4"))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes here")
def test_a_pipe_is_no_manifest(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "recording.toml")
    with pytest.raises(RecordingError, match="not a file"):
        read_manifest(tmp_path)
