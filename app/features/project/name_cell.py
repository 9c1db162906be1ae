"""The first cell of a recording: its image, its name, and a line below."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QFontMetrics, QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from app.core.look.icons import pixmap
from app.core.look.theme import current_theme, line_height, scaled_font
from app.features.project.list_model import ROW, RecordingModel
from app.features.project.scene import Mood, RecordingRow

_PAD = 4
_GAP = 10
_SMALL = 0.9
_ASPECT = 16 / 9


def row_height(metrics: QFontMetrics) -> int:
    """Of every row: two lines, with room for an image that shows something."""
    return 3 * metrics.height() + 2 * _PAD


class NameCell(QStyledItemDelegate):
    """Draws the first column; the others are Qt's own."""

    def __init__(self, model: RecordingModel) -> None:
        super().__init__(model)
        self._model = model

    def sizeHint(  # noqa: N802 - Qt's name
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        """As wide as the name is, and as high as every other row."""
        height = row_height(option.fontMetrics)
        row: RecordingRow = index.data(ROW)
        words = option.fontMetrics.horizontalAdvance(row.name)
        return QSize(_image_width(height) + words + 3 * _GAP, height)

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        """The ground of the row, then its content."""
        row: RecordingRow = index.data(ROW)
        blank = QStyleOptionViewItem(option)
        self.initStyleOption(blank, index)
        blank.text = ""
        style = option.widget.style()
        style.drawControl(QStyle.ControlElement.CE_ItemViewItem, blank, painter, option.widget)
        painter.save()
        inner = option.rect.adjusted(_GAP, _PAD, -_PAD, -_PAD)
        room = QRect(inner.left(), inner.top(), _image_width(option.rect.height()), inner.height())
        self._draw_image(painter, room, row)
        self._draw_words(painter, inner.adjusted(room.width() + _GAP, 0, 0, 0), option, row)
        painter.restore()

    def _draw_image(self, painter: QPainter, room: QRect, row: RecordingRow) -> None:
        theme, image = current_theme(), self._model.image(row)
        if image.isNull():
            painter.fillRect(room, theme.sunken)
            side = room.height() // 2
            ratio = painter.device().devicePixelRatioF()
            film = pixmap("film", theme.text_faint, round(side * ratio))
            film.setDevicePixelRatio(ratio)
            painter.drawPixmap(room.center().x() - side // 2, room.center().y() - side // 2, film)
            return
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        size = image.size().scaled(room.size(), Qt.AspectRatioMode.KeepAspectRatio)
        shown = QRect(0, 0, size.width(), size.height())
        shown.moveCenter(room.center())
        painter.drawPixmap(shown, image)

    def _draw_words(
        self, painter: QPainter, room: QRect, option: QStyleOptionViewItem, row: RecordingRow
    ) -> None:
        theme = current_theme()
        small = scaled_font(option.font, _SMALL)
        lines = line_height(option.font) + line_height(small)
        top = room.top() + max(0, room.height() - lines) // 2
        middle, end = Qt.TextElideMode.ElideMiddle, Qt.TextElideMode.ElideRight
        muted = theme.danger if row.mood is Mood.BAD else theme.text_muted
        for font, text, ink, cut in (
            (option.font, row.name, theme.text, middle),
            (small, row.detail, muted, end),
        ):
            metrics = QFontMetrics(font)
            painter.setFont(font)
            painter.setPen(ink)
            shown = metrics.elidedText(text, cut, room.width())
            painter.drawText(room.left(), top + metrics.ascent(), shown)
            top += line_height(font)


def _image_width(height: int) -> int:
    return round((height - 2 * _PAD) * _ASPECT)
