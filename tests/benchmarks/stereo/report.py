"""docs/results/stereo.md, written from the figures that were measured."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from tests.benchmarks.pages import Figures, table
from tests.benchmarks.stereo import choice, goals, losses, papers, peers, words
from tests.benchmarks.stereo.real import LONGEST


def writers() -> Mapping[str, Callable[[Any], str]]:
    """A writer for each section, in the page's order."""
    return {
        "trackers": choice.written,
        "goals": goals.written,
        "tables": papers.written,
        "peers": peers.written,
        "real": _real,
        "lost": losses.written,
        "robustness": _robustness,
    }


def _real(figures: Figures) -> str:
    if not figures:
        return words.NO_REAL.strip()
    rows = [
        [
            f"frames {row['first']} to {row['last']}, to the {_side(row)}",
            str(row["track"] or "nobody"),
            f"{row['began']} to {row['ended']}" if row["track"] else "",
            f"{row['covered']} of {row['frames']}",
        ]
        for row in figures["passages"]
    ]
    head = ("passage, by eye", "track", "from frame to frame", "frames covered")
    return "\n\n".join((words.REAL.strip(), table(head, rows), _said_of_real(figures)))


def _side(row: Figures) -> str:
    return "right" if row["to_the_right"] else "left"


def _said_of_real(figures: Figures) -> str:
    """The goals in words, with what fails."""
    rows, extra = figures["passages"], figures["extra"]
    tracks = {row["track"] for row in rows} - {0}
    said = [f"Goal, four passages by four people: {len(tracks)} tracks of their own"]
    said[0] += " (met)." if len(tracks) == len(rows) else " (missed)."
    longer = f"Goal, no other track longer than {LONGEST} frames: "
    ids = ", ".join(f"{row['track']} (frames {row['began']} to {row['ended']})" for row in extra)
    said.append(longer + (f"{len(extra)}: {ids} (missed)." if extra else "none (met)."))
    if figures["short"]:
        said.append(f"Shorter ones: {figures['short']}.")
    return " ".join((*said, _uncovered(rows)))


def _uncovered(rows: Sequence[Figures]) -> str:
    """Which frames of the passages have no track."""
    frames = sum(row["frames"] for row in rows)
    before, after = (sum(row[name] for row in rows) for name in ("before", "after"))
    missing = frames - sum(row["covered"] for row in rows)
    if not missing:
        return "All frames of the passages are covered."
    return (
        f"What fails: {missing} of the {frames} frames of the passages have no track, {before} of "
        f"them before it begins, {after} after it has ended."
    )


def _robustness(rows: Sequence[Figures]) -> str:
    cells = [
        [
            row["what"],
            row["clip"],
            f"{row['people_kept']} of {row['people_detected']}",
            *(f"{row[name]:.3f}" for name in ("MOTA", "IDF1")),
            str(row["id_switches"]),
            f"{row['error_m']:.3f}",
            f"{row['alone_s']:.1f}",
        ]
        for row in rows
    ]
    head = (
        "what happens", "scene", "kept", "MOTA", "IDF1", "switches", "error, m", "longest alone, s",
    )  # fmt: skip
    return "\n\n".join((words.ROBUSTNESS.strip(), table(head, cells)))
