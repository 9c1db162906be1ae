"""A feature of the window: one declared value that commands, panel and controller come from."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto
from typing import Any, Protocol

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.core.commands.command import Command
from app.core.controller import Controller
from app.core.document.document import Document
from app.core.drawing.surfaces import Surfaces
from app.core.playback.playback import Playback
from app.core.plots.axis import TimeAxis
from app.core.projection.extent import Bounds
from app.core.scenes import Side
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.labels import PictureLabels, SuggestedPart
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.core.widgets.parts import Panel

Marker = Callable[[PictureMarks, Side, FrameState, int], PictureMarks]
"""Adds what a feature draws over a camera's picture; the number is that camera's own frame. It is
called on any thread, for any frame."""

FloorMarker = Callable[[FloorMarks, FrameState], FloorMarks]
"""The same over the floor."""


class PartLabels(Protocol):
    """What is labelled of body parts."""

    shown: PictureLabels

    @property
    def part(self) -> int:
        """The part that is looked at."""

    @property
    def suggested(self) -> SuggestedPart | None:
        """What is looked at because the detector is unsure of it."""

    def choose_part(self, part: int) -> None:
        """Look at a part."""


@dataclass(frozen=True, slots=True)
class FeatureContext:
    """An open recording as features get it.

    Attributes:
        parent: what their controllers belong to, and tell messages and errors.
        document, playback, surfaces: the tracks, the frame that is shown, the views.
        labels: of body parts. floor_bounds: how far the floor is shown.
    """

    parent: QObject
    document: Document
    playback: Playback
    surfaces: Surfaces
    labels: PartLabels
    floor_bounds: Callable[[], Bounds]


@dataclass(frozen=True, slots=True)
class ShownFrame:
    """A frame as it is drawn in all views.

    Attributes:
        state: its tracks. view_options: what is laid over the pictures, which panels are open.
        cameras: "left", "both" or "anaglyph".
        right: the right camera's frame of the same instant; None: there is none.
    """

    state: FrameState
    view_options: ViewOptions
    cameras: str
    right: int | None


class FeaturePanel(Panel):
    """A panel that the window places by its feature's declaration.

    Signals:
        command_asked(str): a command of the window, by its id.
    """

    command_asked = Signal(str)

    def show_axis(self, axis: TimeAxis) -> None:
        """The timeline shows other frames."""


class FeatureController(Controller):
    """What the window creates and draws by the feature's declaration.

    `changed`: everything is drawn again. Signals: `marked()`, only what stands in the views and in
    panels that open and close is another: the frame is drawn again.
    """

    marked = Signal()

    def draw_frame(self, shown: ShownFrame) -> None:
        """Another frame is shown, or the same one in another way."""

    def marker(self, view_options: ViewOptions) -> Marker | None:  # noqa: ARG002
        """Takes hold of what it draws over the pictures, for clips of them; None: nothing."""
        return None

    def floor_marker(self, view_options: ViewOptions) -> FloorMarker | None:  # noqa: ARG002
        """The same of what it draws over the floor."""
        return None

    def draw(self) -> None:
        """Tracks or what is selected are others than before."""

    def close(self) -> None:
        """End all work; leave nothing on panel and views, which outlive the document."""


class Place(Enum):
    """Where a panel stands."""

    BELOW_FLOOR = auto()
    """Opened and closed by the command `view.ID`; shares its place with others of the kind."""
    SIDE = auto()
    """Always shown, below the review queue and the card."""


@dataclass(frozen=True, slots=True)
class Feature:
    """One subject of the window. It is found in `app/features/*/feature.py` as `FEATURE`.

    Attributes:
        id: of the panel, and of the command that opens it.
        controller: makes the controller of an open recording; given the panel, None without one.
        panel: makes the panel, once for all recordings. place: where it stands.
        commands: those in the View menu.
    """

    id: str
    controller: Callable[[FeatureContext, Any], FeatureController]
    panel: Callable[[QWidget], FeaturePanel] | None = None
    place: Place = Place.BELOW_FLOOR
    commands: tuple[Command[Any], ...] = ()

    @property
    def opens(self) -> bool:
        """Whether its panel opens and closes."""
        return self.panel is not None and self.place is Place.BELOW_FLOOR
