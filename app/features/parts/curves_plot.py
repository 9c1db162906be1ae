"""Failure score, entropy and particles of a person's parts over the frames the timeline shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen
from PySide6.QtWidgets import QWidget

from app.core.drawing.name_plates import draw_message
from app.core.i18n import tr
from app.core.look.theme import Theme, faded
from app.core.plots.curves import PART_LINES, Floats, curve_path, stretches, whole_span
from app.core.plots.frame_plot import FramePlot
from app.core.plots.strips import covered, draw_strip, opacity
from app.core.scenes.labels import PART_COLOURS
from app.core.scenes.part_curve import THRESHOLD, PartCurve
from app.features.parts.scene import CurvesScene

_PLATE = 0.85
"""How little of the curves is seen through the plate of words."""
_GAP_PX = 8.0
_WIDEST_NUMBER = "-88.8"


@dataclass(frozen=True, slots=True)
class _Strip:
    """One of the plots: its name with the unit, what of a curve it shows, at least how far it goes.

    Attributes:
        sides: of a threshold: what is said above and below it. high: its curves mostly run high,
            so its name stands low.
    """

    name: str
    values: Callable[[PartCurve], Floats]
    least: tuple[float, float]
    share: float
    threshold: float | None = None
    sides: tuple[str, str] = ("", "")
    high: bool = False


class CurvesPlot(FramePlot):
    """Draws the curves of a :class:`CurvesScene`; they stay while only the playhead moves."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene = CurvesScene("")
        self._strips = (
            _Strip(
                tr("Score of the part-failure detector in the run"),
                lambda one: one.score,
                (-1.0, 1.0),
                0.46,
                THRESHOLD,
                (tr("off its part"), tr("on its part")),
            ),
            _Strip(
                tr("Entropy of the weights (1: all alike)"),
                lambda one: one.entropy,
                (0.0, 1.0),
                0.27,
                high=True,
            ),
            _Strip(tr("Particles (number)"), lambda one: one.particles, (0.0, 10.0), 0.27),
        )
        self.setAccessibleName(tr("Failure score, entropy and particles over time"))

    def show_scene(self, scene: CurvesScene) -> None:
        """Draw another frame; the curves only where they are others."""
        before, self._scene = self._scene, scene
        if (before.curves, before.chosen, before.message) != (
            scene.curves,
            scene.chosen,
            scene.message,
        ):
            self.draw_anew()
        self.setAccessibleDescription("\n".join(scene.said) or scene.message)
        self.show_playhead(scene.frame)

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Three low plots."""
        return QSize(420, 14 * self.fontMetrics().height())

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Still readable: each plot with both ends of its scale."""
        return QSize(200, 11 * self.fontMetrics().height())

    @property
    def has_curves(self) -> bool:
        """Whether somebody's curves are shown."""
        return bool(self._scene.curves)

    def names_width(self, metrics: QFontMetricsF) -> float:
        """Of the widest number on a scale."""
        return metrics.horizontalAdvance(_WIDEST_NUMBER)

    def draw_still(self, painter: QPainter, theme: Theme) -> None:
        """All strips below each other, or why there are none."""
        if self._scene.message:
            draw_message(painter, QRectF(self.rect()), self._scene.message, theme)
        else:
            self._draw_strips(painter, theme)

    def _draw_strips(self, painter: QPainter, theme: Theme) -> None:
        axis, foot = self.axis, QFontMetricsF(painter.font()).height() + 4
        room = self.height() - foot - _GAP_PX * (len(self._strips) - 1)
        top = 2.0
        for strip in self._strips:
            place = QRectF(axis.left, top, axis.width, strip.share * room)
            self._draw_strip(painter, strip, place, theme)
            top = place.bottom() + _GAP_PX
        self.draw_times(painter, foot, self._scene.fps, theme)

    def _draw_strip(self, painter: QPainter, strip: _Strip, place: QRectF, theme: Theme) -> None:
        painter.fillRect(place, theme.sunken)
        values = [strip.values(curve) for curve in self._scene.curves]
        span = whole_span(values, strip.least)
        inner = place.adjusted(0, 3, 0, -3)
        self._draw_scale(painter, strip, place, inner, span, theme)
        painter.save()
        painter.setClipRect(place.adjusted(0, -1, 0, 1))
        if strip.threshold is not None:
            self._draw_threshold(painter, strip.threshold, inner, span, theme)
        chosen = self._scene.chosen
        for part in sorted(range(len(values)), key=lambda one: one == chosen):
            path = curve_path(self._scene.curves[part].frames, values[part], self.axis, inner, span)
            colour = theme.track(PART_COLOURS[part])
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(colour, 2.4 if part == chosen else 1.3, PART_LINES[part]))
            painter.drawPath(path)
        painter.restore()
        self._name_strip(painter, strip, place, inner, span, theme)

    def _draw_threshold(
        self,
        painter: QPainter,
        threshold: float,
        place: QRectF,
        span: tuple[float, float],
        theme: Theme,
    ) -> None:
        """A dashed line above which a part has failed; shaded where the chosen part has."""
        curve, axis = self._scene.curves[self._scene.chosen], self.axis
        columns = max(1, int(axis.width * painter.device().devicePixelRatioF()))
        ranges = stretches(curve.frames[curve.failed])
        shares = covered(ranges, axis.edges(columns))
        draw_strip(painter, opacity(shares), faded(theme.danger, 0.25), place)
        y = place.bottom() - _share(threshold, span) * place.height()
        painter.setPen(QPen(theme.danger, 1.2, Qt.PenStyle.DashLine))
        painter.drawLine(QLineF(place.left(), y, place.right(), y))

    def _draw_scale(
        self,
        painter: QPainter,
        strip: _Strip,
        place: QRectF,
        inner: QRectF,
        span: tuple[float, float],
        theme: Theme,
    ) -> None:
        """Both ends of the scale, and the threshold where there is room between them."""
        line = painter.fontMetrics().height()
        painter.setPen(theme.text_muted)
        drawn: list[float] = []
        for value in (span[1], span[0], strip.threshold):
            if value is None:
                continue
            y = inner.bottom() - _share(value, span) * inner.height()
            top = min(max(y - line / 2, place.top() - 2), place.bottom() - line + 2)
            if all(abs(top - other) >= line for other in drawn):
                drawn.append(top)
                beside = QRectF(0, top, place.left() - 6, line)
                flags = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
                painter.drawText(beside, flags, _number(value))

    def _name_strip(
        self,
        painter: QPainter,
        strip: _Strip,
        place: QRectF,
        inner: QRectF,
        span: tuple[float, float],
        theme: Theme,
    ) -> None:
        """What is drawn, and at the right which side of a threshold means what: over the curves."""
        height = painter.fontMetrics().height()
        top = place.bottom() - height - 1 if strip.high else place.top() + 1
        _draw_words(painter, strip.name, QPointF(place.left() + 2, top), theme.text, theme)
        if strip.threshold is None:
            return
        line = painter.fontMetrics().height()
        y = inner.bottom() - _share(strip.threshold, span) * inner.height()
        for said, top in zip(strip.sides, (y - line - 1, y + 1), strict=True):
            left = place.right() - painter.fontMetrics().horizontalAdvance(said) - 6
            at = QPointF(left, min(max(top, place.top()), place.bottom() - line))
            _draw_words(painter, said, at, theme.text_muted, theme)


def _number(value: float) -> str:
    """Three digits, and no power of ten."""
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.3g}"


def _share(value: float, span: tuple[float, float]) -> float:
    """How far up between both ends."""
    return (value - span[0]) / max(span[1] - span[0], 1e-12)


def _draw_words(painter: QPainter, text: str, at: QPointF, colour: QColor, theme: Theme) -> None:
    """Words on a plate, their upper left corner given."""
    metrics = painter.fontMetrics()
    plate = QRectF(at.x(), at.y(), metrics.horizontalAdvance(text) + 4, metrics.height())
    painter.fillRect(plate, faded(theme.sunken, _PLATE))
    painter.setPen(colour)
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, text)
