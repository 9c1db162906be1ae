"""The attributes of the schema: a row each, with the control that suits its type."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QCompleter,
    QGridLayout,
    QLineEdit,
    QWidget,
)

from app.core.i18n import tr
from app.core.scenes.attribute_fields import AttributeField
from app.core.widgets.eliding_label import ElidingLabel
from app.core.widgets.number_boxes import NumberBox, tell_beside
from app.core.widgets.parts import quiet
from tracking.tracks import NO, YES, Attribute, AttributeType
from tracking.tracks.attribute_schema import number_text

_MOST_KEYS = 9
_NO_LIMIT = 1e9
_MOST_DECIMALS = 6
_SHOWN_LETTERS = 60


class SchemaForm(QWidget):
    """Shows fields; hidden without any.

    Signals: `value_given(str, object)`: an attribute's name and the value; None takes it away.
    """

    value_given = Signal(str, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows: list[_Row] = []
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(12)
        self._grid.setVerticalSpacing(4)
        self._grid.setColumnStretch(1, 1)
        self.hide()

    def show_scene(self, fields: tuple[AttributeField, ...]) -> None:
        """Show other values; rows are made anew only where the attributes are others."""
        if [row.attribute for row in self._rows] != [field.attribute for field in fields]:
            self._build(fields)
        for row, field in zip(self._rows, fields, strict=True):
            row.show_field(field)
        self.setVisible(bool(fields))

    def edit_first(self) -> bool:
        """Put the keyboard into the first field; whether there is one."""
        if self._rows:
            self._rows[0].control.setFocus(Qt.FocusReason.ShortcutFocusReason)
        return bool(self._rows)

    def _build(self, fields: tuple[AttributeField, ...]) -> None:
        for row in self._rows:
            row.drop()
        self._rows = [_row_of(field.attribute, self) for field in fields]
        for line, row in enumerate(self._rows):
            self._grid.addWidget(row.title, 2 * line, 0)
            self._grid.addWidget(row.control, 2 * line, 1)
            self._grid.addWidget(row.why, 2 * line + 1, 0, 1, 2)
            row.given.connect(self.value_given)


class _Row(QObject):
    """Title, control, and below them why a value does not suit."""

    given = Signal(str, object)

    def __init__(self, attribute: Attribute, control: QWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self.attribute, self.control = attribute, control
        self.field = AttributeField(attribute)
        self._shows = False
        self.title = ElidingLabel(attribute.name, parent)
        self.title.setTextFormat(Qt.TextFormat.PlainText)
        self.why = quiet("", parent, "warning")
        self.why.setTextFormat(Qt.TextFormat.PlainText)
        self.why.setWordWrap(True)
        control.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        control.installEventFilter(self)

    def show_field(self, field: AttributeField) -> None:
        """Show a value, or that there is none."""
        self.field = field
        name = self.attribute.name
        mark = "\u25b8 " if field.active else ""
        self.title.setText(f"{mark}{name} *" if self.attribute.required else f"{mark}{name}")
        said = [tr("{name}, required", name=name) if self.attribute.required else name]
        said += [tr("digit keys set it")] if field.active else []
        self.control.setAccessibleName("; ".join(said))
        self.why.setText(tr("{value}: {why}", value=shortened(field.value or ""), why=field.why))
        self.why.setVisible(bool(field.why))
        self._shows = True
        self.show_value(field)
        self._shows = False

    def show_value(self, field: AttributeField) -> None:
        """The same of the control alone."""

    def give(self, value: str | None) -> None:
        """Say a value, unless it is what is shown already."""
        if not self._shows and value != self.field.value:
            self.given.emit(self.attribute.name, value)

    def drop(self) -> None:
        """Take it off the form."""
        for widget in (self.title, self.control, self.why):
            widget.hide()
            widget.deleteLater()
        self.deleteLater()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """The wheel scrolls the card, and never changes what was said of somebody."""
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    @property
    def unset(self) -> str:
        """What stands where nobody said anything."""
        default = self.attribute.default
        if default:
            return tr("not said; default {default}", default=value_text(self.attribute, default))
        return tr("not said")


class _ChoiceRow(_Row):
    def __init__(self, attribute: Attribute, parent: QWidget) -> None:
        self._box = QComboBox(parent)
        super().__init__(attribute, self._box, parent)
        self._box.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self._box.setMinimumContentsLength(8)
        self._box.activated.connect(self._choose)

    def show_value(self, field: AttributeField) -> None:
        self._box.clear()
        self._box.addItem(self.unset, None)
        for number, choice in enumerate(self.attribute.options, 1):
            key = f"{number}  " if field.active and number <= _MOST_KEYS else ""
            self._box.addItem(f"{key}{value_text(self.attribute, choice)}", choice)
        at = self._box.findData(field.value) if field.value is not None else 0
        if at < 0:  # what does not suit is shown, too
            self._box.addItem(shortened(field.value or ""), field.value)
            at = self._box.count() - 1
        self._box.setCurrentIndex(at)
        self._box.setToolTip(self._box.currentText())

    def _choose(self, at: int) -> None:
        self.give(self._box.itemData(at))


class _YesNoRow(_Row):
    """A box with three states: not said, yes, no."""

    def __init__(self, attribute: Attribute, parent: QWidget) -> None:
        self._box = QCheckBox(parent)
        super().__init__(attribute, self._box, parent)
        self._box.setTristate(True)
        self._box.clicked.connect(self._choose)

    def show_value(self, field: AttributeField) -> None:
        states = {YES: Qt.CheckState.Checked, NO: Qt.CheckState.Unchecked}
        self._box.setCheckState(states.get(field.value or "", Qt.CheckState.PartiallyChecked))
        said = self.unset if field.value is None else value_text(self.attribute, field.value)
        keys = tr(" (1 yes, 2 no)") if field.active else ""
        self._box.setText(shortened(said).replace("&", "&&") + keys)

    def _choose(self) -> None:
        """Not said, yes, no, and around again."""
        self.give({None: YES, YES: NO}.get(self.field.value))
        self.show_field(self.field)


class _NumberRow(_Row):
    def __init__(self, attribute: Attribute, parent: QWidget) -> None:
        self._box = NumberBox(parent)
        super().__init__(attribute, self._box, parent)
        step = attribute.step or 1.0
        self._unset = (-_NO_LIMIT if attribute.least is None else attribute.least) - step
        self._box.setDecimals(_decimals(attribute))
        self._box.setSingleStep(step)
        self._box.setRange(self._unset, _NO_LIMIT if attribute.most is None else attribute.most)
        self._box.setKeyboardTracking(False)
        tell_beside(self._box)
        self._box.valueChanged.connect(self._choose)

    def show_value(self, field: AttributeField) -> None:
        self._box.setSpecialValueText(self.unset)
        try:
            number = float(field.value) if field.value is not None else self._unset
        except ValueError:
            number = self._unset
        self._box.setValue(number)

    def _choose(self, number: float) -> None:
        self.give(None if number == self._box.minimum() else number_text(number))


class _TextRow(_Row):
    def __init__(self, attribute: Attribute, parent: QWidget) -> None:
        self._line = QLineEdit(parent)
        super().__init__(attribute, self._line, parent)
        self._line.setClearButtonEnabled(True)
        self._line.editingFinished.connect(lambda: self.give(self._line.text().strip() or None))

    def show_value(self, field: AttributeField) -> None:
        if self._line.hasFocus() and self._line.isModified():
            return
        self._line.setPlaceholderText(self.unset)
        self._line.setText(field.value or "")
        self._line.setCursorPosition(0)
        known = self._line.completer()
        if field.used and (known is None or known.property("used") != list(field.used)):
            completer = QCompleter(list(field.used), self._line)
            completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
            completer.setProperty("used", list(field.used))
            self._line.setCompleter(completer)


def _row_of(attribute: Attribute, parent: QWidget) -> _Row:
    rows = {
        AttributeType.CHOICE: _ChoiceRow,
        AttributeType.YES_NO: _YesNoRow,
        AttributeType.NUMBER: _NumberRow,
        AttributeType.TEXT: _TextRow,
    }
    return rows[attribute.type](attribute, parent)


def _decimals(attribute: Attribute) -> int:
    """As many as its range and step need; some where there is no step."""
    if attribute.step is None:
        return _MOST_DECIMALS // 2
    numbers = (number for number in (attribute.least, attribute.step) if number is not None)
    texts = [f"{number:.{_MOST_DECIMALS}f}".rstrip("0") for number in numbers]
    return max(len(text.partition(".")[2]) for text in texts)


def value_text(attribute: Attribute, value: str) -> str:
    """A value as people read it."""
    if attribute.type is AttributeType.YES_NO:
        return {YES: tr("yes"), NO: tr("no")}.get(value, shortened(value))
    return shortened(value)


def shortened(value: str) -> str:
    """A value in one line, however long it is."""
    line = " ".join(value.split())
    return line if len(line) <= _SHOWN_LETTERS else f"{line[:_SHOWN_LETTERS]}..."
