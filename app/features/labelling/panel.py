"""The labelling that goes on: what to do, what was said or drawn, and how to leave."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import scaled_font
from app.core.scenes.labels import Tool
from app.core.widgets.fitted_scroll import ScrolledPanel
from app.core.widgets.parts import NOTICE_MARGINS, quiet
from app.features.labelling.lists import DrawnList, RangesList
from app.features.labelling.scene import LabellingScene
from app.features.labelling.verdicts import PartsGrid


class LabellingPanel(ScrolledPanel):
    """Draws a :class:`LabellingScene`; hidden without one.

    Its three pages, `parts`, `drawn` and `ranges`, say by their own signals what was done there.

    Signals:
        leave_asked(): the button beside the title.
    """

    leave_asked = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("notice", True)
        self.setAccessibleName(tr("Labelling"))
        rows = QVBoxLayout(self.content)
        rows.setContentsMargins(*NOTICE_MARGINS)
        rows.setSpacing(8)
        self._title = QLabel(self)
        self._title.setFont(scaled_font(self.font(), 1.1, bold=True))
        self._title.setWordWrap(True)
        rows.addLayout(self._build_heading())
        self._hint = quiet("", self)
        self._hint.setWordWrap(True)
        rows.addWidget(self._hint)
        self._refused = QLabel(self)
        self._refused.setFont(scaled_font(self.font(), 1.0, bold=True))
        self._refused.setWordWrap(True)
        rows.addWidget(self._refused)
        self.parts, self.drawn, self.ranges = PartsGrid(self), DrawnList(self), RangesList(self)
        self._pages = QStackedWidget(self)
        for page in (self.parts, self.drawn, self.ranges):
            self._pages.addWidget(page)
        rows.addWidget(self._pages)
        self.hide()

    def _build_heading(self) -> QHBoxLayout:
        """The title, and beside it how to leave: what is below the fold on a low screen is not."""
        line = QHBoxLayout()
        line.setSpacing(8)
        line.addWidget(self._title, 1)
        done = QPushButton(tr("Done  (Esc)"), self)
        done.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        done.clicked.connect(self.leave_asked)
        line.addWidget(done, 0, Qt.AlignmentFlag.AlignTop)
        return line

    def show_scene(self, scene: LabellingScene | None) -> None:
        """Show another state of the labelling."""
        self.setVisible(scene is not None)
        if scene is None:
            return
        self._title.setText(scene.title)
        self._hint.setText(scene.hint)
        self._refused.setText(scene.refused)
        self._refused.setAccessibleName(scene.refused)
        self._refused.setVisible(bool(scene.refused))
        if scene.tool is Tool.PARTS:
            page: QWidget = self.parts
            self.parts.show_scene(scene)
        elif scene.tool is Tool.REVIEWED:
            page = self.ranges
            self.ranges.show_scene(scene)
        else:
            page = self.drawn
            self.drawn.show_scene(scene)
        self._pages.setCurrentWidget(page)
        for other in (self.parts, self.drawn, self.ranges):
            fits = QSizePolicy.Policy.Preferred if other is page else QSizePolicy.Policy.Ignored
            other.setSizePolicy(QSizePolicy.Policy.Preferred, fits)
        self._pages.updateGeometry()
