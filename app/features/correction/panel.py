"""An edit that waits for Enter: what it will do, how far it reaches, where it cuts."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.core.drawing.preview_legend import PreviewLegend
from app.core.i18n import tr
from app.core.keymap import shown_key
from app.core.look.icons import IconButton
from app.core.look.theme import scaled_font
from app.core.scenes import EditPreview
from app.core.widgets.choices import ChoiceButtons, ProposalChips
from app.core.widgets.id_edit import IdEdit
from app.core.widgets.parts import NOTICE_MARGINS, quiet

_CHOICE_ROWS = 2
_SPACING, _LITTLE_SPACING = 8, 3


class EditPanel(QFrame):
    """Draws an :class:`EditPreview`; hidden without one.

    Signals:
        confirmed(), cancelled(): Enter, Esc.
        cut_moved(int), end_moved(int): by so many frames.
        choice_made(int, int): which row of choices, and which of its options.
        other_typed(int): the other person's id, typed or clicked.
        other_considered(int): the id typed so far; 0: none.
        cut_proposed(int): which of the frames that were found.
    """

    confirmed = Signal()
    cancelled = Signal()
    cut_moved = Signal(int)
    end_moved = Signal(int)
    choice_made = Signal(int, int)
    other_typed = Signal(int)
    other_considered = Signal(int)
    cut_proposed = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._asking = self._terse = False
        self._ready_with = 0
        self._had_keyboard: QWidget | None = None
        self.setProperty("notice", True)
        self.setAccessibleName(tr("Edit preview"))
        rows = QVBoxLayout(self)
        rows.setContentsMargins(*NOTICE_MARGINS)
        rows.setSpacing(_SPACING)
        self._title = self._words(rows)
        self._title.setFont(scaled_font(self.font(), 1.1, bold=True))
        self._build_other(rows)
        self._build_cuts(rows)
        self._build_choices(rows)
        self._build_frames(rows)
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
        self._other_title = quiet(tr("With"), self)
        self._other_line, line = self._line(rows, self._other_title)
        self._other = IdEdit(self)
        self._other.setPlaceholderText(tr("id"))
        self._other.setAccessibleName(tr("Id of the other person"))
        self._other.setToolTip(tr("Type their id; Enter applies what is then shown"))
        self._other.setMaximumWidth(9 * self.fontMetrics().averageCharWidth())
        self._other.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._other.typed.connect(self._take_typed)
        self._other.considered.connect(self.other_considered)
        self._others = ProposalChips("", self)
        self._others.chosen.connect(self.other_typed)
        line.addWidget(self._other)
        line.addWidget(self._others, 1)
        line.addStretch(0)

    def _build_cuts(self, rows: QVBoxLayout) -> None:
        self._cuts = ProposalChips(tr("Swapped at"), self)
        self._cuts.chosen.connect(self.cut_proposed)
        rows.addWidget(self._cuts)

    def _build_choices(self, rows: QVBoxLayout) -> None:
        self._choices = [ChoiceButtons(self) for _ in range(_CHOICE_ROWS)]
        for row, buttons in enumerate(self._choices):
            buttons.chosen.connect(lambda number, row=row: self.choice_made.emit(row, number))
            rows.addWidget(buttons)

    def _build_frames(self, rows: QVBoxLayout) -> None:
        """The cut and, beside it, the end of a range, each with buttons to move it."""
        self._frames = QWidget(self)
        line = QHBoxLayout(self._frames)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(12)
        cut, self._frame = self._nudge(tr("From"), "play.previous", "play.next")
        self._cut_title = cut.title
        cut.moved.connect(self.cut_moved)
        commands = "play.previous_second", "play.next_second"
        self._until, self._end = self._nudge(tr("to"), *commands)
        self._until.moved.connect(self.end_moved)
        for widget in (cut, self._until):
            line.addWidget(widget)
        line.addStretch(1)
        rows.addWidget(self._frames)

    def _nudge(self, title: str, back: str, on: str) -> tuple[_Nudge, QLabel]:
        nudge = _Nudge(title, back, on, self._frames)
        return nudge, nudge.label

    def _build_ends(self, rows: QVBoxLayout) -> None:
        line = QHBoxLayout()
        line.setSpacing(8)
        self._cancel = QPushButton(tr("Cancel"), self)
        self._cancel.setAccessibleName(tr("Cancel the edit"))
        self._cancel.clicked.connect(self.cancelled)
        self._confirm = QPushButton(tr("Apply"), self)
        self._confirm.setAccessibleName(tr("Apply the edit"))
        self._confirm.setProperty("primary", True)
        self._confirm.clicked.connect(self.confirmed)
        line.addStretch(1)
        for button in (self._cancel, self._confirm):
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            line.addWidget(button)
        rows.addLayout(line)

    def set_terse(self, terse: bool) -> None:
        """On a low window: leave out what only explains, so that all of the rest is in sight."""
        if terse == self._terse:
            return
        self._terse = terse
        rows = self.layout()
        if rows is not None:
            rows.setSpacing(_LITTLE_SPACING if terse else _SPACING)
        self._hint.setVisible(bool(self._hint.text()) and not terse)
        self._legend.setVisible(self._confirm.isEnabled() and not terse)

    def show_scene(self, preview: EditPreview | None) -> None:
        """Show what would be done, or nothing."""
        if preview is None:
            self._ready_with = 0
            self._other.take_back()
            self._ask(False)
            self.hide()
            return
        self.show()
        self._title.setText(preview.title)
        self._details.setText("\n".join(preview.details))
        self._details.setVisible(bool(preview.details))
        self._hint.setText(preview.hint)
        self._hint.setVisible(bool(preview.hint) and not self._terse)
        self.setToolTip(preview.hint)
        self._frame.setText(str(preview.frame))
        self._cut_title.setText(tr("From") if preview.begins else tr("At"))
        self._other_title.setText(tr("To") if preview.gives else tr("With"))
        self._until.setVisible(preview.end is not None)
        self._end.setText(str(preview.end - 1) if preview.end is not None else "")
        self._frames.setVisible(preview.has_cut and preview.other != 0)
        self._confirm.setEnabled(preview.ready)
        self._cancel.setText(f"{tr('Cancel')}  {shown_key('tracks.none')}".rstrip())
        self._confirm.setText(f"{tr('Apply')}  {shown_key('tracks.confirm')}".rstrip())
        self._legend.setVisible(preview.ready and not self._terse)
        self._other_line.setVisible(preview.other is not None)
        typing = self._goes_on_typing(preview.other or 0)
        if not typing:
            self._other.setText(str(preview.other or ""))
        self._ready_with = (preview.other or 0) if preview.ready else 0
        self._others.show_scene(preview.others)
        several = len(preview.cuts) > 1  # a single one stands in the line of frames already
        self._cuts.show_scene(preview.cuts if several else ())
        self._ask(preview.other == 0 or typing)
        shown = {choice.row: choice for choice in preview.choices} if preview.other != 0 else {}
        for row, buttons in enumerate(self._choices):
            buttons.show_scene(shown.get(row))

    def _goes_on_typing(self, other: int) -> bool:
        """Whether what is shown is of the id typed so far: then its field keeps the keyboard."""
        so_far = (0, self._ready_with, int(self._other.text() or 0))
        return self._other.being_typed and other in so_far

    def _take_typed(self, track: int) -> None:
        """Enter: do the edit that is shown with the id, or show it first."""
        if track == self._ready_with:
            self.confirmed.emit()
        else:
            self._other.setModified(False)
            self.other_typed.emit(track)

    def _ask(self, asking: bool) -> None:
        """Take the keyboard for the id when it begins to be asked for, give it back after.

        The window knows who has it also while a menu lies over it.
        """
        if asking and not self._asking:
            self._had_keyboard = self.window().focusWidget()
            self._other.setFocus(Qt.FocusReason.OtherFocusReason)
        elif not asking and self.window().focusWidget() is self._other:
            if self._had_keyboard is not None and self._had_keyboard.isVisible():
                self._had_keyboard.setFocus(Qt.FocusReason.OtherFocusReason)
            else:
                self._other.clearFocus()
        self._asking = asking


class _Nudge(QWidget):
    """A frame number between two buttons that move it; `moved(frames)` says by how many."""

    moved = Signal(int)

    def __init__(self, title: str, back: str, on: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.title = quiet(title, self)
        self.label = QLabel(self)
        self.label.setFont(scaled_font(parent.font(), 1.0, bold=True))
        earlier = IconButton("step-back", tr("{0} a frame earlier").format(title), back, self)
        earlier.clicked.connect(lambda: self.moved.emit(-1))
        later = IconButton("step-forward", tr("{0} a frame later").format(title), on, self)
        later.clicked.connect(lambda: self.moved.emit(1))
        line = QHBoxLayout(self)
        line.setContentsMargins(0, 0, 0, 0)
        line.setSpacing(4)
        for widget in (self.title, earlier, self.label, later):
            line.addWidget(widget)
        for button in (earlier, later):
            button.setAutoRepeat(True)
