"""Numbers of JSON from elsewhere: what is none, or none of anything, is None."""

from __future__ import annotations

import math
from typing import Any

from tracking.tracks import LARGEST_NUMBER

_LARGEST = 1e15
"""Nothing that is measured in pixels, percent or seconds is larger."""


def whole_of(value: Any) -> int | None:
    """A whole number an id or a frame can be, also where it is written as 3.0."""
    if type(value) is float and value.is_integer():
        value = int(value)
    return value if type(value) is int and abs(value) <= LARGEST_NUMBER else None


def number_of(value: Any) -> float | None:
    """A finite number; True and False are none."""
    if type(value) not in (int, float) or not abs(value) <= _LARGEST:
        return None
    return float(value) if math.isfinite(value) else None
