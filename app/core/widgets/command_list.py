"""Rows of the command palette: title, menu, key."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetrics, QFontMetricsF, QKeySequence, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from app.core.look.theme import current_theme, scaled_font
from app.core.scenes import CommandItem

ITEM = Qt.ItemDataRole.UserRole
_SIDE = 12


def native_keys(keys: str) -> str:
    """A key sequence as it is written on this machine."""
    portable = QKeySequence(keys, QKeySequence.SequenceFormat.PortableText)
    return portable.toString(QKeySequence.SequenceFormat.NativeText) or keys


def row_height(metrics: QFontMetrics) -> int:
    """Of a command's row."""
    return metrics.height() + 14


def draw_row_ground(painter: QPainter, option: QStyleOptionViewItem) -> None:
    """The rounded ground of a selected row or of the one under the cursor."""
    theme = current_theme()
    if option.state & QStyle.StateFlag.State_Selected:
        painter.setBrush(theme.selection)
    elif option.state & QStyle.StateFlag.State_MouseOver:
        painter.setBrush(theme.hover)
    else:
        return
    painter.setPen(Qt.PenStyle.NoPen)
    painter.drawRoundedRect(option.rect.adjusted(0, 1, 0, -1), 6, 6)


class CommandDelegate(QStyledItemDelegate):
    """Draws a :class:`CommandItem`; one that is not enabled is greyed and says why."""

    def sizeHint(  # noqa: N802 - Qt's name
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        """One line."""
        del index
        return QSize(64, row_height(QFontMetrics(option.font)))

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        """Ground, key, title, menu."""
        item: CommandItem = index.data(ITEM)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        draw_row_ground(painter, option)
        inner = QRectF(option.rect).adjusted(_SIDE, 0, -_SIDE, 0)
        inner.setRight(self._draw_key(painter, item, inner, option.font))
        self._draw_words(painter, item, inner, option.font)
        painter.restore()

    def _draw_words(self, painter: QPainter, item: CommandItem, inner: QRectF, font: QFont) -> None:
        theme = current_theme()
        painter.setFont(font)
        painter.setPen(theme.text if item.enabled else theme.text_disabled)
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.drawText(inner, middle, item.title)
        inner.setLeft(inner.left() + QFontMetricsF(font).horizontalAdvance(item.title) + 10)
        painter.setFont(scaled_font(font, 0.9))
        painter.setPen(theme.text_faint)
        words = item.menu if item.enabled else item.why_not or item.menu
        elided = painter.fontMetrics().elidedText(
            words, Qt.TextElideMode.ElideRight, max(0, round(inner.width()))
        )
        painter.drawText(inner, middle, elided)

    def _draw_key(self, painter: QPainter, item: CommandItem, inner: QRectF, font: QFont) -> float:
        """Draw the first key at the right; where the room left of it ends."""
        if not item.keys:
            return inner.right()
        theme, small = current_theme(), scaled_font(font, 0.88)
        metrics, text = QFontMetricsF(small), native_keys(item.keys[0])
        width, height = metrics.horizontalAdvance(text) + 14, metrics.height() + 4
        plate = QRectF(inner.right() - width, inner.center().y() - height / 2, width, height)
        painter.setPen(QPen(theme.line_strong, 1.0))
        painter.setBrush(theme.raised)
        painter.drawRoundedRect(plate, 4, 4)
        painter.setFont(small)
        painter.setPen(theme.text_muted if item.enabled else theme.text_disabled)
        painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)
        return plate.left() - 8
