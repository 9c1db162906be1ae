"""Where on the widget a place of the picture or of the floor is drawn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QPainterPath, QPolygonF, QTransform

Points = NDArray[np.float64]  # (n, 2)


@dataclass(frozen=True, slots=True)
class Viewport:
    """A uniform scale and a shift from content (pixels or metres) to widget coordinates.

    Attributes:
        scale: widget units per content unit.
        origin_x, origin_y: where content (0, 0) lies on the widget.
        upward: content's y grows upwards (the floor) instead of downwards (a picture).
    """

    scale: float = 1.0
    origin_x: float = 0.0
    origin_y: float = 0.0
    upward: bool = False

    @staticmethod
    def fitting(content: QRectF, area: QRectF, upward: bool = False) -> Viewport:
        """The whole content in the middle of an area of the widget."""
        width, height = max(content.width(), 1e-9), max(content.height(), 1e-9)
        scale = max(min(area.width() / width, area.height() / height), 1e-6)
        sign = -1.0 if upward else 1.0
        middle, centre = content.center(), area.center()
        return Viewport(
            scale,
            centre.x() - scale * middle.x(),
            centre.y() - sign * scale * middle.y(),
            upward,
        )

    def to_widget(self, points: NDArray[np.floating]) -> Points:
        """Content points (n, 2) in widget coordinates."""
        sign = -1.0 if self.upward else 1.0
        factors = np.array([self.scale, sign * self.scale])
        origin = np.array([self.origin_x, self.origin_y])
        placed: Points = np.asarray(points, np.float64).reshape(-1, 2) * factors + origin
        return placed

    def point(self, x: float, y: float) -> QPointF:
        """One content point on the widget."""
        sign = -1.0 if self.upward else 1.0
        return QPointF(self.origin_x + self.scale * x, self.origin_y + sign * self.scale * y)

    def to_content(self, at: QPointF) -> QPointF:
        """The content under a point of the widget."""
        sign = -1.0 if self.upward else 1.0
        return QPointF(
            (at.x() - self.origin_x) / self.scale, sign * (at.y() - self.origin_y) / self.scale
        )

    def rect(self, content: QRectF) -> QRectF:
        """A content rectangle on the widget."""
        return self.transform().mapRect(content)

    def transform(self) -> QTransform:
        """The same as a Qt transform."""
        sign = -1.0 if self.upward else 1.0
        return QTransform(self.scale, 0, 0, sign * self.scale, self.origin_x, self.origin_y)

    def zoomed(self, at: QPointF, factor: float) -> Viewport:
        """Scaled so that what is under `at` stays there."""
        return Viewport(
            self.scale * factor,
            at.x() + factor * (self.origin_x - at.x()),
            at.y() + factor * (self.origin_y - at.y()),
            self.upward,
        )

    def moved(self, by: QPointF) -> Viewport:
        """Shifted by widget units."""
        return Viewport(self.scale, self.origin_x + by.x(), self.origin_y + by.y(), self.upward)

    def kept_inside(self, content: QRectF, area: QRectF) -> Viewport:
        """Shifted as little as it takes that no part of an area is empty where content is hidden.

        Along each axis the content covers the area, or all of it lies within where it is smaller.
        """
        place = self.rect(content)
        across = _shift(place.left(), place.right(), area.left(), area.right())
        along = _shift(place.top(), place.bottom(), area.top(), area.bottom())
        return self.moved(QPointF(across, along))


def _shift(start: float, end: float, first: float, last: float) -> float:
    """The least shift by which a stretch covers the one from first to last, or lies within it."""
    lowest, highest = sorted((first - start, last - end))
    return min(max(0.0, lowest), highest)


def polygon(points: Points) -> QPolygonF:
    """Points (n, 2) as a Qt polygon; rows that are not finite are left out."""
    kept = points[np.isfinite(points).all(axis=1)]
    return QPolygonF([QPointF(x, y) for x, y in kept.tolist()])


def path_through(points: Points, closed: bool) -> QPainterPath:
    """A path through widget points (n, 2); rows of NaN break it."""
    path, down = QPainterPath(), False
    for x, y in points.tolist():
        if x != x or y != y:
            down = False
        elif down:
            path.lineTo(x, y)
        else:
            path.moveTo(x, y)
            down = True
    if closed and len(points) and np.isfinite(points).all():
        path.closeSubpath()
    return path
