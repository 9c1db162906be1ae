"""Videos read by frame number, exactly, in every encoding."""

from __future__ import annotations

import gc
import random
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import av
import numpy as np
import pytest
from av.video.reformatter import VideoReformatter
from numbered_videos import number_in, numbered_picture, write_video

from tracking.errors import RecordingError
from tracking.recording.video import VideoSource, bgr
from tracking.recording.video_cursor import NumberedFrame, VideoCursor

COUNT = 120
UNEVEN = np.cumsum(np.random.default_rng(0).integers(50, 300, COUNT)).tolist()
X264 = "scenecut=0:b-adapt=0:bframes=3"
X265 = "log-level=none:bframes=3:keyint=25"

KINDS: Mapping[str, dict[str, Any]] = {
    "b-frames.mp4": {"options": {"g": "25", "x264-params": X264}},
    "long-group.mp4": {"options": {"g": "1000", "x264-params": X264}},
    "open-groups.mp4": {"options": {"g": "25", "x264-params": f"open-gop=1:{X264}"}},
    "open-groups.ts": {"options": {"g": "25", "x264-params": f"open-gop=1:{X264}"}},
    "intra-refresh.ts": {"options": {"g": "25", "x264-params": "intra-refresh=1"}},
    "variable-rate.mp4": {"times": UNEVEN, "options": {"g": "25"}},
    "variable-rate.mkv": {"times": UNEVEN, "options": {"g": "25", "x264-params": X264}},
    "h264-with-b-frames.avi": {"options": {"g": "25", "x264-params": X264}},
    "mpeg4-with-b-frames.avi": {"codec": "mpeg4", "gop": 12, "b_frames": 2},
    "mpeg4.mp4": {"codec": "mpeg4", "gop": 12},
    "msmpeg4.avi": {"codec": "msmpeg4", "gop": 40},
    "mjpeg.avi": {"codec": "mjpeg", "pixels": "yuvj420p"},
    "mpeg2.ts": {"codec": "mpeg2video", "gop": 15, "b_frames": 2},
    "mpeg2.mpg": {"codec": "mpeg2video", "gop": 15, "b_frames": 2},
    "raw.h264": {"options": {"g": "25", "x264-params": X264}},
    "hevc-open-groups.mp4": {
        "codec": "libx265", "options": {"x265-params": f"open-gop=1:{X265}"}
    },
    "hevc-open-groups.ts": {
        "codec": "libx265", "options": {"x265-params": f"open-gop=1:{X265}"}
    },
}  # fmt: skip


@pytest.fixture(scope="module", params=KINDS)
def video(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("videos") / request.param
    return write_video(path, range(COUNT), **KINDS[request.param])


def opened(path: Path, recent_bytes: int = 1) -> VideoSource:
    """A source that keeps next to nothing, so that every read really seeks."""
    return VideoSource(path, path.name, recent_bytes)


def test_every_frame_is_the_one_asked_for_after_random_seeks(video: Path) -> None:
    source = opened(video)
    order = [random.Random(1).randrange(COUNT) for _ in range(150)]
    assert source.frame_count == COUNT
    assert [number_in(source.read(number)) for number in order] == order


def test_stepping_backward_is_exact(video: Path) -> None:
    source = opened(video)
    steps = list(range(COUNT - 1, COUNT - 40, -1))
    assert [number_in(source.read(number)) for number in steps] == steps


def test_reading_in_order_gives_all_frames_and_any_part_of_them(video: Path) -> None:
    source = opened(video)
    assert [number_in(image) for image in source.pictures(0, COUNT)] == list(range(COUNT))
    assert [number_in(image) for image in source.pictures(41, 97)] == list(range(41, 97))
    assert list(source.pictures(5, 5)) == []


def test_reading_in_order_and_by_number_give_the_same_pixels(video: Path) -> None:
    source = opened(video)
    for number, image in enumerate(source.pictures(20, 60), 20):
        np.testing.assert_array_equal(image, source.read(number))


def test_a_step_back_within_what_was_decoded_needs_no_seek(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = VideoSource(write_video(tmp_path / "v.mp4", range(60)), "v")
    source.read(50)
    monkeypatch.setattr(source, "_run_to", None)
    assert number_in(source.read(49)) == 49
    assert number_in(source.read(12)) == 12
    assert number_in(source.read(51)) == 51


def test_one_keyframe_at_the_beginning_does_not_fill_the_memory(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    video = write_video(tmp_path / "v.mp4", range(60), options={"g": "600"})
    source = VideoSource(video, "v", recent_bytes=5 * 128 * 96 * 2)
    gc.collect()
    before, most = frames_alive(), 0
    frames_from = VideoCursor.frames_from

    def counted(cursor: VideoCursor, packet: int) -> Iterator[NumberedFrame]:
        nonlocal most
        for number, frame in frames_from(cursor, packet):
            most = max(most, frames_alive() - before)
            yield number, frame

    monkeypatch.setattr(VideoCursor, "frames_from", counted)
    assert number_in(source.read(50)) == 50
    assert number_in(next(iter(source.pictures(55, 56)))) == 55
    assert most < 20


def test_reads_from_several_threads_do_not_mix(tmp_path: Path) -> None:
    source = opened(write_video(tmp_path / "v.mp4", range(60), options={"g": "12"}))
    order = [random.Random(2).randrange(60) for _ in range(120)]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(lambda n: number_in(source.read(n)), order)) == order


def test_the_rate_and_the_times_are_the_streams(tmp_path: Path) -> None:
    even = opened(write_video(tmp_path / "even.mp4", range(30), fps=20))
    assert even.fps == 20
    assert even.notes == ()
    assert even.times_s is not None
    np.testing.assert_allclose(even.times_s, np.arange(30) / 20, atol=1e-4)
    uneven = opened(write_video(tmp_path / "uneven.mp4", range(30), times=UNEVEN[:30]))
    assert uneven.times_s is not None
    expected = (np.array(UNEVEN[:30]) - UNEVEN[0]) / 2500
    np.testing.assert_allclose(uneven.times_s, expected, atol=1e-3)
    assert "varies" in uneven.notes[0]


def test_frames_that_were_never_recorded_are_told(tmp_path: Path) -> None:
    times = [100 * n for n in range(40) if n not in (17, 18)]
    source = opened(write_video(tmp_path / "gap.mp4", range(38), times=times))
    assert source.frame_count == 38
    assert source.fps == pytest.approx(25)
    assert "2 frames not recorded, first after 16" in source.notes[0]
    assert source.notes[0].values["note"].values["first"] == 16  # told in any language


def test_a_broken_frame_is_shown_as_the_one_before_and_told(tmp_path: Path) -> None:
    path = write_video(tmp_path / "v.avi", range(40), codec="mjpeg", pixels="yuvj420p")
    _overwrite_packet(path, 20)
    source = opened(path)
    assert source.frame_count == 40
    shown = [number_in(image) for image in source.pictures(0, 40)]
    assert shown == [*range(20), 19, *range(21, 40)]
    assert number_in(source.read(20)) == 19
    assert number_in(source.read(21)) == 21
    assert any("1 broken frame, first 20" in note for note in source.notes)


def test_a_video_cut_short_gives_the_frames_it_still_has(tmp_path: Path) -> None:
    path = write_video(tmp_path / "v.ts", range(60), options={"g": "10"})
    content = path.read_bytes()
    path.write_bytes(content[: len(content) * 2 // 3])
    source = opened(path)
    assert 20 < source.frame_count < 60
    for number in (0, 13, source.frame_count - 3):
        assert number_in(source.read(number)) == number


def test_a_video_that_promises_more_than_it_holds_says_so(tmp_path: Path) -> None:
    path = write_video(tmp_path / "v.avi", range(60), codec="mjpeg", pixels="yuvj420p")
    content = path.read_bytes()
    path.write_bytes(content[: len(content) // 2])
    source = opened(path)
    assert 20 < source.frame_count < 40
    assert any("cut short" in note and "of 60 frames" in note for note in source.notes)


def test_a_stream_that_begins_inside_a_group_begins_with_its_first_whole_picture(
    tmp_path: Path,
) -> None:
    path = write_video(
        tmp_path / "v.ts", range(90), options={"g": "30", "x264-params": f"open-gop=1:{X264}"}
    )
    cut = _without_first_packets(path, tmp_path / "cut.ts", 12)
    source = opened(cut)
    first = number_in(source.read(0))
    assert first > 12
    assert source.frame_count == 90 - first
    assert [number_in(image) for image in source.pictures(0, 20)] == list(range(first, first + 20))
    assert any("left out" in note for note in source.notes)


def test_a_first_frame_of_another_size_gives_way_to_the_next(tmp_path: Path) -> None:
    small = [numbered_picture(0)[::2, ::2].copy()]
    write_video(tmp_path / "small.avi", [], "mjpeg", pixels="yuvj420p", pictures=small)
    write_video(tmp_path / "rest.avi", range(1, 20), "mjpeg", pixels="yuvj420p")
    source = opened(_joined(tmp_path / "small.avi", tmp_path / "rest.avi", tmp_path / "v.avi"))
    assert source.size == (128, 96)
    assert number_in(source.read(0)) == 1
    assert [number_in(image) for image in source.pictures(0, 4)] == [1, 1, 2, 3]
    assert any("first 0" in note for note in source.notes)


@pytest.mark.parametrize("content", [b"", b"not a video at all" * 50, b"\x00" * 4096])
def test_what_is_no_video_is_refused_in_one_line(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "v.mp4"
    path.write_bytes(content)
    with pytest.raises(RecordingError) as caught:
        opened(path)
    assert "v.mp4" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_playlist_is_not_followed(tmp_path: Path) -> None:
    write_video(tmp_path / "secret.ts", range(5))
    path = tmp_path / "v.mp4"
    path.write_text("ffconcat version 1.0\nfile secret.ts\n")
    with pytest.raises(RecordingError):
        opened(path)
    path.write_text("#EXTM3U\n#EXT-X-TARGETDURATION:9\n#EXTINF:9,\nsecret.ts\n#EXT-X-ENDLIST\n")
    with pytest.raises(RecordingError):
        opened(path)


def test_a_missing_video_and_a_frame_out_of_range_are_told(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="no such video"):
        opened(tmp_path / "v.mp4")
    source = opened(write_video(tmp_path / "v.mp4", range(5)))
    for number in (-1, 5):
        with pytest.raises(RecordingError, match="not among 0 to 4"):
            source.read(number)


def frames_alive() -> int:
    return sum(isinstance(held, av.VideoFrame) for held in gc.get_objects())


def _overwrite_packet(path: Path, wanted: int) -> None:
    """Fill one packet of an AVI with zeros."""
    with av.open(str(path)) as container:
        packets = [p for p in container.demux(video=0) if p.size]
        position, size = packets[wanted].pos, packets[wanted].size
    content = bytearray(path.read_bytes())
    assert position is not None
    content[position : position + size] = bytes(size)
    path.write_bytes(content)


def _without_first_packets(source: Path, target: Path, count: int) -> Path:
    with av.open(str(source)) as read, av.open(str(target), "w") as written:
        stream = written.add_stream_from_template(read.streams.video[0])
        for number, packet in enumerate(p for p in read.demux(video=0) if p.size):
            if number >= count:
                packet.stream = stream
                written.mux(packet)
    return target


def _joined(first: Path, second: Path, target: Path) -> Path:
    """The packets of both in one stream; it says the second one's size."""
    with av.open(str(first)) as one, av.open(str(second)) as two, av.open(str(target), "w") as out:
        stream = out.add_stream_from_template(two.streams.video[0])
        packets = [p for source in (one, two) for p in source.demux(video=0) if p.size]
        for number, packet in enumerate(packets):
            packet.stream, packet.pts, packet.dts = stream, number, number
            out.mux(packet)
    return target


def test_a_colour_space_that_cannot_be_converted_is_read_as_the_usual_one(tmp_path: Path) -> None:
    with av.open(str(write_video(tmp_path / "v.mp4", [5]))) as container:
        frame = next(container.decode(video=0))
    frame.colorspace = 14
    assert number_in(bgr(frame, VideoReformatter())) == 5
