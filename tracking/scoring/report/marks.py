"""The marks of errors in drawings: each kind has its shape and its colour."""

from __future__ import annotations

from tracking.pages import Shape
from tracking.scoring.errors import ErrorKind
from tracking.translation import msg

TITLES = {
    ErrorKind.SWITCH: msg("switches"),
    ErrorKind.FRAGMENTATION: msg("fragmentations"),
    ErrorKind.MISS: msg("misses"),
    ErrorKind.FALSE_ALARM: msg("false alarms"),
}
"""In the order they are told of."""

LOOK = {
    ErrorKind.SWITCH: "switch",
    ErrorKind.FRAGMENTATION: "fragment",
    ErrorKind.MISS: "miss",
    ErrorKind.FALSE_ALARM: "alarm",
}
"""Classes of the page's style."""


def mark(kind: ErrorKind, x: float, y: float, says: str) -> Shape:
    """A mark with its middle at a place; a pointer over it makes it say what happened."""
    corners = {
        ErrorKind.SWITCH: f"M{x:.1f} {y - 6:.1f}l6 6l-6 6l-6-6z",
        ErrorKind.FRAGMENTATION: f"M{x:.1f} {y - 5:.1f}l5.5 9.5h-11z",
        ErrorKind.MISS: f"M{x - 3.5:.1f} {y:.1f}a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0-7 0z",
        ErrorKind.FALSE_ALARM: f"M{x - 3.5:.1f} {y - 3.5:.1f}h7v7h-7z",
    }
    return Shape(corners[kind], f"mark {LOOK[kind]}", says)
