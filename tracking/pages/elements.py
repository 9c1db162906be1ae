"""HTML and SVG as trees: whatever text is put in comes out as text, never as markup."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TypeAlias
from xml.etree.ElementTree import Element, tostring

__all__ = ["Content", "Element", "element", "html_text", "name", "svg_text"]

Content: TypeAlias = "str | float | Element | Iterable[Content] | None"
"""What stands in an element: text, numbers, elements, or several of them; None is nothing."""

_UNWRITABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]")
"""What no page can hold: control characters, and the halves that stand for undecodable bytes."""


def element(tag: str, *content: Content, **attributes: str | float | None) -> Element:
    """An element.

    Args:
        tag: its name.
        content: what stands in it, in order.
        attributes: `class_` is class, `stroke_width` is stroke-width; None leaves one out.
    """
    made = Element(tag)
    for key, value in attributes.items():
        if value is not None:
            made.set(key.rstrip("_").replace("_", "-"), _written(value))
    _fill(made, content)
    return made


def name(text: str) -> Element:
    """A name somebody else chose; its writing direction does not reach beyond it."""
    return element("bdi", text)


def html_text(root: Element) -> str:
    """The page of a tree."""
    return "<!doctype html>\n" + tostring(root, encoding="unicode", method="html") + "\n"


def svg_text(root: Element) -> str:
    """A picture that stands alone."""
    root.set("xmlns", "http://www.w3.org/2000/svg")
    return tostring(root, encoding="unicode", method="xml") + "\n"


def _fill(parent: Element, content: Iterable[Content]) -> None:
    for piece in content:
        if piece is None:
            continue
        if isinstance(piece, Element):
            parent.append(piece)
        elif isinstance(piece, str | int | float):
            _add_text(parent, _written(piece))
        else:
            _fill(parent, piece)


def _add_text(parent: Element, text: str) -> None:
    if len(parent):
        parent[-1].tail = (parent[-1].tail or "") + text
    else:
        parent.text = (parent.text or "") + text


def _written(value: str | float) -> str:
    """Text as it may stand in a page; numbers to a hundredth, which no eye sees less than."""
    if isinstance(value, str):
        return _UNWRITABLE.sub("\N{REPLACEMENT CHARACTER}", value)
    return f"{value:.2f}".rstrip("0").rstrip(".") if isinstance(value, float) else str(value)
