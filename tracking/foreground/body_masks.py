"""What a tracker tells its camera's background of people: where they are, and beside them."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracking.arrays import Mask
from tracking.foreground.background import BackgroundModel, Subtraction
from tracking.foreground.shadow_weights import ShadowWeights

_PROTECTED = np.ones((9, 9), np.uint8)
"""Round people the background is not learnt."""


@dataclass(frozen=True, slots=True, eq=False)
class BodyMasks:
    """Where people are in a frame, as masks (height, width) uint8, non-zero there.

    Attributes:
        on: on people known for certain. beside: close to them, where their shadows fall.
        kept: generously on everybody.
    """

    on: Mask
    beside: Mask
    kept: Mask


def learn_frame(
    background: BackgroundModel,
    shadows: ShadowWeights,
    seen: Subtraction,
    people: BodyMasks | None,
) -> None:
    """Let the background follow a frame except where people are, and learn shadows beside them.

    Args:
        seen: the frame, which was weighed last. people: None: nothing is known of them.
    """
    kept = None
    if people is not None and background.update_is_due:
        shadows.learn(seen.mask, people.on, people.beside)
        kept = np.asarray(cv2.dilate(people.kept, _PROTECTED), np.uint8)
    background.update(seen, kept)
