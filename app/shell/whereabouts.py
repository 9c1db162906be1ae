"""Where the user is in the open document, noted for the next start."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, QTimer

from app.core.widgets.user_settings import Place, UserSettings
from app.shell.recording_controller import RecordingController

_NOTE_MS = 2000


class Whereabouts(QObject):
    """Goes to where a document was left, and notes every few seconds where it is now."""

    def __init__(self, remembered: UserSettings, parent: QObject) -> None:
        super().__init__(parent)
        self._remembered = remembered
        self._controller: RecordingController | None = None
        self._opened = Path()
        self._noted: tuple[tuple[Path, ...], Place] | None = None
        self._timer = QTimer(self, interval=_NOTE_MS)
        self._timer.timeout.connect(self.note)

    def begin(self, controller: RecordingController, opened: Path, from_start: bool) -> None:
        """Go where the document was left, unless it is to be seen from its start."""
        self._controller, self._opened, self._noted = controller, opened, None
        place = Place() if from_start else self._remembered.place(self._paths()[0])
        if place.track in controller.document.tracks.ids:
            controller.document.selection.choose(place.track)
        controller.playback.go(place.frame)
        controller.draw()
        self.note()
        self._timer.start()

    @property
    def opened_by(self) -> Path:
        """The path that the document was opened by."""
        return self._opened

    def note(self) -> None:
        """Write down where the user is, where that is another place than before."""
        if self._controller is None:
            return
        here = Place(
            self._controller.playback.clock.frame, self._controller.document.selection.track
        )
        if self._noted != (self._paths(), here):
            self._noted = self._paths(), here
            self._remembered.note_open(self._paths(), here)

    def end(self) -> None:
        """The document is let go as it should be."""
        self._timer.stop()
        self.note()
        self._controller = None
        self._remembered.note_closed()

    def _paths(self) -> tuple[Path, ...]:
        """What is open: the session where there is one, then what was asked for."""
        session = self._controller.document.session if self._controller is not None else None
        paths = (session.path if session is not None else None, self._opened)
        return tuple(dict.fromkeys(path.resolve() for path in paths if path is not None))
