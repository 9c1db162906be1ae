"""Pages from their templates: whatever text is put in comes out as text, never as markup."""

from __future__ import annotations

import base64
import re
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tracking.translation import count_msg, joined, language_in_use, msg, shown

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

_UNWRITABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]")
"""What no page can hold: control characters, and the halves that stand for undecodable bytes."""


def render(template: str, **values: Any) -> str:
    """A page or a picture, in the user's language: messages among the values are translated.

    A template's own words are `tr("{n} of {all}", n=1, all=2)` and `count_text`, as in the program;
    values that are markup stay so within them.

    Args:
        template: its path in this library. `pages/page.html` is the frame of all pages; of it and
            of all that extend it `title` is of the window and the first heading, and `kind` what
            program and command made it, see `is_page`.
        values: what it shows.
    """
    return _environment().get_template(template).render(values)


def is_page(start: str, kind: str) -> bool:
    """Whether a text that begins so is a page of that kind."""
    from markupsafe import escape

    return f'<meta name="generator" content="{escape(kind)}">' in start


@cache
def _environment() -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    made = Environment(
        loader=FileSystemLoader(Path(__file__).parents[1]),
        autoescape=True,
        finalize=_written,
        keep_trailing_newline=True,
        lstrip_blocks=True,
        trim_blocks=True,
        undefined=StrictUndefined,
    )
    made.globals |= {
        "tr": _tr,
        "count_text": _count_text,
        "joined": _joined,
        "language": _language,
    }
    made.filters["jpeg_address"] = _jpeg_address
    made.filters["tick"] = _tick
    return made


def _tr(text: str, /, **values: object) -> Markup:
    """A text in the user's language; none of it is markup but values that are."""
    return msg(text, **values).translated(_as_markup)  # type: ignore[return-value] # what it makes


def _count_text(count: int, one: str, many: str, /, **values: object) -> Markup:
    """One or many of something, as `_tr` does it."""
    return count_msg(count, one, many, **values).translated(_as_markup)  # type: ignore[return-value]


def _joined(separator: str, texts: Iterable[object]) -> Markup:
    """A list in the user's language, as `_tr` does it."""
    return joined(separator, texts).translated(_as_markup)  # type: ignore[return-value]


def _as_markup(template: str, values: Mapping[str, object]) -> Markup:
    from markupsafe import escape

    return escape(template).format(**values) if values else escape(template)


def _language() -> str:
    """The language of the pages as HTML names it, e.g. "pt-BR"."""
    return language_in_use().replace("_", "-") or "en"


def _written(value: Any) -> Any:
    """Text as it may stand in a page; numbers to a hundredth, which no eye sees less than."""
    value = shown(value)
    if isinstance(value, float):
        return f"{value:.2f}".rstrip("0").rstrip(".")
    if isinstance(value, str):  # markup stays markup
        return type(value)(_UNWRITABLE.sub("\N{REPLACEMENT CHARACTER}", value))
    return value


def _jpeg_address(jpeg: bytes) -> str:
    """The address of an image that is in the address itself."""
    return f"data:image/jpeg;base64,{base64.b64encode(jpeg).decode()}"


def _tick(value: float) -> str:
    return f"{value:,.10g}".replace("-", "−")
