"""Letting the open document go: what would be lost is asked for, one thing at a time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMessageBox

from app.core.document import document_loader
from app.core.widgets.questions import ask_about_unsaved
from app.features.files.left_behind import (
    changes_unsaved,
    never_saved,
    result_in_memory,
    tracker_at_work,
    tracker_stopping,
)

if TYPE_CHECKING:
    from app.shell.files import Files
    from app.shell.main_window import MainWindow

Then = Callable[[], object]


def _nothing() -> None:
    """The document stays open, and that is all."""


class ClosePrompts:
    """Asks before a tracker's findings or unsaved changes of the open document are lost."""

    def __init__(self, files: Files, window: MainWindow) -> None:
        self._files = files
        self._window = window
        self._agreed = False
        self._asked: tuple[QMessageBox, str, Then] | None = None

    def agree(self) -> None:
        """Ask nothing the next time."""
        self._agreed = True

    def asks(self) -> bool:
        """Whether something was done here that is not saved, and nobody agreed to leave that.

        Counts an agreement once.
        """
        agreed, self._agreed = self._agreed, False
        return not agreed and self._files.saving.changed_here

    def may_leave(self, again: Then, stay: Then = _nothing) -> bool:
        """Whether the document can be let go; if not, ask, and do `again` afterwards.

        stay: done where the answer is to keep it open.
        """
        if not self.asks():
            return True
        if self._files.tracker_found_some:
            self._ask(None, lambda: self._drop_tracked(again), again, stay)
        else:
            save, discard = lambda: self._save(again), lambda: self._discard(again)
            self._ask(save, discard, again, stay)
        return False

    def settle(self) -> None:
        """Take a question back that tells a loss there no longer is; ask what is left to ask.

        A tracker may have ended, and its result be on disk, since it was asked.
        """
        if self._asked is None or self._files.keeping.at_work:
            return
        box, lost, again = self._asked
        if self._words()[1] != lost:
            box.close()
            if self._files.saving.changed_here:
                again()

    def _ask(self, save: Then | None, discard: Then, again: Then, stay: Then) -> None:
        words = self._words()
        box = ask_about_unsaved(self._window, words, save, discard, stay)
        self._asked = box, words[1], again
        box.finished.connect(lambda _: self._forget(box))

    def _forget(self, box: QMessageBox) -> None:
        """The answer may have asked the next question already."""
        if self._asked is not None and self._asked[0] is box:
            self._asked = None

    def _words(self) -> tuple[str, str]:
        """The question, which names what it is about, and what is lost."""
        controller, session = self._files.controller, self._files.session
        if controller is None:
            return "", ""
        name = controller.document.recording.name
        if self._files.tracker_found_some:
            if controller.live.stopping:
                return tracker_stopping(name, controller.live.tracker)
            return tracker_at_work(name, controller.live.tracker, controller.live.status)
        if session is None:
            return result_in_memory(name)
        if session.path is None or document_loader.is_unsaved_place(session.path):
            return never_saved(name)
        return changes_unsaved(session.path.name, name)

    def _drop_tracked(self, again: Then) -> None:
        """Only what the tracker found goes; `again` asks about edits, where there are any."""
        if self._files.controller is not None:
            self._files.controller.tracking.drop()
        again()

    def _save(self, again: Then) -> None:
        def leave() -> None:
            self.agree()
            again()

        self._files.saving.save(leave)

    def _discard(self, again: Then) -> None:
        """What was discarded is not shown any longer, whether or not something else opens."""
        if self._files.session is not None:
            document_loader.discard(self._files.session)
        self._files.close()
        self._window.show_start()
        again()
