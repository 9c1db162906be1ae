"""Which packet of a video becomes which frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TypeAlias

import av
import numpy as np
from av.codec.context import Flags
from av.container import InputContainer
from av.packet import Packet
from av.video.stream import VideoStream
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.image_headers import MOST_PIXELS

VideoPacket: TypeAlias = "Packet[VideoStream]"

_LOOKED_AT = 512
_SIGNS = ((4, b"ftyp"), (4, b"moov"), (4, b"mdat"), (0, b"\x1a\x45\xdf\xa3"), (8, b"AVI "))
"""Where and how videos begin: MP4 and MOV, Matroska and WebM, AVI."""
_TEXT_ART = frozenset({"ansi", "bintext", "idf", "xbin"})
"""Decoders that draw text as pictures: of any text file, with them, a film could be made."""

PacketStamp = tuple[int | None, int | None]
"""Decoding timestamp and byte position: what a packet is known by after a seek."""


@dataclass(frozen=True, slots=True, eq=False)
class PacketIndex:
    """All packets of one video stream, in the order they are stored (and decoded).

    Attributes:
        number: (p,) frame number of each packet, from 0 in the order of presentation; -1 for a
            packet that shows nothing (cut off by an edit list, or before the first whole picture).
        keyframes: (k,) indices of packets at which decoding can begin.
        stamps: of each keyframe packet.
        times_s: (frame_count,) seconds since the first frame; None where the stream has none.
        left_out: frames at the beginning that cannot be decoded.
    """

    number: NDArray[np.int64]
    keyframes: NDArray[np.int64]
    stamps: tuple[PacketStamp, ...]
    times_s: NDArray[np.float64] | None
    left_out: int

    @property
    def frame_count(self) -> int:
        """The number of frames shown."""
        return int(self.number.max(initial=-1)) + 1

    def start_for(self, number: int) -> int:
        """The last keyframe packet that is shown no later than the frame.

        Frames stored behind a keyframe but shown before it (open groups of pictures) cannot be
        decoded from this one: for them it is the keyframe before.
        """
        shown = self.number[self.keyframes]
        able = np.flatnonzero((shown >= 0) & (shown <= number))
        return int(self.keyframes[able[-1]]) if able.size else 0

    def start_before(self, packet: int) -> int | None:
        """The keyframe packet before the given one; None at the beginning."""
        earlier = self.keyframes[self.keyframes < packet]
        return int(earlier[-1]) if earlier.size else None


def open_video(where: str) -> tuple[InputContainer, VideoStream]:
    """A video's container and its first video stream, decoded on the calling thread.

    Raises:
        RecordingError: missing, not a video, text, or a list that names other files.
    """
    try:
        # Only plain files: a playlist could fetch from anywhere.
        container = av.open(f"file:{where}", options={"protocol_whitelist": "file"})
    except (av.error.FFmpegError, OSError, ValueError) as error:
        raise _refusal(where, getattr(error, "strerror", None) or "unknown contents") from error
    try:
        stream = _video_in(container, where)
    except RecordingError:
        container.close()
        raise
    stream.codec_context.options = {"max_pixels": str(MOST_PIXELS)}  # of frames that say more
    # One thread keeps frames in step with packets, and leaves the other cores to other cameras.
    stream.codec_context.thread_count = 1
    return container, stream


def _refusal(where: str, reason: str) -> RecordingError:
    """Why a file that is no video for the library cannot be read, by how it begins."""
    try:
        with Path(where).open("rb") as file:
            start = file.read(_LOOKED_AT)
    except OSError:
        start = b""
    if any(start[at : at + len(sign)] == sign for at, sign in _SIGNS):
        return RecordingError(
            "{where}: a video that is damaged or cut off ({reason}); copy it from the camera "
            "again, or repair it",
            where=where,
            reason=reason,
        )
    if start and _is_text(start):
        return _no_video_but_text(where)
    return RecordingError(
        "{where}: not a video that can be read ({reason}); give a video, a folder of "
        "images or a folder with recording.toml",
        where=where,
        reason=reason,
    )


def _no_video_but_text(where: str) -> RecordingError:
    return RecordingError(
        "{where}: text, not a video; give a video, a folder of images or a folder with "
        "recording.toml",
        where=where,
    )


def _is_text(start: bytes) -> bool:
    """Whether a file that begins so is text; a letter may be cut at the end."""
    try:
        text = start.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return error.start > len(start) - 4 and error.start > 0 and _is_text(start[: error.start])
    return all(letter.isprintable() or letter.isspace() for letter in text)


def _video_in(container: InputContainer, where: str) -> VideoStream:
    """The first video stream; raises RecordingError where there is none that is decoded here."""
    if not container.streams.video or container.format.name in ("hls", "concat", "dash", "sdp"):
        raise RecordingError("{where}: holds no video of its own; give the video file", where=where)
    stream = container.streams.video[0]
    # PyAV leaves it None, against its own types, where it has no decoder.
    if getattr(stream, "codec_context", None) is None:
        raise RecordingError("{where}: its encoding is not known; convert it to H.264", where=where)
    if stream.codec_context.name in _TEXT_ART:
        raise _no_video_but_text(where)
    width, height = stream.codec_context.width, stream.codec_context.height
    if width * height > MOST_PIXELS:
        raise RecordingError(
            "{where}: has {width} x {height} px; videos of up to {most_pixels} Mpx are read; "
            "make it smaller",
            where=where,
            width=width,
            height=height,
            most_pixels=MOST_PIXELS // 10**6,
        )
    return stream


def video_packets(container: InputContainer, stream: VideoStream) -> Iterator[VideoPacket]:
    """The stream's packets that carry data, up to the end or to where the file breaks off."""
    try:
        for packet in container.demux(stream):
            if packet.size:
                yield packet
    except (av.error.FFmpegError, IndexError):
        # Cut short while it was written, or damaged (PyAV fails by IndexError at a stream that
        # turns up late): what came before is still good.
        return


def index_video(where: str) -> PacketIndex:
    """Read all packets of a video once; decodes only where it does not tell the order.

    Raises:
        RecordingError: the video cannot be read, or holds nothing to decode.
    """
    container, stream = open_video(where)
    with container:
        packets = [_facts(packet) for packet in video_packets(container, stream)]
        trusted = _tells_order(container, stream, packets)
        time_base = float(stream.time_base or 1)
    keyframes = [i for i, packet in enumerate(packets) if packet.key]
    if not keyframes:
        raise RecordingError(
            "{where}: holds no image that can be decoded; record it again", where=where
        )
    if trusted:
        shown = np.array([packet.pts for packet in packets], float)
        number, left_out = _ranked(shown, packets, keyframes[0])
        times = np.sort(shown[number >= 0]) * time_base
    else:
        number, left_out, times = _order_by_decoding(where, len(packets)), 0, None
    return PacketIndex(
        number,
        np.array(keyframes),
        tuple((packets[i].dts, packets[i].position) for i in keyframes),
        None if times is None else times - times[0],
        left_out,
    )


@dataclass(frozen=True, slots=True)
class _Facts:
    pts: int | None
    dts: int | None
    position: int | None
    key: bool
    hidden: bool


def _facts(packet: VideoPacket) -> _Facts:
    return _Facts(packet.pts, packet.dts, packet.pos, packet.is_keyframe, packet.is_discard)


def _tells_order(container: InputContainer, stream: VideoStream, packets: list[_Facts]) -> bool:
    """Whether presentation times can be believed.

    AVI has none; what FFmpeg makes up for it is right only where frames are not reordered, which
    shows as times that simply count on.
    """
    shown = [packet.pts for packet in packets]
    if None in shown:
        return False
    reordered = any(a > b for a, b in pairwise(p for p in shown if p is not None))
    return not (
        container.format.name == "avi" and stream.codec_context.has_b_frames and not reordered
    )


def _ranked(
    shown: NDArray[np.float64], packets: list[_Facts], first_key: int
) -> tuple[NDArray[np.int64], int]:
    """Frame numbers by presentation time, and how many frames at the beginning are left out."""
    visible = np.array([not packet.hidden for packet in packets])
    whole = np.arange(len(packets)) >= first_key
    if not packets[first_key].hidden:
        whole &= shown >= shown[first_key]
    kept = np.flatnonzero(visible & whole)
    number = np.full(len(packets), -1, np.int64)
    number[kept[np.argsort(shown[kept], kind="stable")]] = np.arange(len(kept))
    return number, int((visible & ~whole).sum())


def _order_by_decoding(where: str, count: int) -> NDArray[np.int64]:
    """Frame numbers of packets found by decoding all of them, each marked with its place."""
    container, stream = open_video(where)
    stream.codec_context.flags |= Flags.copy_opaque
    places: list[int] = []
    with container:
        for place, packet in enumerate(video_packets(container, stream)):
            packet.opaque = place
            places += _marks(decoded(stream, packet))
        places += _marks(decoded(stream, None))
    number = np.full(count, -1, np.int64)
    number[places] = np.arange(len(places))
    return number


def _marks(frames: list[av.VideoFrame]) -> list[int]:
    return [frame.opaque for frame in frames if isinstance(frame.opaque, int)]


def decoded(stream: VideoStream, packet: VideoPacket | None) -> list[av.VideoFrame]:
    """The frames a packet completes, or those left at the end; none from a broken packet."""
    try:
        return stream.codec_context.decode(packet)
    except av.error.FFmpegError:
        return []
