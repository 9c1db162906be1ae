"""The tracks of a CVAT file on their way to this program's rows."""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.cvat_interpolation import SIDES, filled, rows_filled
from tracking.formats.cvat_meta import Meta
from tracking.formats.cvat_schema import NAME, OWN_KEYS, TRACK_ID
from tracking.formats.filled_rows import MOST_TRACKS, FilledRows
from tracking.formats.label_text import key_of, label_of
from tracking.formats.read_result import Imported, Reading
from tracking.tracks import LARGEST_NUMBER, Source, TrackLabel, label_as_stored
from tracking.translation import Message, msg, some_of

BOX_NUMBERS = ("xtl", "ytl", "xbr", "ybr")
AUTOMATIC = "auto"
"""The source of a track nobody corrected."""

MOST_EMPTY = 20_000
"""Tracks without boxes, unless as many have some."""

_MOST_TOLD, _MOST_NAMED = 20, 6
_WHOLE = re.compile(r"\d{1,10}")
_HIDDEN_BELOW = 0.5
"""A person of whom less is seen is `occluded`."""
_INTEGERS = ("frame", "line", "outside", "occluded", "key")


class CvatTrack:
    """One `track` element: what it says and its boxes, as they stand there."""

    def __init__(self, said: Mapping[str, str], line: int) -> None:
        self.line = line
        self.number = _number(said.get("id", ""))
        self.kind = said.get("label", "")
        self.automatic = said.get("source", "") == AUTOMATIC
        self.attributes: dict[str, str] = {}
        self.changing: set[str] = set()
        self._whole, self._sides = array("q"), array("d")

    def rows(self, whole: Sequence[int], sides: Sequence[float]) -> None:
        """Add a row: `_INTEGERS`, and the box's four sides."""
        self._whole.extend(whole)
        self._sides.extend(sides)

    def say(self, name: str, text: str) -> None:
        """Take an attribute of a box: the first counts, and those that differ later are noted."""
        if self.attributes.setdefault(name, text) != text:
            self.changing.add(name)

    @property
    def has_rows(self) -> bool:
        """Whether it has any box."""
        return len(self._whole) > 0

    def columns(self) -> dict[str, NDArray[Any]]:
        """All rows by frame, `_INTEGERS` and `SIDES`."""
        whole = np.array(self._whole, np.int64).reshape(-1, len(_INTEGERS))
        sides = np.array(self._sides).reshape(-1, len(SIDES))
        order = np.argsort(whole[:, 0], kind="stable")
        columns: dict[str, NDArray[Any]] = dict(zip(_INTEGERS, whole[order].T, strict=True))
        columns |= {name: columns[name].astype(bool) for name in _INTEGERS[2:]}
        return columns | dict(zip(SIDES, sides[order].T, strict=True))

    @property
    def label(self) -> TrackLabel:
        """What is said of the whole track."""
        others = {
            key_of(OWN_KEYS, key): text
            for key, text in self.attributes.items()
            if key not in OWN_KEYS
        }
        return label_of(self.attributes.get(NAME, ""), self.kind, others)


@dataclass(frozen=True, slots=True)
class _Held:
    """A track of the file: its id, as an attribute or as CVAT numbers it, and its rows."""

    kept: int | None
    number: int | None
    label: TrackLabel
    columns: dict[str, NDArray[Any]]
    automatic: bool


class FileTracks:
    """All tracks of a file."""

    def __init__(self, reading: Reading, meta: Meta, frames: int | None) -> None:
        """meta: of the file, as far as it is read. frames: of the recording; None: unknown."""
        self._reading, self._meta, self._frames = reading, meta, frames
        self._filled = FilledRows(reading.path)
        self._changing: dict[str, list[int]] = {}
        self._held: list[_Held] = []
        self._met = 0

    def __len__(self) -> int:
        return len(self._held)

    def add(self, track: CvatTrack) -> None:
        """Take a track over; one without boxes is none."""
        self._met += 1
        if self._met > MOST_TRACKS:
            raise FormatError(
                "{path} holds more than {most} tracks; split it",
                path=self._reading.path,
                most=MOST_TRACKS,
            )
        if self._met - len(self._held) > max(MOST_EMPTY, len(self._held)):
            raise FormatError(
                "{path} holds hardly more than tracks without boxes; export it again",
                path=self._reading.path,
            )
        if track.number is None:
            self._reading.bad(
                msg("line {line}", line=track.line),
                msg("the id of the track is not a whole number"),
            )
        elif track.has_rows:
            kept = _number(track.attributes.get(TRACK_ID, "")) or None
            columns = track.columns()
            self._count_filled(columns, self._filled)
            for name in sorted(track.changing - OWN_KEYS):
                self._changing.setdefault(key_of(OWN_KEYS, name), []).append(kept or track.number)
            self._held.append(_Held(kept, track.number, track.label, columns, track.automatic))

    def imported(self) -> Imported:
        """The tracks as this program has them."""
        meta, ids, parts = self._meta, self._ids(), self._shown()
        rows = _joined(parts, ids, [held.automatic for held in self._held])
        lines = rows.pop("line")
        schema = meta.labels.schema
        self._reading.notes += [*meta.labels.notes, *self._notes_on_changing()]
        return self._reading.imported(
            rows,
            lambda row: (
                msg("line {lines}", lines=lines[row])
                if lines[row]
                else msg("frame {rows}", rows=rows["frame"][row])
            ),
            labels={
                track: label_as_stored(schema, held.label)
                for track, held in zip(ids, self._held, strict=True)
                if not held.label.is_empty
            },
            size_px=meta.size_px,
            frames=None if meta.last_frame is None else meta.last_frame + 1,
            seen_as=kept_visibility,
            schema=schema,
        )

    def _notes_on_changing(self) -> Iterator[Message]:
        for name, tracks in list(self._changing.items())[:_MOST_TOLD]:
            yield msg(
                "attribute {name} changes along track {tracks}: its first value is taken",
                name=name,
                tracks=some_of(tracks, _MOST_NAMED),
            )

    def _ids(self) -> list[int]:
        """Those that were kept; where a file keeps none, CVAT's own; free ones for new tracks."""
        kept = [held.kept for held in self._held]
        if not any(kept):
            numbers = np.array([held.number for held in self._held], np.int64)
            return [int(number) for number in self._reading.ids_from_zero(numbers)]
        following = max(filter(None, kept)) + 1
        ids = []
        for each in kept:
            ids.append(following if each is None else each)
            following += each is None
        if None in kept:
            self._reading.notes.append(msg("tracks that were made in CVAT got new ids"))
        return ids

    def _shown(self) -> list[dict[str, NDArray[Any]]]:
        """The rows in view of each track; raises FormatError where there are far too many."""
        count = FilledRows(self._reading.path)  # anew: the meta may stand behind the tracks
        by_keyframes = [self._count_filled(held.columns, count) for held in self._held]
        parts = []
        for held, is_filled in zip(self._held, by_keyframes, strict=True):
            rows, outside = held.columns, held.columns["outside"]
            if is_filled:
                shown = filled(rows, outside, self._meta.step, self._end(rows), self._frames)
                parts.append({**shown, "line": _lines(rows, shown)})
            else:
                parts.append({name: column[~outside] for name, column in rows.items()})
        return parts

    def _count_filled(self, rows: Mapping[str, NDArray[Any]], count: FilledRows) -> bool:
        """Whether a track is told by keyframes; the rows between them are counted then."""
        step = self._meta.step
        if not _is_told_by_keyframes(rows, step):
            return False
        count.add(rows_filled(rows["frame"], rows["outside"], step, self._end(rows), self._frames))
        return True

    def _end(self, rows: Mapping[str, NDArray[Any]]) -> int:
        """The last frame of the task or recording; the track's where neither is known."""
        ends = (self._meta.last_frame, None if self._frames is None else self._frames - 1)
        return min((end for end in ends if end is not None), default=int(rows["frame"][-1]))


def _is_told_by_keyframes(rows: Mapping[str, NDArray[Any]], step: int) -> bool:
    """Whether a track's rows are keyframes alone, with boxes to be shown between them.

    CVAT itself writes every box it shows; a converter that does has no gaps without an end.
    """
    frame, shown = rows["frame"], ~rows["outside"]
    if not rows["key"].all() or np.any(np.diff(frame) == 0):
        return False
    return bool(np.any((np.diff(frame) > step) & shown[:-1]))


def _lines(
    rows: Mapping[str, NDArray[Any]], shown: Mapping[str, NDArray[Any]]
) -> NDArray[np.int64]:
    """The line each row stands on; 0: on none."""
    at = np.searchsorted(rows["frame"], shown["frame"], side="right") - 1
    lines: NDArray[np.int64] = np.where(shown["key"], rows["line"][at], 0)
    return lines


def _joined(
    parts: Sequence[Mapping[str, NDArray[Any]]], ids: Sequence[int], automatic: Sequence[bool]
) -> dict[str, NDArray[Any]]:
    """The rows of all tracks."""

    def whole(name: str) -> NDArray[Any]:
        return np.concatenate([part[name] for part in parts]) if parts else np.zeros(0)

    counts = [len(part["frame"]) for part in parts]
    placed = np.where(np.repeat(automatic, counts), Source.TRACKER, Source.PERSON)
    return {
        "frame": whole("frame"),
        "track": np.repeat(np.array(ids, np.int64), counts),
        "left": whole("left"),
        "top": whole("top"),
        "width": whole("right") - whole("left"),
        "height": whole("bottom") - whole("top"),
        "visibility": np.where(whole("occluded").astype(bool), 0.0, 1.0),
        "source": np.where(whole("key").astype(bool), placed, Source.INTERPOLATED),
        "line": whole("line").astype(np.int64),
    }


def kept_visibility(visibility: NDArray[Any], predicted: NDArray[Any]) -> NDArray[np.float64]:
    """(n,) what is left of visibilities that were written: 0 for who is `occluded`, else 1."""
    return np.where(is_occluded(visibility, predicted), 0.0, 1.0)


def is_occluded(visibility: NDArray[Any], predicted: NDArray[Any]) -> NDArray[np.bool_]:
    """(n,) who is `occluded`: of whom less than a half is seen, and whose box is predicted."""
    return np.asarray((visibility < _HIDDEN_BELOW) | predicted)


def _number(text: str) -> int | None:
    """A whole number from 0 on that an id can be."""
    text = text.strip()
    if not _WHOLE.fullmatch(text) or int(text) > LARGEST_NUMBER:
        return None
    return int(text)
