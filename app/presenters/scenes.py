"""Frozen scenes: everything a view needs to draw one instant, and nothing else.

Presenters make scenes, views draw them. No Qt here; colours are (red, green, blue) 0..255.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum, IntEnum

import numpy as np
from numpy.typing import NDArray

from app.presenters.parts.part_curve import LaneScore
from tracking.recording.frame import Image

Colour = tuple[int, int, int]
Points = NDArray[np.float64]  # (n, 2)


class Eye(Enum):
    """Which camera a picture is of; BOTH: one over the other, in the left one's pixels."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


@dataclass(frozen=True, slots=True)
class PersonMark:
    """A person in a picture.

    Attributes:
        track: id.
        box: left, top, width, height in pixels of that eye as recorded.
        label: what is written at the box, e.g. "4 red coat".
        colour: the track's own.
        selected: drawn with emphasis.
        predicted: drawn dashed, nothing was seen of the person.
        trail: (n, 2) foot points in pixels, oldest first.
        occluded: drawn dotted, a person said they are behind something.
        keyframe: a person made the box. movable: drawn with handles; it can be dragged.
    """

    track: int
    box: tuple[float, float, float, float]
    label: str
    colour: Colour
    selected: bool
    predicted: bool
    trail: Points
    occluded: bool = False
    keyframe: bool = False
    movable: bool = False


@dataclass(frozen=True, slots=True)
class PreviewTrail:
    """A trail as it would be, or as it was, in a previewed edit."""

    points: Points
    colour: Colour
    after: bool


@dataclass(frozen=True, slots=True)
class LegendEntry:
    """What a colour laid over a picture means."""

    colour: Colour
    text: str


@dataclass(frozen=True, slots=True)
class PictureScene:
    """One eye at one instant.

    Attributes:
        eye: which.
        frame: frame number shown.
        image: the picture as recorded; None while it is being read.
        people: marks, the selected one last.
        overlay: (height, width, 4) uint8 RGBA laid over the picture, or None; the very same array
            while nothing in it changed.
        legend: what the overlay's colours mean.
        grid: line segments (n, 2, 2) of the floor grid in pixels, or empty.
        message: said in the middle where there is no picture.
        preview: trails in pixels before (dashed) and after (solid) of an edit being previewed.
        ghosts: people where they are before that edit, as far as it moves or takes them out.
        drawing: a box is to be drawn.
    """

    eye: Eye
    frame: int
    image: Image | None
    people: tuple[PersonMark, ...] = ()
    overlay: NDArray[np.uint8] | None = None
    grid: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 2, 2)))
    message: str = ""
    preview: tuple[PreviewTrail, ...] = ()
    legend: tuple[LegendEntry, ...] = ()
    ghosts: tuple[PersonMark, ...] = ()
    drawing: bool = False


@dataclass(frozen=True, slots=True)
class FloorPerson:
    """A person seen from above.

    Attributes:
        position: x, y in metres. velocity: m/s; (0, 0) draws no direction.
        trail: (n, 2) metres, oldest first.
    """

    track: int
    label: str
    position: tuple[float, float]
    velocity: tuple[float, float]
    colour: Colour
    selected: bool
    predicted: bool
    trail: Points


@dataclass(frozen=True, slots=True)
class OverheadScene:
    """The floor at one instant, in metres; x right, y forward (up on the screen).

    Attributes:
        particles: (n, 2) float32 metres. particle_colours: (n, 3) uint8 of their persons.
        particle_weights: (n,) float32 0..1, relative to the person's heaviest: brightness.
        measured: (m, 2) detections, drawn as black dots.
        people: tracks.
        field_of_view: polygon (k, 2) the left camera sees of the floor.
        camera: x, y of the camera.
        bounds: left, bottom, right, top in metres of what is worth showing.
        preview: trails before (dashed) and after (solid) of an edit being previewed.
        message: said where there is nothing to show, e.g. no calibration.
        looks_down: the camera looks (nearly) straight down, not forward.
        ghosts: people where they are before that edit, as far as it moves or takes them out.
        movable: people can be dragged over the floor.
    """

    frame: int
    particles: NDArray[np.float32]
    particle_colours: NDArray[np.uint8]
    particle_weights: NDArray[np.float32]
    measured: Points
    people: tuple[FloorPerson, ...]
    field_of_view: Points
    camera: tuple[float, float]
    bounds: tuple[float, float, float, float]
    preview: tuple[PreviewTrail, ...] = ()
    message: str = ""
    looks_down: bool = False
    ghosts: tuple[FloorPerson, ...] = ()
    movable: bool = False


class SpanKind(IntEnum):
    """What the rows of a stretch of a lane are."""

    MEASURED = 0
    PREDICTED = 1
    INTERPOLATED = 2


class MarkKind(Enum):
    """What a mark on the timeline stands for."""

    EDIT = "edit"
    SWAP = "swap"
    SUSPICION = "suspicion"


@dataclass(frozen=True, slots=True)
class TimelineMark:
    """Something at a frame of a track.

    Attributes:
        track: id; 0 where it is about no track in particular.
        text: said when the mouse rests on it.
    """

    kind: MarkKind
    frame: int
    track: int
    text: str = ""


@dataclass(frozen=True, slots=True)
class Lane:
    """A track on the timeline.

    Attributes:
        spans: (k, 3) int64 rows of first frame, end frame (half-open), `SpanKind`; ascending.
        marks: by frame. keyframes: (n,) int64 frames whose row a person made, ascending.
        reviewed: half-open ranges of frames a person has looked at in this track alone.
        score: how a part of the person went, drawn above the bar.
    """

    track: int
    label: str
    colour: Colour
    selected: bool
    spans: NDArray[np.int64]
    marks: tuple[TimelineMark, ...] = ()
    keyframes: NDArray[np.int64] = field(default_factory=lambda: np.zeros(0, np.int64))
    reviewed: tuple[tuple[int, int], ...] = ()
    score: LaneScore | None = None


@dataclass(frozen=True, slots=True)
class TimelineScene:
    """Lanes, playhead and the overview of the whole recording.

    Attributes:
        frame_count, fps: of the recording. frame: the playhead.
        lanes: a track each, by first frame.
        activity: (frame_count,) people per frame, uint16.
        tracked: half-open frame range. loaded: the half-open ranges of frames at hand.
        cut: a frame with an edit being previewed, or None.
        marked: the half-open range of frames the user has set, or that an edit goes over.
        message: said where there are no lanes.
        suspicions: those of all lanes, in any order; the very same tuple while they are the same.
        reviewed: half-open ranges looked at for all tracks.
    """

    frame_count: int
    fps: float
    frame: int
    lanes: tuple[Lane, ...]
    activity: NDArray[np.uint16]
    tracked: tuple[int, int] = (0, 0)
    loaded: tuple[tuple[int, int], ...] = ()
    cut: int | None = None
    marked: tuple[int, int] | None = None
    message: str = ""
    suspicions: tuple[TimelineMark, ...] = ()
    reviewed: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class TransportScene:
    """The line between the views and the timeline."""

    playing: bool
    speed: float
    frame: int
    frame_count: int
    time_s: float
    tracker: str
    status: str  # e.g. "live 43 fps", "tracked", "no tracker"
    live: bool = False  # a tracker is at work


@dataclass(frozen=True, slots=True)
class TrackCard:
    """The selected track in words; with `others` who are selected too."""

    track: int
    name: str
    colour: Colour
    first_frame: int
    last_frame: int
    frames_seen: int
    frames_predicted: int
    mean_confidence: float
    attributes: tuple[tuple[str, str], ...]
    notes: str
    others: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class HistoryItem:
    """One edit in the history panel; undone edits are shown greyed.

    Attributes:
        kind: one word, e.g. "swap". taken_by: the later edit that takes this one back alone; 0.
    """

    edit: int
    text: str
    when: str
    author: str
    frame: int
    undone: bool
    kind: str = ""
    taken_by: int = 0


@dataclass(frozen=True, slots=True)
class ChoiceRow:
    """Something of an edit that can be chosen.

    Attributes:
        row: its number. title: e.g. "How far". options: e.g. "from here on", "this range".
        chosen: the number of the one in force. key: the one that goes on to the next.
    """

    row: int
    title: str
    options: tuple[str, ...]
    chosen: int
    key: str


@dataclass(frozen=True, slots=True)
class Proposal:
    """Something the program found that may be meant: a person, a frame.

    Attributes:
        number: an id, or which of the proposals it is. chosen: it is the one in force.
        colour: of the person, None for a frame. why: said when the mouse rests on it.
    """

    number: int
    text: str
    chosen: bool
    colour: Colour | None = None
    why: str = ""


@dataclass(frozen=True, slots=True)
class EditPreview:
    """An edit that waits for Enter.

    Attributes:
        title: e.g. "Swap 4 and 7 from frame 834 on".
        details: lines that say what will change.
        frame: the cut, moved by the arrow keys, where it `has_cut`.
        end: one past the last frame of a range; None where the edit goes over none.
        choices: what can be chosen.
        other: id of the second person, 0 while they are to be picked, None where none is needed.
        others: who may be meant. cuts: frames where two people may have changed over.
        ready: False while the other person is still to be picked; Enter does nothing then.
        hint: the keys that work now beside Enter and Esc, e.g. "Left / Right move the frame".
    """

    title: str
    details: tuple[str, ...]
    frame: int
    end: int | None = None
    choices: tuple[ChoiceRow, ...] = ()
    other: int | None = None
    others: tuple[Proposal, ...] = ()
    cuts: tuple[Proposal, ...] = ()
    has_cut: bool = True
    ready: bool = True
    hint: str = ""


@dataclass(frozen=True, slots=True)
class CommandItem:
    """A command as menus, the palette and the list of shortcuts show it.

    Attributes:
        command: id, e.g. "edit.swap". title: e.g. "Swap with...".
        menu: where it stands, e.g. "File", "Correct > Delete".
        keys: in Qt's portable text, e.g. "Ctrl+Shift+Z"; the first is shown.
        why_not: said where it is not enabled.
    """

    command: str
    menu: str
    title: str
    keys: tuple[str, ...]
    enabled: bool
    why_not: str = ""
    checked: bool | None = None


@dataclass(frozen=True, slots=True)
class RecentItem:
    """A recording or session opened before."""

    path: str
    title: str
    detail: str
    exists: bool = True


@dataclass(frozen=True, slots=True)
class WelcomeScene:
    """The first page: what can be opened. `notice` is said above, e.g. after a crash."""

    recent: tuple[RecentItem, ...] = ()
    notice: str = ""
