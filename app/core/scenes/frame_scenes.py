"""What pictures and the floor draw of one frame."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image

Colour = tuple[int, int, int]
Points = NDArray[np.float64]  # (n, 2)


class Side(Enum):
    """Which camera a picture is of; BOTH: one over the other, in the left one's pixels."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


@dataclass(frozen=True, slots=True)
class PersonMark:
    """A person in a picture.

    Attributes:
        track: id.
        box: left, top, width, height in pixels of that camera as recorded.
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
    """What a colour laid over a picture means.

    `opacity`: how much of it covers the ground. `dashed`: it is that of dashed outlines.
    """

    colour: Colour
    text: str
    opacity: float = 1.0
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class PictureScene:
    """One camera in one frame.

    Attributes:
        side: which.
        frame: frame number shown.
        image: the picture as recorded; None while it is being read.
        people: marks, the selected one last.
        overlay: (height, width, 4) uint8 RGBA laid over the picture, or None; the very same array
            while nothing in it changed.
        legend: what the overlay's colours mean.
        grid: line segments (n, 2, 2) of the floor grid in pixels, or empty.
        message: said in the middle where there is no picture, else low down in it.
        preview: trails in pixels before (dashed) and after (solid) of an edit being previewed.
        ghosts: people where they are before that edit, as far as it moves or takes them out.
        drawing: a box is to be drawn. movable: anybody's box can be dragged.
    """

    side: Side
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
    movable: bool = False


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
    """The floor in one frame, in metres; x right, y forward (up on the screen).

    Attributes:
        particles: (n, 2) float32 metres. particle_colours: (n, 3) uint8 of their persons.
        particle_weights: (n,) float32 0..1, relative to the person's heaviest: brightness.
        measured: (m, 2) detections, drawn as black dots.
        people: tracks.
        field_of_view: polygon (k, 2) the left camera sees of the floor.
        camera: x, y of the camera.
        bounds: left, bottom, right, top in metres of what is worth showing. all_bounds: of all
            places that are known, however far; None for the same.
        preview: trails before (dashed) and after (solid) of an edit being previewed.
        message: said where there is nothing to show, e.g. no calibration.
        looks_down: the camera looks (nearly) straight down, not forward.
        ghosts: people where they are before that edit, as far as it moves or takes them out.
        movable: people can be dragged over the floor.
        rough: the calibration is rough, and metres with it.
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
    rough: bool = False
    all_bounds: tuple[float, float, float, float] | None = None
