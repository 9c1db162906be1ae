"""How well texts are read that are seen in a window: measured in its pixels."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QTabBar,
    QWidget,
)

from app.core.colours.shown_colours import contrast
from app.core.look.theme import current_theme
from app.features.setup.picture_view import PictureView

Rgb = tuple[int, int, int]
LEAST = 4.5
"""Of text against what it stands on [WCAG 2.1, 1.4.3]."""
_SCALE = 3
"""Letters are drawn so much larger that their strokes have a core without soft edges."""
_ROUNDED = 0.05
_PLAIN = 0.2
"""A ground of which fewer pixels have one colour is no plain one."""
_MOST_COLOURS = 4000
_LEAST_SHOWN = 0.7
"""Of a text's height: what is scrolled away is not read."""
_WRITTEN = (QLabel, QAbstractButton, QComboBox, QLineEdit, QPlainTextEdit, QTabBar, QHeaderView)


@dataclass(frozen=True, slots=True)
class _Drawn:
    """A text that was painted: on what widget and where, in which ink."""

    widget: QWidget
    rect: QRectF
    ink: QColor
    text: str


@dataclass(slots=True)
class Readings:
    """Contrasts that were measured.

    Attributes:
        least: by text the least one. faults: what is said of those too low.
    """

    least: dict[str, float] = field(default_factory=dict)
    faults: list[str] = field(default_factory=list)

    def add(self, where: str, text: str, ratio: float) -> None:
        """Keep one."""
        key = f"{where} {text!r}"
        self.least[key] = min(ratio, self.least.get(key, ratio))
        if ratio < LEAST - _ROUNDED:
            self.faults.append(f"{key}: {ratio:.2f}")


def read(window: QWidget) -> Readings:
    """Contrast of every text that is seen in a window and enabled."""
    found = Readings()
    with _painted() as drawn:
        picture = _picture(window)
    for one in drawn:
        if isinstance(one.widget, PictureView):
            continue  # its letters are white with a black rim, whatever is below
        if one.widget.window() is window and one.widget.isVisible() and one.ink not in _disabled():
            inks = one.ink.red(), one.ink.green(), one.ink.blue()
            ground = _ground(_part(picture, window, one.widget, one.rect.toAlignedRect()), inks)
            if ground is not None:
                ratio = contrast(_over(one.ink, ground), ground)
                found.add(type(one.widget).__name__, one.text, ratio)
    for widget in window.findChildren(QWidget):
        text = _text(widget)
        shown = widget.visibleRegion().boundingRect()
        seen = shown.height() >= _LEAST_SHOWN * widget.height()
        if (
            text
            and seen
            and widget.isEnabled()
            and widget.isVisible()
            and widget.window() is window
        ):
            part = _part(picture, window, widget, shown)
            ground = _ground(part)
            if ground is not None:
                found.add(type(widget).__name__, text, _most(part, ground))
    return found


def _disabled() -> list[QColor]:
    """The ink of what cannot be used now, which need not be read so well."""
    return [current_theme().text_disabled]


def _text(widget: QWidget) -> str:
    if not isinstance(widget, _WRITTEN):
        return ""
    if isinstance(widget, (QLineEdit, QPlainTextEdit)):
        own = widget.text() if isinstance(widget, QLineEdit) else widget.toPlainText()
        return own or widget.placeholderText()
    if isinstance(widget, QComboBox):
        return widget.currentText()
    if isinstance(widget, (QTabBar, QHeaderView)):
        return type(widget).__name__
    return str(widget.text())


def _picture(window: QWidget) -> NDArray[np.uint8]:
    """(height, width, 3) of the window, larger by `_SCALE`."""
    image = QImage(window.size() * _SCALE, QImage.Format.Format_RGB888)
    image.setDevicePixelRatio(_SCALE)
    image.fill(0)
    window.render(image)
    return _array(image)


def _array(image: QImage) -> NDArray[np.uint8]:
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def _part(
    picture: NDArray[np.uint8], window: QWidget, widget: QWidget, rect: QRect
) -> NDArray[np.uint8]:
    seen = rect.intersected(widget.visibleRegion().boundingRect())
    at = widget.mapTo(window, QPoint(seen.left(), seen.top())) * _SCALE
    size = QSize(seen.width(), seen.height()) * _SCALE
    return picture[max(at.y(), 0) : at.y() + size.height(), max(at.x(), 0) : at.x() + size.width()]


def _ground(part: NDArray[np.uint8], ink: Rgb | None = None) -> Rgb | None:
    """The colour that is there most often; over a picture, where each pixel differs, the usual."""
    if part.size < 3 * _SCALE**2:
        return None
    codes, many = np.unique(_codes(part), return_counts=True)
    if ink is not None:
        many[codes == _codes(np.array([[ink]], np.uint8))[0]] = 0
    if many.max() < _PLAIN * many.sum():
        red, green, blue = np.median(_colours(np.repeat(codes, many)), axis=0).astype(int).tolist()
    else:
        red, green, blue = _colours(codes[many.argmax()][None])[0].tolist()
    return red, green, blue


def _codes(part: NDArray[np.uint8]) -> NDArray[np.int64]:
    """(n,) one number for each pixel's colour."""
    return np.asarray(part.reshape(-1, 3).astype(np.int64) @ (65536, 256, 1))


def _colours(codes: NDArray[np.int64]) -> NDArray[np.int64]:
    return np.stack((codes >> 16, codes >> 8 & 255, codes & 255), axis=1)


def _most(part: NDArray[np.uint8], ground: Rgb) -> float:
    """Of anything there against the ground: the cores of letters, if nothing else is there."""
    colours = _colours(np.unique(_codes(part)))[:_MOST_COLOURS].tolist()
    return max(contrast((red, green, blue), ground) for red, green, blue in colours)


def _over(ink: QColor, ground: Rgb) -> Rgb:
    opacity = ink.alphaF()
    inks = (ink.red(), ink.green(), ink.blue())
    red, green, blue = (
        round(opacity * one + (1 - opacity) * below)
        for one, below in zip(inks, ground, strict=True)
    )
    return red, green, blue


# what is painted


@contextmanager
def _painted() -> Iterator[list[_Drawn]]:
    """Texts painted by our own code meanwhile."""
    drawn: list[_Drawn] = []
    usual = QPainter.drawText

    def draw(painter: QPainter, *asked: Any) -> Any:
        device = painter.device()
        if isinstance(device, QWidget) and asked:
            rect, text = _room(painter, asked)
            if str(text).strip():
                drawn.append(_Drawn(device, rect, painter.pen().color(), str(text)))
        return usual(painter, *asked)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(QPainter, "drawText", draw)
        yield drawn


def _room(painter: QPainter, asked: tuple[Any, ...]) -> tuple[QRectF, str]:
    """Where a text comes to stand, and the text."""
    metrics, place = QFontMetricsF(painter.font()), asked[0]
    if isinstance(place, (QPoint, QPointF)):
        text = str(asked[1])
        rect = metrics.boundingRect(text).translated(QPointF(place))
    else:
        text = next(one for one in asked[1:] if isinstance(one, str))
        flags = asked[1] if not isinstance(asked[1], str) else 0
        flags = getattr(flags, "value", flags)
        rect = metrics.boundingRect(QRectF(place), int(flags), text)
    return painter.worldTransform().mapRect(rect), text
