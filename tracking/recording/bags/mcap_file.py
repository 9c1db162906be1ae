"""MCAP files. Runs in the bag program."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import IO

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
    read_places,
    ros2_name,
)
from tracking.translation import msg

_MOST_MESSAGES = 20_000_000
_INDEX_BYTES = 4096
"""Of a chunk's index that are read ahead."""


class Mcap:
    """An MCAP file of ROS 1 or ROS 2 messages."""

    def __init__(self, path: Path) -> None:
        from mcap.reader import SeekingReader

        self._file: IO[bytes] = path.open("rb")
        reader = SeekingReader(self._file, record_size_limit=MOST_MESSAGE_BYTES)
        summary = reader.get_summary()
        if summary is None or not summary.chunk_indexes:
            raise BagError(NOT_INDEXED)
        self._indexes = sorted(summary.chunk_indexes, key=lambda one: one.chunk_start_offset)
        self._chunks = Chunks()
        counts = summary.statistics.channel_message_counts if summary.statistics else {}
        self._channels: dict[str, list[int]] = {}
        found: dict[str, Topic] = {}
        for channel in list(summary.channels.values())[:MOST_TOPICS]:
            schema = summary.schemas.get(channel.schema_id)
            if schema is None or channel.message_encoding not in ("cdr", "ros1"):
                continue
            self._channels.setdefault(channel.topic, []).append(channel.id)
            before = found[channel.topic].count if channel.topic in found else 0
            count = before + counts.get(channel.id, 0)
            kind = ros2_name(schema.name)
            found[channel.topic] = Topic(
                channel.topic, kind, channel.message_encoding == "ros1", count
            )
        self.topics: Sequence[Topic] = list(found.values())

    def entries(self, topic: Topic) -> Entries:
        """See `Container`."""
        tables = [np.zeros((0, 3), np.int64)]
        found = [
            (part, index.message_index_offsets[channel], channel)
            for part, index in enumerate(self._indexes)
            for channel in self._channels[topic.name]
            if channel in index.message_index_offsets
        ]
        announce(self._file, (offset for _, offset, _ in found), _INDEX_BYTES)
        for part, offset, channel in found:
            tables.append(np.insert(self._index_rows(offset, channel), 1, part, axis=1))
        table = np.concatenate(tables)
        if len(table) > _MOST_MESSAGES:
            raise BagError(msg("holds too many messages"))
        table = table[np.argsort(table[:, 0], kind="stable")]
        return Entries(table[:, 0], table[:, 1], table[:, 2])

    def _index_rows(self, offset: int, channel: int) -> NDArray[np.int64]:
        """(n, 2) time and place of the messages that an index record of a chunk names."""
        self._file.seek(offset)
        opcode, _, number, size = struct.unpack("<BQHI", self._file.read(15))
        if opcode != 0x07 or number != channel or size % 16 or size > MOST_MESSAGE_BYTES:
            raise BagError(DAMAGED_INDEX)
        return np.frombuffer(self._file.read(size), "<i8").reshape(-1, 2)

    def read(self, part: int, place: int) -> bytes:
        """See `Container`."""
        chunk = self._chunk(part)
        opcode, size = struct.unpack_from("<BQ", chunk, place)
        start = place + 9 + 22
        if opcode != 0x05 or not 22 <= size <= MOST_MESSAGE_BYTES:
            raise BagError(msg("holds no message where its index says"))
        return chunk[start : place + 9 + size]

    def packed_bytes(self, part: int) -> int:
        """See `Container`."""
        index = self._indexes[part]
        return int(index.compressed_size) if index.compression else 0

    def heads(self, entries: Entries) -> list[bytes] | None:
        """See `Container`."""
        pairs = list(zip(entries.part.tolist(), entries.place.tolist(), strict=True))
        parts = {part for part, _ in pairs}
        if not any(self._indexes[part].compression for part in parts):
            places = [self._start(part) + place for part, place in pairs]
            return read_places(self._file, places, HEAD_BYTES)
        if sum(self._indexes[part].uncompressed_size for part in parts) > MOST_UNPACKED:
            return None
        return [self.read(part, place)[:HEAD_BYTES] for part, place in pairs]

    def _start(self, part: int) -> int:
        """Where the data of a message at place 0 of a chunk that is not packed would stand."""
        index = self._indexes[part]
        chunk = index.chunk_start_offset + 9 + 28 + 4 + len(index.compression) + 8
        return int(chunk) + 9 + 22

    def _chunk(self, part: int) -> bytes:
        from mcap.data_stream import ReadDataStream
        from mcap.records import Chunk
        from mcap.stream_reader import get_chunk_data_stream

        kept = self._chunks.get(part)
        if kept is not None:
            return kept
        index = self._indexes[part]
        if max(index.uncompressed_size, index.chunk_length) > MOST_CHUNK_BYTES:
            raise BagError(msg("holds a chunk that is too large"))
        self._file.seek(index.chunk_start_offset + 9)
        chunk = Chunk.read(ReadDataStream(self._file))
        if chunk.uncompressed_size > MOST_CHUNK_BYTES:
            raise BagError(msg("holds a chunk that is too large"))
        stream, size = get_chunk_data_stream(chunk)
        return self._chunks.keep(part, stream.read(size))
