"""The mechanisms of trackers that can be left out: by settings, or by what stands in their place.

They stand in `mechanisms.toml`, a table a tracker; `smoothing` and `linking` are those of finishing
runs that several trackers share.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.benchmarks.footage import stand_ins

Values = tuple[tuple[str, Any], ...]


@dataclass(frozen=True, slots=True)
class Mechanism:
    """A part of a tracker that can be left out.

    Attributes:
        name: in tables.
        what: it does, in a few words.
        settings: with which the tracker does without it.
        replaced: module-level values of the library, and what stands in their place; see
            `Case.replaced`.
        finishing: it is a part of finishing runs: one run is finished with it and without.
        seeing: it is a part of finding people, before the tracker.
    """

    name: str
    what: str
    settings: Values = ()
    replaced: Values = ()
    finishing: bool = False
    seeing: bool = False


def _mechanism(name: str, row: Mapping[str, Any]) -> Mechanism:
    """A row of the file."""
    replaced = tuple(
        (f"tracking.{where}", _in_its_place(value))
        for where, value in row.get("replaced", {}).items()
    )
    settings = tuple(row.get("settings", {}).items())
    return Mechanism(name, **{**row, "settings": settings, "replaced": replaced})


def _in_its_place(value: Any) -> Any:
    """A value; a text is the name of a function of `stand_ins`."""
    if isinstance(value, str):
        return f"{stand_ins.__name__}.{value}"
    return tuple(value) if isinstance(value, list) else value


def _tables() -> dict[str, tuple[Mechanism, ...]]:
    text = Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    return {
        table: tuple(_mechanism(name, row) for name, row in rows.items())
        for table, rows in tomllib.loads(text).items()
    }


_OF = _tables()
_LINKING = _OF["linking"] + _OF["smoothing"]

MECHANISMS: Mapping[str, tuple[Mechanism, ...]] = {
    "spheroid": _OF["spheroid"] + _LINKING,
    "flow": _OF["flow"] + _OF["smoothing"],
    "three-part": _OF["three-part"],
    "stereo-joint": _OF["stereo-joint"] + _LINKING,
}
