"""A window no larger than its screen."""

from __future__ import annotations

from PySide6.QtCore import QMargins, QPoint, QRect, QSize
from PySide6.QtWidgets import QStyle, QWidget

_BORDER = 4


def fit_to_screen(window: QWidget, wanted: QSize) -> None:
    """Give a window not yet shown the wanted size, or what its screen has room for, centred.

    All in the screen's own units: at a scale of 200 % a screen has room for half as much.
    """
    frame = _frame_of(window)
    place = fitted(window.screen().availableGeometry(), wanted, frame)
    window.resize(place.size())
    window.move(place.marginsAdded(frame).topLeft())


def keep_on_screen(window: QWidget) -> None:
    """Make a window smaller where it is larger than its screen; move it no farther than needed."""
    room = window.screen().availableGeometry().marginsRemoved(_frame_of(window))
    if window.isMaximized() or window.isFullScreen() or room.contains(window.geometry()):
        return
    window.setGeometry(moved_inside(room, window.geometry()))


def moved_inside(room: QRect, wanted: QRect) -> QRect:
    """A rectangle no larger than a room, and inside of it, as near as can be to where it was."""
    size = wanted.size().boundedTo(room.size())
    left = min(max(wanted.left(), room.left()), room.right() + 1 - size.width())
    top = min(max(wanted.top(), room.top()), room.bottom() + 1 - size.height())
    return QRect(QPoint(left, top), size)


def fitted(room: QRect, wanted: QSize, frame: QMargins) -> QRect:
    """Where a window without its frame stands in the middle of a room, with its frame inside."""
    inner = room.marginsRemoved(frame)
    size = wanted.boundedTo(inner.size())
    left = inner.left() + (inner.width() - size.width()) // 2
    top = inner.top() + (inner.height() - size.height()) // 2
    return QRect(QPoint(left, top), size)


def _frame_of(window: QWidget) -> QMargins:
    """What the desktop draws around a window; before it is shown what the style expects."""
    title = window.style().pixelMetric(QStyle.PixelMetric.PM_TitleBarHeight)
    return QMargins(_BORDER, title + _BORDER, _BORDER, _BORDER)
