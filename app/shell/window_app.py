"""The window as commands see it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.core.commands.conditions import ControllerT
from app.core.document.document import Document
from app.core.tracks.frame_state import FrameState, ViewOptions
from app.features.correction.track_panel import TrackPanel
from app.features.timeline.tracks_area import TracksArea
from app.shell.recording_controller import RecordingController

if TYPE_CHECKING:
    from app.shell.files import Files
    from app.shell.main_window import MainWindow


class WindowApp:
    """Gives each command what it needs.

    The controllers are those of the open recording; asking for one while none is open is a mistake
    of the command, which must say that it needs one.
    """

    def __init__(self, window: MainWindow) -> None:
        """The window that the commands are of."""
        self.window = window

    @property
    def document(self) -> Document | None:
        """The open recording; None: none is open."""
        controller = self.window.controller
        return controller.document if controller is not None else None

    @property
    def open(self) -> RecordingController:
        """The controller of the open recording. Raises LookupError where none is open."""
        controller = self.window.controller
        if controller is None:
            raise LookupError("no recording is open")
        return controller

    def of(self, kind: type[ControllerT]) -> ControllerT:
        """The controller of this kind of the open recording."""
        return self.open.of(kind)

    @property
    def busy(self) -> bool:
        """Whether long work other than tracking is going on."""
        return self.window.work.busy

    @property
    def live(self) -> bool:
        """Whether a tracker is at work."""
        return self.document is not None and self.open.live.running

    @property
    def unkept(self) -> bool:
        """Whether what a tracker found is in memory alone."""
        return self.files.keeping.holds

    @property
    def files(self) -> Files:
        """Opens, saves and closes documents."""
        return self.window.files

    @property
    def card(self) -> TrackPanel:
        """The card of the selected track."""
        return self.window.workspace.card

    @property
    def lanes(self) -> TracksArea:
        """The lanes of the timeline."""
        return self.window.workspace.timeline.area

    @property
    def frame_state(self) -> FrameState:
        """The frame as it is shown."""
        return self.open.document.frame_state(self.open.playback.number)

    @property
    def view_options(self) -> ViewOptions:
        """What is laid over the pictures, and plotted."""
        return self.open.view_options

    @view_options.setter
    def view_options(self, view_options: ViewOptions) -> None:
        self.open.set_view_options(view_options)

    @property
    def cameras(self) -> str:
        """Which cameras are shown: "left", "both" or "anaglyph"."""
        return self.open.cameras

    @cameras.setter
    def cameras(self, mode: str) -> None:
        self.open.set_cameras(mode)

    def say(self, text: str) -> None:
        """A passing word for the user."""
        self.window.say(text)
