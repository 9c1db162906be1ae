"""Counts as a table: one row for each step and line or region, as text for people and as CSV."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

from tracking.atomic_output import replacing
from tracking.cells import CsvWriter, cell_of
from tracking.counting.counts import Counts, LineCount
from tracking.counting.occupancy import Occupancy

HEADINGS = (
    *("start_s", "end_s", "kind", "name", "forward", "backward"),
    *("people", "density_per_m2", "mean_speed_m_s"),
)
"""Columns of the CSV. A step ends before its end; what does not apply or is unknown is empty."""

_NAME = HEADINGS.index("name")
"""The one column that holds a person's words."""
Row = tuple[str, ...]


def rows_of(counts: Counts) -> Iterator[Row]:
    """The rows, by step; in each the lines and then the regions, as they were asked for."""
    for step in range(len(counts.steps)):
        start = step * counts.steps.step_s
        times = number_as_text(start), number_as_text(start + counts.steps.step_s)
        for line in counts.lines:
            yield (*times, *_of_line(line, step))
        for region in counts.regions:
            yield (*times, *_of_region(region, step))


def write_counts(path: Path, counts: Counts) -> None:
    """Write the rows under `HEADINGS` as CSV, whole or not at all. Raises OutputError."""
    with replacing(path) as stream:
        writer = CsvWriter(stream)
        writer.writerow(HEADINGS)
        for row in rows_of(counts):
            writer.writerow(cell_of(c) if at == _NAME else c for at, c in enumerate(row))


def number_as_text(number: float) -> str:
    """To the millionth, without zeros that say nothing; "" for NaN."""
    if math.isnan(number):
        return ""
    return f"{number:.6f}".rstrip("0").rstrip(".")


def _of_line(line: LineCount, step: int) -> Row:
    forward, backward = str(line.forward[step]), str(line.backward[step])
    return ("line", line.line.name, forward, backward, "", "", "")


def _of_region(region: Occupancy, step: int) -> Row:
    density = number_as_text(float(region.density[step]))
    speed = number_as_text(float(region.mean_speed[step]))
    return ("region", region.region.name, "", "", str(region.people[step]), density, speed)
