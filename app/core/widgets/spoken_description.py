"""What is told to screen readers of a view that is painted: what it shows, who is selected."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QWidget

from app.core.i18n import count_text, joined_text, some_of, tr

_AT_REST_MS = 300
_MOST_TOLD = 20


class SpokenDescription(QObject):
    """Keeps a widget's accessible description; words are made once it has come to rest.

    While frames follow each other nothing is made, so that playing costs nothing.
    """

    def __init__(self, widget: QWidget, words: Callable[[], str]) -> None:
        super().__init__(widget)
        self._widget, self._words = widget, words
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(_AT_REST_MS)
        self._rest.timeout.connect(self._tell)
        widget.installEventFilter(self)

    def changed(self) -> None:
        """The widget shows something else: tell it if nothing follows for a moment."""
        self._rest.start()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Tell it in another language."""
        if event.type() == QEvent.Type.LanguageChange:
            self.changed()
        return super().eventFilter(watched, event)

    def _tell(self) -> None:
        words = self._words()
        if words != self._widget.accessibleDescription():
            self._widget.setAccessibleDescription(words)


def told_people(people: Sequence[str], selected: Sequence[str]) -> list[str]:
    """How many people there are and who, and who of them is selected; of many the first ones."""
    told = [count_text(len(people), "{n} person", "{n} people")]
    if people:
        told[0] = tr("{people}: {names}", people=told[0], names=some_of(people, _MOST_TOLD))
    if selected:
        told.append(tr("Selected: {names}", names=joined_text(", ", selected)))
    return told


def told_lines(*lines: str) -> str:
    """Lines that say something, one below the other."""
    return "\n".join(filter(None, lines))
