"""Pages of results: figures kept section by section as JSON, and the page made of them."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

Figures = Mapping[str, Any]
DOCS = Path(__file__).parents[2] / "docs"
_QUALITY = 82
_STATES = "states"
"""In the figures: what each section was measured with."""


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table; the first column is text, the others are numbers."""
    lines = [head, ["---", *["---:"] * (len(head) - 1)], *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def met(ours: float, goal: float, *, at_most: bool = False, digits: int = 1) -> str:
    """Whether a goal is met, or by how much it is missed."""
    lack = ours - goal if at_most else goal - ours
    if lack <= 0:
        return "met"
    if lack != lack:
        return "not measured"
    least = 10.0**-digits
    return f"missed by {lack:.{digits}f}" if lack >= least / 2 else f"missed by less than {least:g}"


def save_jpeg(path: Path, picture: NDArray[np.uint8]) -> None:
    """Write a picture (rows, columns, 3) BGR."""
    _, data = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data.tobytes())


class Page:
    """One subject's page in a folder, and its figures beside it."""

    def __init__(self, subject: str, folder: Path = DOCS / "results") -> None:
        """The page of a subject, e.g. "flow"."""
        self._folder = folder
        self._subject = subject
        self._page, self._kept = folder / f"{subject}.md", folder / f"{subject}.json"

    def figures(self) -> dict[str, Any]:
        """What has been measured so far."""
        if not self._kept.is_file():
            return {}
        return dict(json.loads(self._kept.read_text(encoding="utf-8")))

    def keep(self, name: str, found: Any, state: str = "") -> dict[str, Any]:
        """Put a section's figures in the place of its older ones; all figures.

        Args:
            name, found: the section and what was measured.
            state: names what it was measured with; "": that is not told.
        """
        figures = {**self.figures(), name: found}
        if state:
            others = {**figures.get(_STATES, {})}
            others.pop(name, None)
            figures[_STATES] = {**others, name: state}  # the newest comes last
        self._folder.mkdir(parents=True, exist_ok=True)
        self._kept.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
        return figures

    def picture(self, name: str, drawn: str) -> None:
        """Put an SVG picture beside the page, as `<subject>-<name>.svg`."""
        (self._folder / f"{self._subject}-{name}.svg").write_text(drawn, encoding="utf-8")

    def photograph(self, name: str, picture: NDArray[np.uint8]) -> None:
        """Put a picture (rows, columns, 3) BGR beside the page, as `<subject>-<name>.jpg`."""
        save_jpeg(self._folder / f"{self._subject}-{name}.jpg", picture)

    def write(self, introduction: str, writers: Mapping[str, Callable[[Any], str]]) -> None:
        """Write the page; sections that were not measured are left out."""
        figures = self.figures()
        parts = [introduction, *_older(figures, writers)]
        parts += [write(figures[name]) for name, write in writers.items() if name in figures]
        text = "\n\n".join(part.strip() for part in parts) + "\n"
        self._page.write_text(text, encoding="utf-8")


def _older(figures: Figures, sections: Iterable[str]) -> Iterator[str]:
    """Which sections are of another state than the one measured last."""
    states = figures.get(_STATES, {})
    if not states:
        return
    newest = [*states.values()][-1]
    others = [name for name in sections if name in figures and states.get(name) != newest]
    if others:
        yield f"Measured with other sources than the rest: {', '.join(others)}."
