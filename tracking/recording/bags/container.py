"""Bags as tables of messages: where each one stands, and its bytes. Runs in the bag program."""

from __future__ import annotations

import os
from collections import OrderedDict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import IO, Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.translation import Message, msg

MOST_MESSAGE_BYTES = 256 << 20
MOST_CHUNK_BYTES = 256 << 20
MOST_TOPICS = 10_000
_CHUNKS_KEPT = 3
MOST_UNPACKED = 256 << 20
"""Bytes that are unpacked for the sake of the cameras' own times; beyond, those of recording."""
HEAD_BYTES = 16
"""Of a message, which hold its header's time in either serialization."""
DAMAGED_INDEX = msg("has an index that is damaged")
NOT_INDEXED = msg("has no index: it was not closed; repair it (rosbag reindex, mcap recover)")


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


def announce(file: IO[bytes], places: Iterable[int], size: int) -> None:
    """Say which places will be read, so that the disk is asked for all of them at once.

    Asked one after the other, a hundred thousand take ten times as long.
    """
    if hasattr(os, "posix_fadvise"):
        for place in sorted(places):
            os.posix_fadvise(file.fileno(), place, size, os.POSIX_FADV_WILLNEED)


def read_places(file: IO[bytes], places: Sequence[int], size: int) -> list[bytes]:
    """So many bytes at each of many places, or what the file has there."""
    announce(file, places, size)
    return [read_at(file, place, size) for place in places]


def read_at(file: IO[bytes], place: int, size: int) -> bytes:
    """Bytes at a place, and no more of the file than these."""
    if hasattr(os, "pread"):
        return os.pread(file.fileno(), size, place)
    file.seek(place)  # Windows
    return file.read(size)


def ros2_name(kind: str) -> str:
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
