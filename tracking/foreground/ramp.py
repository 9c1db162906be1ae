"""The background difference as a ramp: how surely each pixel shows something new."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracking.arrays import Picture
from tracking.foreground.background import BackgroundModel, Subtraction
from tracking.foreground.difference import largest_difference
from tracking.setting import setting

_STEPS = 32
"""Grey levels of the quotient for a difference of exactly the limit."""


@dataclass(frozen=True, slots=True)
class RampSettings:
    """How a difference from the background becomes a grey level B of 0 to 1."""

    low: float = setting(
        0.5,
        "",
        (0.0, 7.0),
        "Difference from the background at which a pixel begins to count, in multiples of the "
        "foreground limit; higher: less noise, but people in pale clothes are missed",
        expert=True,
    )
    high: float = setting(
        2.0,
        "",
        (0.1, 7.9),
        "Difference at which a pixel counts fully, in multiples of the foreground limit; higher: "
        "only strong contrast counts fully",
        expert=True,
    )


def ramp(seen: Subtraction, model: BackgroundModel, settings: RampSettings) -> Picture:
    """(height, width) uint8, B times 255.

    [Waechter2013] 3.2.2: grey levels in the place of a hard threshold, so that people who hardly
    differ from the background are not lost and noise counts for little. Where we differ: the
    ramp is measured in each pixel's own limit, so that what flickers counts for less, and the
    exposure is taken out before.

    Args:
        seen: of the frame. model: it was subtracted from.
    """
    if seen.scene_changed:
        return np.zeros(seen.mask.shape, np.uint8)
    difference = largest_difference(seen.picture, seen.background)
    quotient = cv2.divide(difference, model.limit, scale=_STEPS)
    return model.within_region(np.asarray(cv2.LUT(quotient, _table(settings)), np.uint8))


def _table(settings: RampSettings) -> Picture:
    quotient = np.arange(256) / _STEPS
    rise = max(settings.high - settings.low, 1e-3)
    level = np.clip((quotient - settings.low) / rise, 0.0, 1.0)
    return np.rint(255 * level).astype(np.uint8)
