"""What the welcome page is made of: two large choices, recent rows, the floor behind."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFontMetrics,
    QLinearGradient,
    QPainter,
    QPainterPath,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QPushButton, QSizePolicy, QToolButton, QWidget

from app.core.i18n import tr
from app.core.look.icons import pixmap
from app.core.look.theme import Theme, current_theme, faded, line_height, scaled_font
from app.core.scenes import RecentItem
from app.core.scenes.okabe_ito import ORANGE, SKY_BLUE
from app.core.widgets.command_list import native_keys

_PAD, _BESIDE, _BETWEEN = 18, 12, 6
_LEAST_PX = 60
_PATHS = (
    ((0.06, 0.99), (0.36, 0.80), (0.62, 0.96), (0.91, 0.66), QColor(*ORANGE)),
    ((0.95, 0.99), (0.66, 0.84), (0.40, 0.95), (0.09, 0.68), QColor(*SKY_BLUE)),
)


def from_home(path: str) -> str:
    """The path as people read it: ~ for the user's own folder."""
    try:
        return str("~" / Path(path).relative_to(Path.home()))
    except (ValueError, RuntimeError):  # elsewhere, or nobody has a home here
        return path


class ChoiceButton(QPushButton):
    """A card to press: icon, title, key, and what it does."""

    def __init__(self, drawing: str, title: str, keys: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._drawing, self._title, self._said = drawing, title, ""
        self._keys = native_keys(keys) if keys else ""
        self.setProperty("choice", True)
        self.setAccessibleName(title)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def say(self, text: str) -> None:
        """What it does, under the title."""
        self._said = text
        self.setAccessibleDescription(text)
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Title and three lines, or as many as the words take."""
        title, said = self._heights()
        least = 3 * self.fontMetrics().lineSpacing()
        return QSize(260, title + max(least, said) + 2 * _PAD + _BETWEEN)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802 - Qt's name
        """Words wrap at another place."""
        super().resizeEvent(event)
        self.setMinimumHeight(self.sizeHint().height())
        self.updateGeometry()

    def _heights(self) -> tuple[int, int]:
        """Of the title and of the words below it, at the width there is."""
        title = QFontMetrics(scaled_font(self.font(), 1.2, bold=True))
        room = max(self.width() - 2 * _PAD - title.height() - 4 - _BESIDE, _LEAST_PX)
        beside = max(room - self._keys_px(), _LEAST_PX)
        flags = Qt.TextFlag.TextWordWrap
        words = ((title, self._title, beside), (self.fontMetrics(), self._said, room))
        heights = (
            letters.boundingRect(QRect(0, 0, width, 1 << 16), flags, text).height()
            for letters, text, width in words
        )
        above, below = heights
        return above, below

    def set_keys(self, keys: str) -> None:
        """It has another key by now, in Qt's portable text; "": none."""
        self._keys = native_keys(keys) if keys else ""
        self.updateGeometry()
        self.update()

    def _keys_px(self) -> int:
        """What the keys take from the title's room."""
        letters = QFontMetrics(scaled_font(self.font(), 0.9))
        return letters.horizontalAdvance(self._keys) + _BESIDE if self._keys else 0

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802
        """The card from the stylesheet, then its content."""
        super().paintEvent(event)
        theme, painter = current_theme(), QPainter(self)
        inner = self.rect().adjusted(_PAD, _PAD, -_PAD, -_PAD)
        font = scaled_font(self.font(), 1.2, bold=True)
        metrics, ratio = QFontMetrics(font), self.devicePixelRatioF()
        side, above = metrics.height() + 4, self._heights()[0]
        drawn = pixmap(self._drawing, theme.accent, round(side * ratio))
        drawn.setDevicePixelRatio(ratio)
        painter.drawPixmap(inner.left(), inner.top() - 2, drawn)
        painter.setFont(font)
        painter.setPen(theme.text)
        words = inner.adjusted(side + _BESIDE, 0, 0, 0)
        head = words.adjusted(0, 0, -self._keys_px(), 0)
        painter.drawText(head, Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap, self._title)
        painter.setFont(scaled_font(self.font(), 0.9))
        painter.setPen(theme.text_faint)
        at_right = Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignRight
        painter.drawText(inner.adjusted(0, 2, 0, 0), at_right, self._keys)
        painter.setFont(self.font())
        painter.setPen(theme.text_muted)
        below = words.adjusted(0, above + _BETWEEN, 0, 8)
        painter.drawText(below, Qt.TextFlag.TextWordWrap, self._said)
        painter.end()


class RecentRow(QToolButton):
    """One recording or session: its title, and where it is below."""

    def __init__(self, item: RecentItem, parent: QWidget) -> None:
        super().__init__(parent)
        self._item = item
        self.setEnabled(item.exists)
        self.setAccessibleName(tr("Open {0}").format(item.title))
        self.setToolTip(item.path)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Two lines of text."""
        small = scaled_font(self.font(), 0.9)
        return QSize(240, line_height(self.font()) + line_height(small) + 16)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802
        """The button's ground, then both lines."""
        super().paintEvent(event)
        theme, painter, item = current_theme(), QPainter(self), self._item
        detail = item.detail if item.exists else tr("no longer there")
        below = "  \u00b7  ".join(part for part in (detail, from_home(item.path)) if part)
        quiet = theme.text_muted if item.exists else theme.text_faint
        for text, factor, bold, colour, side in (
            (
                item.title,
                1.0,
                True,
                theme.text if item.exists else quiet,
                Qt.AlignmentFlag.AlignTop,
            ),
            (below, 0.9, False, quiet, Qt.AlignmentFlag.AlignBottom),
        ):
            painter.setFont(scaled_font(self.font(), factor, bold))
            painter.setPen(colour)
            inner = self.rect().adjusted(10, 7, -10, -7)
            middle = Qt.TextElideMode.ElideMiddle
            shown = painter.fontMetrics().elidedText(text, middle, inner.width())
            painter.drawText(inner, side, shown)
        painter.end()


def draw_floor(painter: QPainter, area: QRectF, theme: Theme) -> None:
    """A floor that runs to the horizon, and two people's paths across it, all faint."""
    horizon = area.top() + 0.52 * area.height()
    ground = QLinearGradient(0, horizon, 0, area.bottom())
    ground.setColorAt(0.0, faded(theme.line_strong, 0.0))
    ground.setColorAt(1.0, faded(theme.line_strong, 0.55))
    painter.setPen(QPen(ground, 1.0))
    middle = area.center().x()
    for column in range(-14, 15):
        far = QPointF(middle + column * 0.03 * area.width(), horizon)
        near = QPointF(middle + column * 0.16 * area.width(), area.bottom())
        painter.drawLine(far, near)
    for row in range(1, 9):
        y = horizon + (area.bottom() - horizon) * 0.9 / (1 + 0.55 * (row - 1))
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y))
    for start, pull, push, stop, colour in _PATHS:
        _draw_path(painter, [_inside(area, one) for one in (start, pull, push, stop)], colour)


def _inside(area: QRectF, share: tuple[float, float]) -> QPointF:
    return QPointF(area.left() + share[0] * area.width(), area.top() + share[1] * area.height())


def _draw_path(painter: QPainter, points: list[QPointF], colour: QColor) -> None:
    start, pull, push, stop = points
    path = QPainterPath(start)
    path.cubicTo(pull, push, stop)
    ink = QLinearGradient(start, stop)
    ink.setColorAt(0.0, faded(colour, 0.0))
    ink.setColorAt(1.0, faded(colour, 0.45))
    pen = QPen(ink, 3.0)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawPath(path)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(faded(colour, 0.6))
    painter.drawEllipse(stop, 6.0, 6.0)
