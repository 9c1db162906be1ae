"""Counts over the frames that the timeline shows."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFontMetricsF, QPainter, QPen
from PySide6.QtWidgets import QWidget

from app.core.drawing.name_plates import draw_message
from app.core.i18n import joined_text, tr
from app.core.look.theme import Theme, faded
from app.core.plots.curves import curve_path, whole_span
from app.core.plots.frame_plot import FramePlot
from app.core.widgets.spoken_description import SpokenDescription, told_lines
from app.features.counting.scene import CountCurve, CountingScene, CountPlot

_GAP_PX = 8.0
_KEY_PX = 16.0


def _told_plot(plot: CountPlot, frame: int) -> str:
    values = [
        f"{one.label} {float(one.values[frame]):.3g} {plot.unit}".strip()
        for one in plot.curves
        if frame < len(one.values)
    ]
    return tr("{name}: {told}", name=plot.name, told=joined_text(", ", values))


class CountsPlot(FramePlot):
    """Draws the plots of a :class:`CountingScene`; they stay while only the playhead moves."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scene = CountingScene()
        self.setAccessibleName(tr("Counts over time"))
        self._spoken = SpokenDescription(self, self._words)

    def show_scene(self, scene: CountingScene) -> None:
        """Draw another frame; the curves only where they are others."""
        before, self._scene = self._scene, scene
        if before.plots is not scene.plots or self._said(before) != self._said(scene):
            self.draw_anew()
        self.show_playhead(scene.frame)
        self._spoken.changed()

    def _words(self) -> str:
        """What is plotted, and each curve at the frame shown."""
        scene = self._scene
        if not scene.plots:
            return self._said(scene)
        frame = tr("Frame {frame}", frame=scene.frame)
        return told_lines(frame, *(_told_plot(plot, scene.frame) for plot in scene.plots))

    def sizeHint(self) -> QSize:  # noqa: N802 - Qt's name
        """Two or three low plots."""
        return QSize(420, 12 * self.fontMetrics().height())

    def minimumSizeHint(self) -> QSize:  # noqa: N802
        """Still readable."""
        return QSize(200, 6 * self.fontMetrics().height())

    @property
    def has_curves(self) -> bool:
        """Whether something is plotted."""
        return bool(self._scene.plots)

    def names_width(self, metrics: QFontMetricsF) -> float:
        """Of the longest name or unit."""
        names = [name for plot in self._scene.plots for name in (plot.name, plot.unit)]
        return max(map(metrics.horizontalAdvance, names), default=60.0)

    def draw_still(self, painter: QPainter, theme: Theme) -> None:
        """All plots below each other, or what to do where there are none."""
        plots = self._scene.plots
        if not plots:
            draw_message(painter, QRectF(self.rect()), self._said(self._scene), theme)
            return
        axis, foot = self.axis, QFontMetricsF(painter.font()).height() + 4
        height = (self.height() - foot - _GAP_PX * (len(plots) - 1)) / len(plots)
        top, told = 2.0, tuple[str, ...]()
        for plot in plots:
            place = QRectF(axis.left, top, axis.width, height)
            self._draw_plot(painter, plot, place, theme)
            labels = tuple(curve.label for curve in plot.curves)
            if len(labels) > 1 and labels != told:
                _draw_key(painter, plot, place, theme)
            top, told = place.bottom() + _GAP_PX, labels
        self.draw_times(painter, foot, self._scene.fps, theme)

    def _draw_plot(self, painter: QPainter, plot: CountPlot, place: QRectF, theme: Theme) -> None:
        painter.fillRect(place, theme.sunken)
        _, high = whole_span([curve.values for curve in plot.curves], (0.0, plot.high))
        self._name_plot(painter, plot, place, high, theme)
        painter.save()
        painter.setClipRect(place.adjusted(0, -1, 0, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        inner = place.adjusted(0, 3, 0, -2)
        for curve in plot.curves:
            frames = np.arange(len(curve.values))
            painter.setPen(_pen(curve, theme))
            painter.drawPath(curve_path(frames, curve.values, self.axis, inner, (0.0, high)))
        painter.restore()

    def _name_plot(
        self, painter: QPainter, plot: CountPlot, place: QRectF, high: float, theme: Theme
    ) -> None:
        """The name and the unit at the left, and what the lower and the upper edge stand for."""
        flags = Qt.AlignmentFlag
        beside = QRectF(4, place.top(), place.left() - 10, place.height())
        line = painter.fontMetrics().height()
        names = plot.name
        if plot.unit and place.height() >= 2 * line:
            names = f"{plot.name}\n{plot.unit}"
        painter.setPen(theme.text_muted)
        painter.drawText(beside, flags.AlignVCenter | flags.AlignRight, names)
        lines = len(names.splitlines()) + 2.4
        if place.height() > lines * line:
            painter.setPen(theme.text_faint)
            painter.drawText(beside, flags.AlignTop | flags.AlignRight, f"{high:.3g}")
            painter.drawText(beside, flags.AlignBottom | flags.AlignRight, "0")

    def _said(self, scene: CountingScene) -> str:
        return scene.message or scene.doing


def _draw_key(painter: QPainter, plot: CountPlot, place: QRectF, theme: Theme) -> None:
    """Which curve is which, in the upper left corner, on a plate over the curves.

    The next plot of the same curves has none: peaks of a step would lie under it.
    """
    metrics = QFontMetricsF(painter.font())
    wide = sum(_KEY_PX + 18 + metrics.horizontalAdvance(curve.label) for curve in plot.curves)
    plate = QRectF(place.left() + 2, place.top() + 1, wide, metrics.height() * 1.2 + 2)
    painter.fillRect(plate.intersected(place), faded(theme.sunken, 0.85))
    at = QPointF(place.left() + 6, place.top() + metrics.height() * 0.6 + 2)
    for curve in plot.curves:
        painter.setPen(_pen(curve, theme))
        painter.drawLine(at, at + QPointF(_KEY_PX, 0))
        painter.setPen(theme.text_muted)
        painter.drawText(at + QPointF(_KEY_PX + 4, metrics.ascent() / 2 - 1), curve.label)
        at += QPointF(_KEY_PX + 18 + metrics.horizontalAdvance(curve.label), 0)


def _pen(curve: CountCurve, theme: Theme) -> QPen:
    pen = QPen(theme.track(curve.colour), 1.8)
    if curve.dashed:
        pen.setDashPattern([3.0, 2.0])
    return pen
