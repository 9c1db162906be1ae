"""The window there is now: another takes its place where the language of the program changes."""

from __future__ import annotations

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication

from app.core.widgets.user_settings import UserSettings
from app.shell.hand_over import OpenWork, hand_over, look_again, take_over
from app.shell.language_choice import show_language
from app.shell.main_window import MainWindow


class WindowHost(QObject):
    """Holds the window, and builds it anew, with all that is open in it.

    Attributes: `window`, the one there is now.
    """

    def __init__(self, application: QApplication, remembered: UserSettings) -> None:
        super().__init__(application)
        self._application, self._remembered = application, remembered
        self.window: MainWindow = self._built()

    def _built(self) -> MainWindow:
        window = MainWindow(self._remembered)
        window.language_choice.changed.connect(self.build_again)
        return window

    def build_again(self) -> None:
        """Build the window in the language that was chosen; nothing is closed, nothing asked."""
        old = self.window
        jobs = old.work.jobs.lines
        project = old.files.projects.folder
        old.remember_layout()
        work = hand_over(old)
        show_language(self._application, self._remembered)
        self.window = new = self._built()
        new.work.jobs.take_over(jobs)
        if project is not None:
            new.files.projects.project.open(project, new.files.author.name)
        if work is not None:
            take_over(new.files, work)
        elif project is not None:
            new.show_start()
        self._put_in_place(old, new, work)

    def _put_in_place(self, old: MainWindow, new: MainWindow, work: OpenWork | None) -> None:
        """Show the new window where the old one stands; the old one ends."""
        new.setGeometry(old.geometry())
        new.setWindowState(old.windowState())
        new.show()
        if work is not None:
            look_again(new, work)
        old.close()
        old.deleteLater()
        new.activateWindow()
        new.tell_of_letters()
