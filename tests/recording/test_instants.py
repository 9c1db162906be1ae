"""Frames in the left eye's time, with the right picture of the same instant."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from numbered_videos import number_in, write_video
from small_recordings import COUNT, RIGHT_OFFSET, write_pair

from tracking.recording import Instants, Recording, StereoFrame, open_recording


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Recording]:
    folder = tmp_path_factory.mktemp("pair")
    write_pair(folder)
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


def test_each_picture_is_decoded_once(
    recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    decoded: list[int] = []
    frames = Recording.frames

    def counted(self: Recording, start: int, stop: int) -> Iterator[StereoFrame]:
        for frame in frames(self, start, stop):
            decoded.append(frame.number)
            yield frame

    monkeypatch.setattr(Recording, "frames", counted)
    assert len(list(Instants(recording, 3).frames(2, 7))) == 5
    assert decoded == list(range(2, 10))


def test_a_recording_of_one_eye_stays_as_it_is(tmp_path: Path) -> None:
    with open_recording(write_video(tmp_path / "one.mp4", range(3))) as alone:
        frames = list(Instants(alone, 2).frames(0, 3))
    assert [(frame.right, frame.right_lag) for frame in frames] == [(None, 0)] * 3
