"""The overhead view as a picture of its own: PNG or SVG."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QPointF, QRectF, QSize
from PySide6.QtGui import QImageWriter, QPainter
from PySide6.QtSvg import QSvgGenerator

from app.core.look.theme import Theme
from app.features.pictures.floor_painter import (
    FloorInput,
    FloorPainter,
    blank_image,
)
from tracking.atomic_output import replace_with

SCALE = 2.0
"""Pixels of a PNG in one unit of the view: it is printed and shown larger, too."""
_LEAST_SIDE = 900
"""Of the picture's longer side, in units of the view: in a small pane words take all the room."""


def legible(given: FloorInput) -> FloorInput:
    """The same floor, larger where its view is small, with words as large as they were."""
    times = _LEAST_SIDE / max(given.size.width(), given.size.height(), 1)
    if times <= 1.0:
        return given
    size = QSize(round(times * given.size.width()), round(times * given.size.height()))
    return replace(given, viewport=given.viewport.zoomed(QPointF(), times), size=size)


def write_floor(given: FloorInput, theme: Theme, path: Path) -> None:
    """Write the floor as it is shown: as SVG where the name ends so, else as PNG; or not at all.

    Particles are pixels in an SVG, all else are lines and words. May run on any thread.

    Raises OutputError where it cannot be written.
    """
    drawn = _svg(given, theme) if path.suffix.lower() == ".svg" else _png(given, theme)
    replace_with(path, drawn)


def _png(given: FloorInput, theme: Theme) -> bytes:
    image = blank_image(given.size, given.ratio)
    painter = QPainter(image)
    _paint(painter, given, theme)
    painter.end()
    held = QByteArray()
    buffer = QBuffer(held)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    QImageWriter(buffer, QByteArray(b"png")).write(image)
    buffer.close()
    return bytes(held.data())


def _svg(given: FloorInput, theme: Theme) -> bytes:
    held = QByteArray()
    buffer = QBuffer(held)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    generator = QSvgGenerator()
    generator.setOutputDevice(buffer)
    generator.setSize(given.size)
    generator.setViewBox(QRectF(given.area))
    painter = QPainter(generator)
    _paint(painter, given, theme)
    painter.end()
    buffer.close()
    return bytes(held.data())


def _paint(painter: QPainter, given: FloorInput, theme: Theme) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    FloorPainter().paint(painter, given, theme)
