"""What people drew and said, as the views show it: body parts, occluders, lines, regions."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes import ChoiceRow
from app.core.scenes.labels import SuggestedPart, Tool


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
