"""VIAME's CSV, which DIVE reads and writes, too: a line a detection, or a state of a track.

`id, video or picture, frame, left, top, right, bottom, confidence, length`, then pairs of a class
and its confidence, then attributes. Frames and pixels count from 0; `right` and `bottom` are edges,
so nothing is shifted. Lines that begin with `#` are comments; `# metadata` may tell `fps`.

- A track is what shares an id; id 0 becomes the id after the highest. Its class is the likeliest of
  its last line that has any, its confidence in each frame the eighth value, else the class's.
- `(trk-atr) KEY VALUE` belongs to the track: `name` is the person's, others are attributes. Of
  `(atr) KEY VALUE`, which belong to one frame, `occluded true` is visibility 0; others are left
  out, as are lengths, `(kp)`, `(poly)`, `(hole)`, `(mask)` and `(note)`.
- Written, a blank in KEY is `%20`, and an attribute called `name` has the key `name_`; attributes
  beyond 48 kB of a track are left out, as its lines could not be read back.
- Written, who is hidden (predicted, or of whom less than half is seen) has `(atr) occluded true`.
  The second value is the time in the video where the frames a second are known. A confidence nobody
  knows is 1; keyframes and places on the floor are not in the format.

Sources: VIAME's examples/detection_file_conversions/README.rst and its
read_/write_object_track_set_viame_csv; DIVE's server/dive_utils/serializers/viame.py.
"""

from __future__ import annotations

import io
import re
from array import array
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import tracking
from tracking.atomic_output import replacing
from tracking.cells import CsvWriter
from tracking.errors import FormatError
from tracking.formats.cvat_track import is_occluded, kept_visibility
from tracking.formats.delimited_text import TRIED_ROWS
from tracking.formats.filled_rows import MOST_TRACKS
from tracking.formats.label_text import kind_of
from tracking.formats.line_survey import MOST_ROWS, too_many
from tracking.formats.number_text import short_decimals
from tracking.formats.read_result import FASTEST_FPS, Filmed, Imported, Reading
from tracking.formats.row_rules import BOX
from tracking.formats.text_fields import fields_of, number_in, numbered_lines, whole_in
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported
from tracking.formats.viame_class import (
    OF_TRACK,
    attribute_in,
    cell_of_class,
    cells_of_label,
    class_of_cell,
    label_as_read,
    label_in,
)
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns, TrackLabel
from tracking.translation import msg

_HEADER_CELLS = (
    "# 1: Detection or Track-id",
    "2: Video or Image Identifier",
    "3: Unique Frame Identifier",
    "4-7: Img-bbox(TL_x",
    "TL_y",
    "BR_x",
    "BR_y)",
    "8: Detection or Length Confidence",
    "9: Target Length (0 or -1 if invalid)",
    "10-11+: Repeated Species",
    "Confidence Pairs or Attributes",
)
_NO_LENGTH = "-1"
_CERTAIN = 1.0
_MICROSECONDS = 1_000_000
_SECONDS = 60


def export_viame(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks that have boxes, one after the other.

    Raises FormatError where no row has a box.
    """
    with replacing(path) as stream:
        metadata = [] if exported.fps is None else [f"fps: {exported.fps!r}"]
        metadata.append(f'exported_by: "trackwright {tracking.__version__}"')
        stream.write(f"{','.join(_HEADER_CELLS)}\n{_as_csv(['# metadata', *metadata])}")
        for track, rows in exported.tracks_with_boxes(path, "VIAME's CSV", report):
            stream.writelines(_rows(track, rows, exported))
    return (path,)


def _rows(track: int, rows: Columns, exported: Exported) -> Iterator[str]:
    label = exported.label(track)
    kind, cells = _as_csv([cell_of_class(kind_of(label))])[:-1], cells_of_label(label)
    about = f",{_as_csv(cells)[:-1]}" if cells else ""
    hidden = is_occluded(rows["visibility"], rows["predicted"]).tolist()
    boxes = np.column_stack([rows[name] for name in BOX]).astype(np.float64)
    boxes[:, 2:] += boxes[:, :2]
    said = short_decimals(np.asarray(exported.confidence(rows), np.float32))
    confidence = np.where(np.isnan(said), _CERTAIN, said).tolist()
    for frame, (left, top, right, bottom), score, is_hidden in zip(
        rows["frame"].tolist(), boxes.tolist(), confidence, hidden, strict=True
    ):
        occluded = ",(atr) occluded true" if is_hidden else ""
        yield (
            f"{track},{_time_of(frame, exported.fps)},{frame},{left!r},{top!r},{right!r},"
            f"{bottom!r},{score!r},{_NO_LENGTH},{kind},{score!r}{occluded}{about}\n"
        )


def _time_of(frame: int, fps: float | None) -> str:
    """As DIVE writes it, e.g. "00:01:02.500000"; "" where frames a second are not known.

    Hours count on after a day, where DIVE begins again: two frames never have the same time.
    """
    if fps is None:
        return ""
    seconds, micros = divmod(round(frame / fps * _MICROSECONDS), _MICROSECONDS)
    minutes, seconds = divmod(seconds, _SECONDS)
    hours, minutes = divmod(minutes, _SECONDS)
    return f"{hours:02d}:{minutes:02d}:{seconds:02d}.{micros:06d}"


def _as_csv(fields: list[str]) -> str:
    """A line of values, quoted where they need it."""
    text = io.StringIO()
    CsvWriter(text).writerow(fields)
    return text.getvalue()


_NUMBER = rb"\s*[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?\s*"
_HEADER = re.compile(
    rb'(?:\xef\xbb\xbf)?"?# ?(?:1: Detection or Track|metadata[",])', re.IGNORECASE
)
_COMMENTS = re.compile(rb"(?:\xef\xbb\xbf)?(?:\"?#[^\n]*\n|\s*\n)*")
_PICTURE = rb"(?:[^,\n]*\.[A-Za-z][A-Za-z0-9]{1,4}\"?|\"?\d+:\d\d[\d:.]*\"?|)"
"""The name of a file, a time, or nothing: a mere text there would be a bad row of MOT text."""
_FIRST_ROW = re.compile(
    rb"\s*\d+\s*," + _PICTURE + rb",\s*\d+\s*," + (_NUMBER + rb",") * 5 + _NUMBER
)
_FPS = re.compile(r"\bfps: *\"?(\d{1,5}(?:\.\d{1,12})?)\b", re.IGNORECASE)
_UNKNOWN = -1.0
_LEAST = 9
"""Values before classes and attributes."""
_OCCLUDED = "occluded"
_MOST_COMMENTS = 10_000
_MOST_ATTRIBUTES = 65
"""Of a track; its name is one of them."""


def looks_like_viame(_path: Path, head: bytes) -> bool:
    """Whether a file begins with VIAME's header, or a line with a picture's name or a time."""
    if _HEADER.match(head):
        return True
    comments = _COMMENTS.match(head)
    return _FIRST_ROW.match(head, comments.end() if comments else 0) is not None


def import_viame(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a file. Raises FormatError where it cannot be read as a whole."""
    file = _File(Reading(path, report))
    for number, text in numbered_lines(path, report):
        file.take(number, text)
    return file.imported()


class _File:
    """Takes a file in, line by line."""

    def __init__(self, reading: Reading) -> None:
        self._reading = reading
        self._whole, self._numbers = (
            array("q"),
            array("d"),
        )  # line, frame, id; box, confidence, seen
        self._tracks: set[int] = set()
        self._kinds: dict[int, str] = {}
        self._said: dict[int, dict[str, str]] = {}
        self._fps: float | None = None
        self._comments = self._left_out = 0
        self._tells_hidden = False

    def take(self, number: int, text: str) -> None:
        """One line."""
        if text.startswith(("#", '"#')):
            self._take_comment(text)
        elif text.strip():
            fields = fields_of(text)
            reason = (
                msg("{count} values; a line has {least} or more", count=len(fields), least=_LEAST)
                if fields
                else "quotes"
            )
            if len(fields) >= _LEAST:
                reason = self._take_fields(number, fields)
            if reason:
                self._reading.bad(msg("line {number}", number=number), reason)

    def imported(self) -> Imported:
        """The tracks."""
        if self._left_out:
            self._reading.notes.append(
                msg("what the file says of single frames ((atr), (kp), (poly), (note)) is left out")
            )
        line, frame, said = np.asarray(self._whole, np.int64).reshape(-1, 3).T
        numbers = np.asarray(self._numbers).reshape(-1, 6)
        left, top, right, bottom = numbers[:, :4].T
        track = self._reading.ids_from_zero(said)
        rows: dict[str, NDArray[Any]] = {
            "frame": frame,
            "track": track,
            **dict(zip(BOX, (left, top, right - left, bottom - top), strict=True)),
            "confidence": numbers[:, 4],
            "visibility": np.where(self._tells_hidden, numbers[:, 5], np.nan),
        }
        ids, first = np.unique(said, return_index=True)
        labels = self._labels(dict(zip(ids.tolist(), track[first].tolist(), strict=True)))
        return self._reading.imported(
            rows,
            lambda row: msg("line {line}", line=line[row]),
            labels=labels,
            fps=self._fps,
            seen_as=kept_visibility,
        )

    def _take_comment(self, text: str) -> None:
        self._comments += 1
        if self._comments > _MOST_COMMENTS:
            raise FormatError("{path} holds hardly more than comments", path=self._reading.path)
        found = _FPS.search(text)
        if self._fps is None and "metadata" in text and found:
            fps = float(found[1])
            self._fps = fps if 0 < fps < FASTEST_FPS else None

    def _take_fields(self, number: int, fields: Sequence[str]) -> str:
        """Add a row; says why it is invalid where it is."""
        track, frame = whole_in(fields[0]), whole_in(fields[2])
        if track is None or frame is None:
            return msg("its id or frame is not a whole number")
        box = [number_in(field) for field in fields[3:7]]
        if None in box:
            return msg("its box is not four numbers")
        pairs, rest = _pairs_of(fields[_LEAST:])
        if pairs is None:
            return msg("a class has no confidence that is a number")
        confidence = number_in(fields[7]) if fields[7].strip() else _UNKNOWN
        if confidence is None:
            return msg("its confidence is not a number")
        if confidence < 0 and confidence != _UNKNOWN:
            return msg(
                "its confidence is {confidence:g}, below 0; {unknown:g} stands for unknown",
                confidence=confidence,
                unknown=_UNKNOWN,
            )
        self._count(track)
        best = max(pairs, key=lambda pair: pair[1], default=("", -1.0))
        confidence = confidence if confidence >= 0 else best[1]
        if best[0]:
            self._kinds[track] = best[0]
        occluded = self._take_attributes(track, rest)
        self._whole.extend((number, frame, track))
        self._numbers.extend(side for side in box if side is not None)
        self._numbers.extend((confidence if confidence >= 0 else np.nan, 0.0 if occluded else 1.0))
        self._reading.good += 1
        if self._reading.good == TRIED_ROWS:
            self._try()
        if self._reading.good > MOST_ROWS:
            raise too_many(self._reading.path)
        return ""

    def _count(self, track: int) -> None:
        """Raise FormatError where a file has far more ids than people."""
        self._tracks.add(track)
        if len(self._tracks) > MOST_TRACKS:
            raise FormatError(
                "{path} has more than {most} tracks; split it",
                path=self._reading.path,
                most=MOST_TRACKS,
            )

    def _try(self) -> None:
        """Raise FormatError where the first rows are such that the file is refused in the end."""
        line, frame, said = np.array(self._whole, np.int64).reshape(-1, 3).T
        rows = {"frame": frame, "track": said}
        Reading(self._reading.path).checked(
            rows, lambda row: msg("line {line}", line=line[row]), least_track=0
        )

    def _take_attributes(self, track: int, fields: Sequence[str]) -> bool:
        """Keep what is said of the track; gives whether it is hidden in this frame."""
        occluded = False
        for field in fields:
            found = attribute_in(field)
            if found is None:
                self._left_out += bool(field.strip())
            elif found[0] != OF_TRACK:
                is_occluded = found[1] == _OCCLUDED
                self._tells_hidden |= is_occluded
                occluded |= is_occluded and found[2].strip().lower() == "true"
                self._left_out += not is_occluded
            else:
                kept = self._said.setdefault(track, {})
                if found[1] in kept or len(kept) < _MOST_ATTRIBUTES:
                    kept[found[1]] = found[2]
        return occluded

    def _labels(self, ids: dict[int, int]) -> dict[int, TrackLabel]:
        labels = {}
        for said, track in ids.items():
            label = label_in(self._kinds.get(said, ""), self._said.get(said, {}))
            if not label.is_empty:
                labels[track] = label
        return labels


def _pairs_of(fields: Sequence[str]) -> tuple[list[tuple[str, float]] | None, Sequence[str]]:
    """Classes with their confidence, None where one has none; and what stands behind them."""
    pairs: list[tuple[str, float]] = []
    at = 0
    while at < len(fields) and fields[at].strip() and not fields[at].lstrip().startswith("("):
        score = number_in(fields[at + 1]) if at + 1 < len(fields) else None
        if score is None:
            return None, ()
        pairs.append((class_of_cell(fields[at].strip()), score))
        at += 2
    return pairs, fields[at:]


VIAME = TrackFormat(
    "viame",
    "VIAME and DIVE, CSV",
    (".csv",),
    looks_like_viame,
    import_viame,
    export_viame,
    holds=frozenset(
        (Content.BOXES, Content.CONFIDENCE, Content.VISIBILITY, Content.CLASSES, Content.NAMES)
    ),
    needs=Content.BOXES,
    label_as_read=label_as_read,
    about="Boxes with confidence, names and attributes; opens in VIAME and DIVE.",
)
