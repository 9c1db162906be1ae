"""What a frame's scenes are made from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.core.colours.track_colours import TrackColours
from app.core.scenes import LegendEntry, PreviewTrail
from app.core.tracks.made_by import MadeBy
from app.core.tracks.track_reader import TrackReader
from tracking.tracks import Columns


@dataclass(frozen=True, slots=True)
class ViewOptions:
    """What is laid over the pictures, and which panels are open, by id: the user's choice."""

    grid: bool = False
    particles: bool = False
    trails: bool = True
    detections: bool = True
    region: bool = True
    foreground: bool = False
    disparity: bool = False
    labels: bool = True
    parts: bool = True
    part_particles: bool = False
    counts: bool = True
    flow_map: bool = False
    floor_legend: bool = True
    tracklets: bool = False
    outlines: bool = False
    evaluation: bool = False
    ramp: bool = False
    truth: bool = False
    close_up: bool = True
    suggestions: bool = False
    panels: frozenset[str] = frozenset()

    @property
    def lasting(self) -> str:
        """What holds for the next recording, too, for :func:`parse_view_options`."""
        marks = (f"{'+' if getattr(self, name) else '-'}{name}" for name in _LASTING)
        return " ".join((*marks, *(f"{_PANEL}{name}" for name in sorted(self.panels))))

    @property
    def kinds(self) -> Kinds:
        """What of the picture is asked for, worked out in the background."""
        return Kinds(self.foreground, self.disparity, self.ramp)

    @property
    def bodies(self) -> bool:
        """Whether something of what trackers of one camera think of is laid over."""
        return self.tracklets or self.outlines or self.evaluation


_LASTING = (
    *(
        "grid",
        "particles",
        "trails",
        "detections",
        "region",
        "labels",
        "parts",
        "part_particles",
        "counts",
        "suggestions",
    ),
    "floor_legend",
    "close_up",
)
"""What is worked out on request is asked for anew in each recording."""
_PANEL = "panel:"
"""Before the name of one that is open."""


def parse_view_options(lasting: str) -> ViewOptions:
    """The choice as it was left; whatever a damaged file says instead is forgotten."""
    words = lasting.split()
    marks = (word for word in words if word[0] in "+-" and word[1:] in _LASTING)
    said: dict[str, Any] = {word[1:]: word[0] == "+" for word in marks}
    panels = frozenset(word.removeprefix(_PANEL) for word in words if word.startswith(_PANEL))
    return ViewOptions(**said, panels=panels, truth="score" in panels)


@dataclass(frozen=True, slots=True)
class PictureOverlay:
    """What of foreground, subtraction stereo or the ramp lies over the left picture of a frame.

    Attributes:
        image: (height, width, 4) uint8 RGBA; None while it is being made.
        legend: what its colours mean. message: said meanwhile.
    """

    image: NDArray[np.uint8] | None = None
    legend: tuple[LegendEntry, ...] = ()
    message: str = ""


NO_OVERLAY = PictureOverlay()


@dataclass(frozen=True, slots=True)
class FrameState:
    """One frame as all views show it.

    Attributes:
        frame: number. tracks: where people come from. names: of tracks that have one.
        selected: track id, 0 for nobody. other: the second person of an edit, 0 for nobody.
        also: others who are drawn with emphasis, as they are selected too.
        run: what its measurements and particles were made by, be it at work still; None: nothing is
            known of that.
        preview: trails on the floor (m) of an edit that waits.
        picture_preview: the same in pixels of the left camera.
        replaced: the frame's rows that this edit moves elsewhere or takes out; None: none.
        colours: of the tracks.
        movable: boxes and people can be dragged. drawing: a box is to be drawn.
        says: what the next drag over the picture does, while boxes are drawn one after the other.
        waits: an edit stands ready, which a drag of anybody else's box would drop.
    """

    frame: int
    tracks: TrackReader
    names: Mapping[int, str] = field(default_factory=dict)
    selected: int = 0
    other: int = 0
    also: tuple[int, ...] = ()
    run: MadeBy | None = None
    preview: tuple[PreviewTrail, ...] = ()
    picture_preview: tuple[PreviewTrail, ...] = ()
    replaced: Columns | None = None
    colours: TrackColours = field(default_factory=TrackColours)
    movable: bool = False
    drawing: bool = False
    says: str = ""
    waits: bool = False

    @property
    def chosen(self) -> tuple[int, ...]:
        """Everybody who is drawn with emphasis."""
        return tuple(track for track in (self.selected, self.other, *self.also) if track > 0)

    def label(self, track: int) -> str:
        """The id, and the name where there is one."""
        name = self.names.get(track, "")
        return f"{track} {name}" if name else str(track)

    def is_chosen(self, track: int) -> bool:
        """Whether the track is drawn with emphasis."""
        return track in self.chosen


@dataclass(frozen=True, slots=True)
class Kinds:
    """Which of them are laid over the picture; the ramp image comes alone."""

    foreground: bool = False
    disparity: bool = False
    ramp: bool = False

    def __bool__(self) -> bool:
        return self.foreground or self.disparity or self.ramp
