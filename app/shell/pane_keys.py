"""The keyboard inside the parts of the window: F6 to a part, Tab from control to control in it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QTabBar,
    QTableWidget,
    QWidget,
)
from shiboken6 import isValid

from app.core.drawing.canvas import Canvas
from app.core.widgets.id_edit import IdEdit
from app.core.widgets.parts import bring_into_view
from app.core.widgets.tab_order import widgets_in_order
from app.shell.pane_ring import PaneRing

_WHOLE = (QAbstractItemView, QAbstractSpinBox, QComboBox, QTabBar)
"""Controls that are made of others."""
_CONTROLS = (*_WHOLE, QAbstractButton, QLineEdit, QPlainTextEdit)
_TYPED_INTO = (QLineEdit, QPlainTextEdit, QAbstractSpinBox, QComboBox, QTableWidget)
_PRESSED = (QAbstractButton,)
_STEPS = {Qt.Key.Key_Tab: 1, Qt.Key.Key_Backtab: -1}
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
_ALT_OR_CTRL = Qt.KeyboardModifier.AltModifier | Qt.KeyboardModifier.ControlModifier


@dataclass(frozen=True, slots=True)
class Panes:
    """The parts of a window that the keyboard goes to.

    Attributes:
        home: where it is usually. open: all parts that are open, in their order. lists: parts
            whose list is walked as soon as one comes there. show: brings a part to the front that
            shares its place with others.
    """

    home: QWidget
    open: Callable[[], Sequence[QWidget]]
    lists: Callable[[], Sequence[QWidget]]
    show: Callable[[QWidget], None]


class PaneKeys(QObject):
    """Walks the parts of a window, and the controls of a part that was gone to by keys.

    There Tab and Shift+Tab go from control to control, Space presses a button, Enter takes a row
    of a list, Escape gives the keyboard back. Elsewhere these keys are what they are: Tab selects
    people, Space plays. A click leaves them so: it gives no part the ring.
    """

    def __init__(self, panes: Panes, ring: PaneRing) -> None:
        super().__init__(panes.home)
        self._panes, self._ring = panes, ring
        self._watched: QWidget | None = None
        self._pane: QWidget | None = None
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._watch)

    def go(self, step: int) -> None:
        """Give the keyboard to the part that is so many further, and lay the ring around it."""
        panes = list(self._panes.open())
        now = _pane_of(panes, QApplication.focusWidget())
        at = panes.index(now) + step if now is not None else min(step, 0)
        pane = panes[at % len(panes)]
        self._panes.show(pane)
        bring_into_view(pane)
        self._focus(_first(pane) if pane in self._panes.lists() else _sheet(pane))
        self._begin(pane)

    def leave(self) -> bool:
        """Give the keyboard back from a part that was gone to by keys; whether it was there."""
        if not self._is_walking:
            return False
        self._focus(self._panes.home)
        return True

    def stay(self, gone: QWidget | None) -> bool:
        """Have the keyboard stay in its part where the control that had it is hidden or greyed.

        Returns whether it was.
        """
        if gone is None or (gone.isVisible() and gone.isEnabled()):
            return False
        pane = self._pane
        inside = pane is not None and pane.isVisible() and pane.isAncestorOf(gone)
        self._focus(pane if pane is not None and inside else self._panes.home)
        return True

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Keep the keys of a walk from being the window's, and do what they say."""
        if isinstance(event, QKeyEvent) and isinstance(watched, QWidget):
            if event.type() == QEvent.Type.ShortcutOverride:
                if self._is_of_walk(watched, event):
                    event.accept()
                    return True
            elif event.type() == QEvent.Type.KeyPress:
                return self._do(watched, event)
        return super().eventFilter(watched, event)

    def _is_of_walk(self, widget: QWidget, event: QKeyEvent) -> bool:
        if event.modifiers() & _ALT_OR_CTRL:
            return False
        if event.key() in _STEPS:
            return self._walked(widget) is not None
        pressed = event.key() == Qt.Key.Key_Space and isinstance(widget, _PRESSED)
        return self._is_walking and (pressed or event.key() == Qt.Key.Key_Escape)

    def _do(self, widget: QWidget, event: QKeyEvent) -> bool:
        if event.modifiers() & _ALT_OR_CTRL:
            return False
        pane = self._walked(widget)
        if event.key() in _STEPS and pane is not None:
            self._walk(pane, widget, _STEPS[Qt.Key(event.key())])
            return True
        if event.key() in _ENTER and self._is_walking:
            return _take_row(widget)
        return _choose_tab(widget, event.key())

    def _walked(self, widget: QWidget) -> QWidget | None:
        """The part whose controls Tab goes through now; None where Tab means something else."""
        around = widget.parentWidget()
        if around is not None and isinstance(around.parentWidget(), QAbstractItemView):
            return None  # a cell that is typed into, whose table knows the next one
        pane = _pane_of(self._panes.open(), widget)
        if pane is None or isinstance(pane, Canvas):
            return None
        typed = isinstance(widget, _TYPED_INTO) and not isinstance(widget, IdEdit)
        return pane if typed or pane is self._pane else None

    def _walk(self, pane: QWidget, now: QWidget, step: int) -> None:
        found = controls_of(pane)
        if not found:
            return
        inside = [at for at, one in enumerate(found) if one is now or one.isAncestorOf(now)]
        exact = [at for at in inside if found[at] is now] or inside[-1:]
        following = found[(exact[0] + step if exact else min(step, 0)) % len(found)]
        bring_into_view(following)
        following.setFocus(Qt.FocusReason.TabFocusReason)
        if self._pane is not pane:
            self._begin(pane)

    def _begin(self, pane: QWidget) -> None:
        self._pane = pane
        self._ring.show_around(pane)

    @property
    def _is_walking(self) -> bool:
        """Whether a part was gone to by keys whose controls can be walked; an image has none."""
        return self._pane is not None and not isinstance(self._pane, Canvas)

    def _focus(self, widget: QWidget) -> None:
        if not widget.isActiveWindow():
            widget.activateWindow()
        widget.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _watch(self, before: QWidget | None, now: QWidget | None) -> None:
        """Hear the keys of whoever has the keyboard; who gave it up in a walk gives it back."""
        if self._watched is not None and isValid(self._watched):  # gone with its dialog
            self._watched.removeEventFilter(self)
        self._watched = now
        if now is not None:
            now.installEventFilter(self)
        pane = self._pane
        if pane is None or now is pane or (now is not None and pane.isAncestorOf(now)):
            return
        self._pane = None
        if before is None or not isValid(before):
            return
        if now is None and before.isActiveWindow():
            self._focus(self._panes.home)


def controls_of(pane: QWidget) -> list[QWidget]:
    """What can be acted on in a part now, in reading order; what no layout holds comes last."""
    read = list(widgets_in_order(pane))
    laid_out = set(read)
    rest = (one for one in pane.findChildren(QWidget) if one not in laid_out)
    return [one for one in (*read, *rest) if _is_control(one)]


def _is_control(widget: QWidget) -> bool:
    if not widget.isVisible() or not widget.isEnabled() or widget.objectName().startswith("qt_"):
        return False
    if isinstance(widget, QLabel) or isinstance(widget.parentWidget(), (*_WHOLE, QLineEdit)):
        return False
    return isinstance(widget, _CONTROLS) or (_takes_clicks(widget) and widget.focusProxy() is None)


def _pane_of(panes: Sequence[QWidget], widget: QWidget | None) -> QWidget | None:
    inside = (
        pane
        for pane in panes
        if widget is not None and (pane is widget or pane.isAncestorOf(widget))
    )
    return next(inside, None)


def _sheet(pane: QWidget) -> QWidget:
    """What is drawn on over an image while something is labelled, else the image itself."""
    inside = (one for one in pane.findChildren(QWidget) if isinstance(pane, Canvas))
    sheets = (one for one in inside if one.isVisible() and _takes_clicks(one))
    return next(sheets, pane)


def _takes_clicks(widget: QWidget) -> bool:
    return bool(widget.focusPolicy() & Qt.FocusPolicy.ClickFocus)


def _first(pane: QWidget) -> QWidget:
    """The list of a part, which can be walked then; where it has none, the part itself."""
    lists = (one for one in pane.findChildren(QAbstractScrollArea) if one.isVisible())
    return next(lists, pane)


def _take_row(widget: QWidget) -> bool:
    """Enter in a list is a click on its row; cells of a table are typed into."""
    if not isinstance(widget, QAbstractItemView) or isinstance(widget, QTableWidget):
        return False
    if widget.currentIndex().isValid():
        widget.clicked.emit(widget.currentIndex())
    return True


def _choose_tab(widget: QWidget, key: int) -> bool:
    """Up and Down go from tab to tab: Left and Right are frames."""
    steps = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}
    if not isinstance(widget, QTabBar) or key not in steps:
        return False
    widget.setCurrentIndex((widget.currentIndex() + steps[Qt.Key(key)]) % widget.count())
    return True
