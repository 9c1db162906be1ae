"""What people drew and said, as the views show it: body parts, occluders, lines, regions."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

import numpy as np

from app.core.scenes import ChoiceRow, Colour, Points
from tracking.tracks import PartKey

PART_COLOURS: tuple[Colour, ...] = ((230, 159, 0), (86, 180, 233), (204, 121, 167))
"""Of head, torso and hip-leg: told apart also by the colour-blind."""
OCCLUDER_COLOUR: Colour = (240, 228, 66)
LINE_COLOUR: Colour = (213, 94, 0)
REGION_COLOUR: Colour = (0, 158, 115)


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
class PartLine:
    """One part in the panel: its name, what was said of it in this frame, how often in all.

    Attributes:
        said: "on", "off", "unsure"; "" where nothing was said.
        counts: how many labels say on, off and unsure.
    """

    name: str
    said: str
    chosen: bool
    counts: tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class SuggestedPart:
    """A part that is worth labelling.

    Attributes:
        key: frame, track and part. reason: why, as it is kept with the label.
        title: the part in words. label: of the person. colour: theirs. when: e.g. "00:41.70".
    """

    key: PartKey
    reason: str
    title: str
    label: str
    colour: Colour
    when: str


@dataclass(frozen=True, slots=True)
class RangeLine:
    """One reviewed range in the panel; track 0 stands for all."""

    text: str
    track: int
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class LabellingScene:
    """The panel of the labelling that goes on.

    Attributes:
        tool: what is labelled. title: e.g. "Body parts of 4 red coat".
        hint: what to do, in a line.
        parts: head, torso, hip-leg; only of `Tool.PARTS`. step: frames to go on after the last.
        scope: how far an answer goes. suggestions: what is worth labelling, the best first; None:
            they are not asked for. doing: said while they are looked for, or why there are none.
        current: the number of the one looked at; -1: none.
        names: what was drawn, of the tools that draw. picked: number of the one chosen, -1: none.
        ranges: reviewed ranges. proposed: start and end (last frame) for a further one.
        selected: the selected track in words; "" for nobody.
        refused: why the last answer was not taken, while the same frame and person are looked at.
    """

    tool: Tool
    title: str
    hint: str
    parts: tuple[PartLine, ...] = ()
    step: int = 1
    names: tuple[str, ...] = ()
    picked: int = -1
    ranges: tuple[RangeLine, ...] = ()
    proposed: tuple[int, int] = (0, 0)
    selected: str = ""
    scope: ChoiceRow | None = None
    suggestions: tuple[SuggestedPart, ...] | None = None
    current: int = -1
    doing: str = ""
    refused: str = ""
