"""Failure score, entropy and particles of a person's parts over the frames the timeline shows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFontMetricsF, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.presenters.labelling.labelling_scene import PART_COLOURS
from app.presenters.parts.part_curve import THRESHOLD, PartCurve
from app.presenters.parts.parts_scene import CurvesScene
from app.views.look.theme import Theme, current_theme, faded, scaled_font
from app.views.pictures.name_plates import draw_message
from app.views.timeline.axis import TimeAxis, ticks
from app.views.timeline.curves import Floats, curve_path, score_span, span_of, stretches
from app.views.timeline.strips import covered, draw_strip, opacity
from app.views.widgets.still_picture import StillPicture

_GAP_PX = 8.0
_TICK_LETTERS = 11
_SMALL = 0.86


@dataclass(frozen=True, slots=True)
class _Strip:
    """One of the plots: its name, what of a curve it shows, and at least how far it goes."""

    name: str
    values: Callable[[PartCurve], Floats]
    least: tuple[float, float]
    share: float
    threshold: float | None = None


class CurvesPlot(QWidget):
    """Draws the curves of a :class:`CurvesScene`; they stay while only the playhead moves.

    Signals:
        frame_sought(int): a click or a drag.
    """

    frame_sought = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene = CurvesScene("")
        self._shown = TimeAxis(0.0, 1.0, 0.0, 1.0, 1)
        self._still = StillPicture(self)
        self._strips = (
            _Strip(self.tr("Score"), lambda one: one.score, (-1.0, 1.0), 0.46, THRESHOLD),
            _Strip(self.tr("Entropy"), lambda one: one.entropy, (0.0, 1.0), 0.27),
            _Strip(self.tr("Particles"), lambda one: one.particles, (0.0, 10.0), 0.27),
        )
        self.setAccessibleName(self.tr("Failure score, entropy and particles over time"))
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)

    def show_scene(self, scene: CurvesScene) -> None:
        """Draw another instant; the curves only where they are others."""
        before, self._scene = self._scene, scene
        if (before.curves, before.chosen, before.message) != (
            scene.curves,
            scene.chosen,
            scene.message,
        ):
            self._still.forget()
        self.setAccessibleDescription("\n".join(scene.said) or scene.message)
        self.update()

    def show_axis(self, axis: TimeAxis) -> None:
        """Show the frames the timeline's lanes show."""
        self._shown = axis
        self._still.forget()
        self.update()

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Three low plots."""
        return QSize(420, 14 * self.fontMetrics().height())

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Still readable."""
        return QSize(200, 8 * self.fontMetrics().height())

    @property
    def _axis(self) -> TimeAxis:
        metrics = QFontMetricsF(scaled_font(self.font(), _SMALL))
        left = max(metrics.horizontalAdvance(strip.name) for strip in self._strips) + 16
        return self._shown.resized(left, self.width() - left - 12)

    # drawing

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002, N802
        """The curves from their picture, then the playhead."""
        theme, painter = current_theme(), QPainter(self)
        self._still.paint(painter, theme.surface, lambda still: self._draw_still(still, theme))
        axis = self._axis
        x = axis.x_of(self._scene.frame + 0.5)
        if self._scene.curves and axis.left <= x <= axis.left + axis.width:
            painter.setPen(QPen(theme.accent, 1.6))
            painter.drawLine(QLineF(x, 0, x, self.height()))
        painter.end()

    def _draw_still(self, painter: QPainter, theme: Theme) -> None:
        painter.setFont(scaled_font(self.font(), _SMALL))
        if self._scene.message:
            draw_message(painter, QRectF(self.rect()), self._scene.message, theme)
        else:
            self._draw_strips(painter, theme)

    def _draw_strips(self, painter: QPainter, theme: Theme) -> None:
        metrics, axis = QFontMetricsF(painter.font()), self._axis
        foot = metrics.height() + 4
        room = self.height() - foot - _GAP_PX * (len(self._strips) - 1)
        top = 2.0
        for strip in self._strips:
            place = QRectF(axis.left, top, axis.width, strip.share * room)
            self._draw_strip(painter, strip, place, theme)
            top = place.bottom() + _GAP_PX
        painter.setPen(theme.text_muted)
        least = _TICK_LETTERS * metrics.averageCharWidth()
        for frame, text in ticks(axis, self._scene.fps, least):
            at = QRectF(axis.x_of(frame) - least / 2, self.height() - foot, least, foot)
            if at.left() >= axis.left and at.right() <= self.width():
                painter.drawText(at, Qt.AlignmentFlag.AlignCenter, text)

    def _draw_strip(self, painter: QPainter, strip: _Strip, place: QRectF, theme: Theme) -> None:
        painter.fillRect(place, theme.sunken)
        values = [strip.values(curve) for curve in self._scene.curves]
        span = span_of(values, strip.least) if strip.threshold is None else score_span(values)
        self._name_strip(painter, strip, place, span, theme)
        painter.save()
        painter.setClipRect(place.adjusted(0, -1, 0, 1))
        inner = place.adjusted(0, 3, 0, -3)
        if strip.threshold is not None:
            self._draw_threshold(painter, strip.threshold, inner, span, theme)
        chosen = self._scene.chosen
        for part in sorted(range(len(values)), key=lambda one: one == chosen):
            path = curve_path(
                self._scene.curves[part].frames, values[part], self._axis, inner, span
            )
            colour = theme.track(PART_COLOURS[part])
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(colour, 2.4 if part == chosen else 1.3))
            painter.drawPath(path)
        painter.restore()

    def _draw_threshold(
        self,
        painter: QPainter,
        threshold: float,
        place: QRectF,
        span: tuple[float, float],
        theme: Theme,
    ) -> None:
        """A dashed line above which a part has failed; shaded where the chosen part has."""
        curve, axis = self._scene.curves[self._scene.chosen], self._axis
        columns = max(1, int(axis.width * painter.device().devicePixelRatioF()))
        ranges = stretches(curve.frames[curve.failed])
        shares = covered(ranges, axis.edges(columns))
        draw_strip(painter, opacity(shares), faded(theme.danger, 0.25), place)
        share = (threshold - span[0]) / (span[1] - span[0])
        y = place.bottom() - share * place.height()
        painter.setPen(QPen(theme.danger, 1.2, Qt.PenStyle.DashLine))
        painter.drawLine(QLineF(place.left(), y, place.right(), y))

    def _name_strip(
        self,
        painter: QPainter,
        strip: _Strip,
        place: QRectF,
        span: tuple[float, float],
        theme: Theme,
    ) -> None:
        flags = Qt.AlignmentFlag
        beside = QRectF(4, place.top(), place.left() - 10, place.height())
        painter.setPen(theme.text_muted)
        painter.drawText(beside, flags.AlignVCenter | flags.AlignRight, strip.name)
        if place.height() > 3.4 * painter.fontMetrics().height():
            painter.setPen(theme.text_faint)
            painter.drawText(beside, flags.AlignTop | flags.AlignRight, f"{span[1]:.3g}")
            painter.drawText(beside, flags.AlignBottom | flags.AlignRight, f"{span[0]:.3g}")

    # gestures

    def mousePressEvent(self, event: QMouseEvent) -> None:  # noqa: N802 - Qt's name
        """Go to the frame under the mouse."""
        self._seek(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:  # noqa: N802
        """Go on with the button held."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._seek(event.position())

    def _seek(self, at: QPointF) -> None:
        if self._scene.curves and at.x() >= self._axis.left:
            self.frame_sought.emit(self._axis.frame_at(at.x()))

    def changeEvent(self, event: QEvent) -> None:  # noqa: N802
        """Follow theme and font."""
        super().changeEvent(event)
        if event.type() in (QEvent.Type.PaletteChange, QEvent.Type.FontChange):
            self._still.forget()
            self.update()
