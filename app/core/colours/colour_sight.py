"""How much alike colours look to people who see all colours, and to the colour-blind."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.core.colours.colour_difference import ciede2000
from app.core.scenes import Colour

Floats = NDArray[np.float64]

SIGHTS: Final[dict[str, Floats]] = {
    "usual": np.eye(3),
    "protan": np.array(
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ]
    ),
    "deutan": np.array(
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ]
    ),
    "tritan": np.array(
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ]
    ),
}
"""What is left of linear red, green, blue for usual eyes and for those blind to red, green and
blue light: [Machado2009], severity 1.0."""
_XYZ_FROM_RGB = np.array(
    [
        [0.4124564, 0.3575761, 0.1804375],
        [0.2126729, 0.7151522, 0.0721750],
        [0.0193339, 0.1191920, 0.9503041],
    ]
)
"""sRGB with the white point D65."""
_WHITE = _XYZ_FROM_RGB.sum(axis=1)
_ALIKE = 12.0
"""CIELAB distance at which two colours of small marks are told apart only side by side."""
_COMMON = slice(0, 3)
"""Of `SIGHTS`: tritan eyes are too rare to decide which of the colours somebody has."""
_NEIGHBOURING = 30.0
"""Distance of neighbouring hues in CIELAB's plane of green to red and blue to yellow."""


def differences(colours: Sequence[Colour], others: Sequence[Colour] | None = None) -> Floats:
    """(4, n, m) CIEDE2000 of colours and others, or of each two, in the order of `SIGHTS`."""
    one = seen_colours(colours)
    other = one if others is None else seen_colours(others)
    return ciede2000(one[:, :, None], other[:, None])


def seen_colours(colours: Sequence[Colour] | Floats) -> Floats:
    """(4, n, 3) CIELAB of colours (n, 3), 0 to 255, as each of `SIGHTS` sees them."""
    linear = _linear(colours)
    return np.stack([_lab(linear @ sight.T) for sight in SIGHTS.values()])


def alike(colours: Sequence[Colour]) -> Floats:
    """(n, n) how much alike every two colours look to whoever tells them apart least.

    1: the same colour; 0.4 where only a careful look tells; next to 0 where a glance does.
    """
    seen = seen_colours(colours)[_COMMON]
    apart = np.linalg.norm(seen[:, :, None] - seen[:, None], axis=3).min(axis=0)
    return np.asarray(np.exp(-np.square(apart / _ALIKE)))


def of_one_hue(colours: Sequence[Colour]) -> Floats:
    """(n, n) how far every two colours go by one name, such as lilac and violet, for usual eyes.

    1: the same hue, however light or dark; 0.4 for neighbours on the circle of hues.
    """
    hue = _lab(_linear(colours))[:, 1:]
    apart = np.linalg.norm(hue[:, None] - hue[None], axis=2)
    return np.asarray(np.exp(-np.square(apart / _NEIGHBOURING)))


def _linear(colours: Sequence[Colour] | Floats) -> Floats:
    """(n, 3) linear red, green, blue, 0 to 1."""
    values = np.asarray(colours, np.float64) / 255.0
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


def _lab(linear: Floats) -> Floats:
    """(n, 3) CIELAB of linear red, green, blue."""
    xyz = np.clip(linear, 0, 1) @ _XYZ_FROM_RGB.T / _WHITE
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    x, y, z = f.T
    return np.column_stack((116 * y - 16, 500 * (x - y), 200 * (y - z)))
