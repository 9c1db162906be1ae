"""Boxes of a recording as perception asks for them: frame by frame, sure ones, one a person."""

from __future__ import annotations

from pathlib import Path

from tracking.detections.reading import read_detections
from tracking.detections.settings import ONLY, DetectionSettings
from tracking.detections.table import BoxTable, one_each
from tracking.people.given_boxes import FrameBoxes
from tracking.recording import Recording


class GivenBoxes:
    """A `BoxSource` of one table, or of one for each camera.

    Args:
        left: boxes of the left (or only) camera. right: of the right one, None: nothing is known.
        settings: which of them are used.
    """

    def __init__(self, left: BoxTable, right: BoxTable | None, settings: DetectionSettings) -> None:
        self._left = left.sure(settings.least_score)
        self._right = None if right is None else right.sure(settings.least_score)
        self._settings = settings

    @property
    def only(self) -> bool:
        """Whether no people are looked for in the foreground beside them."""
        return self._settings.use == ONLY

    def of(self, frame: int) -> FrameBoxes:
        """The boxes of a frame of the left camera, one for each person."""
        return one_each(self._left.of(frame), self._settings.max_overlap)

    def of_right(self, frame: int) -> FrameBoxes | None:
        """Those of the right camera; None where nothing is known of it."""
        if self._right is None:
            return None
        return one_each(self._right.of(frame), self._settings.max_overlap)


def box_source(recording: Recording, settings: DetectionSettings) -> GivenBoxes | None:
    """The boxes that settings name, of a recording; None where they name no file.

    Raises FormatError where a file cannot be read.
    """
    if not settings.file:
        return None
    left = read_detections(place_of(recording, settings.file)).table
    right = None
    if settings.file_right:
        right = read_detections(place_of(recording, settings.file_right)).table
    return GivenBoxes(left, right, settings)


def place_of(recording: Recording, named: str) -> Path:
    """Where a file is that a setting names: relative paths begin in the recording's folder."""
    return recording.folder / named
