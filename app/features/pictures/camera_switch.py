"""Which cameras are shown: left, both, or both in one red-cyan picture."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QFrame, QHBoxLayout, QToolButton, QWidget

from app.core.i18n import tr


class CameraSwitch(QFrame):
    """Three joined buttons.

    Signals:
        mode_chosen(str): "left", "both" or "anaglyph".
    """

    mode_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("track", True)
        self.setAccessibleName(tr("Cameras shown"))
        row = QHBoxLayout(self)
        row.setContentsMargins(2, 2, 2, 2)
        row.setSpacing(2)
        self._group = QButtonGroup(self)
        self._buttons: dict[str, QToolButton] = {}
        for mode, text in (
            ("left", tr("Left")),
            ("both", tr("Both")),
            ("anaglyph", tr("Anaglyph")),
        ):
            self._add(mode, text, row)
        self.show_scene("left")

    def show_scene(self, mode: str, stereo: bool = True) -> None:
        """Show which mode is on; a monocular recording has only the left camera."""
        self._buttons[mode].setChecked(True)
        for name in ("both", "anaglyph"):
            self._buttons[name].setEnabled(stereo)

    def _add(self, mode: str, text: str, row: QHBoxLayout) -> None:
        button = QToolButton(self)
        button.setText(text)
        button.setAccessibleName(tr("Show: {0}").format(text))
        button.setCheckable(True)
        button.setProperty("segment", True)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        button.clicked.connect(lambda: self.mode_chosen.emit(mode))
        self._group.addButton(button)
        self._buttons[mode] = button
        row.addWidget(button)
