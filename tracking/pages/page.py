"""A page that needs no other file and asks nobody for anything."""

from __future__ import annotations

from tracking.pages.elements import Content, element, html_text
from tracking.pages.look import PAGE

_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"
"""Nothing is fetched and nothing runs, whatever a name in the page may hold."""


def page(title: str, *body: Content, kind: str, style: str = "") -> str:
    """The page as HTML.

    Args:
        title: of the window, and the page's first heading.
        body: what follows it.
        kind: what program and command made it; see `is_page`.
        style: rules of its own, after those of all pages.
    """
    head = element(
        "head",
        element("meta", charset="utf-8"),
        element("meta", name="generator", content=kind),
        element("meta", http_equiv="Content-Security-Policy", content=_POLICY),
        element("meta", name="viewport", content="width=device-width"),
        element("meta", name="color-scheme", content="light dark"),
        element("title", title),
        element("style", PAGE + style),
    )
    main = element("main", element("h1", title), *body)
    return html_text(element("html", head, element("body", main), lang="en"))


def is_page(start: str, kind: str) -> bool:
    """Whether a text that begins so is a page of that kind."""
    return f'<meta name="generator" content="{kind}">' in start
