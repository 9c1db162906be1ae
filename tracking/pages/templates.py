"""Pages from their templates: whatever text is put in comes out as text, never as markup."""

from __future__ import annotations

import base64
import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from jinja2 import Environment

_UNWRITABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]")
"""What no page can hold: control characters, and the halves that stand for undecodable bytes."""


def render(template: str, **values: Any) -> str:
    """A page or a picture.

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
    made.filters["jpeg_address"] = _jpeg_address
    made.filters["tick"] = _tick
    return made


def _written(value: Any) -> Any:
    """Text as it may stand in a page; numbers to a hundredth, which no eye sees less than."""
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
