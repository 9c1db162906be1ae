"""Detections of a recording as perception asks for them: frame by frame, one a person."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

from tracking.arrays import Mask
from tracking.detections.detections_file import DetectionsFile, read_cameras
from tracking.detections.frame_numbers import Footage
from tracking.detections.settings import ONLY, DetectionSettings
from tracking.detections.table import BoxTable, suppress_overlaps
from tracking.errors import FormatError, RecordingError
from tracking.people.detection_source import FrameDetections
from tracking.recording import Recording
from tracking.tracks import DetectionsInput
from tracking.translation import Message, msg


class RecordingDetections:
    """Detections of a recording, from one file or from one for each camera: a `DetectionSource`.

    Args:
        left: of the left (or only) camera. right: of the right one, None: nothing is known.
        settings: which of the boxes are used.
        looked_at: the region of interest, see `Recording`; None: everywhere.

    Attributes:
        inputs: which files these are, as a run keeps it.
        notes: what the user should know of them, a line each.
    """

    def __init__(
        self,
        left: DetectionsFile,
        right: DetectionsFile | None = None,
        *,
        settings: DetectionSettings,
        looked_at: Mask | None = None,
    ) -> None:
        self._settings = settings
        self._left = left.table.above_score(settings.least_score)
        self._right = None if right is None else right.table.above_score(settings.least_score)
        files = [("left", left, self._left)]
        if right is not None and self._right is not None:
            files.append(("right", right, self._right))
        self.inputs: tuple[DetectionsInput, ...] = tuple(
            DetectionsInput(camera, file.path.name, file.format, file.fingerprint, len(file.table))
            for camera, file, _ in files
        )
        self.notes: tuple[Message, ...] = tuple(
            note for _, file, used in files for note in (_used_of(file, used), *file.notes)
        )
        if looked_at is not None and len(self._left):
            self._left = self._left.in_region(looked_at)
            if not len(self._left):
                self.notes += (
                    msg("warning: no box of {file} is in the region", file=left.path.name),
                )

    @property
    def unused(self) -> bool:
        """Whether the boxes of some file are all left out, which is hardly what is wanted."""
        return not all(len(table) for table in (self._left, self._right) if table is not None)

    @property
    def detections_only(self) -> bool:
        """Whether no people are looked for in the foreground beside them."""
        return self._settings.use == ONLY

    def of(self, frame: int) -> FrameDetections:
        """The boxes of a frame of the left camera, one for each person."""
        return suppress_overlaps(self._left.of(frame), self._settings.max_overlap)

    def of_right(self, frame: int) -> FrameDetections | None:
        """Those of the right camera; None where nothing is known of it."""
        if self._right is None:
            return None
        return suppress_overlaps(self._right.of(frame), self._settings.max_overlap)


def _used_of(file: DetectionsFile, used: BoxTable) -> Message:
    if not len(used):
        return msg(
            "warning: none of the {count} boxes of {file} ({title}) is used; lower "
            "detections.min_score",
            count=len(file.table),
            file=file.path.name,
            title=file.title,
        )
    return msg(
        "{file} ({title}): {used} of {count} boxes are used"
        if len(used) == len(file.table)
        else "{file} ({title}): {used} of {count} boxes are used, those with a score from "
        "{least:.3g} on",
        file=file.path.name,
        title=file.title,
        used=len(used),
        count=len(file.table),
        least=float(used.score.min()),
    )


_NAMES = ("det.txt", "detections.txt", "det/det.txt", "detections.json", "labels")
"""What other programs call them."""


def files_beside(recording: Recording) -> tuple[str, ...]:
    """Files in the recording's folder that are called as detections are, the likeliest first."""
    return tuple(name for name in _NAMES if _is_there(recording.folder / name))


def _is_there(path: Path) -> bool:
    try:
        return path.exists() and not path.is_symlink()
    except OSError:  # a folder that may not be read
        return False


def detections_stage(settings: Any) -> DetectionSettings:
    """What a tracker's settings say of detections; no file where it has no such stage."""
    stage = getattr(settings, "detections", None)
    return stage if isinstance(stage, DetectionSettings) else DetectionSettings()


def load_detections(
    recording: Recording, settings: DetectionSettings
) -> RecordingDetections | None:
    """The boxes that settings name, of a recording; None where they name no file.

    Raises FormatError where a file cannot be read, RecordingError where there is one of a right
    camera that the recording does not have.
    """
    if not settings.file:
        return None
    if settings.file_right and not recording.is_stereo:
        raise RecordingError(
            "recording {name} has one camera: leave out the detections of the right one",
            name=recording.name,
        )
    given = [(place_of(recording, settings.file), Footage.of(recording))]
    if settings.file_right:
        right = Footage.of(recording, right=True)
        given.append((place_of(recording, settings.file_right), right))
    return RecordingDetections(
        *read_cameras(given), settings=settings, looked_at=recording.looked_at
    )


def place_of(recording: Recording, named: str) -> Path:
    """Where a file is that a setting names: relative paths begin in the recording's folder.

    Raises FormatError where links lead from there elsewhere, as they may in a copied recording.
    """
    place = recording.folder / named
    if not Path(named).is_absolute():
        real = Path(os.path.realpath(recording.folder))
        folder = Path(os.path.normpath(real / named)).parent
        if Path(os.path.realpath(folder)) != folder:
            raise FormatError(
                "{path}: the folder it is in is a link, which is not followed; name the place it "
                "leads to",
                path=place,
            )
    return place


def outside(settings: Mapping[str, Any]) -> str:
    """The file of detections, or the network, that settings name outside of the folder.

    Settings are by their dotted names, the folder is that of the recording; "" where there is none.
    What only a session names out there is not read: it may come from somebody else.
    """
    keys = ("file", "file_right", "model", "appearance")
    named = (str(settings.get(f"detections.{name}", "")) for name in keys)
    return next((each for each in named if not _is_inside(each)), "")


def _is_inside(named: str) -> bool:
    """Whether a path stays within a folder on every system."""
    parts = (*PurePosixPath(named).parts, *PureWindowsPath(named).parts)
    return not (PurePosixPath(named).root or PureWindowsPath(named).anchor) and ".." not in parts


def with_relative_paths(recording: Recording, settings: Any) -> Any:
    """The settings of a tracker with paths inside of the recording's folder made relative to it.

    So they hold wherever the folder is put.
    """
    named = detections_stage(settings)
    if not (named.file or named.model or named.appearance):
        return settings
    folder = Path(os.path.realpath(recording.folder))
    inside = replace(
        named,
        file=_relative_to(folder, named.file),
        file_right=_relative_to(folder, named.file_right),
        model=_relative_to(folder, named.model),
        appearance=_relative_to(folder, named.appearance),
    )
    return replace(settings, detections=inside)


def _relative_to(folder: Path, named: str) -> str:
    """The path itself where it is relative, or outside; a link stays one."""
    path = Path(os.path.normpath(named))
    if not path.is_absolute():
        return named
    place = Path(os.path.realpath(path.parent), path.name)
    return str(place.relative_to(folder)) if place.is_relative_to(folder) else named
