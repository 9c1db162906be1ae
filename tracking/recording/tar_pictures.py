"""Images in a tar that is not packed, by number: read where they stand, nothing is unpacked."""

from __future__ import annotations

import io
import tarfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.depth_pictures import (
    Depth,
    depth_of_units,
    lost_notes,
    require_depth,
)
from tracking.recording.frame import Image
from tracking.recording.image_headers import MOST_PIXELS, size_in
from tracking.recording.images import IMAGE_SUFFIXES, image_files
from tracking.recording.pace import pace_of
from tracking.recording.pictures import broken_images, check_number
from tracking.recording.time_stamps import stamps_of_names
from tracking.translation import Message, msg

TAR_SUFFIX = ".tar"
_MOST_MEMBERS = 1_000_000
_MOST_BYTES = 256 << 20


@dataclass(frozen=True, slots=True)
class Member:
    """A plain file in a tar: its name, and where its bytes stand."""

    name: PurePosixPath
    start: int
    size: int


def is_tar(path: Path) -> bool:
    """Whether a path is named like a tar."""
    return path.suffix.lower() == TAR_SUFFIX and path.is_file()


def members_of(path: Path) -> list[Member]:
    """The plain files in a tar, links and devices left out.

    Raises:
        RecordingError: it is no tar, is packed, or holds too much.
    """
    members: list[Member] = []
    try:
        with tarfile.open(path, "r:") as archive:
            for info in archive:
                if info.isreg() and not info.issparse():
                    members.append(Member(PurePosixPath(info.name), info.offset_data, info.size))
                if len(members) > _MOST_MEMBERS:
                    raise RecordingError("{path}: holds too many files", path=path)
    except (tarfile.TarError, OSError, ValueError, EOFError) as error:
        raise RecordingError(
            "{path}: cannot be read as a tar that is not packed; unpack it", path=path
        ) from error
    return members


def read_member(path: Path, member: Member) -> bytes:
    """The bytes of a file in a tar; fewer where it is cut short."""
    if member.size > _MOST_BYTES:
        return b""
    with path.open("rb") as file:
        file.seek(member.start)
        return file.read(member.size)


def images_of(members: Sequence[Member], folder: str) -> list[Member]:
    """The images in the folder of that name, at any depth, in natural order."""
    inside = {
        Path(member.name.name): member
        for member in members
        if member.name.parent.name == folder and member.name.suffix.lower() in IMAGE_SUFFIXES
    }
    return [inside[name] for name in image_files(list(inside))]


class TarImages:
    """Pictures of one camera in a tar; see `PictureSource`.

    Args:
        path: the tar. folder: of the camera. name: what to call it in messages.

    Raises:
        RecordingError: there are none, or the first one cannot be read.
    """

    def __init__(self, path: Path, folder: str, name: str) -> None:
        self.name = f"{name} {folder}"
        self.files = (path,)
        self._members = images_of(members_of(path), folder)
        if not self._members:
            raise RecordingError(
                "{path}: holds no images in a folder {folder}", path=path, folder=folder
            )
        first = self._decoded(0)
        if first is None:
            raise RecordingError(
                "{path}: {member} cannot be read as an image",
                path=path,
                member=self._members[0].name,
            )
        self.size = (first.shape[1], first.shape[0])
        self.stamps_ns = stamps_of_names([member.name.stem for member in self._members])
        stamps = self.stamps_ns
        self.times_s = None if stamps is None else (stamps - stamps[0]) / 1e9
        self._pace = pace_of(self.times_s, None)
        self._lost: set[int] = set()

    @property
    def frame_count(self) -> int:
        """The number of images."""
        return len(self._members)

    @property
    def fps(self) -> float | None:
        """Images a second by their names; None where these are no times."""
        return self._pace.fps

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities of the times, and images found broken up to now."""
        notes = [msg("{name}: {note}", name=self.name, note=note) for note in self._pace.notes]
        if self._lost:
            first = self._members[min(self._lost)].name.name
            notes.append(broken_images(self.name, len(self._lost), first))
        return tuple(notes)

    def read(self, number: int) -> Image:
        """One image; a broken one is shown as the last good one before it."""
        check_number(self.name, number, self.frame_count)
        for candidate in range(number, -1, -1):
            image = None if candidate in self._lost else self._decoded(candidate)
            if image is not None and image.shape[1::-1] == self.size:
                return np.asarray(image, np.uint8)
            self._lost.add(candidate)
        raise RecordingError("{name}: none of the images can be read", name=self.name)

    def pictures(self, start: int, stop: int) -> Iterator[Image]:
        """Images start to stop (half-open) in order."""
        for number in range(start, stop):
            yield self.read(number)

    def close(self) -> None:
        """Nothing is held open."""

    def _decoded(self, number: int) -> NDArray[Any] | None:
        return _decoded(read_member(self.files[0], self._members[number]), cv2.IMREAD_COLOR)


class TarDepth:
    """Depth in a tar; see `DepthSource`.

    Args:
        path: the tar. folder: of the depth. name: what to call it. scale_m: metres of a unit.

    Raises:
        RecordingError: there is none, or it is not of 16 bits and one channel.
    """

    def __init__(self, path: Path, folder: str, name: str, scale_m: float) -> None:
        self.name = f"{name} {folder}"
        self.files = (path,)
        self._scale = np.float32(scale_m)
        self._members = images_of(members_of(path), folder)
        first = self._decoded(0) if self._members else None
        if first is None:
            raise RecordingError(
                "{path}: holds no depth images in a folder {folder}", path=path, folder=folder
            )
        require_depth(first, f"{path}: {self._members[0].name}")
        self.size = (first.shape[1], first.shape[0])
        self._lost: set[int] = set()

    @property
    def frame_count(self) -> int:
        """The number of images."""
        return len(self._members)

    @property
    def notes(self) -> tuple[Message, ...]:
        """Images found broken up to now."""
        return lost_notes(self.name, self._lost)

    def read(self, number: int) -> Depth:
        """One picture; a broken one is unknown everywhere."""
        units = self._decoded(number)
        if units is None or units.shape != self.size[::-1] or units.dtype != np.uint16:
            self._lost.add(number)
            return np.zeros(self.size[::-1], np.float32)
        return depth_of_units(units.astype(np.uint16, copy=False), self._scale)

    def close(self) -> None:
        """Nothing is held open."""

    def _decoded(self, number: int) -> NDArray[Any] | None:
        return _decoded(read_member(self.files[0], self._members[number]), cv2.IMREAD_UNCHANGED)


def _decoded(data: bytes, flag: int) -> NDArray[Any] | None:
    """The image; None where it cannot be read, or is too large."""
    size = size_in(io.BytesIO(data))
    if size is None or size[0] * size[1] > MOST_PIXELS:
        return None
    try:
        image = cv2.imdecode(np.frombuffer(data, np.uint8), flag)
    except cv2.error:
        return None
    return None if image is None else np.asarray(image)
