"""The bag at a path, of whichever kind. Runs in the bag program.

The libraries `rosbags` and `mcap` read what the files say of themselves. Messages are found by the
files' own indexes, so that an hour opens at once.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Sequence
from pathlib import Path, PurePath

import numpy as np

from tracking.recording.bags.container import (
    HEAD_BYTES,
    MOST_MESSAGE_BYTES,
    MOST_TOPICS,
    BagError,
    Container,
    Entries,
    Topic,
    announce,
    ros2_name,
)
from tracking.recording.bags.mcap_file import Mcap
from tracking.recording.bags.rosbag1 import Rosbag1
from tracking.translation import msg

_MOST_READ_AHEAD = 4 << 30


class Sqlite:
    """The database of a ROS 2 bag.

    The library counts all messages as it opens one, which reads most of the file. SQL's `substr`
    reads the whole of each message, a blob that is opened only its page.
    """

    def __init__(self, path: Path) -> None:
        if path.stat().st_size <= _MOST_READ_AHEAD:
            with path.open("rb") as file:
                announce(file, (0,), 0)  # whole: messages are found by going through all pages
        where = f"{path.resolve().as_uri()}?mode=ro&immutable=1"
        self._database = sqlite3.connect(where, uri=True)
        topics = self._database.execute("SELECT id, name, type FROM topics").fetchmany(MOST_TOPICS)
        self._ids = {str(name): int(number) for number, name, _ in topics}
        self.topics: Sequence[Topic] = [
            Topic(str(name), ros2_name(str(kind)), False, 1) for _, name, kind in topics
        ]

    def entries(self, topic: Topic) -> Entries:
        """See `Container`."""
        query = "SELECT timestamp, id FROM messages WHERE topic_id = ?"
        rows = self._database.execute(query, (self._ids[topic.name],)).fetchall()
        times, ids = np.array(rows, np.int64).reshape(-1, 2).T
        order = np.lexsort((ids, times))
        return Entries(times[order], np.zeros_like(ids), ids[order])

    def read(self, part: int, place: int) -> bytes:  # noqa: ARG002 - as all containers
        """See `Container`."""
        (data,) = self._database.execute(
            "SELECT data FROM messages WHERE id = ?", (place,)
        ).fetchone()
        return bytes(data)

    def packed_bytes(self, part: int) -> int:  # noqa: ARG002 - as all containers
        """See `Container`."""
        return 0

    def heads(self, entries: Entries) -> list[bytes] | None:
        """See `Container`."""
        return [self._head(place) for place in entries.place.tolist()]

    def _head(self, place: int) -> bytes:
        with self._database.blobopen("messages", "data", place, readonly=True) as blob:
            return blob.read(HEAD_BYTES)


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
