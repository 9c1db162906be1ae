"""How much alike colours look to people who see all colours, and to the colour-blind."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import Colour

Floats = NDArray[np.float64]

_SIGHTS: tuple[Floats, ...] = (
    np.eye(3),
    np.array([[0.152, 1.053, -0.205], [0.115, 0.786, 0.099], [-0.004, -0.048, 1.052]]),
    np.array([[0.367, 0.861, -0.228], [0.280, 0.673, 0.047], [-0.012, 0.043, 0.969]]),
)
"""What is left of linear red, green, blue for usual, red-blind and green-blind eyes:
[Machado2009], severity 1.0."""
_XYZ_FROM_RGB = np.array(
    [[0.4125, 0.3576, 0.1804], [0.2127, 0.7152, 0.0722], [0.0193, 0.1192, 0.9503]]
)
_WHITE = np.array([0.9505, 1.0, 1.0888])
_ALIKE = 12.0
"""CIELAB distance at which two colours of small marks are told apart only side by side."""
_NEIGHBOURING = 30.0
"""Distance of neighbouring hues in CIELAB's plane of green to red and blue to yellow."""


def alike(colours: Sequence[Colour]) -> Floats:
    """(n, n) how much alike every two colours look to whoever tells them apart least.

    1: the same colour; 0.4 where only a careful look tells; next to 0 where a glance does.
    """
    linear = _linear(colours)
    seen = [_lab(linear @ sight.T) for sight in _SIGHTS]
    apart = np.min([np.linalg.norm(one[:, None] - one[None], axis=2) for one in seen], axis=0)
    return np.asarray(np.exp(-np.square(apart / _ALIKE)))


def of_one_hue(colours: Sequence[Colour]) -> Floats:
    """(n, n) how far every two colours go by one name, such as lilac and violet, for usual eyes.

    1: the same hue, however light or dark; 0.4 for neighbours on the circle of hues.
    """
    hue = _lab(_linear(colours))[:, 1:]
    apart = np.linalg.norm(hue[:, None] - hue[None], axis=2)
    return np.asarray(np.exp(-np.square(apart / _NEIGHBOURING)))


def _linear(colours: Sequence[Colour]) -> Floats:
    """(n, 3) linear red, green, blue, 0 to 1."""
    values = np.array(colours) / 255.0
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def _lab(linear: Floats) -> Floats:
    """(n, 3) CIELAB of linear red, green, blue."""
    xyz = np.clip(linear, 0, 1) @ _XYZ_FROM_RGB.T / _WHITE
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    x, y, z = f.T
    return np.column_stack((116 * y - 16, 500 * (x - y), 200 * (y - z)))
