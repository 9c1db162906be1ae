"""Body parts that a tracker saw, as the picture shows them."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import Colour
from tracking.tracks import Box


class Verdict(Enum):
    """What was found of a part while people were tracked."""

    ON = "on"
    OFF = "off"
    HIDDEN = "hidden"
    NONE = "none"


@dataclass(frozen=True, slots=True)
class PartBox:
    """A part's rectangle as the tracker had it.

    Attributes:
        track, part: whose, and 0 head, 1 torso, 2 hip-leg.
        box: left, top, width, height in pixels of the left camera as recorded.
        colour: the person's.
        failed: the detector, or a rule of the tracker, says it is off its part.
        occluded: hidden; it follows motion alone.
        text: what is said of it, e.g. "torso: off, +1.32". scored: a score stands in it.
        selected: of the selected person. chosen: the part that is looked at, too.
    """

    track: int
    part: int
    box: Box
    colour: Colour
    failed: bool
    occluded: bool
    text: str
    selected: bool = False
    chosen: bool = False
    scored: bool = False

    @property
    def verdict(self) -> Verdict:
        """In one word."""
        if self.occluded:
            return Verdict.HIDDEN
        if self.failed:
            return Verdict.OFF
        return Verdict.ON if self.scored else Verdict.NONE


@dataclass(frozen=True, slots=True)
class CardLine:
    """What is said of one part, by the tracker and by people.

    Attributes:
        text: e.g. "head: off, +0.69; labelled on". box: the part's rectangle, as recorded.
        chosen: it is the part that is looked at.
    """

    part: int
    text: str
    verdict: Verdict
    box: Box
    chosen: bool = False


@dataclass(frozen=True, slots=True)
class PartCard:
    """All that is said of one person's parts, in one place beside them.

    Attributes:
        colour: the person's. foot: whose the scores are, a line each. selected: it has the right
            of way; others give way to it and to people.
    """

    track: int
    colour: Colour
    lines: tuple[CardLine, ...]
    foot: tuple[str, ...] = ()
    selected: bool = False


@dataclass(frozen=True, slots=True)
class PicturedParts:
    """All parts in the left camera in one frame.

    Attributes:
        boxes: those of the selected person last. cards: what is said of them, selected first.
        particles: (n, 2) pixels as recorded, of the part that is looked at; none where not asked.
        weights: (n,) 0 to 1, relative to the heaviest. colour: theirs.
    """

    boxes: tuple[PartBox, ...] = ()
    cards: tuple[PartCard, ...] = ()
    particles: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 2)))
    weights: NDArray[np.float32] = field(default_factory=lambda: np.zeros(0, np.float32))
    colour: Colour = (255, 255, 255)
