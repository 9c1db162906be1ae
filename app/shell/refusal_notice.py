"""What the window tells of what went wrong or cannot be done, and when that is over."""

from __future__ import annotations

from typing import TYPE_CHECKING

from app.core.i18n import strip_full_stop, tr
from app.core.scenes import CommandItem
from app.shell.menus import TypingGuard

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

_BEGIN_TYPING = frozenset({"tracks.rename", "tracks.attributes", "tracks.notes"})
"""Commands after which text is typed."""
_LEAVE = "tracks.none"


class RefusalNotice:
    """Says in the window's notice why not, and takes it back once it is no longer so."""

    def __init__(self, window: MainWindow, guard: TypingGuard) -> None:
        self._window, self._notice, self._guard = window, window.notice, guard
        self._refused = ""
        self._passing = "", "", ""
        self._told_after: tuple[object, ...] = ()
        self._notice.spoken.connect(self._note_edits)

    def refuse(self, item: CommandItem) -> None:
        """Say why a command cannot be done; text typed after it must run no other ones.

        Esc where there is nothing to leave is what many press to be sure: nothing is said of it.
        """
        if item.command == _LEAVE:
            return
        said = tr("{title}: {why}", title=item.title.rstrip("."), why=item.why_not)
        if item.command not in _BEGIN_TYPING:
            self._window.say(said)
            self._passing = item.command, item.why_not, said
            return
        self._guard.hold()
        said = tr("{said}. Keys typed now have no effect.", said=strip_full_stop(said))
        self._notice.say(said, is_error=True, passing=True)
        self._refused = said

    def settle(self) -> None:
        """Take back what holds no more, or was told before an edit, or until one may type."""
        self._settle_passing()
        self._notice.take_back_untrue()
        if self._edits() != self._told_after or self._may_type_now:
            self._notice.settle()

    def _settle_passing(self) -> None:
        """Take the passing word back once its command can be done, or not for another reason."""
        command, why, said = self._passing
        if not said:
            return
        line = self._window.statusBar()
        still = self._window.registry.item(command).why_not
        if line.currentMessage() == said and still == why:
            return
        self._passing = "", "", ""
        if line.currentMessage() == said:
            line.clearMessage()

    def _note_edits(self) -> None:
        self._told_after = self._edits()

    def _edits(self) -> tuple[object, ...]:
        """What differs once an edit was done, undone or redone."""
        session = self._window.files.session
        if session is None:
            return ()
        history = session.history
        steps = (history.next_undo, history.next_redo)
        return id(session), len(history), *(step.id if step else 0 for step in steps)

    @property
    def _may_type_now(self) -> bool:
        """Somebody is selected by now, and that nobody was is still told."""
        controller = self._window.controller
        told = self._notice.text == self._refused != ""
        return told and controller is not None and bool(controller.document.selection)
