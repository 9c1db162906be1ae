"""Pictures of switches: who it was before and after, cut out of the recording."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from tracking.arrays import Floats
from tracking.errors import RecordingError
from tracking.scoring.errors import ErrorKind, ErrorTable
from tracking.scoring.report.findings import Finding
from tracking.scoring.report.subject import Subject
from tracking.scoring.table import ScoringTable

if TYPE_CHECKING:
    from tracking.recording import Image

MOST_SWITCHES = 24
"""Of one result on one sequence."""

_SHAPE = 4 / 3
"""Width over height of what is cut out."""
_AROUND = 0.6
"""How much is seen around the boxes, in their own size."""
_LEAST_PX = 96.0
_PLACE_PX = 640
_BEFORE, _AFTER = (0, 159, 230), (233, 180, 86)
"""BGR; told apart by the colour-blind, too."""
_BODY_M = (1.7, 0.6)


@dataclass(frozen=True, slots=True)
class SwitchPictures:
    """One switch.

    Attributes:
        frame, earlier_frame: the first after it, and the last before.
        person: in the truth. earlier, track: of the result.
        before, after: JPEG images.
    """

    frame: int
    earlier_frame: int
    person: int
    earlier: int
    track: int
    before: bytes
    after: bytes


def switch_pictures(
    finding: Finding, tell: Callable[[int, int], None], most: int = MOST_SWITCHES
) -> tuple[SwitchPictures, ...]:
    """The first switches of a finding, in the order of their frames.

    Args:
        tell: told how many are done of how many; may raise to cancel.

    Returns: none where there are no pictures, or nobody knows where people stand in them.
    """
    found = finding.errors.of_kind(ErrorKind.SWITCH)
    if finding.subject.footage.pictures is None:
        return ()
    shown: list[SwitchPictures] = []
    for row in range(len(found)):
        tell(len(shown), min(most, len(found)))
        if len(shown) == most:
            break
        shown += _pictures(finding, found, row)
    return tuple(shown)


def _pictures(finding: Finding, found: ErrorTable, row: int) -> Iterator[SwitchPictures]:
    """The pictures of a switch; nothing where a frame is missing or boxes are unknown."""
    subject = finding.subject
    now, then = int(found.frame[row]), int(found.earlier_frame[row])
    person, track, earlier = (int(c[row]) for c in (found.truth, found.result, found.earlier))
    result = subject.results[finding.result]
    instants = [(then, earlier, _BEFORE), (now, track, _AFTER)]
    boxes = [
        (_box(subject, subject.truth, frame, person), _box(subject, result, frame, number))
        for frame, number, _ in instants
    ]
    every = np.array([box for pair in boxes for box in pair])
    if np.isnan(every).any():
        return
    from tracking.scoring.report.box_pictures import painted  # brings OpenCV

    images = [_image(subject, frame) for frame, _, _ in instants]
    window = _window(every, images[0].shape) if images[0] is not None else None
    made = [
        painted(image, window, pair, (f"person {person}", f"track {number}"), colour)
        for image, pair, (_, number, colour) in zip(images, boxes, instants, strict=True)
        if image is not None and window is not None
    ]
    if len(made) == 2:
        yield SwitchPictures(now, then, person, earlier, track, *made)


def _image(subject: Subject, frame: int) -> Image | None:
    pictures = subject.footage.pictures
    if pictures is None or not 0 <= frame < pictures.frame_count:
        return None
    try:
        return pictures.read(frame).left
    except RecordingError:
        return None


def _box(subject: Subject, table: ScoringTable, frame: int, who: int) -> Floats:
    """(4,) of one row; from where it stands on the floor where it has no box; NaN: unknown."""
    begin, end = np.searchsorted(table.frame, [frame - subject.start, frame - subject.start + 1])
    row = begin + np.flatnonzero(table.track[begin:end] == who)
    box = table.box[row[0]] if len(row) else np.full(4, np.nan)
    view = subject.footage.view
    if np.isnan(box).any() and view is not None and len(row):
        return np.asarray(view.box_of_person(table.position[row[0]], *_BODY_M)[0])
    return box


def _window(boxes: Floats, shape: tuple[int, ...]) -> tuple[int, int, int, int]:
    """Left, top, width, height of what is cut out: about the boxes, of the pictures' shape."""
    rows, columns = shape[:2]
    corners = np.concatenate([boxes[:, :2], boxes[:, :2] + boxes[:, 2:]])
    corners = np.clip(corners, 0, [columns, rows])
    low, high = corners.min(axis=0), corners.max(axis=0)
    middle = (low + high) / 2
    wide, tall = np.maximum((high - low) * (1 + _AROUND), _LEAST_PX)
    tall = max(tall, wide / _SHAPE)
    size = np.minimum([tall * _SHAPE, tall], [columns, rows])
    left, top = np.clip(middle - size / 2, 0, np.array([columns, rows]) - size)
    return int(left), int(top), int(size[0]), int(size[1])


def place_picture(subject: Subject) -> bytes | None:
    """The first frame that is measured, as JPEG, to draw a map on; None where there is none."""
    image = _image(subject, subject.start)
    if image is None:
        return None
    from tracking.scoring.report.box_pictures import shrunk

    return shrunk(image, _PLACE_PX)
