"""Bags as tables of messages: where each one stands, and its bytes. Runs in the bag program.

The libraries `rosbags` and `mcap` read what the files say of themselves. Messages are found by the
files' own indexes, so that an hour opens at once.
"""

from __future__ import annotations

import os
import sqlite3
import struct
from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import IO, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.translation import Message, msg

MOST_MESSAGE_BYTES = 256 << 20
_MOST_CHUNK_BYTES = 256 << 20
_MOST_TOPICS = 10_000
_MOST_MESSAGES = 20_000_000
_CHUNKS_KEPT = 3
_MOST_UNPACKED = 256 << 20
"""Bytes that are unpacked for the sake of the cameras' own times; beyond, those of recording."""
HEAD_BYTES = 16
"""Of a message, which hold its header's time in either serialization."""
_LONGEST_HEAD = 256
_DAMAGED_INDEX = msg("has an index that is damaged")
_NOT_INDEXED = msg("has no index: it was not closed; repair it (rosbag reindex, mcap recover)")


class BagError(Exception):
    """Why a bag cannot be read, in words that follow its name."""

    def __init__(self, why: str) -> None:
        super().__init__(why)
        self.why = why


@dataclass(frozen=True, slots=True)
class Topic:
    """One topic of a bag.

    Attributes:
        name: as recorded. kind: such as "sensor_msgs/msg/Image". is_ros1: how it is serialized.
        count: of messages.
    """

    name: str
    kind: str
    is_ros1: bool
    count: int


@dataclass(frozen=True, slots=True)
class Entries:
    """The messages of a topic in the order they were recorded.

    Attributes:
        time_ns: (n,) when each was recorded.
        part, place: (n,) the chunk or file that holds it, and where in it.
    """

    time_ns: NDArray[np.int64]
    part: NDArray[np.int64]
    place: NDArray[np.int64]


class Container(Protocol):
    """A bag."""

    @property
    def topics(self) -> Sequence[Topic]:
        """All that can be read."""

    def entries(self, topic: Topic) -> Entries:
        """The messages of a topic."""

    def read(self, part: int, place: int) -> bytes:
        """The bytes of one message."""

    def packed_bytes(self, part: int) -> int:
        """How many bytes are unpacked for the sake of a message there; 0: it is not packed."""

    def heads(self, entries: Entries) -> list[bytes] | None:
        """The first bytes of messages; None where too much would have to be unpacked."""


class Chunks:
    """Chunks unpacked last, bounded in number."""

    def __init__(self) -> None:
        self._kept: OrderedDict[int, bytes] = OrderedDict()

    def get(self, part: int) -> bytes | None:
        """A chunk that is kept."""
        return self._kept.get(part)

    def keep(self, part: int, data: bytes) -> bytes:
        """Keep one, and let the oldest go."""
        self._kept[part] = data
        while len(self._kept) > _CHUNKS_KEPT:
            self._kept.popitem(last=False)
        return data


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
            raise BagError(_NOT_INDEXED)
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
        for connection in connections[:_MOST_TOPICS]:
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
        for info in self._infos:
            if wanted.isdisjoint(info.connection_counts):
                continue
            self._place_of(info.pos)
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
            raise BagError(_DAMAGED_INDEX)
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
            return [self._head(part, place) for part, place in pairs]
        if sum(chunk.datasize for chunk in chunks) > _MOST_UNPACKED:
            return None
        return [self.read(part, place)[:HEAD_BYTES] for part, place in pairs]

    def _head(self, part: int, place: int) -> bytes:
        """The first bytes of a message in a chunk that is not packed."""
        at = self._places[part].datapos + place
        data = os.pread(self._file.fileno(), _LONGEST_HEAD, at)
        if b"op=\x07" in data:  # a connection may stand before it
            data = os.pread(self._file.fileno(), 1 << 16, at)
        start, _ = _rosbag1_message(data, 0)
        return data[start : start + HEAD_BYTES]

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
        if chunk.datasize > _MOST_CHUNK_BYTES:
            raise BagError(msg("holds a chunk that is too large"))
        self._file.seek(chunk.datapos)
        return self._chunks.keep(part, chunk.decompressor(self._file.read(chunk.datasize)))


def _rosbag1_message(data: bytes, place: int) -> tuple[int, int]:
    """Where the data of the message record at a place begins, and how long it is.

    Connection records may stand before it.
    """
    for _ in range(_MOST_TOPICS):
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


class Sqlite:
    """The database of a ROS 2 bag.

    The library counts all messages as it opens one, which reads most of the file.
    """

    def __init__(self, path: Path) -> None:
        where = f"{path.resolve().as_uri()}?mode=ro&immutable=1"
        self._database = sqlite3.connect(where, uri=True)
        topics = self._database.execute("SELECT id, name, type FROM topics").fetchmany(_MOST_TOPICS)
        self._ids = {str(name): int(number) for number, name, _ in topics}
        self.topics: Sequence[Topic] = [
            Topic(str(name), _ros2_name(str(kind)), False, 1) for _, name, kind in topics
        ]

    def entries(self, topic: Topic) -> Entries:
        """See `Container`."""
        rows = self._rows(
            "SELECT timestamp, 0, id FROM messages WHERE topic_id = ? ORDER BY timestamp, id",
            self._ids[topic.name],
        )
        table = np.array(rows, np.int64).reshape(-1, 3)
        return Entries(table[:, 0], table[:, 1], table[:, 2])

    def read(self, part: int, place: int) -> bytes:  # noqa: ARG002 - as all containers
        """See `Container`."""
        ((data,),) = self._rows("SELECT data FROM messages WHERE id = ?", place)
        return bytes(data)

    def packed_bytes(self, part: int) -> int:  # noqa: ARG002 - as all containers
        """See `Container`."""
        return 0

    def heads(self, entries: Entries) -> list[bytes] | None:
        """See `Container`."""
        wanted = entries.place.tolist()
        if not wanted:
            return []
        found = dict(
            self._rows(
                "SELECT id, substr(data, 1, 16) FROM messages WHERE topic_id = "
                "(SELECT topic_id FROM messages WHERE id = ?)",
                wanted[0],
            )
        )
        return [bytes(found[place]) for place in wanted]

    def _rows(self, query: str, value: int) -> list[tuple[Any, ...]]:
        return self._database.execute(query, (value,)).fetchall()


class Mcap:
    """An MCAP file of ROS 1 or ROS 2 messages."""

    def __init__(self, path: Path) -> None:
        from mcap.reader import SeekingReader

        self._file: IO[bytes] = path.open("rb")
        reader = SeekingReader(self._file, record_size_limit=MOST_MESSAGE_BYTES)
        summary = reader.get_summary()
        if summary is None or not summary.chunk_indexes:
            raise BagError(_NOT_INDEXED)
        self._indexes = sorted(summary.chunk_indexes, key=lambda one: one.chunk_start_offset)
        self._chunks = Chunks()
        counts = summary.statistics.channel_message_counts if summary.statistics else {}
        self._channels: dict[str, list[int]] = {}
        found: dict[str, Topic] = {}
        for channel in list(summary.channels.values())[:_MOST_TOPICS]:
            schema = summary.schemas.get(channel.schema_id)
            if schema is None or channel.message_encoding not in ("cdr", "ros1"):
                continue
            self._channels.setdefault(channel.topic, []).append(channel.id)
            before = found[channel.topic].count if channel.topic in found else 0
            count = before + counts.get(channel.id, 0)
            kind = _ros2_name(schema.name)
            found[channel.topic] = Topic(
                channel.topic, kind, channel.message_encoding == "ros1", count
            )
        self.topics: Sequence[Topic] = list(found.values())

    def entries(self, topic: Topic) -> Entries:
        """See `Container`."""
        tables = [np.zeros((0, 3), np.int64)]
        for part, index in enumerate(self._indexes):
            for channel in self._channels[topic.name]:
                offset = index.message_index_offsets.get(channel)
                if offset is not None:
                    rows = self._index_rows(offset, channel)
                    tables.append(np.insert(rows, 1, part, axis=1))
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
            raise BagError(_DAMAGED_INDEX)
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
            return [self._head(part, place) for part, place in pairs]
        if sum(self._indexes[part].uncompressed_size for part in parts) > _MOST_UNPACKED:
            return None
        return [self.read(part, place)[:HEAD_BYTES] for part, place in pairs]

    def _head(self, part: int, place: int) -> bytes:
        index = self._indexes[part]
        start = index.chunk_start_offset + 9 + 28 + 4 + len(index.compression) + 8
        self._file.seek(start + place + 9 + 22)
        return self._file.read(HEAD_BYTES)

    def _chunk(self, part: int) -> bytes:
        from mcap.data_stream import ReadDataStream
        from mcap.records import Chunk
        from mcap.stream_reader import get_chunk_data_stream

        kept = self._chunks.get(part)
        if kept is not None:
            return kept
        index = self._indexes[part]
        if max(index.uncompressed_size, index.chunk_length) > _MOST_CHUNK_BYTES:
            raise BagError(msg("holds a chunk that is too large"))
        self._file.seek(index.chunk_start_offset + 9)
        chunk = Chunk.read(ReadDataStream(self._file))
        if chunk.uncompressed_size > _MOST_CHUNK_BYTES:
            raise BagError(msg("holds a chunk that is too large"))
        stream, size = get_chunk_data_stream(chunk)
        return self._chunks.keep(part, stream.read(size))


class Several:
    """The files of a split ROS 2 bag, one after the other."""

    def __init__(self, containers: Sequence[Container], packed: bool) -> None:
        self._containers, self._packed = containers, packed
        found: dict[str, Topic] = {}
        for topic in (topic for each in containers for topic in each.topics):
            before = found[topic.name].count if topic.name in found else 0
            found[topic.name] = Topic(topic.name, topic.kind, topic.is_ros1, before + topic.count)
        self.topics: Sequence[Topic] = list(found.values())
        self._most = 1 << 40

    def entries(self, topic: Topic) -> Entries:
        """See `Container`."""
        parts = []
        for number, each in enumerate(self._containers):
            if any(one.name == topic.name for one in each.topics):
                own = each.entries(topic)
                parts.append((own.time_ns, own.part + number * self._most, own.place))
        time, part, place = (np.concatenate(columns) for columns in zip(*parts, strict=True))
        order = np.argsort(time, kind="stable")
        return Entries(time[order], part[order], place[order])

    def read(self, part: int, place: int) -> bytes:
        """See `Container`."""
        data = self._containers[part // self._most].read(part % self._most, place)
        return _unpacked(data) if self._packed else data

    def packed_bytes(self, part: int) -> int:
        """See `Container`."""
        return self._containers[part // self._most].packed_bytes(part % self._most)

    def heads(self, entries: Entries) -> list[bytes] | None:
        """See `Container`."""
        if self._packed:
            return None
        heads: list[bytes] = [b""] * len(entries.part)
        numbers = entries.part // self._most
        for number, each in enumerate(self._containers):
            here = np.flatnonzero(numbers == number)
            own = Entries(
                entries.time_ns[here], entries.part[here] % self._most, entries.place[here]
            )
            found = each.heads(own)
            if found is None:
                return None
            for at, head in zip(here.tolist(), found, strict=True):
                heads[at] = head
        return heads


def _unpacked(data: bytes) -> bytes:
    """A message that was packed on its own."""
    import zstandard

    return zstandard.ZstdDecompressor().decompress(data, max_output_size=MOST_MESSAGE_BYTES)


def open_container(path: Path) -> Container:
    """The bag at a path: a file, or the folder of a ROS 2 bag.

    Raises BagError, or whatever the libraries raise on a damaged file.
    """
    if path.is_dir():
        return _open_folder(path)
    with path.open("rb") as file:
        start = file.read(16)
    if start.startswith(b"#ROSBAG V"):
        return Rosbag1(path)
    if start.startswith(b"\x89MCAP"):
        return Mcap(path)
    if start.startswith(b"SQLite format 3\0"):
        return Sqlite(path)
    raise BagError(msg("is no bag of ROS and no MCAP file"))


def _open_folder(folder: Path) -> Container:
    from ruamel.yaml import YAML

    text = folder / "metadata.yaml"
    if text.stat().st_size > 1 << 22:
        raise BagError(msg("has a metadata.yaml that is too large"))
    told = YAML(typ="safe", pure=True).load(text.read_text("utf-8"))["rosbag2_bagfile_information"]
    mode = str(told.get("compression_mode") or "").lower()
    if mode == "file":
        raise BagError(msg("is packed as a whole; unpack its files first (zstd -d)"))
    paths = [folder / PurePath(str(name)).name for name in told["relative_file_paths"]]
    for path in paths:
        if path.resolve().parent != folder.resolve() or not path.is_file():
            raise BagError(msg("lacks its file {name}", name=path.name[:100]))
    return Several([open_container(path) for path in paths], packed=mode == "message")


def _ros2_name(kind: str) -> str:
    """The name of a message as ROS 2 has it: package/msg/Name."""
    package, _, name = kind.rpartition("/")
    return kind if "/msg" in package else f"{package}/msg/{name}"


def why_of(error: Exception) -> str:
    """Why a bag is refused, in words that follow its name."""
    if isinstance(error, BagError):
        return error.why
    if isinstance(error, ImportError):
        return MISSING
    return msg("is damaged or cut short")


MISSING: Message = msg(
    "needs the libraries rosbags and mcap, the extra bags: pip install rosbags mcap"
)
