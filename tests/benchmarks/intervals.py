"""Shares of few people, and how far chance may have moved them."""

from __future__ import annotations

from math import sqrt

from scipy.stats import fisher_exact

_Z = 1.96


def interval(part: int, whole: int) -> tuple[float, float]:
    """Wilson's 95 % interval of a share; everything where nobody was counted."""
    if not whole:
        return 0.0, 1.0
    share = part / whole
    middle = (share + _Z**2 / (2 * whole)) / (1 + _Z**2 / whole)
    half = _Z * sqrt(share * (1 - share) / whole + _Z**2 / (4 * whole**2)) / (1 + _Z**2 / whole)
    return max(0.0, middle - half), min(1.0, middle + half)


def interval_text(part: int, whole: int) -> str:
    """Wilson's interval with two digits."""
    low, high = interval(part, whole)
    return f"{low:.2f} to {high:.2f}"


def same_share(one: tuple[int, int], other: tuple[int, int]) -> float:
    """Fisher's exact p of two shares, each (part, whole), being the same."""
    rows = [[part, whole - part] for part, whole in (one, other)]
    return float(fisher_exact(rows).pvalue)
