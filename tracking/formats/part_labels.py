"""Labels of body parts as CSV text: made elsewhere, or for elsewhere."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from tracking.atomic_output import replacing
from tracking.cells import CsvWriter, cell_of
from tracking.errors import EditError, FormatError
from tracking.failure import FEATURE_NAMES
from tracking.formats.lines import header_of, numbered_rows, place_of
from tracking.tracks import PART_NAMES, PartLabel, check_part_label
from tracking.tracks.part_labels import Box
from tracking.translation import joined, msg

_NEEDED = ("frame", "track", "part", "on")
_BOX = ("left", "top", "width", "height")
_ALSO = (*_BOX, "source", "author", "reason")
_SAID: Mapping[str, bool | None] = {
    **dict.fromkeys(("on", "1", "true", "yes"), True),
    **dict.fromkeys(("off", "0", "false", "no"), False),
    **dict.fromkeys(("unsure", "", "?"), None),
}
_NO_BOX: Box = (0.0, 0.0, 1.0, 1.0)
"""Stands where a line gives none."""
_WORDS = {True: "on", False: "off", None: "unsure"}


@dataclass(frozen=True, slots=True)
class GivenLabel:
    """A label as a line of text gives it.

    Attributes:
        line: from 1. place: the file and line, as messages name them.
        label: its box counts only where `has_box`.
    """

    line: int
    place: str
    label: PartLabel
    has_box: bool


def read_part_labels(path: Path, author: str = "") -> list[GivenLabel]:
    """The labels of a CSV file: `frame, track, part, on` and, where known, what else there is.

    Frames are counted from 0. The part is a name or its number; `on` is on, off or unsure (1, 0
    and nothing do too). `left, top, width, height` say where the rectangle was, where it is not
    the tracker's own; `source` who drew it; `author` and `reason` as in `PartLabel`.

    Args:
        author: of labels whose line does not name one.

    Raises FormatError where the file is no such table; names the line.
    """
    if {"label", "source", FEATURE_NAMES[0]} <= set(header_of(path)):
        raise FormatError(
            "{path} holds samples, which are labels no more: train from it (trackwright "
            "train), or export labels (--format labels) to import into a session",
            path=path,
        )
    given = [_given(path, line, row, author) for line, row in numbered_rows(path, _NEEDED, _ALSO)]
    seen: dict[tuple[int, int, int], int] = {}
    for one in given:
        earlier = seen.setdefault(one.label.key, one.line)
        if earlier != one.line:
            raise FormatError(
                "{place}: line {earlier} speaks of the same part; remove one of them",
                place=one.place,
                earlier=earlier,
            )
    return given


def write_part_labels(path: Path, labels: Iterable[PartLabel]) -> None:
    """Write labels with everything they say, so that reading gives the same ones.

    Raises OutputError where the file cannot be written.
    """
    with replacing(path) as stream:
        rows = CsvWriter(stream)
        rows.writerow((*_NEEDED, *_ALSO))
        for label in labels:
            box = (repr(float(value)) for value in label.box)
            place = (label.frame, label.track, PART_NAMES[label.part], _WORDS[label.on_part])
            words = map(cell_of, (label.source, label.author, label.reason))
            rows.writerow((*place, *box, *words))


def _given(path: Path, line: int, row: Mapping[str, str], author: str) -> GivenLabel:
    place = place_of(path, line)
    values = {name: value.strip() for name, value in row.items()}
    try:
        box = _box_of(values)
        label = PartLabel(
            frame=_whole(values, "frame"),
            track=_whole(values, "track"),
            part=_part(values["part"]),
            box=box or _NO_BOX,
            on_part=_said(values["on"]),
            source=values.get("source") or ("person" if box else "tracker"),
            author=row.get("author") or author,
            reason=row.get("reason", ""),
        )
        check_part_label(label)
    except (ValueError, EditError) as error:
        raise FormatError("{place}: {error}", place=place, error=error) from error
    return GivenLabel(line, place, label, box is not None)


def _whole(values: Mapping[str, str], name: str) -> int:
    try:
        return int(values[name])
    except ValueError:
        raise ValueError(
            msg("the {name} {values!r} is no whole number", name=name, values=values[name][:40])
        ) from None


def _part(text: str) -> int:
    names = {name: at for at, name in enumerate(PART_NAMES)} | {"hip_leg": 2, "hipleg": 2}
    numbers = {str(at): at for at in range(len(PART_NAMES))}
    part = {**names, **numbers}.get(text.lower())
    if part is None:
        raise ValueError(
            msg(
                "the part {text!r} is none; {part_names} are",
                text=text[:40],
                part_names=joined(", ", PART_NAMES),
            )
        )
    return part


def _said(text: str) -> bool | None:
    if text.lower() not in _SAID:
        raise ValueError(msg("{text!r} in column on; write on, off or unsure", text=text[:40]))
    return _SAID[text.lower()]


def _box_of(values: Mapping[str, str]) -> Box | None:
    texts = [values.get(name, "") for name in _BOX]
    if not any(texts):
        return None
    try:
        left, top, width, height = map(float, texts)
    except ValueError:
        raise ValueError(
            msg("the box {texts!r} is not four numbers", texts=",".join(texts)[:60])
        ) from None
    if not all(map(math.isfinite, (left, top, width, height))):
        raise ValueError(
            msg("the box {texts!r} is not four finite numbers", texts=",".join(texts)[:60])
        )
    return left, top, width, height
