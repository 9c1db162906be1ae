"""Draws the small pictures of a review item side by side."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.core.i18n import tr
from app.core.look.theme import current_theme, scaled_font
from app.features.review.strip import StripPicture, StripScene

_GAP, _LEAST_PX = 4, 24
_SHAPE = 0.8
"""Height of a picture for its width, where there is room."""


class StripView(QWidget):
    """Pictures with their times below; on a low screen it gives its room to the list."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._scene = StripScene()
        self._images: tuple[QImage, ...] = ()
        self.setFont(scaled_font(self.font(), 0.8))
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Maximum)
        self.show_scene(StripScene())

    def show_scene(self, scene: StripScene) -> None:
        """Show the pictures of another review item; none hide it."""
        self._scene = scene
        self._images = tuple(_image(picture) for picture in scene.pictures)
        self.setAccessibleName(tr("Pictures before, at and after"))
        self.setAccessibleDescription(scene.text)
        self.setToolTip(scene.text)
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """As high as its pictures are at a usual width."""
        letters = self.fontMetrics()
        width = 14 * letters.averageCharWidth()
        return QSize(3 * width, round(_SHAPE * width) + letters.height())

    def minimumSizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """It may be left out."""
        return QSize(0, 0)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        """Draw them."""
        del event
        count, line = len(self._images), self.fontMetrics().height()
        if not count or self.height() < _LEAST_PX + line:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        width = (self.width() - (count - 1) * _GAP) / count
        pairs = zip(self._images, self._scene.pictures, strict=True)
        for number, (image, picture) in enumerate(pairs):
            room = QRectF(number * (width + _GAP), 0, width, self.height() - line)
            self._draw(painter, image, picture, room)
        painter.end()

    def _draw(self, painter: QPainter, image: QImage, picture: StripPicture, room: QRectF) -> None:
        size = image.size().toSizeF().scaled(room.size(), Qt.AspectRatioMode.KeepAspectRatio)
        place = QRectF(QPointF(0, 0), size)
        place.moveCenter(room.center())
        painter.drawImage(place, image)
        painter.save()
        painter.setClipRect(place)
        for one in picture.boxes:
            left, top, width, height = one.box
            box = QRectF(
                place.x() + left * place.width(),
                place.y() + top * place.height(),
                width * place.width(),
                height * place.height(),
            )
            painter.setPen(QPen(QColor(*one.colour), 2))
            painter.drawRect(box)
            self._write(painter, one.label.split(" ")[0], box, QColor(*one.colour))
        painter.restore()
        painter.setPen(current_theme().text_muted)
        below = QRectF(room.x(), room.bottom(), room.width(), self.height() - room.bottom())
        painter.drawText(below, Qt.AlignmentFlag.AlignCenter, picture.when)

    def _write(self, painter: QPainter, number: str, box: QRectF, colour: QColor) -> None:
        """A track's number on a ground of its colour, so that nothing is told by colour alone."""
        letters = self.fontMetrics()
        plate = QRectF(box.x(), box.y(), letters.horizontalAdvance(number) + 4, letters.height())
        painter.fillRect(plate, colour)
        light = colour.lightnessF() > 0.5
        painter.setPen(Qt.GlobalColor.black if light else Qt.GlobalColor.white)
        painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, number)


def _image(picture: StripPicture) -> QImage:
    height, width = picture.image.shape[:2]
    shown = QImage(picture.image.data, width, height, 3 * width, QImage.Format.Format_BGR888)
    return shown.copy()  # the array may go first
