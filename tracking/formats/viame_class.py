"""Classes and attributes in VIAME's CSV: attributes are the cells that begin with a bracket."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tracking.cells import cell_of, text_of_cell
from tracking.formats.label_text import (
    attributes_of,
    escaped,
    key_beside,
    key_of,
    kind_of,
    label_of,
    line,
    unescaped,
)
from tracking.tracks import TrackLabel

OF_TRACK = "trk-atr"
_NAME = "name"
_ATTRIBUTE = re.compile(rf"\((atr|{OF_TRACK})\) +(\S+)\s+(.+)", re.DOTALL)
_MOST_BYTES = 48 << 10
"""Of a track's attributes, which stand in each of its lines: a longer line is not read back."""
_LIKE_ATTRIBUTE = re.compile(r"'*\(")
_GUARDED = re.compile(r"'+\(")


def cell_of_class(name: str) -> str:
    """A class as a cell: neither a formula nor like an attribute, both by an apostrophe before."""
    return f"'{cell_of(name)}" if _LIKE_ATTRIBUTE.match(name) else str(cell_of(name))


def class_of_cell(cell: str) -> str:
    """What `cell_of_class` was given, of a cell as it was read."""
    return text_of_cell(cell[1:] if _GUARDED.match(cell) else cell)


def cells_of_label(label: TrackLabel) -> list[str]:
    """What a label says beside the class: a cell each, as far as there is room in a line.

    Each begins with a bracket, which is at the start of no formula.
    """
    said = {_NAME: line(label.name)} if line(label.name) else {}
    said |= {key_beside({_NAME}, key): text for key, text in attributes_of(label).items()}
    cells, room = [], _MOST_BYTES
    for key, text in said.items():
        cell = str(cell_of(f"({OF_TRACK}) {escaped(key, ' ')} {text}"))
        room -= len(cell.encode("utf-8", "replace")) + cell.count('"') + len(',""')
        if room >= 0:
            cells.append(cell)
    return cells


def attribute_in(cell: str) -> tuple[str, str, str] | None:
    """Of what an attribute is (atr or `OF_TRACK`), its key and its text; None where it is none."""
    found = _ATTRIBUTE.match(text_of_cell(cell))
    return None if found is None else (found[1], found[2], found[3])


def label_in(kind: str, said: Mapping[str, str]) -> TrackLabel:
    """The label of a track, of its class and its attributes as they are in cells."""
    others = {key_of({_NAME}, key): text for key, text in said.items() if key != _NAME}
    about = {unescaped(key): text for key, text in others.items()}
    return label_of(said.get(_NAME, ""), kind, about)


def label_as_read(label: TrackLabel) -> TrackLabel:
    """What comes back of a label."""
    found = filter(None, map(attribute_in, cells_of_label(label)))
    return label_in(kind_of(label), {key: text for _, key, text in found})
