"""Recordings whose cameras, images or times are not as they should be: mended or told."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest
from numbered_videos import number_in, numbered_picture, write_video
from small_recordings import (
    COUNT,
    RIGHT_OFFSET,
    numbers_of,
    ones,
    pairs,
    write_images,
    write_pair,
)

from tracking.errors import RecordingError
from tracking.recording import (
    OpenOptions,
    open_recording,
)


def test_cameras_of_different_length_end_with_the_shorter_one(tmp_path: Path) -> None:
    write_pair(tmp_path, right_count=COUNT - 4)
    with open_recording(tmp_path) as recording:
        assert numbers_of(recording) == pairs(COUNT - 4)
        assert any("left.mp4 has 12 frames, right.mp4 8" in note for note in recording.notes)


def test_cameras_of_different_size_are_refused(tmp_path: Path) -> None:
    write_video(tmp_path / "left.mp4", range(3))
    big = [numbered_picture(n, 160, 96) for n in range(3)]
    write_video(tmp_path / "right.mp4", [], pictures=big)
    with pytest.raises(RecordingError, match=r"128 x 96.*160 x 96"):
        open_recording(tmp_path)


def test_a_frame_one_camera_dropped_does_not_shift_the_rest(tmp_path: Path) -> None:
    """The right camera's times show a gap; cameras stay paired by the instant."""
    write_video(tmp_path / "left.mp4", range(40))
    kept = [n for n in range(40) if n != 21]
    write_video(
        tmp_path / "right.mp4", [n + RIGHT_OFFSET for n in kept], times=[100 * n for n in kept]
    )
    with open_recording(tmp_path) as recording:
        expected = pairs(40)
        expected[21] = (21, 20 + RIGHT_OFFSET)
        assert numbers_of(recording) == expected
        frame = recording.read(30)
        assert frame.right is not None
        assert number_in(frame.right) == 30 + RIGHT_OFFSET
        assert any(
            "in 1 frame the right image is the one before" in note for note in recording.notes
        )
        assert any("right.mp4: 1 frame not recorded" in note for note in recording.notes)


def test_an_image_one_camera_lacks_does_not_shift_the_rest(tmp_path: Path) -> None:
    write_images(tmp_path / "left", range(COUNT))
    write_images(tmp_path / "right", [n for n in range(COUNT) if n != 5], RIGHT_OFFSET)
    with open_recording(tmp_path, OpenOptions(fps=10.0)) as recording:
        expected = pairs()
        expected[5] = (5, 4 + RIGHT_OFFSET)
        assert numbers_of(recording) == expected


def test_a_broken_image_is_shown_as_the_one_before_and_told(tmp_path: Path) -> None:
    folder = write_images(tmp_path / "images", range(COUNT))
    (folder / "000004.png").write_bytes(b"broken")
    cv2.imwrite(str(folder / "000000.png"), numbered_picture(0, 64, 48))
    with open_recording(folder, OpenOptions(fps=10.0)) as recording:
        assert [left for left, _ in numbers_of(recording)] == [1, 1, 2, 3, 3, *range(5, COUNT)]
        assert any("2 images broken or of another size" in note for note in recording.notes)


def test_numbers_missing_among_images_are_told(tmp_path: Path) -> None:
    folder = write_images(tmp_path / "images", [*range(5), *range(7, 12)])
    with open_recording(folder, OpenOptions(fps=10.0)) as recording:
        assert recording.frame_count == 10
        assert any("2 numbers missing" in note for note in recording.notes)


def test_images_stand_in_natural_order(tmp_path: Path) -> None:
    for number in range(COUNT):
        cv2.imwrite(str(tmp_path / f"frame {number}.png"), numbered_picture(number))
    with open_recording(tmp_path, OpenOptions(fps=10.0)) as recording:
        assert numbers_of(recording) == ones()


def test_raised_digits_in_names_are_no_numbers(tmp_path: Path) -> None:
    for name in ("²1.png", "²3.png"):
        cv2.imwrite(str(tmp_path / name), numbered_picture(int(name[1])))
    with open_recording(tmp_path, OpenOptions(fps=5.0)) as recording:
        assert numbers_of(recording) == [(1, None), (3, None)]


def test_grey_images_and_sixteen_bits_become_bgr(tmp_path: Path) -> None:
    grey = numbered_picture(3)[..., 0].astype(np.uint16) * 256
    for number in range(3):
        cv2.imwrite(str(tmp_path / f"{number}.png"), grey)
    with open_recording(tmp_path, OpenOptions(fps=10.0)) as recording:
        left = recording.read(1).left
        assert (left.shape, left.dtype) == ((96, 128, 3), np.uint8)
        assert number_in(left) == 3


def test_a_letterboxed_first_frame_is_told(tmp_path: Path) -> None:
    first = numbered_picture(0)
    first[:12] = first[-12:] = 0
    pictures = [first, *(np.maximum(numbered_picture(n), 60) for n in range(1, 6))]
    write_video(tmp_path / "v.mp4", [], pictures=pictures)
    with open_recording(tmp_path / "v.mp4") as recording:
        assert any("letterboxed" in note for note in recording.notes)


def test_a_rate_that_differs_from_the_streams_counts_and_is_told(tmp_path: Path) -> None:
    write_video(tmp_path / "v.mp4", range(10))
    (tmp_path / "recording.toml").write_text('fps = 7\nshade = 1\n[left]\nsource = "v.mp4"\n')
    with open_recording(tmp_path) as recording:
        assert recording.read(7).time_s == pytest.approx(1.0)
        assert any(
            "25 frames per second, recording.toml says 7" in note for note in recording.notes
        )
        assert any("shade means nothing" in note for note in recording.notes)


def test_a_rate_that_differs_a_little_counts_for_every_frame(tmp_path: Path) -> None:
    """Long enough for the two clocks to be more than half a frame apart."""
    write_video(tmp_path / "v.mp4", range(120))
    (tmp_path / "recording.toml").write_text('fps = 25.167\n[left]\nsource = "v.mp4"\n')
    with open_recording(tmp_path) as recording:
        assert recording.uneven_times_s is None
        assert recording.time_s(100) == pytest.approx(100 / 25.167)


def test_uneven_frames_keep_the_times_of_the_stream(tmp_path: Path) -> None:
    times = [0, 100, 200, 900, 1000, 1100]
    write_video(tmp_path / "v.mp4", range(6), times=times)
    with open_recording(tmp_path / "v.mp4") as recording:
        assert recording.read(3).time_s == pytest.approx(0.36, abs=0.002)
        assert [f.time_s for f in recording.frames(1, 3)] == pytest.approx([0.04, 0.08], abs=0.002)
