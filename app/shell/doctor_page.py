"""Help > Check this recording: the doctor's page, and what follows once files were mended."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.core.controller import Controller
from app.core.i18n import tr
from app.features.doctor.controller import DoctorController

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow


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
        self.page = DoctorController(recording.path, recording.name, self._window)
        self.page.closed.connect(self._close)
        self.page.open()

    def _close(self, changed: bool) -> None:
        """Open the recording anew where nothing was tracked yet; say what to do where it was."""
        self.page = None
        controller = self._window.controller
        if not changed or controller is None:
            return
        document = controller.document
        if document.session is None or not len(document.session.runs):
            self._window.files.open_path(document.recording.path)
            return
        self._window.notice.say(
            tr(
                "The recording's files were mended. Tracks made before keep their positions: open "
                "the recording again and track it anew to use them."
            )
        )
