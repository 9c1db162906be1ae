"""Trees that become pages."""

from __future__ import annotations

from html.parser import HTMLParser

from hypothesis import given
from hypothesis import strategies as st

from tracking.pages import element, name, page
from tracking.pages.elements import html_text


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.titles: list[str | None] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.titles += [value for key, value in attrs if key == "title"]


@given(st.text())
def test_text_and_attributes_never_become_markup(text: str) -> None:
    read = _Reader()
    read.feed(html_text(element("p", name(text), title=text)).encode("utf-8").decode("utf-8"))
    assert read.tags == ["p", "bdi"]
    assert read.titles == [text] or not text.isprintable()


def test_pieces_stand_in_their_order() -> None:
    made = element("p", "a", element("b", 1), None, [" c ", 2.5], class_="x", stroke_width=0.5)
    assert html_text(made).endswith('<p class="x" stroke-width="0.5">a<b>1</b> c 2.5</p>\n')


def test_a_page_lets_nothing_run_and_fetches_nothing() -> None:
    made = page("<script>alert(1)</script>", element("p", "x"), kind="a test")
    assert "<script" not in made
    assert "default-src 'none'" in made
    assert "http" not in made.replace('http-equiv="', "")
