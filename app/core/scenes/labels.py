"""What people draw and say, as pictures and floor show it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from enum import Enum

import numpy as np

from app.core.i18n import N_
from app.core.scenes import Colour, Points
from app.core.scenes.okabe_ito import GREEN, ORANGE, PURPLE, SKY_BLUE, VERMILION, YELLOW
from tracking.tracks import PartKey
from tracking.translation import Message

PART_COLOURS: tuple[Colour, ...] = (ORANGE, SKY_BLUE, PURPLE)
"""Of head, torso and hip-leg: told apart also by the colour-blind."""

OCCLUDER_COLOUR: Colour = YELLOW

LINE_COLOUR: Colour = VERMILION

REGION_COLOUR: Colour = GREEN


class Tool(Enum):
    """What is being labelled; the value is the command that begins it."""

    PARTS = "labels.parts"
    OCCLUDERS = "labels.occluders"
    LINES = "labels.lines"
    REGIONS = "labels.regions"
    REVIEWED = "labels.reviewed"

    @property
    def on_floor(self) -> bool:
        """Whether it is drawn on the overhead view."""
        return self in (Tool.LINES, Tool.REGIONS)

    @property
    def in_picture(self) -> bool:
        """Whether it is drawn in the left camera; lines and regions are where there is no floor."""
        return self is Tool.OCCLUDERS or self.on_floor


@dataclass(frozen=True, slots=True)
class PartMark:
    """A body part's rectangle in a picture.

    Attributes:
        track, part: whose, and 0 head, 1 torso, 2 hip-leg.
        box: left, top, width, height in pixels of that camera as recorded.
        colour: the part's while it is labelled, else the person's.
        given: somebody said it; else it is a first guess, drawn faint.
        on_part: what was said; None: unsure.
        asked: it is being labelled. chosen: it is the part that the keys speak of.
    """

    track: int
    part: int
    box: tuple[float, float, float, float]
    colour: Colour
    given: bool
    on_part: bool | None = None
    asked: bool = False
    chosen: bool = False


@dataclass(frozen=True, slots=True)
class Outline:
    """A polygon or a line.

    Attributes:
        points: (n, 2) pixels or metres; a row of NaN breaks it where it is out of sight.
        closed: a polygon, else a line.
        arrow: (2, 2) from tail to tip, which way is forward over a line; (0, 2): none.
        picked: drawn with emphasis and its corners.
        key: the tool that draws it and its number. said: what is counted at it; "": nothing.
    """

    name: str
    points: Points
    closed: bool
    colour: Colour
    arrow: Points = field(default_factory=lambda: np.zeros((0, 2)))
    picked: bool = False
    key: tuple[Tool, int] = (Tool.OCCLUDERS, -1)
    said: str = ""


@dataclass(frozen=True, slots=True)
class PictureLabels:
    """Labels and drawings in one image; `labelling`: the boxes of people give way to parts."""

    parts: tuple[PartMark, ...] = ()
    outlines: tuple[Outline, ...] = ()
    labelling: bool = False


@dataclass(frozen=True, slots=True)
class FloorLabels:
    """What was drawn on the floor, in metres."""

    outlines: tuple[Outline, ...] = ()


@dataclass(frozen=True, slots=True)
class SuggestedPart:
    """A part that is worth labelling.

    Attributes:
        key: frame, track and part. reason: why, as it is kept with the label.
        title: the part in words. label: of the person. colour: theirs. when: e.g. "00:41.70".
    """

    key: PartKey
    reason: Message
    title: str
    label: str
    colour: Colour
    when: str


CountText = Callable[[Tool, int], str]
"""What is counted at a line or in a region, by its number; "" where nothing is."""

SAID: dict[bool | None, str] = {True: N_("on"), False: N_("off"), None: N_("unsure")}


def with_texts(outlines: tuple[Outline, ...], text_at: CountText) -> tuple[Outline, ...]:
    """The outlines with what is counted at them."""
    return tuple(replace(one, said=text_at(*one.key)) for one in outlines)
