"""Label Studio's JSON of video, read; see `label_studio` for the layout."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.filled_rows import MOST_TRACKS, FilledRows
from tracking.formats.json_numbers import number_of
from tracking.formats.json_stream import JsonPath, values_of
from tracking.formats.label_studio_region import PREDICTION, Region, upright
from tracking.formats.label_text import left_out
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.row_rules import BOX
from tracking.progress import Progress, no_progress
from tracking.tracks import LARGEST_NUMBER, Source
from tracking.translation import msg

_START = re.compile(rb"(\xef\xbb\xbf)?\s*[\[{]")
_REGION = re.compile(rb'"(videorectangle|sequence)"')
_FRAMES = re.compile(rb'"(framesCount|enabled)"')
_ANNOTATIONS, _PREDICTIONS = frozenset({"annotations", "completions"}), "predictions"
_LISTS = _ANNOTATIONS | {_PREDICTIONS}
_DRAFTS = "drafts"
"""What nobody has handed in yet; passed over piece by piece, as it may be as long."""
_VIDEO = "videorectangle"
_OF_BOXES = frozenset({_VIDEO, "labels"})
_KEPT = frozenset(
    {
        "id",
        "type",
        "meta",
        "score",
        "origin",
        "original_width",
        "original_height",
        "labels",
        "framesCount",
    }
)
_MOST_KEYFRAMES = 20_000_000
_MOST_ANNOTATIONS = 20_000
"""Of all tasks together: a file is of one video, and has a few of them."""
_LONGEST_TIME = 64


def looks_like_label_studio(_path: Path, head: bytes) -> bool:
    """Whether a file is JSON that speaks of regions with keyframes soon after it begins."""
    return _START.match(head) is not None and bool(_REGION.search(head) and _FRAMES.search(head))


def import_label_studio(path: Path, filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of one video; see `label_studio` for what becomes of keyframes and ids.

    Raises FormatError where the file holds several videos, does not say how large the image is
    and nobody else does, is no such JSON, or has keyframes that stand for more rows than any
    footage has.
    """
    file = _File(Reading(path, report), filmed)
    for place, value in values_of(path, _inside, report):
        file.take(_of_task(place), value)
    return file.imported()


def _of_task(place: JsonPath) -> JsonPath:
    """The same place in an array of tasks, where the file is a single one."""
    return (0, *place) if place and isinstance(place[0], str) else place


def _inside(place: JsonPath) -> bool:
    """Tasks, annotations, regions and sequences come by their members, everything else whole."""
    place = _of_task(place)
    if len(place) <= 2:
        return True
    at, rest = place[2], place[3:]
    if not isinstance(at, int):
        return False
    if place[1] in _LISTS or place[1] == _DRAFTS:
        return (
            not rest
            or rest == ("result",)
            or (len(rest) == 2 and isinstance(rest[1], int) and rest[0] == "result")
            or rest[2:] in (("value",), ("value", "sequence"))
        )
    return rest in ((), ("sequence",))


@dataclass(slots=True)
class _Annotation:
    """What one person, or a model, said of a task."""

    task: Any
    predicted: bool
    filled: FilledRows
    said: dict[str, Any] = field(default_factory=dict)
    regions: dict[JsonPath, Region] = field(default_factory=dict)

    @property
    def rank(self) -> tuple[bool, bool, str]:
        """What of several is read: a person's, then ground truth, then the newest."""
        time = self.said.get("updated_at") or self.said.get("created_at") or ""
        return (
            not self.predicted,
            self.said.get("ground_truth") is True,
            str(time)[:_LONGEST_TIME],
        )

    @property
    def is_cancelled(self) -> bool:
        """Whether it was given up."""
        return any(self.said.get(name) is True for name in ("was_cancelled", "skipped"))


class _File:
    """Takes a file in, value by value."""

    def __init__(self, reading: Reading, filmed: Filmed) -> None:
        self._reading, self._filmed = reading, filmed
        self._annotations: dict[JsonPath, _Annotation] = {}
        self._regions = self._keyframes = 0

    def take(self, place: JsonPath, value: Any) -> None:
        """A value and where it stands among tasks."""
        if len(place) < 2:
            self._reading.bad(_named(place), msg("is no object"))
        elif place[1] in _LISTS:
            self._take_full(place, value)
        elif place[1] == _DRAFTS:
            return
        elif len(place) == 2 and place[1] in ("id", "updated_at", "created_at"):
            self._annotation(place[:1], False).said[str(place[1])] = value
        elif len(place) >= 4 and isinstance(place[2], int):
            self._take_region(place[:1], place[:3], place[3:], value)

    def _take_full(self, place: JsonPath, value: Any) -> None:
        owner, rest = place[:3], place[3:]
        if len(rest) == 1:
            self._annotation(owner, place[1] == _PREDICTIONS).said[str(rest[0])] = value
        elif len(rest) == 2:
            self._reading.bad(_named(place), msg("is no object"))
        elif len(rest) >= 3:
            self._annotation(owner, place[1] == _PREDICTIONS)
            inner = rest[2:]
            inner = inner[1:] if inner[0] == "value" and len(inner) > 1 else inner
            self._take_region(owner, place[:5], inner, value)

    def _take_region(self, owner: JsonPath, place: JsonPath, inner: JsonPath, value: Any) -> None:
        if inner[0] == "sequence" and len(inner) == 2:
            if isinstance(inner[1], int):
                self._take_keyframe(self._region(owner, place), inner[1], value)
            else:
                self._reading.bad(_named(place), msg("its sequence is no list"))
        elif len(inner) == 1 and inner[0] in _KEPT:
            region = self._region(owner, place)
            held = region.value if inner[0] in ("labels", "framesCount") else region.said
            held[str(inner[0])] = value

    def _take_keyframe(self, region: Region, number: int, value: Any) -> None:
        self._keyframes += 1
        if self._keyframes > _MOST_KEYFRAMES:
            raise FormatError(
                "{path} has more than {most} keyframes",
                path=self._reading.path,
                most=_MOST_KEYFRAMES,
            )
        if reason := region.take(number, value):
            self._reading.bad(
                msg("{place}, sequence[{number}]", place=region.place, number=number), reason
            )
        else:
            self._reading.good += 1

    def _annotation(self, owner: JsonPath, predicted: bool) -> _Annotation:
        if owner not in self._annotations:
            if len(self._annotations) == _MOST_ANNOTATIONS:
                path, most = self._reading.path, _MOST_ANNOTATIONS
                raise FormatError(
                    "{path} has more than {most} annotations; keep the task of one",
                    path=path,
                    most=most,
                )
            filled = FilledRows(self._reading.path)
            self._annotations[owner] = _Annotation(owner[0], predicted, filled)
        return self._annotations[owner]

    def _region(self, owner: JsonPath, place: JsonPath) -> Region:
        held = self._annotation(owner, False)
        if place not in held.regions:
            self._regions += 1
            if self._regions > MOST_TRACKS:
                raise FormatError(
                    "{path} has more than {most} regions", path=self._reading.path, most=MOST_TRACKS
                )
            self._count_last(held)
            held.regions[place] = Region(_named(place))
        return held.regions[place]

    def _count_last(self, held: _Annotation) -> None:
        """Count the rows of the region before the next: a file with far too many is not read on."""
        if held.regions:
            region = held.regions[next(reversed(held.regions))]
            frames = self._filmed.frames
            held.filled.add(region.rows_filled(_least(region.frames, frames), frames))

    def imported(self) -> Imported:
        """The tracks."""
        chosen = self._chosen()
        regions = self._tracks(chosen)
        if chosen is not None and chosen.predicted:
            for each in regions:
                each.said["origin"] = PREDICTION
        ids = self._ids(regions)
        size_px = next((each.size_px for each in regions if each.size_px), None)
        told = [count for each in regions if (count := each.frames) is not None]
        frames = max(told, default=None)
        stop = _least(frames, self._filmed.frames)
        rows, places = self._rows(regions, ids, stop, size_px or self._filmed.size_px)
        labels = {
            track: label
            for track, each in zip(ids, regions, strict=True)
            if not (label := each.label).is_empty
        }
        return self._reading.imported(
            rows,
            lambda row: regions[places[row][0]].place + places_of_key(places[row][1]),
            labels=labels,
            fps=next((fps for each in regions if (fps := each.fps) is not None), None),
            size_px=size_px,
            frames=frames,
        )

    def _chosen(self) -> _Annotation | None:
        """The annotation that is read; raises FormatError where they are of several videos."""
        for owner, each in self._annotations.items():
            if len(owner) == 1:  # JSON_MIN: a record of each annotation, which names its task
                each.task = each.said.get("id", each.task)
        held = [
            each
            for each in self._annotations.values()
            if not each.is_cancelled and any(part.keyframes for part in each.regions.values())
        ]
        videos = len({str(each.task) for each in held})
        if videos > 1:
            raise FormatError(
                "{path} holds tracks of {videos} videos; keep the task of one",
                path=self._reading.path,
                videos=videos,
            )
        by_people = [each for each in held if not each.predicted] or held
        if len(by_people) > 1:
            self._reading.notes.append(
                msg(
                    "of {count} annotations of the video one is read: that marked as "
                    "ground truth, or else the newest",
                    count=len(by_people),
                )
            )
        return max(by_people, key=lambda each: each.rank, default=None)

    def _tracks(self, chosen: _Annotation | None) -> list[Region]:
        """The regions that are tracks, each once, with the labels other results give them."""
        tracks: dict[Any, Region] = {}
        others = 0
        for place, each in () if chosen is None else chosen.regions.items():
            name = each.said.get("id")
            key = name if isinstance(name, str) and name else place
            first = tracks.get(key)
            if first is not None:
                first.value = {**each.value, **first.value}
            elif str(each.said.get("type", _VIDEO)).lower() not in _OF_BOXES:
                others += each.keyframes > 0
            elif each.keyframes:
                tracks[key] = each
                for number in each.repeated():
                    self._reading.bad(
                        msg("{place}, sequence[{number}]", place=each.place, number=number),
                        msg("its frame stands there twice"),
                    )
        if others:
            self._reading.notes.append(
                left_out(others, msg("region that is no box"), msg("regions that are no boxes"))
            )
        return list(tracks.values())

    def _ids(self, regions: Sequence[Region]) -> list[int]:
        """Those that were kept, and free ones for others."""
        first: dict[int, Region] = {}
        for region in regions:
            if region.kept_id is not None:
                first.setdefault(region.kept_id, region)
        kept = [
            each.kept_id if each.kept_id is not None and first[each.kept_id] is each else None
            for each in regions
        ]
        following = max((each for each in kept if each is not None), default=0)
        if following + kept.count(None) > LARGEST_NUMBER:
            raise FormatError("{path}: no ids are left for its new tracks", path=self._reading.path)
        if None in kept and any(kept):
            self._reading.notes.append(msg("tracks that were made in Label Studio got new ids"))
        free = itertools.count(following + 1)
        return [next(free) if each is None else each for each in kept]

    def _rows(
        self,
        regions: Sequence[Region],
        ids: Sequence[int],
        stop: int | None,
        size_px: tuple[int, int] | None,
    ) -> tuple[dict[str, NDArray[Any]], NDArray[np.int64]]:
        """The rows in view, and (n, 2) of each its region and keyframe."""
        self._check(regions, stop, size_px)
        parts = [each.shown(stop, self._filmed.frames) for each in regions]
        if any(part.turn.any() for part in parts):
            self._reading.notes.append(
                msg("boxes that are turned became the upright boxes around them")
            )
        boxes = [upright(part, size_px or (0, 0)) for part in parts]
        lengths = [len(part.frame) for part in parts]
        keyframe = _joined([part.keyframe for part in parts], np.int64)
        placed = np.array([each.placed for each in regions], np.int64)
        scores = [number_of(each.said.get("score")) for each in regions]
        sides = np.concatenate(boxes) if boxes else np.zeros((0, len(BOX)))
        rows: dict[str, NDArray[Any]] = {
            "frame": _joined([part.frame for part in parts], np.int64),
            "track": np.repeat(np.array(ids, np.int64), lengths),
            **dict(zip(BOX, sides.T, strict=True)),
            "confidence": np.repeat(
                np.array([np.nan if each is None else each for each in scores]), lengths
            ),
            "source": np.where(keyframe < 0, Source.INTERPOLATED, np.repeat(placed, lengths)),
        }
        return rows, np.column_stack([np.repeat(np.arange(len(parts)), lengths), keyframe])

    def _check(
        self, regions: Sequence[Region], stop: int | None, size_px: tuple[int, int] | None
    ) -> None:
        path = self._reading.path
        if regions and size_px is None:
            raise FormatError(
                "{path} tells boxes in percent, and not how large the image is; import it with "
                "its recording",
                path=path,
            )
        filled = FilledRows(path)
        for each in regions:
            filled.add(each.rows_filled(stop, self._filmed.frames))


def places_of_key(number: int) -> str:
    """Where a keyframe stands in its region; "" where a row is none."""
    return f", sequence[{number}]" if number >= 0 else ""


def _named(place: JsonPath) -> str:
    """A place as messages name it, e.g. "[0].annotations[0].result[3]"."""
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part[:40]}" for part in place)


def _least(*counts: int | None) -> int | None:
    """The least of those that are known."""
    return min((count for count in counts if count is not None), default=None)


def _joined(parts: Sequence[NDArray[Any]], dtype: type) -> NDArray[Any]:
    return np.concatenate(parts) if parts else np.zeros(0, dtype)
