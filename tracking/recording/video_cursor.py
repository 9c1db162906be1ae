"""Decoding a video from any keyframe on."""

from __future__ import annotations

from collections.abc import Iterator

import av

from tracking.recording.packet_index import (
    PacketIndex,
    VideoPacket,
    decoded,
    open_video,
    video_packets,
)

NumberedFrame = tuple[int, av.VideoFrame]

_SEEK_ATTEMPTS = 3


class VideoCursor:
    """One decoder over a video; each frame it gives bears its number.

    A packet is stamped with its frame's number before it is decoded, so a frame's identity does
    not hang on timestamps, seeks that land elsewhere, or what a decoder leaves out.

    Args:
        where: path of the video.
        index: its packets.
    """

    def __init__(self, where: str, index: PacketIndex) -> None:
        self._where = where
        self._index = index
        self._known = dict(zip(index.stamps, map(int, index.keyframes), strict=True))
        # Without positions (MPEG program streams) a time after a seek is a guess, not an identity.
        self._can_seek = len(self._known) == len(index.stamps) and all(
            time is not None and position is not None for time, position in index.stamps
        )
        self._container, self._stream = open_video(where)

    def close(self) -> None:
        """Let go of the file."""
        self._container.close()

    def frames_from(self, packet: int) -> Iterator[NumberedFrame]:
        """Frames in order from the keyframe packet on, up to the end.

        Only one such iteration at a time: beginning another ends this one. A broken packet gives
        no frame.
        """
        last = int(self._index.number[packet]) - 1
        for number, frame in self._decoded_from(packet):
            # What is shown before its keyframe lacks the pictures it was made from.
            if number > last:
                last = number
                yield number, frame

    def _decoded_from(self, start: int) -> Iterator[NumberedFrame]:
        number = self._index.number
        for place, packet in self._packets_from(start):
            if place >= len(number):
                break
            packet.pts = int(number[place]) if number[place] >= 0 else None
            packet.dts = None
            yield from _numbered(decoded(self._stream, packet))
        yield from _numbered(decoded(self._stream, None))

    def _packets_from(self, start: int) -> Iterator[tuple[int, VideoPacket]]:
        """Packets with their place in the index, from the given place on."""
        landed, packets = self._landed(start)
        for place, packet in enumerate(packets, landed):
            if place >= start:
                yield place, packet

    def _landed(self, start: int) -> tuple[int, Iterator[VideoPacket]]:
        """Seek to the place or one before it: where it is, and the packets from there.

        A container's seek may land anywhere; only a packet known by its stamp tells. Where it is
        too late, the keyframe before is tried, and in the end the file from its beginning.
        """
        target: int | None = start
        for _ in range(_SEEK_ATTEMPTS if self._can_seek else 0):
            if target is None:
                break
            landed = self._seek(target)
            if landed is not None and landed[0] <= start:
                return landed
            target = self._index.start_before(target)
        self._container.close()
        self._container, self._stream = open_video(self._where)
        return 0, video_packets(self._container, self._stream)

    def _seek(self, target: int) -> tuple[int, Iterator[VideoPacket]] | None:
        time = next(time for (time, _), place in self._known.items() if place == target)
        try:
            self._container.seek(time or 0, stream=self._stream, backward=True)
        except (av.error.FFmpegError, OSError):
            return None
        packets = video_packets(self._container, self._stream)
        for packet in packets:
            place = self._known.get((packet.dts, packet.pos))
            if place is not None:
                return place, _chained(packet, packets)
        return None


def _chained(first: VideoPacket, others: Iterator[VideoPacket]) -> Iterator[VideoPacket]:
    yield first
    yield from others


def _numbered(frames: list[av.VideoFrame]) -> Iterator[NumberedFrame]:
    for frame in frames:
        if frame.pts is not None:
            yield frame.pts, frame
