"""The flow map over the floor: cells in colours, arrows upon them, what the colours mean."""

from __future__ import annotations

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, QSizeF, Qt
from PySide6.QtGui import QFont, QImage, QPainter, QPen

from app.core.drawing.legend import draw_legend
from app.core.drawing.viewport import Points, Viewport
from app.core.look.theme import Theme, faded, scaled_font
from app.core.scenes.flow_map import FlowScene
from app.features.pictures.floor import inner_corner

_TIP_PX, _TIP_SHARE, _TIP_DEG = 5.0, 0.4, 152.0
_LEAST_PX = 7.0
"""Shorter arrows could not be read."""


class FlowMapPainter:
    """Draws a :class:`FlowScene`; it is kept until the scene, the view or the look is another."""

    def __init__(self) -> None:
        self._key: tuple[object, ...] = ()
        self._drawn = QImage()

    def paint(
        self,
        painter: QPainter,
        scene: FlowScene,
        viewport: Viewport,
        over: tuple[QSize, float, QFont],
        theme: Theme,
    ) -> float:
        """The map from its picture, then its legend in the lower left corner; where that begins.

        over: size of the view, pixels in one of its units, its font.
        """
        size, ratio, font = over
        key = (id(scene), viewport, size.toTuple(), ratio, theme.name)
        if key != self._key:
            self._key = key
            self._drawn = QImage(size * ratio, QImage.Format.Format_ARGB32_Premultiplied)
            self._drawn.setDevicePixelRatio(ratio)
            self._drawn.fill(0)
            still = QPainter(self._drawn)
            still.setRenderHint(QPainter.RenderHint.Antialiasing)
            _draw_cells(still, scene, viewport)
            _draw_arrows(still, scene, viewport, theme)
            still.end()
        painter.drawImage(0, 0, self._drawn)
        painter.setFont(scaled_font(font, 0.85))
        foot = inner_corner(painter.font(), QRectF(QPointF(), QSizeF(size)))
        return foot.y() - draw_legend(painter, scene.legend, foot, theme)


def _draw_cells(painter: QPainter, scene: FlowScene, viewport: Viewport) -> None:
    rows, columns = scene.image.shape[:2]
    if not rows * columns:
        return
    picture = QImage(scene.image.data, columns, rows, 4 * columns, QImage.Format.Format_RGBA8888)
    side = scene.cell_m
    area = viewport.rect(QRectF(scene.left, scene.bottom, columns * side, rows * side))
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, False)
    painter.drawImage(area, picture)


def _draw_arrows(painter: QPainter, scene: FlowScene, viewport: Viewport, theme: Theme) -> None:
    """All shafts and tips at once: pale below dark or dark below pale, seen on every colour."""
    tails, tips = viewport.to_widget(scene.arrows[:, :2]), viewport.to_widget(scene.arrows[:, 2:])
    lines = _strokes(tails, tips)
    ground = faded(theme.sunken, 0.7)
    for pen in (QPen(ground, 3.0), QPen(theme.text, 1.3)):
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        painter.drawLines(lines)


def _strokes(tails: Points, tips: Points) -> list[QLineF]:
    """A shaft and two wings each; arrows that are too short to be read are a dot."""
    found = []
    for (x1, y1), (x2, y2) in zip(tails.tolist(), tips.tolist(), strict=True):
        shaft = QLineF(x1, y1, x2, y2)
        found.append(shaft)
        if shaft.length() >= _LEAST_PX:
            for turn in (_TIP_DEG, -_TIP_DEG):
                wing = QLineF(shaft.p2(), shaft.p1())
                wing.setAngle(shaft.angle() + turn)
                wing.setLength(min(_TIP_PX, _TIP_SHARE * shaft.length()))
                found.append(wing)
    return found
