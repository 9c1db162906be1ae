"""Small pictures of a review item's people before, at and after its instant."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.core.i18n import joined_text, time_text, tr
from app.core.projection.concern import corners_around
from app.core.scenes import Colour
from tracking.progress import Progress
from tracking.review import ReviewItem
from tracking.tracks import Box, Columns, TrackTable
from tracking.tracks.columns import boxes_of

_BESIDE_S = 0.5
_AROUND = 0.6
"""How much is seen around the boxes, in the height of the tallest one."""
_LONGEST_PX = 320
_SHAPE = 3 / 4
"""Pictures are at least so wide for their height, and so high for their width."""


@dataclass(frozen=True, slots=True)
class StripBox:
    """Somebody in a small picture.

    Attributes:
        box: left, top, width, height as shares of the picture. label: number and name.
    """

    box: Box
    label: str
    colour: Colour


@dataclass(frozen=True, slots=True, eq=False)
class StripPicture:
    """One of the pictures.

    Attributes:
        image: (h, w, 3) BGR. when: its time in words. boxes: of who is there.
    """

    image: NDArray[np.uint8]
    when: str
    boxes: tuple[StripBox, ...]


@dataclass(frozen=True, slots=True, eq=False)
class StripScene:
    """All of them, and the same in words for who does not see them."""

    pictures: tuple[StripPicture, ...] = ()
    text: str = ""


@dataclass(frozen=True, slots=True)
class StripAsk:
    """What the pictures are of; equal where they would be the same.

    Attributes:
        tracks, frames: whom they show, and when. revision: of the tracks. fps: of the recording.
        labels, colours: of the tracks, in their order.
    """

    tracks: tuple[int, ...]
    frames: tuple[int, ...]
    revision: int
    fps: float
    labels: tuple[str, ...]
    colours: tuple[Colour, ...]


def strip_frames(item: ReviewItem, fps: float, frame_count: int) -> tuple[int, ...]:
    """Three frames: before, at and after the instant, within what is watched where that is."""
    beside = max(1, round(_BESIDE_S * fps))
    before = max(min(item.start, item.frame - 1), item.frame - beside)
    after = min(max(item.end - 1, item.frame + 1), item.frame + beside)
    last = max(frame_count - 1, 0)
    return tuple(min(max(frame, 0), last) for frame in (before, item.frame, after))


def prepare_strip(
    asked: StripAsk, table: TrackTable, read: Callable[[int], NDArray[np.uint8]]
) -> Callable[[Progress], StripScene]:
    """Take hold of the rows now; what is given makes the pictures on any thread.

    Args:
        read: gives the left picture of a frame, BGR; asked on that thread.
    """
    there = [track for track in asked.tracks if track in table]
    rows = [table.of_tracks(there, frame, frame + 1) for frame in asked.frames]
    return lambda report: _strip(asked, rows, read, report)


def _strip(
    asked: StripAsk,
    rows: Sequence[Columns],
    read: Callable[[int], NDArray[np.uint8]],
    report: Progress,
) -> StripScene:
    boxes = [boxes_of(part).astype(np.float64) for part in rows]
    part = _part(np.concatenate(boxes))
    if part is None:
        return StripScene()
    pictures = []
    for number, (frame, found, its) in enumerate(zip(asked.frames, boxes, rows, strict=True)):
        report(number, len(asked.frames))
        picture = read(frame)
        left, top, right, bottom = _inside(part, picture.shape)
        image = _small(picture[top:bottom, left:right])
        shown = tuple(
            _strip_box(asked, track, box, (left, top, right, bottom))
            for track, box in zip(its["track"].tolist(), found, strict=True)
            if np.isfinite(box).all()
        )
        pictures.append(StripPicture(image, time_text(frame / asked.fps), shown))
    return StripScene(tuple(pictures), _words(asked, pictures))


def _part(boxes: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Left, top, right and bottom around all boxes, neither very wide nor very high."""
    corners = corners_around(boxes, _AROUND)
    if corners is None:
        return None
    low, high = corners
    width, height = high - low
    size = np.array([max(width, _SHAPE * height), max(height, _SHAPE * width)])
    middle = (low + high) / 2
    return np.concatenate((middle - size / 2, middle + size / 2))


def _inside(part: NDArray[np.float64], shape: tuple[int, ...]) -> tuple[int, int, int, int]:
    """The part in whole pixels, moved and cut so that it lies in the picture."""
    ends = []
    for low, high, length in ((part[0], part[2], shape[1]), (part[1], part[3], shape[0])):
        size = min(max(round(high - low), 1), length)
        start = min(max(round(low), 0), length - size)
        ends.append((start, start + size))
    (left, right), (top, bottom) = ends
    return left, top, right, bottom


def _small(piece: NDArray[np.uint8]) -> NDArray[np.uint8]:
    longest = max(piece.shape[:2])
    if longest <= _LONGEST_PX:
        return np.ascontiguousarray(piece)
    scale = _LONGEST_PX / longest
    small = cv2.resize(piece, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    return np.ascontiguousarray(small, np.uint8)


def _strip_box(
    asked: StripAsk, track: int, box: NDArray[np.float64], part: tuple[int, int, int, int]
) -> StripBox:
    left, top, right, bottom = part
    width, height = right - left, bottom - top
    at = asked.tracks.index(track)
    x, y, w, h = box.tolist()
    shares = ((x - left) / width, (y - top) / height, w / width, h / height)
    return StripBox(shares, asked.labels[at], asked.colours[at])


def _words(asked: StripAsk, pictures: Sequence[StripPicture]) -> str:
    """Who is in sight in each picture, and who is not."""
    said = []
    for picture in pictures:
        seen = {one.label for one in picture.boxes}
        there = [label for label in asked.labels if label in seen]
        gone = [label for label in asked.labels if label not in seen]
        words = []
        if there:
            words.append(tr("{who} in sight", who=joined_text(", ", there)))
        if gone:
            words.append(tr("{who} not there", who=joined_text(", ", gone)))
        said.append(f"{picture.when}: {joined_text(', ', words)}")
    return joined_text("; ", said)
