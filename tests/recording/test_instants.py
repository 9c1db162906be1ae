"""Frames in the left camera's time, with the right picture of the same instant."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numbered_videos import number_in, numbered_picture, write_video
from small_recordings import COUNT, RIGHT_OFFSET, write_pair

from tracking.errors import RecordingError
from tracking.recording import Instants, Recording, StereoFrame, open_recording
from tracking.recording.frame import Image
from tracking.recording.video import VideoSource


def write_split(folder: Path, layout: str) -> None:
    """One video that holds both cameras."""
    stack = np.hstack if layout == "side-by-side" else np.vstack
    both = [stack((numbered_picture(n), numbered_picture(n + RIGHT_OFFSET))) for n in range(COUNT)]
    write_video(folder / "both.mp4", (), pictures=both)
    manifest = f'format = 1\n[stereo]\nsource = "both.mp4"\nlayout = "{layout}"\n'
    (folder / "recording.toml").write_text(manifest)


@pytest.fixture(scope="module", params=["two videos", "side-by-side", "top-bottom"])
def recording(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> Iterator[Recording]:
    folder = tmp_path_factory.mktemp("pair")
    if request.param == "two videos":
        write_pair(folder)
    else:
        write_split(folder, request.param)
    with open_recording(folder) as opened:
        yield opened


def told(frame: StereoFrame) -> tuple[int, int, int | None, int | None]:
    """Of a frame its number, the left picture's, the right one's if it has one, and the lag."""
    assert frame.right is not None
    right = number_in(frame.right) - RIGHT_OFFSET
    paired = None if frame.right_lag is None else right
    return frame.number, number_in(frame.left), paired, frame.right_lag


def wanted(lag: int, start: int, stop: int) -> list[tuple[int, int, int | None, int | None]]:
    there = {n: n + lag for n in range(start, stop) if 0 <= n + lag < COUNT}
    return [(n, n, there.get(n), lag if n in there else None) for n in range(start, stop)]


@pytest.mark.parametrize("lag", [-COUNT, -5, -1, 0, 1, 4, COUNT])
@pytest.mark.parametrize(("start", "stop"), [(0, COUNT), (3, 9), (COUNT - 1, COUNT)])
def test_the_right_picture_is_the_one_of_the_left_ones_instant(
    recording: Recording, lag: int, start: int, stop: int
) -> None:
    instants = Instants(recording, lag)
    assert [told(frame) for frame in instants.frames(start, stop)] == wanted(lag, start, stop)
    assert [told(instants.read(n)) for n in range(start, stop)] == wanted(lag, start, stop)


@pytest.mark.parametrize("lags", [(0, 3), (2, -2), (-3, 0), (4, 1)])
def test_another_lag_counts_from_the_next_frame_on(
    recording: Recording, lags: tuple[int, int]
) -> None:
    instants = Instants(recording, lags[0])
    seen = []
    for frame in instants.frames(0, COUNT):
        seen.append(told(frame))
        if frame.number == 5:
            instants.lag = lags[1]
    assert seen == wanted(lags[0], 0, 6) + wanted(lags[1], 6, COUNT)


@pytest.mark.parametrize("lag", [-3, 0, 3])
@pytest.mark.parametrize(("start", "stop"), [(4, COUNT + 1), (-2, 5), (5, 3)])
def test_frames_that_are_not_there_are_refused(
    recording: Recording, lag: int, start: int, stop: int
) -> None:
    with pytest.raises(RecordingError, match="are not within 0 to"):
        list(Instants(recording, lag).frames(start, stop))


@pytest.mark.parametrize(("lag", "rights"), [(3, (5, 10)), (-1, (1, 6))])
def test_each_picture_is_decoded_once_and_none_waits(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, lag: int, rights: tuple[int, int]
) -> None:
    write_pair(tmp_path)
    asked: list[tuple[int, int]] = []
    decoded = [0]
    pictures = VideoSource.pictures

    def counted(self: VideoSource, start: int, stop: int) -> Iterator[Image]:
        asked.append((start, stop))
        for picture in pictures(self, start, stop):
            decoded[0] += 1
            yield picture

    monkeypatch.setattr(VideoSource, "pictures", counted)
    with open_recording(tmp_path) as opened:
        so_far = [decoded[0] for _ in Instants(opened, lag).frames(2, 7)]
    assert sorted(asked) == sorted([(2, 7), rights])
    assert so_far == [2, 4, 6, 8, 10]


@pytest.mark.parametrize("recording", ["top-bottom"], indirect=True)
@pytest.mark.parametrize("lag", [-4, 4])
def test_of_pictures_that_hold_both_cameras_one_half_waits(recording: Recording, lag: int) -> None:
    frames = Instants(recording, lag).frames(5, 7)
    frame = next(iter(frames))
    assert frame.right is not None
    assert (frame.left if lag > 0 else frame.right).base is None


def test_a_recording_of_one_camera_stays_as_it_is(tmp_path: Path) -> None:
    with open_recording(write_video(tmp_path / "one.mp4", range(3))) as alone:
        frames = list(Instants(alone, 2).frames(0, 3))
    assert [(frame.right, frame.right_lag) for frame in frames] == [(None, 0)] * 3
