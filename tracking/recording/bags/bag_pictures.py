"""Pictures and depth of a bag by number."""

from __future__ import annotations

import re
import threading
import weakref
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.bags.bag_contents import BagContents
from tracking.recording.bags.bag_process import BagProcess, BrokenMessageError
from tracking.recording.depth_pictures import Depth, depth_of_units, lost_notes
from tracking.recording.frame import Image
from tracking.recording.pace import pace_of
from tracking.recording.pictures import broken_frames, check_number
from tracking.translation import Message, count_msg, msg

BAG_SUFFIXES = frozenset((".bag", ".mcap", ".db3"))
_BAG_KEY = re.compile(rb"^['\"]?rosbag2_bagfile_information['\"]?\s*:", re.MULTILINE)
_MOST_LOOKED_AT = 64 << 10
_SIDES = ("left", "right", "depth")
_MOST_STEPS_BACK = 50
"""Broken pictures on end before one is given up."""

_opened: weakref.WeakValueDictionary[tuple[str, tuple[str, ...]], BagProcess] = (
    weakref.WeakValueDictionary()
)
_opening = threading.Lock()


def is_bag(path: Path) -> bool:
    """Whether a path is named like a bag, or is the folder of a ROS 2 bag."""
    if path.is_dir():
        return _is_told_of(path / "metadata.yaml")
    return path.suffix.lower() in BAG_SUFFIXES and path.is_file()


def _is_told_of(path: Path) -> bool:
    """Whether a file tells of a bag: other programs have a metadata.yaml, too."""
    try:
        if not path.is_file():
            return False
        with path.open("rb") as file:
            return _BAG_KEY.search(file.read(_MOST_LOOKED_AT)) is not None
    except OSError:
        return False


def open_bag(path: Path, topics: Sequence[str] = ("", "", "")) -> BagProcess:
    """The bag at a path; opened once for all who hold it."""
    key = (str(path.resolve()), tuple(topics))
    with _opening:
        bag = _opened.get(key)
        if bag is None:
            bag = BagProcess(path, topics)
            _opened[key] = bag
        return bag


def bag_files(path: Path) -> tuple[Path, ...]:
    """The files of a bag, in order."""
    if not path.is_dir():
        return (path,)
    return tuple(sorted(file for file in path.iterdir() if file.suffix in (".mcap", ".db3")))


def calibration_texts(contents: BagContents) -> tuple[str, ...]:
    """camera_info of the bag's cameras in YAML; none where it says nothing of use."""
    wanted = 2 if contents.topics[1] else 1
    return contents.calibrations if len(contents.calibrations) == wanted else ()


class BagPictures:
    """Pictures of one camera in a bag; see `PictureSource`.

    Args:
        bag: the opened bag. right: the right camera's. name: what to call it in messages.

    Raises:
        RecordingError: the bag has no such camera.
    """

    def __init__(self, bag: BagProcess, name: str, *, right: bool = False) -> None:
        self._side = int(right)
        contents = bag.contents
        topic, size = contents.topics[self._side], contents.sizes[self._side]
        if not topic or size is None:
            raise RecordingError(
                "{path}: has no images of the {side} camera; name its topic in recording.toml",
                path=bag.path,
                side=_SIDES[self._side],
            )
        self.name = f"{name} {topic}"
        self.size = size
        self.files = bag_files(bag.path)
        self.stamps_ns: NDArray[np.int64] = contents.stamps_ns[self._side]
        self.times_s: NDArray[np.float64] = (self.stamps_ns - self.stamps_ns[0]) / 1e9
        self._pace = pace_of(self.times_s, None)
        self._recorded_times = contents.recorded_times
        self._bag: BagProcess | None = bag
        self._lost: set[int] = set()

    @property
    def frame_count(self) -> int:
        """The number of pictures."""
        return len(self.stamps_ns)

    @property
    def fps(self) -> float | None:
        """Pictures a second by their times."""
        return self._pace.fps

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities of the times, and pictures found broken up to now."""
        notes = [msg("{name}: {note}", name=self.name, note=note) for note in self._pace.notes]
        if self._recorded_times:
            notes.append(
                msg("{name}: times are those of recording, not the camera's own", name=self.name)
            )
        if self._lost:
            notes.append(broken_frames(self.name, self._lost))
        return tuple(notes)

    def read(self, number: int) -> Image:
        """One picture; a broken one is shown as the last good one before it."""
        check_number(self.name, number, self.frame_count)
        back = range(number, max(-1, number - _MOST_STEPS_BACK), -1)
        on = range(number + 1, min(self.frame_count, number + _MOST_STEPS_BACK))
        for candidate in (*back, *on):
            image = self._good(candidate)
            if image is not None:
                return image
        raise RecordingError("{name}: none of the images can be read", name=self.name)

    def pictures(self, start: int, stop: int) -> Iterator[Image]:
        """Pictures start to stop (half-open) in order."""
        for number in range(start, stop):
            yield self.read(number)

    def close(self) -> None:
        """Let go of the bag; the last one ends its program."""
        self._bag = None

    def _good(self, number: int) -> Image | None:
        if number in self._lost:
            return None
        if self._bag is None:
            raise RecordingError("{name}: was closed; open it again", name=self.name)
        try:
            image = self._bag.read(self._side, number)
        except BrokenMessageError:
            self._lost.add(number)
            return None
        if image.shape == (*self.size[::-1], 3) and image.dtype == np.uint8:
            return np.asarray(image, np.uint8)
        self._lost.add(number)
        return None


class BagDepth:
    """Depth in a bag, one for each picture of its left camera; see `DepthSource`.

    Args:
        bag: the opened bag. name: what to call it in messages. scale_m: metres of a unit.
        left_ns: when the left pictures were taken; the nearest depth goes with each.

    Raises:
        RecordingError: the bag has no depth.
    """

    def __init__(
        self, bag: BagProcess, name: str, scale_m: float, left_ns: NDArray[np.int64] | None
    ) -> None:
        topic, size = bag.contents.topics[2], bag.contents.sizes[2]
        if not topic or size is None:
            raise RecordingError(
                "{path}: has no depth images; name their topic in recording.toml", path=bag.path
            )
        self.name = f"{name} {topic}"
        self.size = size
        self.files = bag_files(bag.path)
        self._scale = np.float32(scale_m)
        stamps = bag.contents.stamps_ns[2]
        self._number = _nearest(stamps, stamps if left_ns is None else left_ns)
        self.frame_count = len(self._number)
        self._bag: BagProcess | None = bag
        self._lost: set[int] = set()

    @property
    def notes(self) -> tuple[Message, ...]:
        """Depth that is missing or was found broken up to now."""
        without = int((self._number < 0).sum())
        notes: tuple[Message, ...] = ()
        if without:
            frames = count_msg(without, "{n} frame", "{n} frames")
            notes = (msg("{name}: {frames} without depth", name=self.name, frames=frames),)
        return (*notes, *lost_notes(self.name, self._lost))

    def read(self, number: int) -> Depth:
        """One picture; unknown everywhere where there is none."""
        unknown = np.zeros(self.size[::-1], np.float32)
        wanted = int(self._number[number])
        if wanted < 0 or number in self._lost:
            return unknown
        if self._bag is None:
            raise RecordingError("{name}: was closed; open it again", name=self.name)
        try:
            units = self._bag.read(2, wanted)
        except BrokenMessageError:
            units = np.zeros(0, np.uint8)
        if units.shape != unknown.shape:
            self._lost.add(number)
            return unknown
        if units.dtype == np.float32:  # metres, as ROS has it
            return np.where(np.isfinite(units) & (units > 0), units, np.float32(0))
        return depth_of_units(units.astype(np.uint16, copy=False), self._scale)

    def close(self) -> None:
        """Let go of the bag; the last one ends its program."""
        self._bag = None


def _nearest(stamps: NDArray[np.int64], wanted: NDArray[np.int64]) -> NDArray[np.int64]:
    """The place of the stamp nearest to each wanted one; -1 where none is within half a frame."""
    after = np.searchsorted(stamps, wanted).clip(0, len(stamps) - 1)
    before = (after - 1).clip(0)
    nearer = np.abs(stamps[before] - wanted) <= np.abs(stamps[after] - wanted)
    place = np.where(nearer, before, after)
    step = float(np.median(np.diff(wanted))) if len(wanted) > 1 else np.inf
    return np.where(np.abs(stamps[place] - wanted) <= step / 2, place, -1)
