"""The comparison as a table and as JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from tests.benchmarks.tracker_peers.rows import Figures, PeerRow

_HEAD = (
    *("tracker", "colours", "identity switches", "IDF1", "HOTA", "MOTA"),
    *("tracking accuracy", "floor error", "ms a frame"),
)


def markdown(rows: Sequence[PeerRow]) -> str:
    """A table, ours first; a line at the end for each peer that is not installed."""
    lines = [_line(_HEAD), _line(["---"] * 2 + ["---:"] * (len(_HEAD) - 2))]
    lines += [_line(_cells(row, row.figures)) for row in rows if row.figures is not None]
    missing = dict.fromkeys(row.absent for row in rows if row.figures is None)
    return "\n".join([*lines, *(f"\nNot measured: {why}." for why in missing)]) + "\n"


def as_json(rows: Sequence[PeerRow]) -> list[dict[str, Any]]:
    """A dictionary for each row; `figures` is null where a peer is not installed."""
    return [asdict(row) for row in rows]


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _cells(row: PeerRow, figures: Figures) -> list[str]:
    name = f"**{row.tracker}**" if row.ours else row.tracker
    return [
        f"{name}, finished" if row.finished else name,
        "yes" if row.colour else "no",
        str(figures.id_switches),
        *(f"{share:.3f}" for share in (figures.idf1, figures.hota, figures.mota)),
        f"{figures.kept} of {figures.people}",
        f"{100.0 * figures.floor_error_m:.1f} cm",
        f"{figures.ms:.2f}",
    ]
