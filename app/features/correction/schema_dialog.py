"""The dialog in which it is said which attributes people have."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.core.error_messages import explain_in_sentence
from app.core.i18n import tr
from app.core.widgets.parts import quiet
from app.core.widgets.questions import choose_file, choose_new_file
from app.core.widgets.tab_order import tab_in_reading_order
from app.core.widgets.user_settings import LastFolder
from app.features.correction.schema_draft import SchemaDraft
from tracking.errors import TrackwrightError
from tracking.formats.schema_files import SCHEMA_NAME, read_schema, write_schema
from tracking.tracks import Attribute, AttributeType
from tracking.tracks.attribute_schema import number_text
from tracking.translation import N_

_TITLES = {
    AttributeType.CHOICE: N_("Choice"),
    AttributeType.YES_NO: N_("Yes or no"),
    AttributeType.NUMBER: N_("Number"),
    AttributeType.TEXT: N_("Text"),
}
_NUMBERS = ("least", "most", "step")
_LETTERS, _LINES, _CHOICE_LINES = 84, 26, 6
_FILES = "*.toml *.json"


class SchemaDialog(QDialog):
    """A list of attributes, the chosen one beside it, and what becomes of values below.

    Signals: `wanted(object)`: the `SchemaChange` that is to be done.
    """

    wanted = Signal(object)

    def __init__(self, draft: SchemaDraft, folder: Path, last: LastFolder, parent: QWidget) -> None:
        """folder: of the recording or its project. last: where such a file was chosen last."""
        super().__init__(parent)
        self.draft, self._folder, self._last = draft, folder, last
        self._filling = False
        self.setWindowTitle(tr("Which attributes people have"))
        rows = QVBoxLayout(self)
        rows.setContentsMargins(20, 20, 20, 16)
        rows.setSpacing(12)
        columns = QHBoxLayout()
        columns.setSpacing(16)
        columns.addLayout(self._build_list(), 2)
        columns.addWidget(self._build_fields(), 3)
        rows.addLayout(columns, 1)
        self.told = QLabel(self)
        self.told.setWordWrap(True)
        self.told.setTextFormat(self.told.textFormat().PlainText)
        self.told.setMinimumHeight(3 * self.fontMetrics().lineSpacing())
        rows.addWidget(self.told)
        rows.addWidget(self._build_ends())
        tab_in_reading_order(self)
        self._show(0)
        letter, line = self.fontMetrics().averageCharWidth(), self.fontMetrics().lineSpacing()
        room = self.screen().availableSize() * 0.9
        self.resize(min(_LETTERS * letter, room.width()), min(_LINES * line, room.height()))

    def _build_list(self) -> QVBoxLayout:
        self.list = QListWidget(self)
        self.list.setAccessibleName(tr("Attributes"))
        self.list.currentRowChanged.connect(self._fill)
        buttons = QHBoxLayout()
        self.add = self._button(tr("&Add"), self._add)
        self.remove = self._button(tr("&Remove"), self._remove)
        self.up = self._button(tr("&Up"), lambda: self._move(-1))
        self.down = self._button(tr("&Down"), lambda: self._move(1))
        for button in (self.add, self.remove, self.up, self.down):
            buttons.addWidget(button)
        column = QVBoxLayout()
        column.addWidget(self.list, 1)
        column.addLayout(buttons)
        return column

    def _build_fields(self) -> QWidget:
        self.fields = QWidget(self)
        form = self._form = QFormLayout(self.fields)
        form.setContentsMargins(0, 0, 0, 0)
        self.name, self.default = QLineEdit(self), QLineEdit(self)
        self.type = QComboBox(self)
        for kind, title in _TITLES.items():
            self.type.addItem(tr(title), kind)
        self.choices = QPlainTextEdit(self)
        self.choices.setTabChangesFocus(True)
        self.choices.setMaximumHeight(_CHOICE_LINES * self.fontMetrics().lineSpacing() + 12)
        self.choices.setPlaceholderText(tr("One choice a line"))
        self.required = QCheckBox(tr("Everybody has to have a value"), self)
        self.numbers = {name: QLineEdit(self) for name in _NUMBERS}
        self._add_row(tr("&Name"), self.name)
        self._add_row(tr("&Type"), self.type)
        self._add_row(tr("&Choices"), self.choices)
        titles = (tr("&Least"), tr("&Most"), tr("&Step"))
        for title, field in zip(titles, self.numbers.values(), strict=True):
            self._add_row(title, field)
        self._add_row(tr("De&fault"), self.default)
        self.default.setPlaceholderText(tr("Shown where nothing is said"))
        letters = self.fontMetrics()
        whole = letters.horizontalAdvance(self.default.placeholderText())
        self.default.setMinimumWidth(whole + 4 * letters.averageCharWidth())
        form.addRow("", self.required)
        for line in (self.name, self.default, *self.numbers.values()):
            line.textEdited.connect(self._take)
        self.choices.textChanged.connect(self._take)
        self.type.activated.connect(self._take)
        self.required.clicked.connect(self._take)
        return self.fields

    def _add_row(self, title: str, field: QWidget) -> None:
        label = quiet(title, self)
        label.setBuddy(field)
        field.setAccessibleName(title.replace("&", ""))
        self._form.addRow(label, field)

    def _build_ends(self) -> QDialogButtonBox:
        kinds = QDialogButtonBox.StandardButton
        box = QDialogButtonBox(kinds.Ok | kinds.Cancel, self)
        role = QDialogButtonBox.ButtonRole.ResetRole  # apart from OK and Cancel
        box.addButton(self._button(tr("Import..."), self._import), role)
        self.export = self._button(tr("Export..."), self._export)
        self.export.setToolTip(
            tr("{file} in a project's folder is what its new sessions begin with", file=SCHEMA_NAME)
        )
        box.addButton(self.export, role)
        self.ok = box.button(kinds.Ok)
        box.accepted.connect(self._accept)
        box.rejected.connect(self.reject)
        return box

    def _button(self, text: str, act: Callable[[], object]) -> QPushButton:
        button = QPushButton(text, self)
        button.setAutoDefault(False)
        button.clicked.connect(lambda: act())
        return button

    # what is shown

    def _show(self, at: int) -> None:
        """Fill the list anew, with one of it chosen."""
        self._filling = True
        self.list.clear()
        self.list.addItems([one.name for one in self.draft.schema])
        self._filling = False
        self.list.setCurrentRow(min(at, self.list.count() - 1))
        self._fill(self.list.currentRow())
        self._tell()

    def _fill(self, at: int) -> None:
        """Show the chosen attribute."""
        if self._filling:
            return
        self.fields.setEnabled(at >= 0)
        one = self.draft.schema[at] if at >= 0 else Attribute("")
        self._filling = True
        self.name.setText(one.name)
        self.type.setCurrentIndex(self.type.findData(one.type))
        self.choices.setPlainText("\n".join(one.choices))
        self.default.setText(one.default)
        self.required.setChecked(one.required)
        for name, field in self.numbers.items():
            number = getattr(one, name)
            field.setText("" if number is None else number_text(number))
        self._filling = False
        self._fit()

    def _fit(self) -> None:
        """Show the fields that the type has."""
        at, kind = self.list.currentRow(), AttributeType(self.type.currentData())
        self._form.setRowVisible(self.choices, kind is AttributeType.CHOICE)
        for field in self.numbers.values():
            self._form.setRowVisible(field, kind is AttributeType.NUMBER)
        self.remove.setEnabled(at >= 0)
        self.up.setEnabled(at > 0)
        self.down.setEnabled(0 <= at < self.list.count() - 1)

    def _tell(self, text: str = "") -> None:
        """Say why it cannot be taken, or what becomes of values."""
        why = self.draft.why_not()
        lines = (text,) if text else (why,) if why else self.draft.effects()
        empty = tr("No attributes yet: people have what you write of them.")
        self.told.setText("\n".join(lines) or ("" if self.draft.rows else empty))
        self.ok.setEnabled(self.draft.is_changed and not why)
        self.export.setEnabled(bool(self.draft.rows) and not why)

    # what the user does

    def _take(self, *_: object) -> None:
        """Take what the fields say."""
        at = self.list.currentRow()
        if self._filling or at < 0:
            return
        kind = AttributeType(self.type.currentData())
        lines = (line.strip() for line in self.choices.toPlainText().split("\n"))
        choices = tuple(filter(None, lines)) if kind is AttributeType.CHOICE else ()
        try:
            numbers = [_number(field.text()) for field in self.numbers.values()]
        except ValueError as error:
            self._tell(tr("{text} is no number", text=str(error)))
            self.ok.setEnabled(False)
            return
        numbers = numbers if kind is AttributeType.NUMBER else [None] * len(_NUMBERS)
        name, default = self.name.text().strip(), self.default.text().strip()
        required = self.required.isChecked()
        self.draft.put(at, Attribute(name, kind, choices, default, required, *numbers))
        self.list.item(at).setText(name)
        self._fit()
        self._tell()

    def _add(self) -> None:
        self._show(self.draft.add())
        self.name.setFocus()
        self.name.selectAll()

    def _remove(self) -> None:
        at = self.list.currentRow()
        if at >= 0:
            self.draft.remove(at)
            self._show(at)

    def _move(self, by: int) -> None:
        if self.list.currentRow() >= 0:
            self._show(self.draft.move(self.list.currentRow(), by))

    def _accept(self) -> None:
        self.wanted.emit(self.draft.wanted)
        self.accept()

    def _import(self) -> None:
        choose_file(self, tr("Import attributes"), self._filter(), self.read, self._last)

    def _export(self) -> None:
        start = self._folder / SCHEMA_NAME
        title = tr("Export attributes")
        choose_new_file(self, title, start, self._filter(), self.write, self._last)

    def _filter(self) -> str:
        return f"{tr('Attributes, or labels of CVAT')} ({_FILES})"

    def read(self, path: Path) -> None:
        """Take the schema of a file into the draft, or say why not."""
        try:
            found = read_schema(path)
        except TrackwrightError as error:
            self._tell(explain_in_sentence(error))
            return
        self.draft.take(found.schema)
        self._show(0)
        if found.notes:
            self._tell("\n".join(map(tr, found.notes)))

    def write(self, path: Path) -> None:
        """Write the draft, or say why not."""
        try:
            write_schema(path, self.draft.schema)
        except TrackwrightError as error:
            self._tell(explain_in_sentence(error))
            return
        self._tell(tr("Exported: {path}", path=path))


def _number(text: str) -> float | None:
    """A number that is typed, None for nothing. Raises ValueError with the text."""
    text = text.strip()
    try:
        return float(text.replace(",", ".")) if text else None
    except ValueError:
        raise ValueError(text) from None
