"""What stands for what on the floor, each beside the very sign."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from app.core.drawing.people_marks import draw_fading_trail
from app.core.i18n import tr
from app.core.look.theme import Theme, faded
from app.core.scenes import OverheadScene
from app.features.pictures.floor_people import draw_arrow, walks
from app.features.pictures.measurement_marks import draw_measured

_PAD, _GAP, _SIGN_PX = 7.0, 8.0, 16.0
_MOST_OF_AREA = 0.3
"""Reaching higher than this share of the view, or wider than half of it, it would hide people."""
_CLOUD = ((-4, 2), (0, -4), (3, 3), (-1, 1), (5, -2), (2, -1), (-5, -3), (-2, -1), (1, 5))

Sign = Callable[[QPainter, QPointF, Theme], None]


class FloorLegend:
    """A plate with the signs the scene has, in a corner where it hides nobody.

    It stays in its corner until somebody comes there; where somebody is in every one, it goes.
    """

    def __init__(self) -> None:
        self._corner = 0

    def place(self, size: QSizeF, foot: QPointF, area: QRectF, taken: Sequence[QRectF]) -> QRectF:
        """Where a plate hides nothing that is taken; empty: nowhere.

        Args:
            foot: its lower left corner, where that corner of the area is free.
        """
        inset = foot.x() - area.left()
        inner = area.adjusted(inset, inset, -inset, -inset)
        low, high = foot.y() - size.height(), inner.top()
        right = inner.right() - size.width()
        corners = [QPointF(foot.x(), low), QPointF(right, low), QPointF(foot.x(), high)]
        order = [self._corner, *(at for at in range(len(corners)) if at != self._corner)]
        for at in order:
            plate = QRectF(corners[at], size)
            if not any(plate.intersects(one) for one in taken):
                self._corner = at
                return plate
        return QRectF()

    def draw(
        self,
        painter: QPainter,
        scene: OverheadScene,
        foot: QPointF,
        area: QRectF,
        taken: Sequence[QRectF],
        theme: Theme,
    ) -> None:
        """Draw it, as far as there is room; see `place`."""
        metrics = QFontMetricsF(painter.font())
        line = metrics.height() + 3
        room = _MOST_OF_AREA * area.height() - (area.bottom() - foot.y()) - 2 * _PAD
        lines = _lines(scene)[: max(0, int(room / line))]
        width = max((metrics.horizontalAdvance(text) for _, text in lines), default=0.0)
        size = QSizeF(width + _SIGN_PX + _GAP + 2 * _PAD, len(lines) * line + 2 * _PAD)
        if not lines or size.width() > area.width() / 2:
            return
        plate = self.place(size, foot, area, taken)
        if not plate.isEmpty():
            _draw_plate(painter, plate, lines, line, theme)


def _draw_plate(
    painter: QPainter, plate: QRectF, lines: Sequence[tuple[Sign, str]], line: float, theme: Theme
) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(faded(theme.window, 0.82))
    painter.drawRoundedRect(plate, 5, 5)
    for row, (sign, text) in enumerate(lines):
        top = plate.top() + _PAD + row * line
        inside = QRectF(plate.left() + _PAD, top, plate.width(), line)
        sign(painter, QPointF(inside.left() + _SIGN_PX / 2, inside.center().y()), theme)
        inside.setLeft(inside.left() + _SIGN_PX + _GAP)
        painter.setPen(theme.text)
        painter.drawText(inside, Qt.AlignmentFlag.AlignVCenter, text)


def _lines(scene: OverheadScene) -> list[tuple[Sign, str]]:
    """The signs that are to be seen, and what they mean; first what is guessed least easily."""
    lines: list[tuple[Sign, str]] = []
    if len(scene.measured):
        lines.append((_draw_dot, tr("measured in this frame")))
    if any(not person.predicted for person in scene.people):
        lines.append((_draw_ring, tr("where the tracker has a person")))
    if any(person.predicted for person in scene.people):
        lines.append((_draw_dashed, tr("predicted: not detected now")))
    if len(scene.particles):
        lines.append((_draw_cloud, tr("particles: where they may be")))
    if any(map(walks, scene.people)):
        lines.append((_draw_way, tr("arrow: which way they walk")))
    if any(len(person.trail) > 1 for person in scene.people):
        lines.append((_draw_trail, tr("trail: where they came from")))
    return lines


def _draw_dot(painter: QPainter, at: QPointF, theme: Theme) -> None:
    draw_measured(painter, np.array([[at.x(), at.y()]]), theme)


def _draw_ring(painter: QPainter, at: QPointF, theme: Theme) -> None:
    _ring(painter, at, QPen(theme.text_muted, 1.8))


def _draw_dashed(painter: QPainter, at: QPointF, theme: Theme) -> None:
    pen = QPen(theme.text_muted, 1.8)
    pen.setDashPattern([2.0, 1.6])
    _ring(painter, at, pen)


def _ring(painter: QPainter, at: QPointF, pen: QPen) -> None:
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawEllipse(at, 6.0, 6.0)


def _draw_way(painter: QPainter, at: QPointF, theme: Theme) -> None:
    reach = QPointF(_SIGN_PX / 2, 0)
    draw_arrow(painter, at - reach, at + reach, theme.text_muted, 1.8)


def _draw_trail(painter: QPainter, at: QPointF, theme: Theme) -> None:
    x = np.linspace(-_SIGN_PX / 2, _SIGN_PX / 2, 7)
    points = np.column_stack((at.x() + x, at.y() + 2.0 * np.sin(x / 3.0)))
    draw_fading_trail(painter, points, theme.text_muted, 2.0)


def _draw_cloud(painter: QPainter, at: QPointF, theme: Theme) -> None:
    painter.setPen(Qt.PenStyle.NoPen)
    colour = QColor(theme.text_muted)
    for number, (x, y) in enumerate(_CLOUD):
        painter.setBrush(faded(colour, 0.45 + 0.06 * number))
        painter.drawEllipse(at + QPointF(x, y), 1.4, 1.4)
