"""A form for a tracker's settings, made from what its dataclass says of each of them."""

from __future__ import annotations

from collections.abc import Container, Mapping, Set
from typing import Any, Protocol

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QGridLayout,
    QLabel,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)

from app.core.i18n import tr
from app.core.look.theme import scaled_font
from app.core.widgets.number_boxes import NumberBox, WholeBox, tell, why_refused
from app.core.widgets.parts import heading, quiet
from app.core.widgets.settings_search import FoldButton, SettingRow, show_found
from tracking.settings import stage_title
from tracking.trackers import SettingField, settings_fields, settings_from

_WHOLE_LIMIT = 2**31 - 1
_NUMBER_LIMIT = 1e12


class HasSettings(Protocol):
    """What a form is made from: a tracker of the catalogue, a training."""

    @property
    def settings_type(self) -> type:
        """A frozen dataclass of settings."""


class SettingsForm(QWidget):
    """One control a setting, with its unit, range and help; dotted names stand in groups.

    Settings that are filled in elsewhere (`without`) have none. Expert settings are shown once
    they are asked for, changed or found by a search.

    Signals:
        edited(): some value is another than before.
    """

    edited = Signal()

    def __init__(
        self,
        spec: HasSettings,
        parent: QWidget | None = None,
        without: Container[str] = (),
    ) -> None:
        super().__init__(parent)
        self._spec = spec
        fields = settings_fields(spec.settings_type)
        self._fields = [field for field in fields if field.name not in without]
        self._controls: dict[str, QWidget] = {}
        rows = QVBoxLayout(self)
        rows.setContentsMargins(0, 0, 8, 0)
        self._labels: dict[str, QLabel] = {}
        self._rows: list[SettingRow] = []
        self._folds: dict[str, FoldButton] = {}
        self._sought, self._with_expert = "", False
        self._changed: set[str] = set()
        groups: dict[str, QGridLayout] = {}
        for field in self._fields:
            group = field.name.rpartition(".")[0]
            if group not in groups:
                groups[group] = self._add_group(group, rows)
            if group:
                self._add_field(field, groups[group], fold=self._folds[group])
        self._add_own([one for one in self._fields if "." not in one.name], groups)
        rows.addStretch(1)
        self.edited.connect(self._mark)
        self._show()

    @property
    def expert_count(self) -> int:
        """How many expert settings there are."""
        return sum(field.expert for field in self._fields)

    def values(self) -> dict[str, Any]:
        """What differs from the defaults, by (dotted) name."""
        shown = {field.name: self._value(field) for field in self._fields}
        return {f.name: shown[f.name] for f in self._fields if shown[f.name] != self._default(f)}

    def settings(self) -> Any:
        """The settings as the form stands.

        Raises:
            SettingsError: a value is out of range; the message names it.
        """
        return settings_from(self._spec.settings_type, self.values())

    def reset(self) -> None:
        """Put all defaults back."""
        for field in self._fields:
            self.put(field.name, field.default)
        self._changed.clear()
        self._show()

    def put(self, name: str, value: Any) -> None:
        """Put a value into a control."""
        control = self._controls[name]
        if isinstance(control, QCheckBox):
            control.setChecked(bool(value))
        elif isinstance(control, WholeBox | NumberBox):
            control.setValue(value)
            tell(control)  # the same value is no change, though another number was being typed
        elif isinstance(control, QLineEdit):
            control.setText(str(value))

    def put_known(self, values: Mapping[str, Any]) -> None:
        """Put those values in whose settings there are; a run of an older program had others."""
        for name in values.keys() & self._controls.keys():
            self.put(name, values[name])

    def seek(self, sought: str) -> int:
        """Show the settings that have all the words in name or help, and tell how many."""
        self._sought = sought
        return self._show()

    def show_expert(self, shown: bool) -> None:
        """Show the expert settings, or hide those that are not changed."""
        self._with_expert, self._changed = shown, set(self.values())
        self._show()

    def _show(self) -> int:
        """Show what is sought or offered, and tell how many settings that is.

        A setting that was changed stays in sight also once it is as it comes: it must not vanish
        from below the hands of whoever types into it.
        """
        offered = {
            field.name
            for field in self._fields
            if self._with_expert or not field.expert or field.name in self._changed
        }
        return show_found(self._rows, self._sought, offered)

    def _add_own(self, fields: list[SettingField], groups: Mapping[str, QGridLayout]) -> None:
        """The tracker's own settings, those about one thing together under its heading."""
        titles = {field.name: tr(field.group) for field in fields}
        several = len(set(titles.values())) > 1
        for title in dict.fromkeys(titles.values()):
            grid, above = groups[""], heading(title, self) if several else None
            if above is not None:
                grid.addWidget(above, grid.rowCount(), 0, 1, 3)
            for field in fields:
                if titles[field.name] == title:
                    self._add_field(field, grid, above)

    def _mark(self) -> None:
        """Have the names of settings that are not as they come stand out, and say what comes."""
        changed = self.values()
        for field in self._fields:
            is_changed, label = field.name in changed, self._labels[field.name]
            label.setFont(scaled_font(self.font(), 1.0, bold=is_changed))
            title = tr(field.title)
            label.setText(f"\u2022 {title}" if is_changed else title)
            shown = _said(field.default, _unit(field))
            said = tr("Changed; the default is {0}").format(shown)
            label.setToolTip(said if is_changed else _words(field))
        self._bring_to_sight(changed.keys() - self._changed)

    def _bring_to_sight(self, names: Set[str]) -> None:
        """Show settings that have just been changed, wherever they stand."""
        if not names:
            return
        self._changed |= names
        for group in {name.rpartition(".")[0] for name in names} & self._folds.keys():
            self._folds[group].unfold()
        self._show()

    def _add_group(self, name: str, rows: QVBoxLayout) -> QGridLayout:
        """The tracker's own settings stand open; those of the stages before it are folded."""
        body = QWidget(self)
        if name:
            title = tr(stage_title(name))
            self._folds[name] = FoldButton(title, body, self)
            rows.addWidget(self._folds[name])
        grid = QGridLayout(body)
        grid.setContentsMargins(0, 0, 0, 8)
        grid.setHorizontalSpacing(12)
        grid.setColumnStretch(2, 1)
        rows.addWidget(body)
        return grid

    def _add_field(
        self,
        field: SettingField,
        grid: QGridLayout,
        above: QLabel | None = None,
        fold: FoldButton | None = None,
    ) -> None:
        control = self._control(field)
        title = tr(field.title)
        words = _words(field)
        letter = self.fontMetrics().averageCharWidth()
        control.setMinimumWidth(14 * letter)
        control.setAccessibleName(title)
        control.setAccessibleDescription(words)
        control.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        control.installEventFilter(self)
        label, about = QLabel(title, self), quiet(words, self)
        label.setBuddy(control)
        about.setWordWrap(True)
        about.setFont(scaled_font(self.font(), 0.88))
        about.setMinimumWidth(30 * letter)
        for widget in (control, label):
            widget.setToolTip(words)
        row = grid.rowCount()
        for column, widget in enumerate((label, control, about)):
            grid.addWidget(widget, row, column)
        sought = f"{field.name} {title} {words} {' '.join(field.formerly)}"
        self._rows.append(SettingRow(field.name, sought, (label, control, about), above, fold))
        self._controls[field.name], self._labels[field.name] = control, label
        if isinstance(control, WholeBox | NumberBox):
            control.typed.connect(lambda refused: self._tell(about, field, refused))
        self.put(field.name, field.default)

    def _tell(self, about: QLabel, field: SettingField, refused: str) -> None:
        """Beside a number that is typed: why it cannot be."""
        control = self._controls[field.name]
        assert isinstance(control, WholeBox | NumberBox)
        about.setText(why_refused(control, refused) if refused else _words(field))
        about.setProperty("role", "warning" if refused else "muted")
        about.style().unpolish(about)
        about.style().polish(about)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - Qt's name
        """Scrolling over a number that is not being edited scrolls the form."""
        if event.type() == QEvent.Type.Wheel and watched is not QApplication.focusWidget():
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    def _control(self, field: SettingField) -> QWidget:
        low, high = field.range or (-_NUMBER_LIMIT, _NUMBER_LIMIT)
        suffix = _unit(field)
        if field.type is bool:
            check = QCheckBox(self)
            check.toggled.connect(self.edited)
            return check
        if field.type is int:
            whole = WholeBox(self)
            whole.setRange(int(max(low, -_WHOLE_LIMIT)), int(min(high, _WHOLE_LIMIT)))
            whole.setSuffix(suffix)
            whole.valueChanged.connect(self.edited)
            return whole
        if field.type is float:
            number = NumberBox(self)
            number.setDecimals(_decimals(float(field.default), low, high))
            number.setRange(low, high)
            number.setSingleStep(10.0 ** -max(0, number.decimals() - 1))
            number.setSuffix(suffix)
            number.valueChanged.connect(self.edited)
            return number
        line = QLineEdit(self)
        line.textChanged.connect(self.edited)
        return line

    def _value(self, field: SettingField) -> Any:
        control = self._controls[field.name]
        if isinstance(control, QCheckBox):
            return control.isChecked()
        if isinstance(control, WholeBox | NumberBox):
            return control.value()
        return control.text() if isinstance(control, QLineEdit) else field.default

    def _default(self, field: SettingField) -> Any:
        """The default as the control can show it, rounded to its decimals."""
        control = self._controls[field.name]
        if isinstance(control, NumberBox):
            return round(float(field.default), control.decimals())
        return field.default


def _words(field: SettingField) -> str:
    """What a setting is for, with its range."""
    if field.range is None:
        return tr(field.help)
    low, high = field.range
    return tr(field.help) + tr(
        " ({low:g} to {high:g}{unit})", low=low, high=high, unit=_unit(field)
    )


def _said(value: object, unit: str) -> str:
    """A value in words: switches are on or off."""
    if isinstance(value, bool):
        return tr("on") if value else tr("off")
    return f"{value}{unit}"


def _unit(field: SettingField) -> str:
    """The unit behind a number."""
    return f" {field.unit}" if field.unit else ""


def _decimals(*values: float) -> int:
    """Decimals enough to show all of these values, 2 to 8."""
    for count in range(2, 8):
        if all(abs(value - round(value, count)) <= 1e-9 * abs(value) for value in values):
            return count
    return 8
