"""Bags of ROS 1. Runs in the bag program."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from tracking.recording.bags.container import (
    DAMAGED_INDEX,
    HEAD_BYTES,
    MOST_CHUNK_BYTES,
    MOST_MESSAGE_BYTES,
    MOST_TOPICS,
    MOST_UNPACKED,
    NOT_INDEXED,
    BagError,
    Chunks,
    Entries,
    Topic,
    announce,
    read_at,
    read_places,
)
from tracking.translation import msg

_LONGEST_HEAD = 256
_INDEX_BYTES = 4096
"""Of a chunk's index that are read ahead."""


class Rosbag1:
    """A bag of ROS 1, version 2.0.

    The library's own reader makes an object for each message as it opens a bag; here its parts are
    used, and the index of a topic is read when it is asked for.
    """

    def __init__(self, path: Path) -> None:
        from rosbags.rosbag1.reader import Header, Reader, RecordType

        self._reader = Reader(path)
        self._file: IO[bytes] = path.open("rb")
        self._reader.bio = self._file
        if self._file.readline(64) != b"#ROSBAG V2.0\n":
            raise BagError(msg("is no bag of version 2.0"))
        header = Header.read(self._file, RecordType.BAGHEADER)
        if header.get_uint64("index_pos") == 0:
            raise BagError(NOT_INDEXED)
        self._file.seek(header.get_uint64("index_pos"))
        connections = [
            self._reader.read_connection() for _ in range(header.get_uint32("conn_count"))
        ]
        self._infos = [
            self._reader.read_chunk_info() for _ in range(header.get_uint32("chunk_count"))
        ]
        self._chunks, self._places = Chunks(), dict[int, Any]()
        self._ids: dict[str, list[int]] = {}
        kinds: dict[str, str] = {}
        for connection in connections[:MOST_TOPICS]:
            self._ids.setdefault(connection.topic, []).append(connection.id)
            kinds[connection.topic] = connection.msgtype
        counts: dict[int, int] = {}
        for info in self._infos:
            for number, count in info.connection_counts.items():
                counts[number] = counts.get(number, 0) + count
        self.topics: Sequence[Topic] = [
            Topic(name, kinds[name], True, sum(counts.get(number, 0) for number in ids))
            for name, ids in self._ids.items()
        ]

    def entries(self, topic: Topic) -> Entries:
        """See `Container`."""
        wanted = set(self._ids[topic.name])
        tables = [np.zeros((0, 3), np.int64)]
        infos = [one for one in self._infos if not wanted.isdisjoint(one.connection_counts)]
        self._find_chunks([info.pos for info in infos])
        for info in infos:
            chunk = self._places[info.pos]
            self._file.seek(chunk.datapos + chunk.datasize)
            for _ in info.connection_counts:
                number, rows = self._index_record()
                if number in wanted:
                    tables.append(np.insert(rows, 1, info.pos, axis=1))
        table = np.concatenate(tables)
        table = table[np.argsort(table[:, 0], kind="stable")]
        return Entries(table[:, 0], table[:, 1], table[:, 2])

    def _index_record(self) -> tuple[int, NDArray[np.int64]]:
        """A connection's number, and (n, 2) time and place of its messages in a chunk."""
        (size,) = struct.unpack("<I", self._file.read(4))
        head = self._file.read(min(size, _LONGEST_HEAD))
        at = head.index(b"conn=") + 5
        (number,) = struct.unpack_from("<I", head, at)
        (size,) = struct.unpack("<I", self._file.read(4))
        if b"op=\x04" not in head or size % 12 or size > MOST_MESSAGE_BYTES:
            raise BagError(DAMAGED_INDEX)
        rows = np.frombuffer(self._file.read(size), "<u4").reshape(-1, 3).astype(np.int64)
        return number, np.column_stack((rows[:, 0] * 10**9 + rows[:, 1], rows[:, 2]))

    def read(self, part: int, place: int) -> bytes:
        """See `Container`."""
        chunk = self._chunk(part)
        start, size = _rosbag1_message(chunk, place)
        return chunk[start : start + size]

    def packed_bytes(self, part: int) -> int:
        """See `Container`."""
        from rosbags.rosbag1.reader import decompressors

        chunk = self._place_of(part)
        return 0 if chunk.decompressor is decompressors["none"] else int(chunk.datasize)

    def heads(self, entries: Entries) -> list[bytes] | None:
        """See `Container`."""
        from rosbags.rosbag1.reader import decompressors

        pairs = list(zip(entries.part.tolist(), entries.place.tolist(), strict=True))
        chunks = [self._place_of(part) for part in {part for part, _ in pairs}]
        if all(chunk.decompressor is decompressors["none"] for chunk in chunks):
            places = [self._places[part].datapos + place for part, place in pairs]
            starts = read_places(self._file, places, _LONGEST_HEAD)
            return [self._head(at, start) for at, start in zip(places, starts, strict=True)]
        if sum(chunk.datasize for chunk in chunks) > MOST_UNPACKED:
            return None
        return [self.read(part, place)[:HEAD_BYTES] for part, place in pairs]

    def _head(self, at: int, data: bytes) -> bytes:
        """The first bytes of a message that is not packed, by what stands at its place."""
        if b"op=\x07" in data:  # a connection may stand before it
            data = read_at(self._file, at, 1 << 16)
        start, _ = _rosbag1_message(data, 0)
        return data[start : start + HEAD_BYTES]

    def _find_chunks(self, parts: Sequence[int]) -> None:
        """Look up many chunks, and have their indexes read ahead."""
        announce(self._file, (part for part in parts if part not in self._places), _LONGEST_HEAD)
        chunks = [self._place_of(part) for part in parts]
        ends = (chunk.datapos + chunk.datasize for chunk in chunks)
        announce(self._file, ends, _INDEX_BYTES)

    def _place_of(self, part: int) -> Any:
        """Where the data of a chunk stands, and how it is packed."""
        if part not in self._places:
            self._file.seek(part)
            self._places[part] = self._reader.read_chunk()
        return self._places[part]

    def _chunk(self, part: int) -> bytes:
        kept = self._chunks.get(part)
        if kept is not None:
            return kept
        chunk = self._place_of(part)
        if chunk.datasize > MOST_CHUNK_BYTES:
            raise BagError(msg("holds a chunk that is too large"))
        self._file.seek(chunk.datapos)
        return self._chunks.keep(part, chunk.decompressor(self._file.read(chunk.datasize)))


def _rosbag1_message(data: bytes, place: int) -> tuple[int, int]:
    """Where the data of the message record at a place begins, and how long it is.

    Connection records may stand before it.
    """
    for _ in range(MOST_TOPICS):
        (head_size,) = struct.unpack_from("<I", data, place)
        head = data[place + 4 : place + 4 + head_size]
        at = place + 4 + head_size
        (size,) = struct.unpack_from("<I", data, at)
        if b"op=\x07" not in head:
            if size > MOST_MESSAGE_BYTES:
                raise BagError(msg("holds a message that is too large"))
            return at + 4, size
        place = at + 4 + size
    raise BagError(msg("holds no message where its index says"))
