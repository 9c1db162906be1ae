"""The shapes of errors: each kind has one of its own, on lanes, in lists and on pictures."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import ceil

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QImage, QPainter, QPen, QPixmap

from app.core.look.theme import Theme, current_theme, load_theme
from app.core.scenes.ground_truth import ERROR_COLOURS
from tracking.scoring import ErrorKind

_ICON_PX = 12
_HALO_PX = 4.0


def error_colour(kind: ErrorKind, theme: Theme) -> QColor:
    """The kind's colour, readable on the ground of the look."""
    return theme.track(ERROR_COLOURS[kind])


def draw_signs(
    painter: QPainter, kind: ErrorKind, at: Sequence[QPointF], reach: float, theme: Theme
) -> None:
    """Signs of one kind around some places, each on a halo of the ground.

    A cross stands for a switch, a bar parted in two for a fragmentation, a ring for a miss, a
    triangle for a false alarm.
    """
    if not at:
        return
    device = painter.device()
    ratio = device.devicePixelRatioF() if device is not None else 1.0
    sign = _drawn(kind, round(reach, 1), theme.name, ratio)
    half = QPointF(_side(reach) / 2, _side(reach) / 2)
    for place in at:
        painter.drawImage(place - half, sign)


def _side(reach: float) -> int:
    """Of the square a sign with its halo fits into."""
    return 2 * ceil(reach + _HALO_PX)


@lru_cache(maxsize=64)
def _drawn(kind: ErrorKind, reach: float, theme_name: str, ratio: float) -> QImage:
    """A sign drawn once: hundreds of them on a lane are then put down in a moment."""
    theme, side = load_theme(theme_name), _side(reach)
    picture = QImage(QSize(side, side) * ratio, QImage.Format.Format_ARGB32_Premultiplied)
    picture.setDevicePixelRatio(ratio)
    picture.fill(0)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for colour, width in ((theme.sunken, _HALO_PX), (error_colour(kind, theme), 1.8)):
        painter.setPen(QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        _draw_sign(painter, kind, QPointF(side / 2, side / 2), reach)
    painter.end()
    return picture


def _draw_sign(painter: QPainter, kind: ErrorKind, at: QPointF, reach: float) -> None:
    if kind is ErrorKind.SWITCH:
        for arm in (QPointF(reach, reach), QPointF(reach, -reach)):
            painter.drawLine(at - arm, at + arm)
    elif kind is ErrorKind.FRAGMENTATION:
        near, far = 0.35 * reach, reach
        x, y = at.x(), at.y()
        painter.drawLines(
            [
                QLineF(x - far, y, x - near, y),
                QLineF(x + near, y, x + far, y),
                QLineF(x - near, y - far, x - near, y + far),
                QLineF(x + near, y - far, x + near, y + far),
            ]
        )
    elif kind is ErrorKind.MISS:
        painter.drawEllipse(at, 0.9 * reach, 0.9 * reach)
    else:
        top, side = QPointF(0, -reach), QPointF(0.95 * reach, 0.8 * reach)
        corners = [at + top, at + side, at + QPointF(-side.x(), side.y())]
        painter.drawPolygon(corners)


def sign_icon(kind: ErrorKind) -> QIcon:
    """The sign as a button has it."""
    picture = QPixmap(QSize(_ICON_PX, _ICON_PX) * 2)
    picture.setDevicePixelRatio(2)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(error_colour(kind, current_theme()), 1.8))
    middle = QRectF(0, 0, _ICON_PX, _ICON_PX).center()
    _draw_sign(painter, kind, middle, 0.36 * _ICON_PX)
    painter.end()
    return QIcon(picture)
