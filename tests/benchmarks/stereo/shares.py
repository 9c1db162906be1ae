"""Shares of few people, and how far chance may have moved them."""

from __future__ import annotations

from math import sqrt

_Z = 1.96


def interval(part: int, whole: int) -> tuple[float, float]:
    """Wilson's 95 % interval of a share; everything where nobody was counted."""
    if not whole:
        return 0.0, 1.0
    share = part / whole
    middle = (share + _Z**2 / (2 * whole)) / (1 + _Z**2 / whole)
    half = _Z * sqrt(share * (1 - share) / whole + _Z**2 / (4 * whole**2)) / (1 + _Z**2 / whole)
    return max(0.0, middle - half), min(1.0, middle + half)


def percent(part: int, whole: int) -> str:
    """A share in per cent with one digit; - of nobody."""
    return f"{100 * part / whole:.1f}" if whole else "-"


def said_interval(part: int, whole: int) -> str:
    """Wilson's interval with two digits."""
    low, high = interval(part, whole)
    return f"{low:.2f} to {high:.2f}"
