"""Classes in VIAME's CSV: their cells are told from attributes, which begin with a bracket."""

from __future__ import annotations

import re

from tracking.cells import cell_of, text_of_cell

_LIKE_ATTRIBUTE = re.compile(r"'*\(")
_GUARDED = re.compile(r"'+\(")


def cell_of_class(name: str) -> str:
    """A class as a cell: neither a formula nor like an attribute, both by an apostrophe before."""
    return f"'{cell_of(name)}" if _LIKE_ATTRIBUTE.match(name) else str(cell_of(name))


def class_of_cell(cell: str) -> str:
    """What `cell_of_class` was given, of a cell as it was read."""
    return text_of_cell(cell[1:] if _GUARDED.match(cell) else cell)
