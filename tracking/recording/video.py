"""A video file as pictures by number, exact to the frame."""

from __future__ import annotations

from collections import OrderedDict, deque
from collections.abc import Iterator
from pathlib import Path
from threading import Lock

import av
import numpy as np
from av.video.reformatter import ColorRange, Colorspace, VideoReformatter
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.frame import Image
from tracking.recording.pace import Pace, pace_of
from tracking.recording.packet_index import PacketIndex, index_video, open_video
from tracking.recording.pictures import broken_frames, check_number
from tracking.recording.video_cursor import NumberedFrame, VideoCursor
from tracking.translation import Message, count_msg, msg

_RECENT_BYTES = 48 * 1024 * 1024
_STEPS_BACK = 2


class VideoSource:
    """Pictures of a video file; see `PictureSource`.

    `read` keeps a decoder near the last picture and the frames decoded on the way, so that a step
    forward decodes one frame and a step back usually none.

    Args:
        path: the video.
        name: what to call it in messages.
        recent_bytes: how much to keep of the frames decoded last.

    Raises:
        RecordingError: missing, unreadable, or without frames.
    """

    def __init__(self, path: Path, name: str, recent_bytes: int = _RECENT_BYTES) -> None:
        if not path.is_file():
            raise RecordingError("{path}: no such video; check the path", path=path)
        self.name = name
        self._path = path
        self._recent_bytes = recent_bytes
        self._index: PacketIndex = index_video(str(path))
        if not self._index.frame_count:
            raise RecordingError(
                "{path}: holds no frame that can be decoded; record it again", path=path
            )
        container, stream = open_video(str(path))
        with container:
            self._promised = stream.frames
            rate = stream.average_rate or stream.guessed_rate
        self._pace: Pace = pace_of(self._index.times_s, float(rate) if rate else None)
        self._lock = Lock()
        self._cursor = VideoCursor(str(path), self._index)
        self._size = self._usual_size()
        self._reformatter = VideoReformatter()
        self._run: Iterator[NumberedFrame] = iter(())
        self._next = -1
        self._closed = False
        self._recent: OrderedDict[int, av.VideoFrame] = OrderedDict()
        self._lost: set[int] = set()

    @property
    def frame_count(self) -> int:
        """The number of frames."""
        return self._index.frame_count

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in px."""
        return self._size

    @property
    def fps(self) -> float | None:
        """Frames a second as the stream has them."""
        return self._pace.fps

    @property
    def times_s(self) -> NDArray[np.float64] | None:
        """(frame_count,) seconds since the first frame; None where the stream has no times."""
        return self._index.times_s

    @property
    def stamps_ns(self) -> NDArray[np.int64] | None:
        """None: a video's times begin with it."""
        return None

    @property
    def files(self) -> tuple[Path, ...]:
        """The video file."""
        return (self._path,)

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities of the stream, and frames found broken up to now."""
        notes = [msg("{name}: {note}", name=self.name, note=note) for note in self._pace.notes]
        if self._index.left_out:
            notes.append(
                msg(
                    "{name}: {frames} before the first whole image left out",
                    name=self.name,
                    frames=count_msg(self._index.left_out, "{n} frame", "{n} frames"),
                )
            )
        if self._promised > len(self._index.number):
            notes.append(
                msg(
                    "{name}: cut short, {n} of {promised} frames are there",
                    name=self.name,
                    n=len(self._index.number),
                    promised=self._promised,
                )
            )
        if self._lost:
            notes.append(broken_frames(self.name, self._lost))
        return tuple(notes)

    def read(self, number: int) -> Image:
        """One frame; a broken one is shown as the last good one before it."""
        check_number(self._path, number, self.frame_count)
        with self._lock:
            if self._closed:
                raise RecordingError("{path}: was closed; open it again", path=self._path)
            frame = self._recent.get(number)
            if frame is None:
                frame = self._found(number)
            return bgr(frame, self._reformatter)

    def pictures(self, start: int, stop: int) -> Iterator[Image]:
        """Frames start to stop (half-open) in order, with a decoder of their own."""
        cursor, reformatter = VideoCursor(str(self._path), self._index), VideoReformatter()
        try:
            for frame in self._every(cursor, start, stop):
                yield bgr(frame, reformatter)
        finally:
            cursor.close()

    def close(self) -> None:
        """Let go of the file."""
        with self._lock:
            self._closed = True
            self._recent.clear()
            self._cursor.close()

    def _usual_size(self) -> tuple[int, int]:
        """The size of the second picture: the first may be of another kind."""
        start = self._index.start_for(1)
        size: tuple[int, int] | None = None
        for number, frame in self._cursor.frames_from(start):
            size = frame.width, frame.height
            if number >= 1:
                break
        if size is None:
            raise RecordingError(
                "{path}: no frame can be decoded; record it again", path=self._path
            )
        return size

    def _every(self, cursor: VideoCursor, start: int, stop: int) -> Iterator[av.VideoFrame]:
        """One frame for each number, broken ones replaced by the last good one."""
        expected, good = start, None
        for number, frame in self._run_to(cursor, start):
            if number >= start:
                for missing in range(expected, min(number, stop)):
                    self._lost.add(missing)
                    yield good or frame
                if number >= stop:
                    return
                yield frame
                expected = number + 1
            good = frame
        for missing in range(expected, stop):
            self._lost.add(missing)
            yield self._only(good)

    def _found(self, number: int) -> av.VideoFrame:
        """Decode on to a frame, from where the decoder stands if it stands well."""
        if not self._index_allows_going_on(number):
            self._run = self._run_to(self._cursor, number)
        good: av.VideoFrame | None = None
        for found, frame in self._run:
            self._keep(found, frame)
            self._next = found + 1
            if found == number:
                return frame
            if found > number:
                good = good or frame
                break
            good = frame
        self._lost.add(number)
        return self._only(good or self._nearest_kept(number))

    def _index_allows_going_on(self, number: int) -> bool:
        """Whether decoding on is no longer than decoding from the frame's keyframe."""
        start = self._index.number[self._index.start_for(number)]
        return 0 <= self._next <= number and int(start) <= self._next

    def _run_to(self, cursor: VideoCursor, number: int) -> Iterator[NumberedFrame]:
        """Frames from a keyframe on from which the wanted frame comes out whole.

        A stream may call a picture a keyframe that others behind it cannot be decoded from
        (intra refresh): where the wanted frame does not come, begin a keyframe earlier.
        """
        start: int | None = self._index.start_for(number)
        held: deque[NumberedFrame] = deque()
        run: Iterator[NumberedFrame] = iter(())
        for _ in range(_STEPS_BACK + 1):
            if start is None:
                break
            run, held = cursor.frames_from(start), deque()
            for found, frame in run:
                if (frame.width, frame.height) == self._size:
                    held.append((found, frame))
                    if len(held) > self._most_kept(frame):  # a keyframe may be hours back
                        held.popleft()
                if found >= number:
                    break
            if held and held[-1][0] == number and not held[-1][1].is_corrupt:
                break
            start = self._index.start_before(start)
        yield from held
        yield from (pair for pair in run if (pair[1].width, pair[1].height) == self._size)

    def _keep(self, number: int, frame: av.VideoFrame) -> None:
        self._recent[number] = frame
        while len(self._recent) > self._most_kept(frame):
            self._recent.popitem(last=False)

    def _most_kept(self, frame: av.VideoFrame) -> int:
        """How many frames like this one may be in memory at once."""
        return max(2, self._recent_bytes // max(1, sum(p.buffer_size for p in frame.planes)))

    def _nearest_kept(self, number: int) -> av.VideoFrame | None:
        earlier = [kept for kept in self._recent if kept < number]
        return self._recent[max(earlier)] if earlier else None

    def _only(self, frame: av.VideoFrame | None) -> av.VideoFrame:
        if frame is None:
            raise RecordingError(
                "{path}: no frame can be decoded; record it again", path=self._path
            )
        return frame


def bgr(frame: av.VideoFrame, reformatter: VideoReformatter) -> Image:
    """The frame as (height, width, 3) BGR.

    Args:
        frame: in whatever pixel format the decoder gave.
        reformatter: kept by the caller from frame to frame, which makes it fast. Threads of its
            own would cost it more than they save.

    Raises:
        RecordingError: the pixel format cannot be converted.
    """
    try:
        try:
            converted = reformatter.reformat(frame, format="bgr24", threads=1)
        except av.error.FFmpegError:
            # A colour space that FFmpeg does not convert, often only a damaged header.
            converted = reformatter.reformat(
                frame,
                format="bgr24",
                src_colorspace=Colorspace.ITU601,
                src_color_range=ColorRange.MPEG,
                threads=1,
            )
        return np.asarray(converted.to_ndarray(), np.uint8)
    except (av.error.FFmpegError, ValueError) as error:
        raise RecordingError(
            "frame {pts}: its pixels ({name}) cannot be converted; convert the video to H.264",
            pts=frame.pts,
            name=frame.format.name,
        ) from error
