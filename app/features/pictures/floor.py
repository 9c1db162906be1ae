"""The floor seen from above, without the people: grid, numbers, scale bar, camera."""

from __future__ import annotations

import math

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from app.core.drawing.viewport import Points, Viewport, polygon
from app.core.look.theme import Theme, faded

_EDGE = 6.0


def nice_step(least: float) -> float:
    """The smallest of 1, 2, 5 times a power of ten that is not below `least`."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(step * power for step in (1.0, 2.0, 5.0, 10.0) if step * power >= least * 0.999999)


def draw_grid(painter: QPainter, area: QRectF, viewport: Viewport, theme: Theme) -> None:
    """Lines every few metres with their numbers at the left and lower edge."""
    metrics = QFontMetricsF(painter.font())
    step = nice_step(4.2 * metrics.height() / viewport.scale)
    near, far = viewport.to_content(area.bottomLeft()), viewport.to_content(area.topRight())
    fine = step / 5 if f"{step:.1e}"[0] in "15" else step / 4
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    for spacing, colour in ((fine, theme.grid), (step, theme.grid_major)):
        painter.setPen(QPen(colour, 1.0))
        painter.drawLines(
            [
                QLineF(viewport.point(x, near.y()), viewport.point(x, far.y()))
                for x in _multiples(near.x(), far.x(), spacing)
            ]
            + [
                QLineF(viewport.point(near.x(), y), viewport.point(far.x(), y))
                for y in _multiples(near.y(), far.y(), spacing)
            ]
        )
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, True)
    _draw_numbers(painter, area, viewport, theme, step)


def inner_corner(font: QFont, area: QRectF) -> QPointF:
    """The lower left corner inside the numbers of the grid, for what must not hide them."""
    metrics = QFontMetricsF(font)
    right = area.left() + _EDGE + metrics.horizontalAdvance("-00.0")
    return QPointF(right + _EDGE, area.bottom() - metrics.height() - 2 * _EDGE)


def _multiples(low: float, high: float, step: float) -> list[float]:
    first, last = math.ceil(low / step), math.floor(high / step)
    return [index * step for index in range(first, last + 1)]


def _draw_numbers(
    painter: QPainter, area: QRectF, viewport: Viewport, theme: Theme, step: float
) -> None:
    metrics = QFontMetricsF(painter.font())
    painter.setPen(theme.text_faint)
    near, far = viewport.to_content(area.bottomLeft()), viewport.to_content(area.topRight())
    places = max(0, -math.floor(math.log10(step)))
    for x in _multiples(near.x(), far.x(), step):
        text, at = f"{x + 0.0:.{places}f}", viewport.point(x, 0).x()
        left = at - metrics.horizontalAdvance(text) / 2
        if left > area.left() + 3 * metrics.height():
            painter.drawText(QPointF(left, area.bottom() - _EDGE), text)
    for y in _multiples(near.y(), far.y(), step):
        baseline = viewport.point(0, y).y() + metrics.ascent() / 2 - 1
        if baseline < area.bottom() - 2 * metrics.height():
            painter.drawText(QPointF(area.left() + _EDGE, baseline), f"{y + 0.0:.{places}f}")


def scale_bar_plate(metrics: QFontMetricsF, area: QRectF, viewport: Viewport) -> QRectF:
    """Where the scale bar stands, in a font."""
    length = _bar_length_m(metrics, viewport) * viewport.scale
    left = area.right() - 16 - length - 8
    return QRectF(left, area.top() + 8, length + 16, metrics.height() + 14)


def _bar_length_m(metrics: QFontMetricsF, viewport: Viewport) -> float:
    return nice_step(5 * metrics.height() / viewport.scale)


def draw_scale_bar(
    painter: QPainter, area: QRectF, viewport: Viewport, theme: Theme, unit: str
) -> None:
    """A bar of a round length, at the upper right."""
    metrics = QFontMetricsF(painter.font())
    length_m = _bar_length_m(metrics, viewport)
    length = length_m * viewport.scale
    text = f"{length_m:g} {unit}"
    right, line = area.right() - 16, area.top() + 14 + metrics.height()
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(faded(theme.window, 0.82))
    painter.drawRoundedRect(scale_bar_plate(metrics, area, viewport), 5, 5)
    painter.setPen(QPen(theme.text_muted, 1.5))
    for start, stop in (
        ((right - length, line), (right, line)),
        ((right - length, line - 4), (right - length, line)),
        ((right, line - 4), (right, line)),
    ):
        painter.drawLine(QPointF(*start), QPointF(*stop))
    painter.setPen(theme.text_muted)
    middle = right - length / 2 - metrics.horizontalAdvance(text) / 2
    painter.drawText(QPointF(middle, line - 5), text)


def draw_field_of_view(
    painter: QPainter, corners: Points, viewport: Viewport, theme: Theme
) -> None:
    """What the camera sees of the floor, softly shaded."""
    if len(corners) < 3:
        return
    painter.setPen(QPen(faded(theme.accent, 0.45), 1.0))
    painter.setBrush(faded(theme.accent, 0.08 if theme.is_dark else 0.07))
    painter.drawPolygon(polygon(viewport.to_widget(corners)))


def draw_camera(
    painter: QPainter,
    camera: tuple[float, float],
    viewport: Viewport,
    theme: Theme,
    looks_down: bool = False,
) -> None:
    """A small camera that looks forward (up on the screen), or down: then its lens alone."""
    at = viewport.point(*camera)
    painter.setPen(QPen(theme.sunken, 1.0))
    painter.setBrush(theme.text_muted)
    if looks_down:
        painter.drawEllipse(at, 7.0, 7.0)
        painter.setBrush(theme.sunken)
        painter.drawEllipse(at, 3.5, 3.5)
        return
    lens = [QPointF(-4, -3), QPointF(-7, -10), QPointF(7, -10), QPointF(4, -3)]
    painter.drawPolygon(QPolygonF([at + corner for corner in lens]))
    painter.drawRoundedRect(QRectF(at.x() - 7, at.y() - 4, 14, 11), 2.5, 2.5)
