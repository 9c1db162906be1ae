"""Swatches of the legend look like what they stand for."""

from __future__ import annotations

from PySide6.QtCore import QPointF
from PySide6.QtGui import QImage, QPainter

from app.core.drawing.legend import draw_legend
from app.core.look.theme import load_theme
from app.core.scenes import LegendEntry

WHITE = (245, 245, 245)


def lightness(entry: LegendEntry) -> set[int]:
    """Of the pixels inside of the swatch of an entry that stands alone."""
    image = QImage(200, 40, QImage.Format.Format_RGB32)
    image.fill(0xFFFFFF)
    painter = QPainter(image)
    draw_legend(painter, [entry], QPointF(0, 40), load_theme("light"))
    painter.end()
    return {image.pixelColor(x, y).lightness() for x in range(8, 15) for y in range(20, 33)}


def test_an_outline_shows_on_a_plate_of_its_own_colour(qapp) -> None:
    dashed = lightness(LegendEntry(WHITE, "boxes", dashed=True))
    assert min(dashed) < 100
    assert max(dashed) > 200
    assert min(lightness(LegendEntry(WHITE, "spots"))) > 150
