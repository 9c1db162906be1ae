"""What is said to trackers that follow body parts: the failure detector, what hides people."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox, QFormLayout, QWidget

from app.core.document.detector_choice import DETECTOR, OCCLUDERS, DetectorChoice, PartSettings
from app.core.i18n import count_text, tr
from app.core.keymap import key_or_title
from app.core.widgets.parts import quiet
from tracking.trackers import settings_fields


class PartsLine(QWidget):
    """Chooses between the detector in use and the built-in one; tells of drawn occluders."""

    def __init__(self, asked: PartSettings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._asked = asked
        in_use = [asked.choice] if asked.choice.path else []
        self._choices = [*in_use, DetectorChoice()]
        self._detector = QComboBox(self)
        self._detector.addItems([choice.name for choice in self._choices])
        self._detector.setAccessibleName(tr("Part-failure detector"))
        tip = tr("Others are opened or trained in the Detector menu")
        self._detector.setToolTip(tip)
        self._occluders = quiet(self._said(len(asked.occluders)), self)
        self._occluders.setWordWrap(True)
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.addRow(tr("Part-failure detector"), self._detector)
        self._form.addRow(self._occluders)

    def _said(self, count: int) -> str:
        if not count:
            return tr(
                "No occluders are drawn: {key} draws outlines of objects that hide people.",
                key=key_or_title("labels.occluders"),
            )
        return count_text(
            count,
            "{n} drawn occluder hides people from the tracker.",
            "{n} drawn occluders hide people from the tracker.",
        )

    def show_for(self, settings_type: type) -> None:
        """Show what a tracker with these settings has a use for."""
        known = {field.name for field in settings_fields(settings_type)}
        self.setVisible(bool(known & {DETECTOR, OCCLUDERS}))
        self._form.setRowVisible(self._detector, DETECTOR in known)

    def asked(self) -> PartSettings:
        """The answer."""
        choice = self._choices[self._detector.currentIndex()]
        return PartSettings(choice, self._asked.occluders)
