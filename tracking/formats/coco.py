"""COCO for video, in the layout of TAO: one JSON file a video.

`images` (one a frame, `frame_index` from 0), `videos`, `tracks` (`id`, `category_id`) and
`annotations` (`image_id`, `track_id`, `bbox`). A `bbox` is left, top, width and height in pixels
whose first is 0: as boxes are here, so nothing is shifted. `iscrowd` 1 marks what is not counted,
which is confidence 0 here. `attributes` of an annotation hold its `track_id` once more, where
datumaro and CVAT look for it. Source: TAO's toolkit, tao.py; COCO's data format.

What a track has besides its category (a name, attributes) stands in its `tracks` entry, under
keys of this program; other tools pass over them. The format has no places on the floor and no
keyframes.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.coco_writer import export_coco
from tracking.formats.filled_rows import MOST_TRACKS
from tracking.formats.json_numbers import number_of, whole_of
from tracking.formats.json_stream import elements_of
from tracking.formats.label_text import label_as_read, label_of
from tracking.formats.line_survey import MOST_ROWS
from tracking.formats.read_result import FASTEST_FPS, Filmed, Imported, Reading
from tracking.formats.row_rules import BOX, MAX_FRAME
from tracking.formats.track_format import Content, TrackFormat
from tracking.progress import Progress, no_progress
from tracking.tracks import TrackLabel
from tracking.translation import msg

_MEMBERS = ("info", "videos", "images", "tracks", "categories", "annotations")
_START = re.compile(
    rb"(\xef\xbb\xbf)?\s*\{\s*"
    rb'"(info|licenses|videos|images|tracks|categories|annotations)"\s*:\s*[\[{]'
)
_WIDEST_PX = 1 << 20
_LARGEST = 1 << 62
"""A whole number beyond it is no measure of anything."""


_MOST = {
    "info": 1000,
    "videos": 10_000,
    "images": MAX_FRAME,
    "tracks": MOST_TRACKS,
    "categories": 100_000,
    "annotations": MOST_ROWS,
}
"""Elements of each member; a file is of one video."""


def looks_like_coco(_path: Path, head: bytes) -> bool:
    """Whether a file begins as an object with one of COCO's members."""
    return _START.match(head) is not None


def import_coco(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a file of one video.

    A frame is an image's `frame_index` (or `frame_id`, as some tools write). Rows marked `iscrowd`
    or `ignore` get confidence 0: they are not counted; others their `score`, where they have one.
    Raises FormatError where the file holds several videos, no tracks, or no such JSON.
    """
    file = _File(Reading(path, report))
    for member, at, value in elements_of(path, _MEMBERS, report):
        file.take(member, at, value)
    return file.imported()


def object_of(
    reading: Reading, member: str, at: int, value: Any, most: int
) -> dict[str, Any] | None:
    """An element of a member, which is an object; None: it is not, which is told as bad.

    Args:
        at: which element it is; -1: the member itself, which is no array. Then nothing is told.

    Raises FormatError where the member has more elements than `most`.
    """
    if at >= most:
        raise FormatError(
            "{path} has more than {at} {member}; split it first",
            path=reading.path,
            at=at,
            member=member,
        )
    if isinstance(value, dict):
        return value
    if at >= 0:
        reading.bad(f"{member}[{at}]", msg("is no object"))
    return None


class _File:
    """Takes a file in, whatever order its members have."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading
        self._videos: dict[int, dict[str, Any]] = {}
        self._images: dict[int, int] = {}
        self._kinds: dict[int, str] = {}
        self._tracks: dict[int, dict[str, Any]] = {}
        self._fps: float | None = None
        self._size_px: tuple[int, int] | None = None
        self._whole = array("q")  # of each annotation: which it is, its image, track and kind
        self._boxes, self._confidence = array("d"), array("d")
        self._untracked = 0

    def take(self, member: str, at: int, value: Any) -> None:
        """One element of a member."""
        element = object_of(self._reading, member, at, value, _MOST[member])
        if element is None:
            return
        takers = {
            "info": self._take_info,
            "videos": self._take_videos,
            "images": self._take_images,
            "tracks": self._take_tracks,
            "categories": self._take_categories,
            "annotations": self._take_annotations,
        }
        takers[member](at, element)

    def _take_info(self, _at: int, info: Mapping[str, Any]) -> None:
        self._fps = self._fps or _fps_of(info)

    def _take_videos(self, at: int, video: dict[str, Any]) -> None:
        number = whole_of(video.get("id"))
        if number is None:
            self._reading.bad(f"videos[{at}]", msg("its id is no whole number"))
        else:
            self._videos[number] = video
        metadata = video.get("metadata")
        for known in (video, metadata if isinstance(metadata, dict) else {}):
            self._fps = self._fps or _fps_of(known)
        self._size_px = self._size_px or size_of(video)

    def _take_images(self, at: int, image: Mapping[str, Any]) -> None:
        number, frame = whole_of(image.get("id")), frame_of(image)
        if number is None or frame is None:
            self._reading.bad(f"images[{at}]", msg("its id or frame_index is no whole number"))
        elif number in self._images:
            self._reading.bad(
                msg("images[{at}]", at=at), msg("the id {number} stands there twice", number=number)
            )
        else:
            self._images[number] = frame
        self._size_px = self._size_px or size_of(image)

    def _take_tracks(self, _at: int, track: dict[str, Any]) -> None:
        number = whole_of(track.get("id"))
        if number is not None:  # a track with no id has no annotations
            self._tracks[number] = track

    def _take_categories(self, _at: int, category: Mapping[str, Any]) -> None:
        number = whole_of(category.get("id"))
        if number is not None:
            self._kinds[number] = str(category.get("name", ""))

    def _take_annotations(self, at: int, row: Mapping[str, Any]) -> None:
        said = _track_said(row)
        self._untracked += said is None
        track, image, box = whole_of(said), whole_of(row.get("image_id")), row.get("bbox")
        if track is None or image is None:
            self._reading.bad(
                f"annotations[{at}]", msg("its track_id or image_id is no whole number")
            )
            return
        numbers = numbers_of(box)
        if numbers is None:
            self._reading.bad(f"annotations[{at}]", msg("its bbox is not four numbers"))
            return
        kind = whole_of(row.get("category_id"))
        self._whole.extend((at, image, track, -1 if kind is None else kind))
        self._boxes.extend(numbers)
        self._confidence.append(_confidence_of(row))
        self._reading.good += 1

    def imported(self) -> Imported:
        """The tracks."""
        self._check()
        at, image, track, kind = np.asarray(self._whole, np.int64).reshape(-1, 4).T
        frame = np.array([self._images.get(number, -1) for number in image.tolist()], np.int64)
        known = frame >= 0
        for row in np.flatnonzero(~known).tolist():
            what = (
                msg("has no image of the file")
                if self._images
                else msg("is of a file without images")
            )
            self._reading.bad(f"annotations[{at[row]}]", what)
        boxes = np.asarray(self._boxes).reshape(-1, len(BOX))[known]
        rows: dict[str, NDArray[Any]] = {
            "frame": frame[known],
            "track": self._reading.ids_from_zero(track[known]),
            **dict(zip(BOX, boxes.T, strict=True)),
            "confidence": np.array(self._confidence)[known],
        }
        places = at[known]
        labels = self._labels(track[known], rows["track"], kind[known])
        return self._reading.imported(
            rows,
            lambda row: f"annotations[{places[row]}]",
            labels=labels,
            fps=self._fps,
            size_px=self._size_px,
            frames=self._frames(),
        )

    def _frames(self) -> int | None:
        """How many the footage has, where there is an image of every one."""
        whole = set(self._images.values()) == set(range(len(self._images)))
        return len(self._images) if self._images and whole else None

    def _check(self) -> None:
        path = self._reading.path
        if len(self._videos) > 1:
            raise FormatError(
                "{path} holds tracks of {count} videos; keep those of one of them",
                path=path,
                count=len(self._videos),
            )
        if self._untracked and not self._whole:
            raise FormatError(
                "{path} holds detections without track_id, no tracks; track first", path=path
            )

    def _labels(
        self, said: NDArray[np.int64], track: NDArray[Any], kind: NDArray[np.int64]
    ) -> dict[int, TrackLabel]:
        """What is said of each track; its kind is that of its first annotation."""
        labels = {}
        for number, first in zip(*np.unique(track, return_index=True), strict=True):
            known = self._tracks.get(int(said[first]), {})
            of_track = whole_of(known.get("category_id"))
            name = self._kinds.get(int(kind[first]) if of_track is None else of_track, "")
            attributes = known.get("attributes")
            if not isinstance(attributes, dict):
                attributes = {}
            label = label_of(known.get("name", ""), name, attributes)
            if not label.is_empty:
                labels[int(number)] = label
        return labels


def _track_said(row: Mapping[str, Any]) -> Any:
    """Which track an annotation is of: as TAO, others, or CVAT and datumaro write it."""
    attributes = row.get("attributes")
    others = attributes if isinstance(attributes, dict) else {}
    told = (row.get("track_id"), row.get("instance_id"), others.get("track_id"))
    return next((one for one in told if one is not None), None)


def frame_of(image: Mapping[str, Any]) -> int | None:
    """The frame an image says it is, from 0; None: it says none."""
    frame = whole_of(image.get("frame_index", image.get("frame_id")))
    return frame if frame is not None and 0 <= frame < MAX_FRAME else None


def _confidence_of(row: Mapping[str, Any]) -> float:
    if row.get("iscrowd") or row.get("ignore"):
        return 0.0
    score = row.get("score")
    return float(score) if score is not None and _is_number(score) else np.nan


def _fps_of(known: Mapping[str, Any]) -> float | None:
    fps = number_of(known.get("fps"))
    return fps if fps is not None and 0 < fps < FASTEST_FPS else None


def size_of(known: Mapping[str, Any]) -> tuple[int, int] | None:
    """Width and height in px that an image or a video says it has; None: it says none."""
    width, height = whole_of(known.get("width")), whole_of(known.get("height"))
    if width is None or height is None or not 0 < min(width, height) <= _WIDEST_PX:
        return None
    return (width, height) if max(width, height) <= _WIDEST_PX else None


def _is_number(value: Any) -> bool:
    return type(value) is float or (type(value) is int and abs(value) < _LARGEST)


def numbers_of(box: Any) -> array[float] | None:
    """The four numbers of a `bbox`; None for everything else."""
    if type(box) is not list or len(box) != len(BOX):
        return None
    try:
        return array("d", box)
    except (TypeError, OverflowError):
        return None


COCO = TrackFormat(
    "coco",
    "COCO for video (TAO), JSON",
    (".json",),
    looks_like_coco,
    import_coco,
    export_coco,
    dont_cares=True,
    holds=frozenset((Content.BOXES, Content.CONFIDENCE, Content.CLASSES, Content.NAMES)),
    needs=Content.BOXES,
    label_as_read=label_as_read,
    about="Boxes with tracks, in TAO's form; for detectors and their tools.",
)
