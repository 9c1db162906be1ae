"""Where to look next; empty until suspicions are looked for."""

from __future__ import annotations

from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.views.parts import EmptyState, Panel


class ReviewPanel(Panel):
    """The review queue. It says plainly that no suspicions have been looked for yet."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(self.tr("Review queue"), parent)
        self._empty = EmptyState("review", parent=self)
        body = QVBoxLayout()
        body.addWidget(self._empty)
        self.layout_body(body)
        self.show_scene()

    def show_scene(self, message: str = "") -> None:
        """Say why there is nothing to review."""
        self._empty.say(
            self.tr("Not looked for yet"),
            message
            or self.tr("Likely mistakes are not searched for. Watch for ids that change place."),
        )
