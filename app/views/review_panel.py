"""Where to look next; empty until suspicions are looked for."""

from __future__ import annotations

from PySide6.QtWidgets import QSizePolicy, QVBoxLayout, QWidget

from app.views.parts import Panel, quiet


class ReviewPanel(Panel):
    """The review queue. It says plainly that no suspicions have been looked for yet.

    While it is empty it takes a line and leaves the room to the panels below.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(self.tr("Review queue"), parent)
        self._empty = quiet("", self)
        self._empty.setToolTip(self.tr("Watch for ids that change place."))
        body = QVBoxLayout()
        body.addWidget(self._empty)
        self.layout_body(body)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self.show_scene()

    def show_scene(self, message: str = "") -> None:
        """Say why there is nothing to review."""
        self._empty.setText(message or self.tr("Likely mistakes are not looked for yet."))
