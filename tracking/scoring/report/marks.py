"""The marks of errors in drawings: each kind has its shape and its colour."""

from __future__ import annotations

from tracking.pages import Element, element
from tracking.scoring.errors import ErrorKind

TITLES = {
    ErrorKind.SWITCH: "switches",
    ErrorKind.FRAGMENTATION: "fragmentations",
    ErrorKind.MISS: "misses",
    ErrorKind.FALSE_ALARM: "false alarms",
}
"""In the order they are told of."""

LOOK = {
    ErrorKind.SWITCH: "switch",
    ErrorKind.FRAGMENTATION: "fragment",
    ErrorKind.MISS: "miss",
    ErrorKind.FALSE_ALARM: "alarm",
}
"""Classes of the page's style."""

STYLE = """
svg .switch{fill:var(--switch)} svg .fragment{fill:var(--fragment)}
svg .miss{fill:var(--miss)} svg .alarm{fill:var(--alarm)}
svg .mark{stroke:var(--paper);stroke-width:.8}
svg .kept{fill:var(--kept)}
svg .walk{fill:none;stroke:var(--kept);stroke-width:1.2;stroke-linejoin:round}
svg .way{fill:none;stroke-width:3.2;stroke-linecap:round;stroke-linejoin:round}
svg .way.miss{fill:none;stroke:var(--miss)}
svg .way.alarm{fill:none;stroke:var(--alarm);stroke-dasharray:1 5}
svg .view{fill:var(--panel);stroke:var(--faint);stroke-dasharray:5 4}
svg .camera{fill:var(--ink)}
svg .scale{stroke:var(--ink);stroke-width:2}
svg .lane{stroke:var(--line)}
"""


def mark(kind: ErrorKind, x: float, y: float, says: str) -> Element:
    """A mark with its middle at a place; a pointer over it makes it say what happened."""
    corners = {
        ErrorKind.SWITCH: f"M{x:.1f} {y - 6:.1f}l6 6l-6 6l-6-6z",
        ErrorKind.FRAGMENTATION: f"M{x:.1f} {y - 5:.1f}l5.5 9.5h-11z",
        ErrorKind.MISS: f"M{x - 3.5:.1f} {y:.1f}a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0z",
        ErrorKind.FALSE_ALARM: f"M{x - 3.5:.1f} {y - 3.5:.1f}h7v7h-7z",
    }
    made = element("path", d=corners[kind], class_=f"mark {LOOK[kind]}")
    made.append(element("title", says))
    return made


def key(*more: tuple[Element, str]) -> Element:
    """What the marks stand for, and other signs with their words."""
    signs = [(mark(kind, 8, 8, title), title) for kind, title in TITLES.items()]
    shown = [
        element("span", element("svg", sign, viewBox="0 0 16 16"), says)
        for sign, says in (*signs, *more)
    ]
    return element("div", shown, class_="key")
