"""How different two colours look: CIEDE2000 [Sharma, Wu and Dalal 2005]."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_25_7 = 25.0**7


def ciede2000(one: Floats, other: Floats) -> Floats:
    """Difference of colours (..., 3) in CIELAB; shapes are broadcast, and the last axis goes.

    1 is about what people see side by side; all weights are 1.
    Source: Sharma, Wu and Dalal 2005, "The CIEDE2000 color-difference formula", equations 2 to 22.
    """
    chroma_one, chroma_other = _chroma(one), _chroma(other)
    mean_7 = ((chroma_one + chroma_other) / 2) ** 7
    stretch = 1.5 - 0.5 * np.sqrt(mean_7 / (mean_7 + _25_7))
    a_one, a_other = one[..., 1] * stretch, other[..., 1] * stretch
    c_one, c_other = np.hypot(a_one, one[..., 2]), np.hypot(a_other, other[..., 2])
    h_one, h_other = _hue_deg(a_one, one[..., 2]), _hue_deg(a_other, other[..., 2])
    grey = c_one * c_other == 0
    turn = np.where(grey, 0.0, _turn_deg(h_other - h_one))
    mean_h = np.where(grey, h_one + h_other, _mean_hue_deg(h_one, h_other))
    mean_c = (c_one + c_other) / 2
    weight = _hue_weight(mean_h)
    mean_l = (one[..., 0] + other[..., 0]) / 2
    lightness = (other[..., 0] - one[..., 0]) / _lightness_scale(mean_l)
    chroma = (c_other - c_one) / (1 + 0.045 * mean_c)
    across = 2 * np.sqrt(c_one * c_other) * np.sin(np.radians(turn) / 2)
    hue = across / (1 + 0.015 * mean_c * weight)
    squares = lightness**2 + chroma**2 + hue**2 + _rotation(mean_h, mean_c) * chroma * hue
    return np.asarray(np.sqrt(np.maximum(squares, 0.0)))


def _chroma(lab: Floats) -> Floats:
    return np.asarray(np.hypot(lab[..., 1], lab[..., 2]))


def _hue_deg(a: Floats, b: Floats) -> Floats:
    """Angle of the hue, 0 to 360; 0 for greys."""
    return np.asarray(np.degrees(np.arctan2(b, a)) % 360.0)


def _turn_deg(difference: Floats) -> Floats:
    """The shorter way around the circle of hues."""
    shorter = np.where(difference > 180.0, difference - 360.0, difference)
    return np.where(shorter < -180.0, shorter + 360.0, shorter)


def _mean_hue_deg(one: Floats, other: Floats) -> Floats:
    total = one + other
    across = np.where(total < 360.0, total + 360.0, total - 360.0)
    return np.where(np.abs(one - other) <= 180.0, total, across) / 2


def _hue_weight(hue_deg: Floats) -> Floats:
    """The term T."""
    hue = np.radians(hue_deg)
    return np.asarray(
        1
        - 0.17 * np.cos(hue - np.radians(30))
        + 0.24 * np.cos(2 * hue)
        + 0.32 * np.cos(3 * hue + np.radians(6))
        - 0.20 * np.cos(4 * hue - np.radians(63))
    )


def _lightness_scale(mean: Floats) -> Floats:
    from_middle = (mean - 50.0) ** 2
    return np.asarray(1 + 0.015 * from_middle / np.sqrt(20 + from_middle))


def _rotation(hue_deg: Floats, chroma: Floats) -> Floats:
    """The term R_T, which turns ellipses of blue colours."""
    turn = 30 * np.exp(-(((hue_deg - 275) / 25) ** 2))
    chroma_7 = chroma**7
    return np.asarray(-2 * np.sqrt(chroma_7 / (chroma_7 + _25_7)) * np.sin(np.radians(2 * turn)))
