"""Text in columns of letters, as in terminals: letters of Japanese are two columns wide."""

from __future__ import annotations

import textwrap
import unicodedata
from collections.abc import Iterator

_WIDE = "WF"
_UNSEEN = frozenset({"Mn", "Me", "Cf"})
_NOT_FIRST = frozenset(
    "、。，．・：；？！ー）」』】〕〉》ぁぃぅぇぉっゃゅょァィゥェォッャュョ,.:;?!)]}"
)
"""Signs that no line begins with: one more column is less bad."""
_NOT_LAST = frozenset("（「『【〔〈《([{")


def columns_of(text: str) -> int:
    """How many columns a text takes."""
    return len(text) if text.isascii() else sum(map(_columns, text))


def _columns(sign: str) -> int:
    if unicodedata.east_asian_width(sign) in _WIDE:
        return 2
    return 0 if unicodedata.category(sign) in _UNSEEN else 1


def to_left(text: str, columns: int) -> str:
    """The text, filled up at its end."""
    return text + " " * (columns - columns_of(text))


def to_right(text: str, columns: int) -> str:
    """The text, filled up at its beginning."""
    return " " * (columns - columns_of(text)) + text


def lines_of(text: str, columns: int, indent: str = "") -> list[str]:
    """The text in lines of at most so many columns; those after the first one are indented.

    Words stay whole; between wide letters a line may end, where Japanese rules allow it.
    """
    if columns_of(text) == len(text):
        return textwrap.wrap(text, columns, subsequent_indent=indent)
    lines = [""]
    for piece in _pieces(text):
        if lines[-1].strip() and columns_of(lines[-1] + piece.rstrip()) > columns:
            lines[-1] = lines[-1].rstrip()
            lines.append(indent + piece.lstrip())
        else:
            lines[-1] += piece
    return [line for line in (*lines[:-1], lines[-1].rstrip()) if line.strip()]


def _pieces(text: str) -> Iterator[str]:
    """What no line may end in: words with the space after them, wide letters with their signs."""
    piece = ""
    for sign in text:
        wide = _columns(sign) == 2 or (piece and _columns(piece[-1]) == 2)
        ends = piece and (piece[-1] == " " or wide)
        if ends and sign != " " and sign not in _NOT_FIRST and piece[-1] not in _NOT_LAST:
            yield piece
            piece = ""
        piece += sign
    if piece:
        yield piece
