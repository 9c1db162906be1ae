"""COCO's JSON: results of a detector, a list of boxes; or a data set with images and annotations.

A `bbox` is left, top, width and height in px from 0, as boxes are here. Results say `image_id` and
`category_id` only; a data set names its images and categories. Source: COCO's data and results
formats.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from tracking.arrays import Flags, Integers
from tracking.detections.box_collector import MOST_IN_ALL, BoxCollector
from tracking.detections.frame_numbers import Footage
from tracking.errors import FormatError
from tracking.formats.coco import frame_of, looks_like_coco, numbers_of, object_of, size_of
from tracking.formats.json_numbers import number_of, whole_of
from tracking.formats.json_stream import elements_of, values_of
from tracking.formats.read_result import MOST_BAD
from tracking.formats.row_rules import MAX_FRAME
from tracking.translation import joined, msg

_LIST = re.compile(rb"(?:\xef\xbb\xbf)?\s*\[\s*\{")
_LIST_MEMBERS = (rb'"image_id"\s*:', rb'"bbox"\s*:')
_MEMBERS = ("images", "categories", "annotations")
_MOST_CATEGORIES = 100_000
PEOPLE = frozenset(("person", "persons", "people", "pedestrian", "pedestrians", "human"))
"""What data sets call the class of people."""
_NO_CATEGORY = -1


def is_coco(head: bytes) -> bool:
    """Whether a file begins as COCO's results or as a data set."""
    is_list = _LIST.match(head) is not None
    return looks_like_coco(Path(), head) or (
        is_list and all(re.search(each, head) for each in _LIST_MEMBERS)
    )


def read_coco_boxes(boxes: BoxCollector, footage: Footage) -> None:
    """All boxes of people in the file; raises FormatError where it is no such JSON."""
    file = _File(boxes)
    for member, at, value in _elements(boxes):
        file.take(member, at, value)
    file.finish(footage)


def _elements(boxes: BoxCollector) -> Iterator[tuple[str, int, Any]]:
    """The elements of each member; those of a bare list are annotations."""
    path, report = boxes.reading.path, boxes.reading.report
    if not boxes.held[:64].lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"["):
        yield from elements_of(path, _MEMBERS, report, boxes.held)
        return
    for place, value in values_of(path, lambda place: not place, report, boxes.held):
        yield "annotations", int(place[0]) if place else 0, value


class _File:
    """Takes a file in, whatever order its members have."""

    def __init__(self, boxes: BoxCollector) -> None:
        self._boxes, self._reading = boxes, boxes.reading
        self._images: dict[int, tuple[int | None, str]] = {}
        self._size_px: tuple[int, int] | None = None
        self._kinds: dict[int, str] = {}
        self._whole = array("q")  # of each box: which annotation it is, its image, its category
        self._sides, self._scores = array("d"), array("d")

    def take(self, member: str, at: int, value: Any) -> None:
        """One element of a member."""
        most = {"images": MAX_FRAME, "categories": _MOST_CATEGORIES}.get(member, 2 * MOST_IN_ALL)
        element = object_of(self._reading, member, at, value, most)
        if element is None:
            return
        if member == "annotations":
            self._take_box(at, element)
        elif (number := whole_of(element.get("id"))) is None:
            self._reading.bad(f"{member}[{at}]", msg("its id is no whole number"))
        elif member == "images":
            self._images[number] = (frame_of(element), str(element.get("file_name", ""))[:1000])
            self._size_px = self._size_px or size_of(element)
        else:
            self._kinds[number] = str(element.get("name", "")).strip().lower()[:1000]

    def _take_box(self, at: int, row: Mapping[str, Any]) -> None:
        if row.get("iscrowd") or row.get("ignore"):
            return  # a crowd is nobody's box
        image, sides = whole_of(row.get("image_id")), numbers_of(row.get("bbox"))
        if image is None or sides is None:
            what = msg("its image_id is no whole number") if image is None else ""
            self._reading.bad(f"annotations[{at}]", what or msg("its bbox is not four numbers"))
            return
        kind, score = whole_of(row.get("category_id")), number_of(row.get("score"))
        self._whole.extend((at, image, _NO_CATEGORY if kind is None else kind))
        self._sides.extend(sides)
        self._scores.append(np.nan if score is None else score)
        self._reading.good += 1

    def finish(self, footage: Footage) -> None:
        """Hand the boxes of people on, by frame."""
        at, image, kind = np.asarray(self._whole, np.int64).reshape(-1, 3).T
        people = self._are_people(kind)
        number = self._numbers(image, footage)
        for place in at[people & (number < 0)][: MOST_BAD + 1].tolist():
            self._reading.bad(
                f"annotations[{place}]",
                msg("its image tells no frame: it is not listed, or has no number"),
            )
        kept = people & (number >= 0)
        sides = np.asarray(self._sides, np.float64).reshape(-1, 4) * self._scale(footage)
        places = at[kept]
        self._boxes.add(
            number[kept].astype(np.float64),
            sides[kept],
            np.asarray(self._scores, np.float64)[kept],
            lambda row: f"annotations[{places[row]}]",
        )

    def _are_people(self, kind: Integers) -> Flags:
        """(n,) which boxes are of people.

        Where no names are told, the first category is: COCO's is 1, person.
        """
        if not self._kinds:
            known = np.unique(kind)
            if len(known) < 2:
                return np.ones(len(kind), np.bool_)
            self._reading.notes.append(
                msg(
                    "its categories have no names: {first}, the first one, is taken for people",
                    first=int(known[0]),
                )
            )
            return np.asarray(kind == known[0])
        wanted = [number for number, name in self._kinds.items() if name in PEOPLE]
        if not wanted:
            raise FormatError(
                "{path}: none of its categories is person ({names}); rename the one of people",
                path=self._reading.path,
                names=joined(", ", sorted(set(self._kinds.values()))[:5]),
            )
        return np.isin(kind, wanted)

    def _numbers(self, image: Integers, footage: Footage) -> Integers:
        """(n,) the frame of each box, or what counts its picture; -1: it is of none."""
        if not self._images:
            self._boxes.count(image)
            return image
        number = np.fromiter(self._images, np.int64, len(self._images))
        said = [frame for frame, _ in self._images.values()]
        if all(frame is not None for frame in said):
            numbers = np.array(said, np.int64)
        else:
            names = [
                name.rpartition("/")[2].rpartition(".")[0] for _, name in self._images.values()
            ]
            numbers, counts = footage.numbers_of_names(names)
            if (numbers < 0).all():
                numbers, counts = number, True
            if counts:
                self._boxes.count(numbers)
        order = np.argsort(number)
        at = np.searchsorted(number[order], image).clip(max=len(number) - 1)
        found = order[at]
        return np.where(number[found] == image, numbers[found], -1)

    def _scale(self, footage: Footage) -> tuple[float, float, float, float]:
        """What makes sides in px of the file's images px of the recording's."""
        if self._size_px is None or self._size_px == footage.size_px:
            return 1.0, 1.0, 1.0, 1.0
        (width, height), (wide, high) = self._size_px, footage.size_px
        self._reading.notes.append(
            msg(
                "its images have {width} x {height} px, those of the recording {wide} x {high}: "
                "its boxes are scaled",
                width=width,
                height=height,
                wide=wide,
                high=high,
            )
        )
        return wide / width, high / height, wide / width, high / height
