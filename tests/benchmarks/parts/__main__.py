"""Body parts: `python -m tests.benchmarks.parts [--report] [--only SECTION ...] [--clips DIR]`.

Without --report: the rates on a few scenes for choosing settings, as a table. With it: all sections
on the scenes reported, kept one by one in docs/results/parts.json, and the page made of them.
--rewrite only makes the page and its diagrams anew. Real footage is looked for where --data or
TRACKWRIGHT_DATA says; --pictures draws parts into a few of its frames, into a folder of yours.
"""

from __future__ import annotations

import argparse
import json
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from tests.benchmarks.options import parser_of

_FOLDER = Path(__file__).parents[3] / "docs" / "results"
_PAGE = "docs/results/parts"
SECTIONS = ("rates", "crouching", "equalisation", "detector", "real", "speed")


def main() -> None:
    """Measure and write."""
    for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[variable] = "1"
    asked = _asked()
    import cv2

    cv2.setNumThreads(1)
    if asked.rewrite:
        _write(json.loads((_FOLDER / "parts.json").read_text(encoding="utf-8")))
    elif asked.pictures is not None:
        _real_pictures(asked.data, asked.pictures)
    elif asked.report:
        _report(asked.only or SECTIONS, asked.clips, asked.data)
    else:
        _tune(asked.clips)


def _asked() -> argparse.Namespace:
    parser = parser_of("parts", __doc__)
    parser.add_argument("--report", action="store_true", help=f"measure and write {_PAGE}.md")
    parser.add_argument("--rewrite", action="store_true", help=f"write it from {_PAGE}.json")
    parser.add_argument("--only", nargs="+", choices=SECTIONS, help="these sections anew")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    parser.add_argument("--data", type=Path, default=_data(), help="folder of real recordings")
    parser.add_argument("--pictures", type=Path, help="where pictures of real footage are put")
    return parser.parse_args()


def _data() -> Path | None:
    named = os.environ.get("TRACKWRIGHT_DATA")
    return Path(named) if named else None


def _report(sections: tuple[str, ...] | list[str], clips: Path | None, data: Path | None) -> None:
    from tests.benchmarks.parts import clips as known
    from tests.benchmarks.parts import part_rates

    detector_clips = (*known.REPORTED, *known.REPORTED_CROUCHING, *known.REPORTED_ELSEWHERE)
    measures: dict[str, Callable[[], Iterable[Any]]] = {
        "rates": lambda: part_rates.rates_one_by_one(known.REPORTED, clips),
        "crouching": lambda: [part_rates.crouching(known.REPORTED_CROUCHING, clips)],
        "equalisation": lambda: [part_rates.equalisation()],
        "detector": lambda: [part_rates.detector(detector_clips, clips)],
        "real": lambda: [part_rates.real(data)],
        "speed": lambda: [part_rates.speed()],
    }
    path = _FOLDER / "parts.json"
    anew = set(sections) == set(SECTIONS)  # then nothing on the page is older than the rest
    figures = {} if anew or not path.is_file() else json.loads(path.read_text(encoding="utf-8"))
    for name in sections:
        for found in measures[name]():
            figures = {**figures, name: found} if found else _without(figures, name)
            path.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
            _write(figures)
        if name == "rates":
            _picture(clips)


def _picture(clips: Path | None) -> None:
    from tests.benchmarks.pages import save_jpeg
    from tests.benchmarks.parts import clips as known
    from tests.benchmarks.parts import pictures
    from tests.benchmarks.parts.tracker_runs import ADJUSTED, PLAIN

    shown = pictures.side_by_side(known.REPORTED[0], (ADJUSTED, PLAIN), (150, 190), clips)
    save_jpeg(_FOLDER / "parts-walkway.jpg", shown)


def _without(figures: dict[str, Any], name: str) -> dict[str, Any]:
    """What was not measured is not on the page: nothing there is older than the rest."""
    return {section: found for section, found in figures.items() if section != name}


def _real_pictures(data: Path | None, shown: Path) -> None:
    from tests.benchmarks.parts import pictures

    for path in pictures.of_real_footage(data, shown):
        print(path)


def _write(figures: dict[str, Any]) -> None:
    from tests.benchmarks.parts import report

    if "rates" in figures:
        (_FOLDER / "parts-rates.svg").write_text(
            report.rates_picture(figures["rates"]), encoding="utf-8"
        )
    if "detector" in figures:
        (_FOLDER / "parts-detector-roc.svg").write_text(
            report.roc_picture(figures["detector"]), encoding="utf-8"
        )
    (_FOLDER / "parts.md").write_text(report.results(figures), encoding="utf-8")


def _tune(clips: Path | None) -> None:
    from tests.benchmarks.parts import clips as known
    from tests.benchmarks.parts import part_rates, report

    print(report.rates_tables(part_rates.rates(known.TUNED, clips)))
    print(report.crouching_table(part_rates.crouching(known.TUNED_CROUCHING, clips)))


if __name__ == "__main__":
    main()
