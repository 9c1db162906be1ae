"""A line or two that tell what went wrong, or well, without standing in the way."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QStatusBar, QWidget

from app.core.i18n import tr

_PASSES_MS = 60_000
_LINES = 2
"""More of a text is shown once it is asked for: it would lie over the overview and lanes."""
_EDGE_PX, _APART_PX = 16, 12
_MOVES = (QEvent.Type.Resize, QEvent.Type.Move, QEvent.Type.Show, QEvent.Type.Hide)
_HIGH_PX = 1_000_000
_ELLIPSIS = "\u2026"
_READ_S = 4.0
"""After this time a passing word has been read by whoever goes on working."""


def _always() -> bool:
    """What is said whatever becomes of the rest."""
    return True


class NoticeBar(QFrame):
    """One message across a window, hidden while there is none.

    It lies over the line at the window's lower edge while that is free, else over the page above
    it: what is being looked at, or aimed at with the mouse, does not move. Of a long text it shows
    two lines, and a button that shows all.

    Signals: `spoken()`, another message is shown.
    """

    spoken = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._said = ""
        self._do: Callable[[], object] | None = None
        self._holds: Callable[[], bool] = _always
        self._settles = False
        self._said_s = 0.0
        self._page: QWidget | None = None
        self._line: QStatusBar | None = None
        self._progress: QWidget | None = None
        self._last: QWidget | None = None
        self._passing = QTimer(self, singleShot=True, interval=_PASSES_MS)
        self._passing.timeout.connect(self.hide)
        self.setProperty("notice", "true")
        self.setAccessibleName(tr("Message"))
        row = QHBoxLayout(self)
        row.setContentsMargins(_EDGE_PX, 1, _EDGE_PX, 1)
        row.setSpacing(_APART_PX)
        self._text = QLabel(self)
        self._text.setWordWrap(True)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._action = QPushButton(self)
        self._action.clicked.connect(self._act)
        self._more = QPushButton(self)
        self._more.setCheckable(True)
        self._more.toggled.connect(self._place)
        self._close = QPushButton(tr("Close"), self)
        self._close.clicked.connect(self.hide)
        row.addWidget(self._text, 1)
        for button in (self._more, self._action, self._close):
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            row.addWidget(button)
        self.hide()

    def stand_over(self, page: QWidget, line: QStatusBar, progress: QWidget, last: QWidget) -> None:
        """Lie over the lower edge of a window from now on, as wide as its page: people are above.

        Words on the line below the page, and progress there, stay to be seen, and so does what
        stands `last` on that line.
        """
        self.setParent(page.window())
        self._page, self._line, self._progress, self._last = page, line, progress, last
        for widget in (page, progress, last):
            widget.installEventFilter(self)
        line.messageChanged.connect(lambda _: self._place())
        self._place()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Stay as wide as the page, and beside what the line tells."""
        if event.type() in _MOVES:
            self._place()
        return super().eventFilter(watched, event)

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Be as high as the text is in another font."""
        super().changeEvent(event)
        if event.type() is QEvent.Type.FontChange:
            self._place()

    def _place(self) -> None:
        if self._page is None or self._line is None:
            return
        page = self._page.geometry()
        free = not (self._line.currentMessage() or self._is_under_way)
        line = self._line.height() if free else 0
        width = page.width() if not free else page.width() - self._taken_px(page.right())
        self._fold(width)
        least = max(self.heightForWidth(width), line)
        self.setGeometry(page.left(), page.bottom() + 1 + line - least, width, least)
        self.raise_()

    def _taken_px(self, right: int) -> int:
        """How much of the line, at its end, is to stay in sight."""
        if self._last is None or self._line is None or self._last.isHidden():
            return 0
        return right + 1 - self._line.mapToParent(self._last.pos()).x() + _APART_PX // 2

    def _fold(self, width: int) -> None:
        """Leave out what has no room on two lines, unless all of it was asked for."""
        buttons = [one for one in (self._action, self._close) if not one.isHidden()]
        cut = self._cut(width, buttons)
        self._more.setVisible(cut != self._said)
        self._more.setText(tr("Less") if self._more.isChecked() else tr("More"))
        if cut != self._said:
            cut = self._cut(width, [self._more, *buttons])
        self._text.setText(self._said if self._more.isChecked() else cut)

    def _cut(self, width: int, buttons: list[QPushButton]) -> str:
        room = width - 2 * _EDGE_PX - sum(_APART_PX + one.sizeHint().width() for one in buttons)
        return _cut_to_lines(self._said, self._text.fontMetrics(), room, _LINES)

    @property
    def least_height(self) -> int:
        """What as many lines take as a text is cut to."""
        return _LINES * self._text.fontMetrics().lineSpacing() + 3

    @property
    def _is_under_way(self) -> bool:
        return self._progress is not None and not self._progress.isHidden()

    @property
    def text(self) -> str:
        """What is said; "" while hidden."""
        return "" if self.isHidden() else self._said

    @property
    def action_text(self) -> str:
        """What the offered button says; "" where there is none."""
        return self._action.text()

    def say(
        self,
        text: str,
        action: str = "",
        do: Callable[[], object] | None = None,
        *,
        is_error: bool = False,
        passing: bool = False,
        holds: Callable[[], bool] = _always,
    ) -> None:
        """Show a message, with a button where there is something to `do` about it.

        One that is `passing` goes by itself after a minute, or when it is to `give_way`; any goes
        once it `holds` no more.
        """
        self._do, self._said_s, self._holds = do, time.monotonic(), holds
        self._settles = (is_error or passing) and do is None
        if passing:
            self._passing.start()
        else:
            self._passing.stop()
        self._tint("error" if is_error else "true")
        self.setAccessibleName(tr("Error") if is_error else tr("Message"))
        self._said = text
        self._more.setChecked(False)
        self._text.setText(text)
        self._text.setAccessibleName(text)
        self._action.setText(action)
        self._action.setVisible(bool(action))
        self.show()
        self._place()
        self.spoken.emit()

    def settle(self) -> None:
        """Something went well: an error that was told is over, and so is a passing word.

        What offers a button stays: it is still to be answered.
        """
        if self._settles:
            self.hide()

    def take_back_untrue(self) -> None:
        """Something is another by now: what holds no more goes, whatever it is."""
        if not self.isHidden() and not self._holds():
            self.hide()

    def give_way(self) -> None:
        """The user goes on working: a passing word that was there long enough goes."""
        if self._passing.isActive() and time.monotonic() - self._said_s > _READ_S:
            self.hide()

    def _tint(self, notice: str) -> None:
        """Have the stylesheet draw another kind of notice."""
        if self.property("notice") != notice:
            self.setProperty("notice", notice)
            self.style().unpolish(self)
            self.style().polish(self)

    def _act(self) -> None:
        self.hide()
        if self._do is not None:
            self._do()


def _cut_to_lines(text: str, metrics: QFontMetrics, width: int, lines: int) -> str:
    """The text, or its first words and an ellipsis where all would take more lines."""
    room = QRect(0, 0, max(1, width - metrics.averageCharWidth()), _HIGH_PX)

    def fits(part: str) -> bool:
        taken = metrics.boundingRect(room, Qt.TextFlag.TextWordWrap, part)
        return taken.height() <= lines * metrics.lineSpacing()

    if fits(text):
        return text
    words = text.split(" ")
    low, high = 1, len(words)
    while low < high:
        middle = (low + high + 1) // 2
        if fits(" ".join(words[:middle]) + _ELLIPSIS):
            low = middle
        else:
            high = middle - 1
    return " ".join(words[:low]) + _ELLIPSIS
