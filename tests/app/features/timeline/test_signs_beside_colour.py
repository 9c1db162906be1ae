"""What the timeline tells by a colour it tells by a line or a bar, too."""

from __future__ import annotations

from drawn_scenes import lane
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from app.core.look.theme import load_theme
from app.core.plots.axis import TimeAxis
from app.features.timeline.lanes import draw_lane, draw_reviewed

_AXIS = TimeAxis(100.0, 200.0, 0.0, 100.0, 100)
_ROW = QRectF(0, 0, 300, 24)
_THEME = load_theme("light")


def _drawn(draw) -> QImage:
    image = QImage(300, 24, QImage.Format.Format_RGB888)
    image.fill(_THEME.surface)
    painter = QPainter(image)
    draw(painter)
    painter.end()
    return image


def test_a_selected_lane_has_a_bar_before_its_name(qapp):
    chosen, other = (
        _drawn(
            lambda painter, on=on: draw_lane(
                painter, lane(1, selected=on), _ROW, _AXIS, (0, 100), _THEME
            )
        )
        for on in (True, False)
    )
    assert chosen.pixelColor(1, 12) == _THEME.accent
    assert other.pixelColor(1, 12) == _THEME.surface


def test_what_was_reviewed_is_underlined(qapp):
    image = _drawn(lambda painter: draw_reviewed(painter, ((20, 60),), _AXIS, _ROW, _THEME))
    inside, outside = (image.pixelColor(x, 23) for x in (180, 260))
    assert inside == QColor(_THEME.good)
    assert outside == _THEME.surface
