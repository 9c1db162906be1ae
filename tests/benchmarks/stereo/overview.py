"""Figures of the stereo trackers in docs/results.md, from those of docs/results/stereo.md.

`python -m tests.benchmarks.stereo.overview` writes them between two comments of docs/results.md.
"""

from __future__ import annotations

from pathlib import Path

from tests.benchmarks.options import parser_of
from tests.benchmarks.pages import Figures, Page, table
from tests.benchmarks.stereo import choice, goals
from tests.benchmarks.stereo.shares import said_interval
from tracking.synthesis import SCENES

OVERVIEW = Path(__file__).parents[3] / "docs" / "results.md"
BEGIN = "<!-- written by python -m tests.benchmarks.stereo.overview -->"
END = "<!-- until here -->"

_HEAD = ("people kept", "tracking accuracy", "MOTA", "IDF1", "floor error")
_OFTEN = "people kept in clips measured often"


def passage(figures: Figures) -> str:
    """The text between the comments: of the fresh clips, if any were measured."""
    fresh, often = figures["goals"]["fresh"], figures["goals"]["often"]
    if not fresh:
        return table(
            ("scene", *_HEAD), [[_titled(scene), *_cells(often[scene])] for scene in often]
        )
    rows = [[_titled(scene), *_cells(fresh[scene]), _kept(often[scene])] for scene in fresh]
    parts = [goals.summary(fresh, often), table(("scene", *_HEAD, _OFTEN), rows)]
    if "trackers" in figures:
        parts.append(choice.advice(figures["trackers"]["all"]))
    return "\n\n".join(parts)


def _titled(scene: str) -> str:
    return SCENES[scene].title.lower()


def _cells(row: Figures) -> list[str]:
    between = said_interval(row["people_kept"], row["people_detected"])
    return [
        _kept(row),
        f"{row['tracking_accuracy']:.3f} ({between})",
        *(f"{row[name]:.3f}" for name in ("MOTA", "IDF1")),
        f"{row['error_m']:.3f} m",
    ]


def _kept(row: Figures) -> str:
    return f"{row['people_kept']} of {row['people_detected']}"


def with_passage(text: str, figures: Figures) -> str:
    """The overview's text with the passage in the place of its older one."""
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    return f"{before}{BEGIN}\n\n{passage(figures)}\n\n{END}{after}"


def main() -> None:
    """Write the passage into the overview; the only option is --help."""
    parser_of("stereo.overview", __doc__).parse_args()
    text = with_passage(OVERVIEW.read_text(encoding="utf-8"), Page("stereo").figures())
    OVERVIEW.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
