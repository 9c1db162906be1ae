"""Pages made of templates."""

from __future__ import annotations

from html.parser import HTMLParser

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.page_reader import Portuguese, Reader
from tracking.pages import Panel, render, svg
from tracking.pages.templates import is_page
from tracking.translation import use_catalogue

_TAGS = ["html", "head", *["meta"] * 5, "title", "style", "body", "main", "h1"]


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.contents: list[str | None] = []
        self.texts: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.contents += [value for key, value in attrs if key == "content"]

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


@given(st.text(min_size=1))
def test_text_and_attributes_never_become_markup(text: str) -> None:
    read = _Reader()
    made = render("pages/page.html", title=text, kind=text)
    read.feed(made.encode("utf-8").decode("utf-8"))
    assert read.tags == _TAGS
    assert read.contents[0] == text or not text.isprintable()
    assert text in read.texts or not text.isprintable()


@given(st.text(min_size=1))
def test_a_page_is_told_by_its_kind(kind: str) -> None:
    page = render("pages/page.html", title="x", kind=kind)
    assert is_page(page, kind) or not kind.isprintable()
    assert not is_page(page, f"another {kind}")


def test_what_no_page_can_hold_is_replaced() -> None:
    panel = Panel("a\x00b\ud800", {}, np.arange(2.0), ("x", "y"), (0.0, 1.0), (0.0, 1.0))
    made = svg([panel])
    assert "a\N{REPLACEMENT CHARACTER}b\N{REPLACEMENT CHARACTER}" in made
    made.encode("utf-8")


def test_a_page_lets_nothing_run_and_fetches_nothing() -> None:
    made = render("pages/page.html", title="<script>alert(1)</script>", kind="a test")
    assert "<script" not in made
    assert "default-src 'none'" in made
    assert "http" not in made.replace('http-equiv="', "")


def test_a_page_tells_its_language() -> None:
    page = {"title": "x", "kind": "y"}
    assert Reader(render("pages/page.html", **page)).language == "en"
    use_catalogue(Portuguese())
    try:
        assert Reader(render("pages/page.html", **page)).language == "pt-BR"
    finally:
        use_catalogue(None)
