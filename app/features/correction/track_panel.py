"""The selected track in words: name, attributes, notes, where it is seen."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QAction, QFocusEvent, QKeyEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import count_text, joined_text, tr
from app.core.look.icons import IconButton
from app.core.look.theme import scaled_font
from app.core.scenes import TrackCard
from app.core.widgets.parts import Panel, Swatch, bring_into_view, heading, quiet
from app.features.correction.attributes import AttributesTable
from app.features.correction.schema_form import SchemaForm

_LEAST_LINES = 6
_MOST_NAMED = 8


class NameEdit(QLineEdit):
    """A line that is sent by Enter or by leaving it, and put back by Esc."""

    escaped = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Give the keyboard back on Esc and Enter."""
        if event.key() == Qt.Key.Key_Escape:
            self.escaped.emit()
            self.clearFocus()
            return
        super().keyPressEvent(event)
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.clearFocus()


class NotesEdit(QPlainTextEdit):
    """Free text, sent when it is left."""

    done = Signal()

    def focusOutEvent(self, event: QFocusEvent) -> None:  # noqa: N802
        """Send."""
        super().focusOutEvent(event)
        self.done.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802
        """Give the keyboard back on Esc."""
        if event.key() == Qt.Key.Key_Escape:
            self.clearFocus()
        else:
            super().keyPressEvent(event)


class TrackPanel(Panel):
    """Draws a :class:`TrackCard`, or says how to select a track.

    Signals:
        name_edited(int, str), notes_edited(int, str): track and the new text.
        attributes_edited(int, object): track and all own (name, value) pairs, a tuple.
        field_given(int, str, object): track, an attribute of the schema, its value or None.
        schema_asked(): which attributes people have is to be changed.
        frame_sought(int): to the track's first or last frame.
    """

    name_edited = Signal(int, str)
    notes_edited = Signal(int, str)
    attributes_edited = Signal(int, object)
    field_given = Signal(int, str, object)
    schema_asked = Signal()
    frame_sought = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Track"), parent)
        self._card: TrackCard | None = None
        self._tools: list[QToolButton] = []
        self._empty = quiet(tr("Click a person to see their track."), self)
        self._empty.setToolTip(tr("In an image, on the floor or in the timeline"))
        self._body = QWidget(self)
        rows = QVBoxLayout(self._body)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(8)
        self._several = quiet("", self._body)
        self._several.setWordWrap(True)
        rows.addWidget(self._several)
        self._build_name(rows)
        self._form = SchemaForm(self)  # what is set again and again is not below the fold
        self._form.value_given.connect(self._send_field)
        rows.addWidget(self._form)
        self._build_figures(rows)
        self._build_attributes(rows)
        self._build_notes(rows)
        both = QVBoxLayout()  # no stack: what is hidden would keep its room
        both.addWidget(self._empty, 0, Qt.AlignmentFlag.AlignTop)
        self._scroll = QScrollArea(self)  # a card that is too high scrolls by itself
        self._scroll.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._scroll.setWidget(self._body)
        self._scroll.setWidgetResizable(True)
        for widget in (self._body, self._scroll.viewport()):
            widget.setAutoFillBackground(False)  # the panel's own is seen
        self._scroll.setFrameShape(QFrame.Shape.NoFrame)
        self._scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._scroll.setMinimumHeight(_LEAST_LINES * self.fontMetrics().lineSpacing())
        # Selecting somebody must not move the panels below away from the pointer.
        self._empty.setMinimumHeight(self._scroll.minimumHeight())
        self._empty.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._scroll.setMinimumWidth(self._body.minimumSizeHint().width())
        self._scroll.setFocusProxy(self._attributes)
        both.addWidget(self._scroll)
        self._scroll.hide()
        self.layout_body(both)

    def _build_name(self, rows: QVBoxLayout) -> None:
        row = QHBoxLayout()
        row.setSpacing(8)
        self._swatch = Swatch(self)
        self._id = QLabel(self)
        self._id.setFont(scaled_font(self.font(), 1.3, bold=True))
        self._name = NameEdit(self)
        self._name.setPlaceholderText(tr("Name this person"))
        self._name.setAccessibleName(tr("Name of the track"))
        self._name.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._name.editingFinished.connect(self._send_name)
        self._name.escaped.connect(
            lambda: self._name.setText(self._card.name if self._card else "")
        )
        row.addWidget(self._swatch)
        row.addWidget(self._id)
        row.addWidget(self._name, 1)
        rows.addLayout(row)

    def _build_figures(self, rows: QVBoxLayout) -> None:
        grid = QGridLayout()
        grid.setHorizontalSpacing(16)
        grid.setVerticalSpacing(4)
        grid.setColumnStretch(1, 1)
        self._range = QHBoxLayout()
        self._first, self._last = self._link(), self._link()
        self._range.setSpacing(4)
        self._range.addWidget(self._first)
        self._range.addWidget(quiet("\u2013", self))
        self._range.addWidget(self._last)
        self._range.addStretch(1)
        self._seen, self._confidence = QLabel(self), QLabel(self)
        self._seen.setWordWrap(True)
        grid.addWidget(quiet(tr("Frames"), self), 0, 0)
        grid.addLayout(self._range, 0, 1)
        for line, name, value in (
            (1, tr("Seen"), self._seen),
            (2, tr("Confidence"), self._confidence),
        ):
            grid.addWidget(quiet(name, self), line, 0)
            grid.addWidget(value, line, 1)
        rows.addLayout(grid)

    def _build_attributes(self, rows: QVBoxLayout) -> None:
        self._attributes = AttributesTable(self)
        self._attributes.edited.connect(self._send_attributes)
        schema = IconButton("settings", tr("Which attributes people have"), "tracks.schema", self)
        schema.clicked.connect(self.schema_asked)
        row = QHBoxLayout()
        row.addWidget(heading(tr("Attributes"), self), 1)
        row.addWidget(schema)
        for button in (self._attributes.add_button, self._attributes.remove_button):
            row.addWidget(button)
        rows.addLayout(row)
        rows.addWidget(self._attributes, 1)

    def _build_notes(self, rows: QVBoxLayout) -> None:
        rows.addWidget(heading(tr("Notes"), self))
        self._notes = NotesEdit(self)
        self._notes.setPlaceholderText(tr("Anything worth knowing"))
        self._notes.setAccessibleName(tr("Notes on the track"))
        self._notes.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._notes.setTabChangesFocus(True)
        self._notes.setMaximumHeight(4 * self.fontMetrics().lineSpacing() + 12)
        self._notes.done.connect(self._send_notes)
        rows.addWidget(self._notes)

    def _link(self) -> QPushButton:
        button = QPushButton(self)
        button.setProperty("link", True)
        button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        button.setCursor(Qt.CursorShape.PointingHandCursor)
        button.setToolTip(tr("Go there"))
        button.clicked.connect(lambda: self.frame_sought.emit(int(button.text())))
        return button

    def set_actions(self, actions: Sequence[QAction]) -> None:
        """Offer the window's own actions (swap, split, ...) beside the title: always in sight."""
        for tool in self._tools:
            tool.deleteLater()
        self._tools = []
        for action in actions:
            tool = QToolButton(self)
            tool.setDefaultAction(action)
            tool.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            tool.setAccessibleName(action.text().replace("&", ""))
            self._tools.append(tool)
            self.add_to_heading(tool)

    def show_scene(self, card: TrackCard | None) -> None:
        """Show another track; what is being typed about the same one is left alone."""
        before, self._card = self._card, card
        self._empty.setVisible(card is None)
        self._scroll.setVisible(card is not None)
        if card is None or card == before:
            return
        other = before is None or before.track != card.track
        if other:  # whose track it is stands above
            self._scroll.verticalScrollBar().setValue(0)
        self._several.setVisible(bool(card.others))
        self._several.setText(self._words_on(card))
        self._swatch.set_track_colour(card.colour)
        self._id.setText(str(card.track))
        self._first.setText(str(card.first_frame))
        self._last.setText(str(card.last_frame))
        seen = count_text(card.frames_seen, "{n} frame", "{n} frames")
        others = [tr("{0} predicted").format(card.frames_predicted)]
        if card.frames_interpolated:
            others.append(tr("{0} interpolated").format(card.frames_interpolated))
        if card.frames_occluded:
            others.append(tr("{0} occluded").format(card.frames_occluded))
        self._seen.setText(joined_text(", ", (seen, *others)))
        known = card.mean_confidence == card.mean_confidence
        self._confidence.setText(f"{card.mean_confidence:.2f}" if known else tr("not known"))
        if other or not self._name.hasFocus():
            self._name.setText(card.name)
            self._name.setCursorPosition(0)  # of a long name the beginning is seen
        if other or not self._notes.hasFocus():
            self._notes.setPlainText(card.notes)
        self._form.show_scene(card.fields)
        self._attributes.show_pairs(card.attributes, keep_editing=not other)

    def _words_on(self, card: TrackCard) -> str:
        """Who is selected together, and what can be done with them."""
        everybody = sorted((card.track, *card.others))
        rest = ("...",) if len(everybody) > _MOST_NAMED else ()
        named = joined_text(", ", (*everybody[:_MOST_NAMED], *rest))
        together = tr("merge, delete, hide, fill gaps or mark them as reviewed together")
        if len(everybody) == 2:
            together = tr("swap or {0}").format(together)
        said = tr("{0} selected: {1}. You can {2}. Below: {3}, picked last.")
        return said.format(len(everybody), named, together, card.track)

    def edit_name(self) -> None:
        """Put the cursor into the name."""
        bring_into_view(self._name)
        self._name.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self._name.selectAll()

    def edit_attributes(self) -> None:
        """Go to the first attribute of the schema; begin another one where there is none.

        Its name, Enter, its value, Enter.
        """
        if not self.edit_fields():
            self._attributes.add_row()

    def edit_notes(self) -> None:
        """Put the cursor into the notes."""
        bring_into_view(self._notes)
        self._notes.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def edit_fields(self) -> bool:
        """Put the keyboard into the first attribute of the schema; whether there is one."""
        bring_into_view(self._form)
        return self._form.edit_first()

    def _send_field(self, name: str, value: str | None) -> None:
        if self._card is not None:
            self.field_given.emit(self._card.track, name, value)

    def _send_name(self) -> None:
        if self._card is not None and self._name.text() != self._card.name:
            self.name_edited.emit(self._card.track, self._name.text())
            self._name.setText(self._card.name)  # the old one, where it was refused
            self._name.setCursorPosition(0)

    def _send_notes(self) -> None:
        if self._card is not None and self._notes.toPlainText() != self._card.notes:
            self.notes_edited.emit(self._card.track, self._notes.toPlainText())

    def _send_attributes(self, pairs: tuple[tuple[str, str], ...]) -> None:
        if self._card is not None and pairs != self._card.attributes:
            self.attributes_edited.emit(self._card.track, pairs)
            # The old ones, where they were refused.
            self._attributes.show_pairs(self._card.attributes, keep_editing=True)
