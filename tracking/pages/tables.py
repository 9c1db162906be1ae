"""Tables of a page."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tracking.pages.elements import Content, Element, element


def table(
    head: Sequence[Content],
    rows: Iterable[Sequence[Content]],
    *,
    words: int = 1,
    caption: str | None = None,
) -> Element:
    """A table that can be scrolled sideways where it is wider than the page.

    Args:
        head: of the columns.
        rows: a cell each column; a `td` or `th` is taken as it is.
        words: so many columns from the left hold words; the others are numbers.
        caption: what it says, over it.
    """
    made = element(
        "table",
        element("caption", caption) if caption else None,
        element("thead", _row("th", head, words)),
        element("tbody", [_row("td", row, words) for row in rows]),
    )
    return element("div", made, class_="scrolled")


def _row(tag: str, cells: Sequence[Content], words: int) -> Element:
    return element("tr", [_cell(tag, cell, index < words) for index, cell in enumerate(cells)])


def _cell(tag: str, content: Content, is_word: bool) -> Element:
    if isinstance(content, Element) and content.tag in ("td", "th"):
        return content
    return element(tag, content, class_="word" if is_word else None)
