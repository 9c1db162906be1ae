"""Figures as a table, and what changed since they were kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from tests.benchmarks.footage.measures import Figures

Rows = Mapping[str, Figures]

COLUMNS: Mapping[str, tuple[str, int]] = {
    "kept": ("", 8),
    "MOTA": ("boxes.MOTA", 2),
    "IDF1": ("boxes.IDF1", 2),
    "HOTA": ("boxes.HOTA", 2),
    "switches": ("boxes.id_switches", 0),
    "floor MOTA": ("floor.MOTA", 2),
    "floor IDF1": ("floor.IDF1", 2),
    "floor m": ("floor.error_m", 2),
    "misses": ("floor.misses", 2),
    "false": ("floor.false_positives", 2),
    "tracks": ("tracks", 0),
    "nobody": ("nobody", 0),
    "passages": ("", 0),
    "ms": ("ms", 0),
}
"""What each column is called, where its figure is, and with how many digits it is told."""
_SHARES = ("MOTA", "IDF1", "HOTA")
_WIDTH = 13
_TOLD = 0.02
"""A change of a score by less is not listed."""


def value(row: Figures, dotted: str) -> float | None:
    """A figure by its place; None where it is not there."""
    found: Any = row
    for name in dotted.split("."):
        found = found.get(name) if isinstance(found, Mapping) else None
    return found


def cell(row: Figures, column: str) -> str:
    """A figure for people; nothing where there is none."""
    if column == "kept":
        if "walkers" in row:
            return f"{row['walkers']['found']}/{row['walkers']['of']}"
        best = row.get("floor") or row.get("boxes")
        return f"{best['people_kept']}/{best['people_detected']}/{row['people']}" if best else ""
    if column == "passages":
        said = row.get("passages")
        return f"{said['hit']}/{said['found']}/{said['happened']}" if said else ""
    dotted, digits = COLUMNS[column]
    found = value(row, dotted)
    if found is None and dotted.startswith("floor.") and row.get("floor") is None:
        found = value(row, dotted.replace("floor.", "boxes.")) if column in _EITHER else None
    return "" if found is None else f"{found:.{digits}f}"


def cells(row: Figures) -> list[str]:
    """A row's figures for people, by `COLUMNS`; - where there is none."""
    return [cell(row, column) or "-" for column in COLUMNS]


_EITHER = ("misses", "false")
"""Told by boxes where nothing is known of the floor."""


def table(name: str, rows: Rows, before: Rows) -> str:
    """A recording's table; where a figure changed, the older one stands in brackets."""
    lines = [name, "  " + "".join(f"{c:>{_WIDTH}}" for c in ("", *COLUMNS)).rstrip()]
    for tracker, row in rows.items():
        old = before.get(tracker)
        cells = [_beside(cell(row, c), cell(old, c) if old else "") for c in COLUMNS]
        lines.append("  " + f"{tracker:<{_WIDTH + 4}}" + "".join(f"{c:>{_WIDTH}}" for c in cells))
    return "\n".join(line.rstrip() for line in lines) + "\n"


def _beside(now: str, before: str) -> str:
    return now if before in ("", now) else f"{now} ({before})"


def changes(found: Mapping[str, Rows], before: Mapping[str, Rows]) -> str:
    """The scores that changed by much, the greatest loss first."""
    listed = sorted(_changed(found, before))
    if not listed:
        return "Nothing changed by 0.02 or more since the run that was kept."
    lines = ["Changed by 0.02 or more since the run that was kept:"]
    lines += [f"  {by:+.3f}  {what}" for by, what in listed]
    return "\n".join(lines)


def _changed(found: Mapping[str, Rows], before: Mapping[str, Rows]) -> Iterator[tuple[float, str]]:
    for name, rows in found.items():
        for tracker, row in rows.items():
            old = before.get(name, {}).get(tracker, {})
            for column, (dotted, _) in COLUMNS.items():
                now, was = (value(which, dotted) if dotted else None for which in (row, old))
                if not dotted.endswith(_SHARES) or now is None or was is None:
                    continue
                if abs(now - was) >= _TOLD:
                    yield now - was, f"{name}, {tracker}: {column} {was:.2f} to {now:.2f}"
