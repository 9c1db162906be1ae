"""The program that reads a bag: what is asked for through its standard input, pictures back.

A damaged bag can crash the libraries that read it, or keep them busy for ever: it ends this program
only. It may take so much memory and, for each message by its size, so much processor time.
"""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from tracking.message_data import message_data
from tracking.recording.bags.container import (
    HEAD_BYTES,
    BagError,
    Container,
    Entries,
    Topic,
    why_of,
)
from tracking.recording.bags.containers import open_container
from tracking.recording.bags.messages import (
    COMPRESSED,
    IMAGE,
    INFO,
    Messages,
    Picture,
    calibration_text,
    choose_topics,
    first_value,
    info_topic,
    stamp_ns,
)
from tracking.translation import msg
from tracking.untrusted.pipe import receive_bytes, receive_head, send

_MEMORY_BYTES = 4 << 30
_ASK_S = 1.2
"""Of processor time that a message may cost beside what its bytes do."""
_BYTES_A_SECOND = 100 << 20
"""Of the file, as it is opened."""
_WORKED_BYTES_A_SECOND = 5 << 20
"""That are unpacked (bzip2 is the slowest) and decoded, on a slow machine."""
_LONGEST_S = 120.0
_MOST_IMAGE_TOPICS = 64


class Bag:
    """An opened bag: the topics of its cameras, and their messages in order of time.

    Args:
        container: the bag. size: of its files in bytes.
        named: topics of left, right and depth; "": not told.
        known: the entries of each, of a bag that was opened before; `named` are its topics then.

    Attributes:
        topics: of the left camera, the right one and depth; None where there is none.
        entries: of each, in order of time. stamps: when each was taken.
        first: the first picture of each.
        recorded_times: the times are those of recording, not the cameras' own.
    """

    def __init__(
        self, container: Container, size: int, named: list[str], known: list[Entries] | None
    ) -> None:
        self._container, self._size = container, size
        self._messages = Messages()
        self._entries: dict[str, Entries] = {}
        self.recorded_times = False
        self.first: list[Picture | None] = [None] * 3
        if known is not None:
            by_name = {topic.name: topic for topic in self._container.topics}
            self.topics = [by_name[name] if name else None for name in named]
            self.entries = known
            self.stamps = [one.time_ns for one in known]
            return
        self._choose(named)
        ordered = [self._in_order(topic) for topic in self.topics]
        self.entries, self.stamps = [one[0] for one in ordered], [one[1] for one in ordered]
        self._entries.clear()

    def _choose(self, named: list[str]) -> None:
        """Find the topics of the cameras by what they hold."""
        there = [t for t in self._container.topics if t.kind in (IMAGE, COMPRESSED) and t.count]
        firsts = dict(self._first(topic) for topic in there[:_MOST_IMAGE_TOPICS])
        images = [topic for topic in there if firsts.get(topic.name) is not None]
        is_depth = {name: first is not None and first.ndim == 2 for name, first in firsts.items()}
        names = choose_topics(images, named, is_depth)
        if not names[0]:
            raise BagError(msg("holds no images (sensor_msgs Image or CompressedImage)"))
        if names[2] and not named[2] and _size(firsts[names[2]]) != _size(firsts[names[0]]):
            names = (names[0], names[1], "")  # it is not aligned to this camera
        by_name = {topic.name: topic for topic in images}
        self.topics = [by_name.get(name) for name in names]
        self.first = [firsts.get(name) for name in names]

    def _entries_of(self, topic: Topic) -> Entries:
        """The messages of a topic, which are looked up once while the bag is opened."""
        if topic.name not in self._entries:
            self._entries[topic.name] = self._container.entries(topic)
        return self._entries[topic.name]

    def _first(self, topic: Topic) -> tuple[str, Picture | None]:
        """The first picture of a topic; None: it is of a kind that is not read."""
        try:
            entries = self._entries_of(topic)
            return topic.name, self._picture(topic, int(entries.part[0]), int(entries.place[0]))
        except Exception:  # whatever the libraries raise: this topic is of no use
            return topic.name, None

    def _in_order(self, topic: Topic | None) -> tuple[Entries, NDArray[np.int64]]:
        """The messages of a topic by the cameras' own times, where these can be had at once."""
        if topic is None:
            nothing = np.zeros(0, np.int64)
            return Entries(nothing, nothing, nothing), nothing
        entries = self._entries_of(topic)
        parts = np.unique(entries.part).tolist()
        self._allow_for(sum(self._container.packed_bytes(part) for part in parts))
        heads = self._container.heads(entries)
        stamps = entries.time_ns
        if heads is None or any(len(head) < HEAD_BYTES for head in heads):
            self.recorded_times = True
        else:
            own = np.array([stamp_ns(topic, head) for head in heads], np.int64)
            if own.any():
                stamps = own
            else:  # nobody filled the headers in
                self.recorded_times = True
        order = np.argsort(stamps, kind="stable")
        kept = Entries(entries.time_ns[order], entries.part[order], entries.place[order])
        return kept, stamps[order]

    def picture(self, side: int, number: int) -> Picture:
        """One picture of the left camera, the right one or depth."""
        topic, entries = self.topics[side], self.entries[side]
        assert topic is not None
        picture = self._picture(topic, int(entries.part[number]), int(entries.place[number]))
        return picture if side == 2 else _of_camera(picture)

    def _picture(self, topic: Topic, part: int, place: int) -> Picture:
        """The picture in a message, with the time that its bytes take."""
        self._allow_for(self._container.packed_bytes(part))
        data = self._container.read(part, place)
        self._allow_for(len(data))
        return self._messages.picture(topic, data)

    def _allow_for(self, count: int) -> None:
        """Time for bytes of the bag, however many it says there are."""
        _allow_more(min(count, self._size) / _WORKED_BYTES_A_SECOND)

    def calibrations(self) -> list[str]:
        """camera_info of the left camera, and of the right one, in YAML; none where they lack."""
        infos = [topic for topic in self._container.topics if topic.kind == INFO and topic.count]
        texts = []
        for topic in filter(None, self.topics[:2]):
            info = info_topic(topic.name, infos)
            if info is None:
                return []
            try:
                value = first_value(self._container, self._messages, info)
                texts.append(calibration_text(value, topic.name))
            except Exception:  # whatever the libraries raise: there is none of use
                return []
        return texts


def _of_camera(picture: Picture) -> Picture:
    """A camera's picture in BGR; of 16 bits, the upper eight."""
    if picture.ndim == 2:
        grey = (picture >> 8).astype(np.uint8) if picture.dtype == np.uint16 else picture
        picture = np.repeat(grey[..., None], 3, axis=2)
    if picture.dtype != np.uint8:
        raise BagError(msg("holds images of {encoding}", encoding=str(picture.dtype)))
    return picture


def _size(picture: Picture | None) -> list[int]:
    """Width and height."""
    return [] if picture is None else [picture.shape[1], picture.shape[0]]


def opened(bag: Bag) -> tuple[dict[str, Any], list[bytes]]:
    """What is told of a bag: a head, and time, part and place of each message of three topics."""
    head = {
        "topics": ["" if topic is None else topic.name for topic in bag.topics],
        "counts": [len(stamps) for stamps in bag.stamps],
        "sizes": [_size(first) for first in bag.first],
        "in_metres": bag.first[2] is not None and bag.first[2].dtype == np.float32,
        "recorded_times": bag.recorded_times,
        "calibrations": bag.calibrations(),
    }
    tables = [
        np.stack((stamps, entries.part, entries.place))
        for stamps, entries in zip(bag.stamps, bag.entries, strict=True)
    ]
    return head, [table.tobytes() for table in tables]


def _known(start: dict[str, Any], commands: IO[bytes]) -> list[Entries] | None:
    """The entries that come with the first message; None where there are none."""
    if "counts" not in start:
        return None
    tables = [
        np.frombuffer(receive_bytes(commands, 24 * int(count)), np.int64).reshape(3, -1)
        for count in start["counts"]
    ]
    return [Entries(*table) for table in tables]


def _allow(seconds: float) -> float:
    """Let the system end this program where more processor time than that goes by; 0: never.

    Returns what was left until then.
    """
    try:
        import signal

        signal.signal(signal.SIGPROF, signal.SIG_DFL)
        return signal.setitimer(signal.ITIMER_PROF, seconds)[0]
    except (ImportError, AttributeError, ValueError):  # Windows
        return 0.0


def _allow_more(seconds: float) -> None:
    """Let it take so much more."""
    _allow(min(_LONGEST_S, _allow(0) + seconds))


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows
        return
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = _MEMORY_BYTES if hard == resource.RLIM_INFINITY else min(_MEMORY_BYTES, hard)
    with contextlib.suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_AS, (most, hard))


def _size_of(path: Path) -> int:
    files = path.iterdir() if path.is_dir() else (path,)
    return sum(file.stat().st_size for file in files if file.is_file())


def _prepared(path: Path) -> Container:
    """The bag at a path; what the library makes for every file counts for no time limit."""
    container = open_container(path)
    left = _allow(0)
    Messages().prepare(container.topics)
    _allow(left)
    return container


def main(commands: IO[bytes], answers: IO[bytes]) -> None:
    """Open the bag that is asked for, then give pictures until nobody asks."""
    _limit_memory()
    start = receive_head(commands)
    if start is None:
        return
    path = Path(start["path"])
    try:
        size = _size_of(path)
        _allow(min(_LONGEST_S, _ASK_S + size / _BYTES_A_SECOND))
        known = _known(start, commands)
        bag = Bag(_prepared(path), size, list(start["topics"]), known)
        head, parts = opened(bag) if known is None else ({"ready": True}, [])
    except Exception as error:
        send(answers, {"refused": message_data(why_of(error))})
        return
    send(answers, head, *parts)
    _allow(0)
    while (asked := receive_head(commands)) is not None:
        _allow(_ASK_S)
        try:
            picture = np.ascontiguousarray(bag.picture(int(asked["side"]), int(asked["number"])))
        except Exception as error:
            send(answers, {"refused": message_data(why_of(error))})
        else:
            told = {"shape": list(picture.shape), "kind": str(picture.dtype)}
            send(answers, told, picture.data.cast("B"))
        _allow(0)
