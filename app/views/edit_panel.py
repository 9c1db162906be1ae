"""An edit that waits for Enter: what it will do, how far it reaches, where it cuts."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QFocusEvent, QIntValidator, QKeyEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.presenters.scenes import EditPreview
from app.views.icons import IconButton
from app.views.parts import quiet
from app.views.preview_legend import PreviewLegend
from app.views.theme import scaled_font

_LARGEST_ID = 2**31 - 1


class IdEdit(QLineEdit):
    """Takes a track's id. It wants digits and their correction only: other keys stay shortcuts.

    Signals:
        typed(int): Enter was pressed.
    """

    typed = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setValidator(QIntValidator(1, _LARGEST_ID, self))
        self.returnPressed.connect(lambda: self.typed.emit(int(self.text())))

    def wants(self, event: QKeyEvent) -> bool:
        """Whether a key is typed into the field rather than a shortcut of the window."""
        corrections = (Qt.Key.Key_Backspace, Qt.Key.Key_Return, Qt.Key.Key_Enter)
        return event.text().isdigit() or (bool(self.text()) and event.key() in corrections)

    def event(self, event: QEvent) -> bool:
        """Leave the keys to the window that are not wanted here."""
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            event.setAccepted(self.wants(event))
            return event.isAccepted()
        return super().event(event)

    def focusInEvent(self, event: QFocusEvent) -> None:  # noqa: N802 - Qt's name
        """What is typed replaces what is there."""
        super().focusInEvent(event)
        self.selectAll()


class EditPanel(QFrame):
    """Draws an :class:`EditPreview`; hidden without one.

    Signals:
        confirmed(), cancelled(): Enter, Esc.
        cut_moved(int): by so many frames.
        choice_made(int): one of the preview's choices, counted from 0.
        other_typed(int): the other person's id.
    """

    confirmed = Signal()
    cancelled = Signal()
    cut_moved = Signal(int)
    choice_made = Signal(int)
    other_typed = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._choices: tuple[str, ...] = ()
        self._asking = False
        self.setProperty("notice", True)
        self.setAccessibleName(self.tr("Edit preview"))
        rows = QVBoxLayout(self)
        rows.setContentsMargins(12, 10, 12, 10)
        rows.setSpacing(8)
        self._title = self._words(rows)
        self._title.setFont(scaled_font(self.font(), 1.1, bold=True))
        self._build_other(rows)
        self._build_choices(rows)
        self._build_nudge(rows)
        self._details = self._words(rows)
        self._legend = PreviewLegend(self)
        rows.addWidget(self._legend, 0, Qt.AlignmentFlag.AlignLeft)
        self._hint = self._words(rows, "muted")
        self._build_ends(rows)
        self.hide()

    def _words(self, rows: QVBoxLayout, role: str = "") -> QLabel:
        label = quiet("", self, role)
        label.setWordWrap(True)
        rows.addWidget(label)
        return label

    def _line(self, rows: QVBoxLayout, title: QLabel) -> tuple[QWidget, QHBoxLayout]:
        """A row with its title, which can be hidden as a whole."""
        widget = QWidget(self)
        line = QHBoxLayout(widget)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(6)
        line.addWidget(title)
        rows.addWidget(widget)
        return widget, line

    def _build_other(self, rows: QVBoxLayout) -> None:
        title = quiet(self.tr("Other person"), self)
        self._other_line, line = self._line(rows, title)
        self._other = IdEdit(self)
        self._other.setPlaceholderText(self.tr("id"))
        self._other.setAccessibleName(self.tr("Id of the other person"))
        self._other.setToolTip(self.tr("Type their id and press Enter"))
        self._other.setMaximumWidth(12 * self.fontMetrics().averageCharWidth())
        self._other.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._other.typed.connect(self.other_typed)
        line.addWidget(self._other)
        line.addStretch(1)

    def _build_choices(self, rows: QVBoxLayout) -> None:
        self._choice_title = quiet("", self)
        rows.addWidget(self._choice_title)
        self._choice_frame = QFrame(self)
        self._choice_frame.setProperty("track", True)
        self._choice_row = QHBoxLayout(self._choice_frame)
        self._choice_row.setContentsMargins(2, 2, 2, 2)
        self._choice_row.setSpacing(2)
        self._choice_group = QButtonGroup(self)
        rows.addWidget(self._choice_frame, 0, Qt.AlignmentFlag.AlignLeft)

    def _build_nudge(self, rows: QVBoxLayout) -> None:
        self._nudge, line = self._line(rows, quiet(self.tr("Cut at"), self))
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
        line.addStretch(1)

    def _build_ends(self, rows: QVBoxLayout) -> None:
        line = QHBoxLayout()
        line.setSpacing(8)
        self._cancel = QPushButton(self.tr("Cancel  Esc"), self)
        self._cancel.setAccessibleName(self.tr("Leave the edit undone"))
        self._cancel.clicked.connect(self.cancelled)
        self._confirm = QPushButton(self.tr("Apply  Enter"), self)
        self._confirm.setAccessibleName(self.tr("Do the edit"))
        self._confirm.setProperty("primary", True)
        self._confirm.clicked.connect(self.confirmed)
        line.addStretch(1)
        for button in (self._cancel, self._confirm):
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            line.addWidget(button)
        rows.addLayout(line)

    def show_scene(self, preview: EditPreview | None) -> None:
        """Show what would be done, or nothing."""
        self.setVisible(preview is not None)
        if preview is None:
            self._ask(False)
            return
        self._title.setText(preview.title)
        self._details.setText("\n".join(preview.details))
        self._details.setVisible(bool(preview.details))
        self._hint.setText(preview.hint)
        self._hint.setVisible(bool(preview.hint))
        self._frame.setText(self.tr("frame {0}").format(preview.frame))
        self._nudge.setVisible(preview.ready and preview.has_cut)
        self._confirm.setVisible(preview.ready)
        self._legend.setVisible(preview.ready)
        self._other_line.setVisible(preview.other is not None)
        self._other.setText(str(preview.other or ""))
        self._ask(preview.other == 0)
        self._show_choices(preview)

    def _ask(self, asking: bool) -> None:
        """Take the keyboard for the id when it begins to be asked for, give it back after."""
        if asking and not self._asking:
            self._other.setFocus(Qt.FocusReason.OtherFocusReason)
        elif not asking:
            self._other.clearFocus()
        self._asking = asking

    def _show_choices(self, preview: EditPreview) -> None:
        shown = preview.ready and len(preview.choices) > 1
        self._choice_title.setVisible(shown)
        self._choice_title.setText(preview.choice_title)
        self._choice_frame.setVisible(shown)
        self._choice_frame.setAccessibleName(preview.choice_title)
        if preview.choices != self._choices:
            self._choices = preview.choices
            for button in self._choice_group.buttons():
                self._choice_group.removeButton(button)
                self._choice_row.removeWidget(button)
                button.deleteLater()
            for number, text in enumerate(preview.choices):
                self._add_choice(number, text)
        for button in self._choice_group.buttons():
            button.setChecked(self._choice_group.id(button) == preview.choice)

    def _add_choice(self, number: int, text: str) -> None:
        button = QToolButton(self._choice_frame)
        button.setText(text)
        button.setAccessibleName(text)
        button.setCheckable(True)
        button.setProperty("segment", True)
        button.setProperty("tight", True)
        button.setFont(scaled_font(self.font(), 0.92))
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        button.clicked.connect(lambda: self.choice_made.emit(number))
        self._choice_group.addButton(button, number)
        self._choice_row.addWidget(button)
