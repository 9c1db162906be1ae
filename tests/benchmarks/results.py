"""A subject's page of results: its sections measured one by one, kept, and written."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tests.benchmarks.options import Asked, asked, one_core
from tests.benchmarks.page_texts import told

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tests.benchmarks.pages import Page


@dataclass(frozen=True, slots=True)
class Contents:
    """What a page is made of, by section.

    Attributes:
        introduction: above all sections. writers: figures to Markdown, in the page's order.
        measures: what gives a section's figures.
        photographs: a picture (rows, columns, 3) BGR of what was measured, kept beside the page;
            None: there is nothing to show.
        state: names what is measured with; sections of another state are told on the page.
        diagrams: a name and what draws the kept figures as SVG, anew with each page.
    """

    introduction: str
    writers: Mapping[str, Callable[[Any], str]]
    measures: Mapping[str, Callable[[], Any]]
    photographs: Mapping[str, Callable[[Any], NDArray[np.uint8] | None]] = field(
        default_factory=dict
    )
    state: Callable[[], str] = str
    diagrams: Mapping[str, tuple[str, Callable[[Any], str]]] = field(default_factory=dict)


def run(
    subject: str, about: str, sections: Sequence[str], contents_of: Callable[[Asked], Contents]
) -> None:
    """Read the command line, measure, and print or write: `python -m tests.benchmarks.SUBJECT`.

    Args:
        sections: in the order in which they are measured.
        contents_of: imports what measures only once everything is bound to one core.
    """
    one_core()
    wish = asked(subject, about, sections)
    from tests.benchmarks.pages import Page

    page, contents = Page(subject), contents_of(wish)
    if wish.rewrite:
        _write(page, contents)
        return
    for name in wish.only:
        with told(f"{subject}, {name}"):
            found = contents.measures[name]()
        if wish.report:
            _keep(page, contents, name, found)
        else:
            print(contents.writers[name](found), flush=True)


def _keep(page: Page, contents: Contents, name: str, found: Any) -> None:
    page.keep(name, found, contents.state())
    shown = contents.photographs[name](found) if name in contents.photographs else None
    if shown is not None:
        page.photograph(name, shown)
    _write(page, contents)


def _write(page: Page, contents: Contents) -> None:
    figures = page.figures()
    for name, (title, draw) in contents.diagrams.items():
        if name in figures:
            page.picture(title, draw(figures[name]))
    page.write(contents.introduction, contents.writers)
