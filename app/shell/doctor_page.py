"""Help > Check this recording: the doctor's page, and what follows once files were mended."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from app.core.controller import Controller
from app.core.i18n import tr
from app.features.doctor.controller import DoctorController
from app.features.doctor.presenter import Place

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow
    from app.shell.recording_controller import RecordingController


class DoctorPage(Controller):
    """Opens the doctor's page over a window."""

    def __init__(self, window: MainWindow, parent: Controller) -> None:
        super().__init__(parent)
        self._window = window
        self.page: DoctorController | None = None

    def ask(self) -> None:
        """Check the open recording."""
        controller = self._window.controller
        if controller is None or self.page is not None:
            return
        recording = controller.document.recording
        self.page = DoctorController(Place.of(recording), recording.name, self._window)
        self.page.closed.connect(partial(self._close, controller))
        self.page.open()

    def close(self) -> None:
        """End with the recording: a mend at work is waited for."""
        if self.page is not None:
            self.page.end()
            self.page.deleteLater()
            self.page = None

    def _close(self, controller: RecordingController, changed: bool, problem: str) -> None:
        """Open the recording anew where nothing was tracked yet; say what to do where it was."""
        self.page = None
        if problem:
            self._window.notice.say(problem, is_error=True)
        if not changed or self._window.controller is not controller:
            return
        document = controller.document
        if document.session is None or not len(document.session.runs):
            place = Place.of(document.recording)
            self._window.files.open_path(place.path, options=place.options)
            return
        self._window.notice.say(
            tr(
                "The recording's files were mended. Tracks made before keep their positions: open "
                "the recording again and track it anew to use them."
            )
        )
