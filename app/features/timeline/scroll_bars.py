"""The two scroll bars of the lanes: down through the tracks, along through the time."""

from __future__ import annotations

from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtWidgets import QScrollBar, QWidget

from app.core.plots.axis import TimeAxis

BAR_PX = 12


class LanesBar(QScrollBar):
    """Scrolls the lanes; its value is in pixels."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(Qt.Orientation.Vertical, parent)

    def fit(self, area: QRectF, whole: float, step: float) -> None:
        """Stand at the right of an area in which lanes of that height are scrolled."""
        height = area.height()
        place = QRect(round(area.right()) - BAR_PX, round(area.top()), BAR_PX, max(0, int(height)))
        self.setGeometry(place)
        self.setRange(0, max(0, round(whole - height)))
        self.setPageStep(max(1, round(height)))
        self.setSingleStep(round(step))
        self.setVisible(whole > height)


class TimeBar(QScrollBar):
    """Scrolls in time; its value is the first frame shown. Hidden where all frames are."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)

    def fit(self, axis: TimeAxis, bottom: int) -> None:
        """Stand below the lanes and show where the axis is; that is no scrolling."""
        self.blockSignals(True)
        self.setVisible(axis.frames < axis.frame_count)
        self.setRange(0, max(0, int(axis.frame_count - axis.frames)))
        self.setPageStep(max(1, int(axis.frames)))
        self.setSingleStep(max(1, int(axis.frames / 20)))
        self.setValue(int(axis.start))
        self.blockSignals(False)
        self.setGeometry(round(axis.left), bottom - BAR_PX, round(axis.width), BAR_PX)

    @property
    def room(self) -> int:
        """The height it takes from the lanes, shown or hidden with all that is around it."""
        return 0 if self.isHidden() else BAR_PX
