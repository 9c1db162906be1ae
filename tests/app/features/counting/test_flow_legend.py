"""The legend of the flow map has the colours that the map has on the floor."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from app.core.drawing.legend import draw_legend
from app.core.drawing.viewport import Viewport
from app.core.look.theme import load_theme
from app.features.counting.flow_scene import flow_scene
from app.features.pictures.flow_map import _draw_cells
from tracking.counting import FlowMap


def _scene():
    density = np.array([[1.0, 0.25]])
    nobody_moves = np.zeros((1, 2, 2))
    return flow_scene(FlowMap(0.0, 0.0, 1.0, density, nobody_moves, 9))


@pytest.mark.parametrize("name", ["dark", "light"])
def test_the_legend_shows_the_colours_as_they_lie_on_the_floor(qapp, name):
    theme, scene = load_theme(name), _scene()
    picture = QImage(400, 200, QImage.Format.Format_RGB32)
    picture.fill(theme.sunken)
    painter = QPainter(picture)
    _draw_cells(painter, scene, Viewport.fitting(QRectF(0, 0, 2, 1), QRectF(200, 0, 200, 100)))
    draw_legend(painter, scene.legend, QPointF(0, 190), theme)
    painter.end()
    cells = [picture.pixelColor(x, 50) for x in (250, 350)]
    legend = {picture.pixelColor(14, y).rgb() for y in range(100, 190)}
    for cell in cells:
        assert min(_apart(cell, QColor(one)) for one in legend) <= 3


def _apart(one, other):
    return max(abs(a - b) for a, b in zip(one.getRgb(), other.getRgb(), strict=True))
