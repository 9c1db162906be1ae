"""Recordings that lead out of their folder, and what is no recording, are refused in a line."""

from __future__ import annotations

from pathlib import Path

import cv2
import pytest
from numbered_videos import numbered_picture, write_video
from small_recordings import write_images

from tracking.errors import RecordingError, TrackwrightError
from tracking.recording import Manifest, OpenOptions, open_recording, write_manifest


@pytest.mark.parametrize("named", ["/etc/left.mp4", "../left.mp4", "a/../../left.mp4", "C:\\l.mp4"])
@pytest.mark.parametrize("key", ["source", "calibration"])
def test_a_manifest_may_not_name_files_outside_its_folder(
    tmp_path: Path, named: str, key: str
) -> None:
    folder = tmp_path / "recording"
    folder.mkdir()
    write_video(folder / "v.mp4", range(3))
    source, calibration = (named, "c.yaml") if key == "source" else ("v.mp4", named)
    write_manifest(folder, Manifest("Hall", source, calibration=(calibration,)))
    with pytest.raises(RecordingError, match=r"outside the folder.*--allow-outside"):
        open_recording(folder)


def test_a_link_out_of_the_folder_is_refused_and_all_is_opened_where_the_user_allows_it(
    tmp_path: Path,
) -> None:
    folder = tmp_path / "recording"
    folder.mkdir()
    video = write_video(tmp_path / "v.mp4", range(3))
    (folder / "linked.mp4").symlink_to(video)
    write_manifest(folder, Manifest("Hall", "linked.mp4"))
    with pytest.raises(RecordingError, match="outside the folder"):
        open_recording(folder)
    allowed = OpenOptions(allow_outside=True)
    assert open_recording(folder, allowed).frame_count == 3
    write_manifest(folder, Manifest("Hall", "../v.mp4"))
    assert open_recording(folder, allowed).frame_count == 3
    write_manifest(folder, Manifest("Hall", str(video)))
    assert open_recording(folder, allowed).frame_count == 3


def test_a_pattern_that_leads_through_a_link_out_of_the_folder_is_refused(tmp_path: Path) -> None:
    folder = tmp_path / "recording"
    write_images(tmp_path / "elsewhere", range(3))
    write_images(folder / "eye1", range(3))
    write_manifest(folder, Manifest("Hall", "eye*/*.png", fps=10.0))
    assert open_recording(folder).frame_count == 3
    (folder / "eye2").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(RecordingError, match="outside the folder"):
        open_recording(folder)
    assert open_recording(folder, OpenOptions(allow_outside=True)).frame_count == 6


def test_signs_of_patterns_in_the_names_of_folders_are_no_pattern(tmp_path: Path) -> None:
    folder = tmp_path / "[2024] hall"
    write_images(folder / "left", range(3))
    write_manifest(folder, Manifest("Hall", "left/*.png", fps=10.0))
    assert open_recording(folder).frame_count == 3


def _empty(folder: Path) -> Path:
    (folder / "empty").mkdir()
    return folder / "empty"


def _text_file(folder: Path) -> Path:
    (folder / "notes.mp4").write_text("no video")
    return folder / "notes.mp4"


def _image(folder: Path) -> Path:
    cv2.imwrite(str(folder / "one.png"), numbered_picture(0))
    return folder / "one.png"


def _no_match(folder: Path) -> Path:
    write_manifest(folder, Manifest("Hall", "left/*.png", fps=10.0))
    return folder


def _only_broken_images(folder: Path) -> Path:
    (folder / "a.png").write_bytes(b"")
    return folder


def _missing_source(folder: Path) -> Path:
    write_manifest(folder, Manifest("Hall", "left.mp4"))
    return folder


@pytest.mark.parametrize(
    "made",
    [
        _empty,
        _text_file,
        _image,
        _no_match,
        _only_broken_images,
        _missing_source,
        lambda f: f / "x",
    ],
)
def test_what_is_no_recording_ends_in_one_line(tmp_path: Path, made: object) -> None:
    assert callable(made)
    with pytest.raises(TrackwrightError) as caught:
        open_recording(made(tmp_path))
    assert "\n" not in str(caught.value)


def test_of_a_file_that_is_no_video_it_is_said_what_can_be_opened(tmp_path: Path) -> None:
    (tmp_path / "notes.md").write_text("# Notes\n")
    with pytest.raises(RecordingError, match=r"give a video, a folder of images or a folder with"):
        open_recording(tmp_path / "notes.md")


def test_a_video_that_is_cut_off_is_told_as_that(tmp_path: Path) -> None:
    video = write_video(tmp_path / "cut.mp4", range(30))
    whole = video.read_bytes()
    video.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(RecordingError, match=r"a video that is damaged or cut off .*copy it"):
        open_recording(video)


@pytest.mark.parametrize("text", ["Bilder von Tür 1\n", "\ufeffnotes", "ü" * 600])
def test_a_text_with_the_name_of_a_video_is_told_as_that(tmp_path: Path, text: str) -> None:
    (tmp_path / "notes.mp4").write_text(text, "utf-8")
    with pytest.raises(RecordingError, match="text, not a video"):
        open_recording(tmp_path / "notes.mp4")


def test_a_text_that_could_be_drawn_as_a_film_is_none(tmp_path: Path) -> None:
    (tmp_path / "truth.txt").write_text("1,1,10,20,30,60,1,1,1\n" * 50)
    with pytest.raises(RecordingError, match=r"text, not a video; give a video"):
        open_recording(tmp_path / "truth.txt")


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("lacking", ["missing", "empty"])
def test_a_manifests_camera_that_is_not_there_is_told_as_that(
    tmp_path: Path, side: str, lacking: str
) -> None:
    other = "left" if side == "right" else "right"
    write_video(tmp_path / f"{other}.mp4", range(3))
    if lacking == "empty":
        (tmp_path / f"{side}.mp4").touch()
    write_manifest(tmp_path, Manifest("Hall", "left.mp4", right="right.mp4"))
    with pytest.raises(RecordingError) as refused:
        open_recording(tmp_path)
    told = str(refused.value)
    assert f"recording.toml: the {side} camera is {lacking}" in told
    assert "give a video" not in told
    assert ("leave [right] out" in told) == (side == "right")


@pytest.mark.parametrize(
    ("manifest", "named"),
    [
        (Manifest("Hall", "both.mp4", layout="side-by-side"), "the video of both cameras"),
        (Manifest("Hall", "only.mp4"), "the video"),
    ],
)
def test_a_manifests_only_source_that_is_not_there_is_called_no_camera(
    tmp_path: Path, manifest: Manifest, named: str
) -> None:
    write_manifest(tmp_path, manifest)
    with pytest.raises(RecordingError, match=f"recording.toml: {named} is missing"):
        open_recording(tmp_path)
