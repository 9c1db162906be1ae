"""The plots of a person's parts with their figures at the playhead."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QGridLayout, QLabel, QVBoxLayout, QWidget

from app.core.feature import FeaturePanel
from app.core.i18n import tr
from app.core.look.icons import IconButton
from app.core.look.theme import scaled_font
from app.core.plots.axis import TimeAxis
from app.core.scenes.labels import PART_COLOURS
from app.core.widgets.parts import Swatch
from app.features.parts.curves_plot import CurvesPlot
from app.features.parts.scene import CurvesScene


class CurvesPanel(FeaturePanel):
    """Draws a :class:`CurvesScene`; hidden without one.

    Signals:
        frame_sought(int): a click into the plots.
    """

    frame_sought = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Parts over time"), parent)
        close = IconButton("close", tr("Hide the parts over time"), "view.curves", self)
        close.clicked.connect(lambda: self.command_asked.emit("view.curves"))
        self.add_to_heading(close)
        self.plot = CurvesPlot(self)
        self.plot.frame_sought.connect(self.frame_sought)
        self._swatches = [Swatch(self) for _ in PART_COLOURS]
        self._said = [QLabel(self) for _ in PART_COLOURS]
        body = QVBoxLayout()
        body.setSpacing(6)
        body.addLayout(self._legend())
        body.addWidget(self.plot, 1)
        self.layout_body(body)
        self.hide()

    def _legend(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(6)
        grid.setVerticalSpacing(1)
        grid.setColumnStretch(1, 1)
        for line, (swatch, said) in enumerate(zip(self._swatches, self._said, strict=True)):
            grid.addWidget(swatch, line, 0)
            grid.addWidget(said, line, 1)
        return grid

    def show_axis(self, axis: TimeAxis) -> None:
        """The timeline shows other frames."""
        self.plot.show_axis(axis)

    def show_scene(self, scene: CurvesScene | None) -> None:
        """Show another frame, or nothing at all."""
        self.setVisible(scene is not None)
        if scene is None:
            return
        self.set_title(scene.title)
        for part, (swatch, said) in enumerate(zip(self._swatches, self._said, strict=True)):
            there = part < len(scene.said)
            swatch.setVisible(there)
            said.setVisible(there)
            if there:
                swatch.set_track_colour(PART_COLOURS[part])
                said.setText(scene.said[part])
                said.setFont(scaled_font(self.font(), 0.92, bold=part == scene.chosen))
        self.plot.show_scene(scene)
