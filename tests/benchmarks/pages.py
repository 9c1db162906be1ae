"""Pages of results: sections measured one by one, kept as JSON, and written by a template.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results, and the page made of them.
--rewrite only makes the page and its diagrams anew.

A page is a template with a block a section, in the page's order; `introduction` comes first. A
block is given the figures of all sections by their names and what else the page declares.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from jinja2 import Environment, FileSystemLoader, StrictUndefined, Template
from numpy.typing import NDArray

from tests.benchmarks.command import one_core, parser_of, telling
from tests.benchmarks.intervals import interval_text
from tests.benchmarks.runner import sources
from tests.benchmarks.tables import met
from tracking.synthesis import SCENES

Figures = Mapping[str, Any]
Picture = NDArray[np.uint8]
DOCS = Path(__file__).parents[2] / "docs"
_HERE = Path(__file__).parent
_QUALITY = 82
_STATES = "states"
"""In the figures: what each section was measured with."""


def fixed(value: float | None, digits: int) -> str:
    """A number with so many digits; - for none."""
    return "-" if value is None else f"{value:.{digits}f}"


def titled(scene: str) -> str:
    """A scene's title within a sentence."""
    return SCENES[scene].title.lower()


def template(path: str) -> Template:
    """A template below this folder."""
    environment = Environment(
        loader=FileSystemLoader(_HERE),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=False,  # Markdown, made of our own figures
    )
    environment.filters |= {"fixed": fixed, "titled": titled}
    environment.globals |= {"met": met, "interval": interval_text}
    return environment.get_template(path)


def save_jpeg(path: Path, picture: Picture) -> None:
    """Write a picture (rows, columns, 3) BGR."""
    _, data = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data.tobytes())


@dataclass(frozen=True)
class Page:
    """A subject's page and how it is measured.

    Attributes:
        subject: names the page, its figures and pictures in docs/results, and its command.
        about: the command's help.
        measures: what gives a section's figures, in the order in which they are measured: of the
            clips that are reported, or else of those for choosing settings.
        words: what the template is given beside the figures.
        diagrams: by section a name and what draws its kept figures as SVG, anew with each page.
        folder: of the page.
    """

    subject: str
    about: str
    measures: Mapping[str, Callable[[bool], Any]]
    words: Mapping[str, Any] = field(default_factory=dict)
    diagrams: Mapping[str, tuple[str, Callable[[Any], str]]] = field(default_factory=dict)
    folder: Path = DOCS / "results"

    def figures(self) -> dict[str, Any]:
        """What has been measured so far."""
        kept = self.folder / f"{self.subject}.json"
        return dict(json.loads(kept.read_text(encoding="utf-8"))) if kept.is_file() else {}

    def keep(self, name: str, found: Any) -> None:
        """Put a section's figures, and what they were measured with, in the place of older ones."""
        figures = {**self.figures(), name: found}
        states = {**figures.get(_STATES, {})}
        states.pop(name, None)
        figures[_STATES] = {**states, name: sources()[:16]}  # the newest comes last
        self.folder.mkdir(parents=True, exist_ok=True)
        text = json.dumps(figures, indent=1) + "\n"
        (self.folder / f"{self.subject}.json").write_text(text, encoding="utf-8")

    def sections(self, figures: Figures) -> dict[str, str]:
        """Each measured section's text, in the page's order, the introduction first."""
        page = template(f"{self.subject}/page.md.j2")
        context = page.new_context({**self.words, **figures})
        texts = {
            name: "".join(block(context))
            for name, block in page.blocks.items()
            if name == "introduction" or name in figures
        }
        return {name: re.sub(r"\n{3,}", "\n\n", text).strip() for name, text in texts.items()}

    def text(self, figures: Figures) -> str:
        """The whole page; sections that were not measured are left out."""
        sections = self.sections(figures)
        introduction = sections.pop("introduction")
        parts = (introduction, *_older(figures.get(_STATES, {}), sections), *sections.values())
        return "\n\n".join(part for part in parts if part) + "\n"

    def write(self) -> None:
        """Write the page and its diagrams from what was measured."""
        figures = self.figures()
        for name, (title, draw) in self.diagrams.items():
            if name in figures:
                path = self.folder / f"{self.subject}-{title}.svg"
                path.write_text(draw(figures[name]), encoding="utf-8")
        path = self.folder / f"{self.subject}.md"
        path.write_text(self.text(figures), encoding="utf-8")

    def main(self) -> None:
        """Read the command line, measure, and print or write."""
        one_core()
        parser, page = parser_of(self.subject, self.about), f"docs/results/{self.subject}.md"
        told = (
            f"on the clips reported, and write {page}; else on those for choosing settings, printed"
        )
        parser.add_argument("--report", action="store_true", help=f"measure {told}")
        parser.add_argument("--rewrite", action="store_true", help="only write it anew")
        parser.add_argument("--only", nargs="+", choices=self.measures, help="these sections")
        asked = parser.parse_args()
        if asked.rewrite:
            self.write()
            return
        for name in asked.only or self.measures:
            with telling(f"{self.subject}, {name}"):
                found = self.measures[name](asked.report)
            if asked.report:
                self.keep(name, found)
                self.write()
            else:
                print(self.sections({name: json.loads(json.dumps(found))})[name], flush=True)


def _older(states: Mapping[str, str], sections: Iterable[str]) -> Iterator[str]:
    """Which sections are of another state than the one measured last."""
    newest = [*states.values()][-1:]
    others = [name for name in sections if newest and states.get(name) != newest[0]]
    if others:
        yield f"Measured with other sources than the rest: {', '.join(others)}."
