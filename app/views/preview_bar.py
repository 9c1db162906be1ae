"""An edit that waits for Enter: what it will do, how far it reaches, where it cuts."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.presenters.scenes import EditPreview
from app.views.icons import IconButton
from app.views.parts import quiet
from app.views.theme import scaled_font


class PreviewBar(QFrame):
    """Draws an :class:`EditPreview`; hidden without one.

    Signals:
        confirmed(), cancelled(): Enter, Esc.
        cut_moved(int): by so many frames.
        scope_chosen(str): one of the preview's scopes.
    """

    confirmed = Signal()
    cancelled = Signal()
    cut_moved = Signal(int)
    scope_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._scopes: tuple[str, ...] = ()
        self.setProperty("notice", True)
        self.setAccessibleName(self.tr("Edit preview"))
        row = QHBoxLayout(self)
        row.setContentsMargins(16, 8, 16, 8)
        row.setSpacing(16)
        row.addLayout(self._build_words(), 1)
        self._build_scopes(row)
        self._build_nudge(row)
        self._build_ends(row)
        self.hide()

    def _build_words(self) -> QVBoxLayout:
        words = QVBoxLayout()
        words.setSpacing(2)
        self._title = QLabel(self)
        self._title.setFont(scaled_font(self.font(), 1.1, bold=True))
        self._details = quiet("", self)
        self._details.setWordWrap(True)
        words.addWidget(self._title)
        words.addWidget(self._details)
        return words

    def _build_scopes(self, row: QHBoxLayout) -> None:
        self._scope_frame = QFrame(self)
        self._scope_frame.setProperty("track", True)
        self._scope_frame.setAccessibleName(self.tr("How far the edit reaches"))
        self._scope_row = QHBoxLayout(self._scope_frame)
        self._scope_row.setContentsMargins(2, 2, 2, 2)
        self._scope_row.setSpacing(2)
        self._scope_group = QButtonGroup(self)
        row.addWidget(self._scope_frame, 0, Qt.AlignmentFlag.AlignVCenter)

    def _build_nudge(self, row: QHBoxLayout) -> None:
        self._nudge = QWidget(self)
        line = QHBoxLayout(self._nudge)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(4)
        earlier = IconButton("step-back", self.tr("Cut a frame earlier"), self.tr("Left"), self)
        earlier.clicked.connect(lambda: self.cut_moved.emit(-1))
        later = IconButton("step-forward", self.tr("Cut a frame later"), self.tr("Right"), self)
        later.clicked.connect(lambda: self.cut_moved.emit(1))
        for button in (earlier, later):
            button.setAutoRepeat(True)
        self._frame = QLabel(self)
        self._frame.setFont(scaled_font(self.font(), 1.0, bold=True))
        for widget in (earlier, self._frame, later):
            line.addWidget(widget)
        row.addWidget(self._nudge)

    def _build_ends(self, row: QHBoxLayout) -> None:
        self._cancel = QPushButton(self.tr("Cancel  Esc"), self)
        self._cancel.setAccessibleName(self.tr("Leave the edit undone"))
        self._cancel.clicked.connect(self.cancelled)
        self._confirm = QPushButton(self.tr("Apply  Enter"), self)
        self._confirm.setAccessibleName(self.tr("Do the edit"))
        self._confirm.setProperty("primary", True)
        self._confirm.clicked.connect(self.confirmed)
        for button in (self._cancel, self._confirm):
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            row.addWidget(button, 0, Qt.AlignmentFlag.AlignVCenter)

    def show_scene(self, preview: EditPreview | None) -> None:
        """Show what would be done, or nothing."""
        self.setVisible(preview is not None)
        if preview is None:
            return
        self._title.setText(preview.title)
        lines = [*preview.details, *([preview.hint] if preview.hint else [])]
        self._details.setText("  \u00b7  ".join(lines))
        self._details.setVisible(bool(lines))
        self._frame.setText(self.tr("frame {0}").format(preview.frame))
        self._nudge.setVisible(preview.ready)
        self._confirm.setVisible(preview.ready)
        self._show_scopes(preview)

    def _show_scopes(self, preview: EditPreview) -> None:
        self._scope_frame.setVisible(preview.ready and len(preview.scopes) > 1)
        if preview.scopes != self._scopes:
            self._scopes = preview.scopes
            for button in self._scope_group.buttons():
                self._scope_group.removeButton(button)
                self._scope_row.removeWidget(button)
                button.deleteLater()
            for scope in preview.scopes:
                self._add_scope(scope)
        for button in self._scope_group.buttons():
            button.setChecked(button.text() == preview.scope)

    def _add_scope(self, scope: str) -> None:
        button = QToolButton(self._scope_frame)
        button.setText(scope)
        button.setAccessibleName(self.tr("Scope: {0}").format(scope))
        button.setCheckable(True)
        button.setProperty("segment", True)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        button.clicked.connect(lambda: self.scope_chosen.emit(scope))
        self._scope_group.addButton(button)
        self._scope_row.addWidget(button)
