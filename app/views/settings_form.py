"""A form for a tracker's settings, made from what its dataclass says of each of them."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QDoubleSpinBox,
    QFormLayout,
    QLabel,
    QLineEdit,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from tracking.trackers import SettingField, TrackerSpec, settings_fields, settings_from

_WHOLE_LIMIT = 2**31 - 1
_NUMBER_LIMIT = 1e12


class SettingsForm(QWidget):
    """One control a setting, with its unit, range and help; dotted names stand in groups.

    Signals:
        edited(): some value is another than before.
    """

    edited = Signal()

    def __init__(self, spec: TrackerSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._spec = spec
        self._fields = settings_fields(spec.settings_type)
        self._controls: dict[str, QWidget] = {}
        rows = QVBoxLayout(self)
        groups: dict[str, QFormLayout] = {}
        for field in self._fields:
            group = field.name.rpartition(".")[0]
            if group not in groups:
                groups[group] = self._add_group(group, rows)
            self._add_field(field, groups[group])
        rows.addStretch(1)

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

    def put(self, name: str, value: Any) -> None:
        """Put a value into a control."""
        control = self._controls[name]
        if isinstance(control, QCheckBox):
            control.setChecked(bool(value))
        elif isinstance(control, QSpinBox | QDoubleSpinBox):
            control.setValue(value)
        elif isinstance(control, QLineEdit):
            control.setText(str(value))

    def _add_group(self, name: str, rows: QVBoxLayout) -> QFormLayout:
        if name:
            title = QLabel(name.replace(".", " / ").replace("_", " ").capitalize(), self)
            title.setProperty("role", "heading")
            rows.addWidget(title)
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.FieldsStayAtSizeHint)
        rows.addLayout(form)
        return form

    def _add_field(self, field: SettingField, form: QFormLayout) -> None:
        control = self._control(field)
        title = _title(field)
        help_text = field.help
        if field.range is not None:
            low, high = field.range
            help_text += self.tr(" ({0:g} to {1:g})").format(low, high)
        control.setMinimumWidth(12 * self.fontMetrics().averageCharWidth())
        control.setAccessibleName(title)
        control.setAccessibleDescription(help_text)
        label = QLabel(title, self)
        for widget in (control, label):
            widget.setToolTip(help_text)
        form.addRow(label, control)
        self._controls[field.name] = control
        self.put(field.name, field.default)

    def _control(self, field: SettingField) -> QWidget:
        low, high = field.range or (-_NUMBER_LIMIT, _NUMBER_LIMIT)
        suffix = f" {field.unit}" if field.unit else ""
        if field.type is bool:
            check = QCheckBox(self)
            check.toggled.connect(self.edited)
            return check
        if field.type is int:
            whole = QSpinBox(self)
            whole.setRange(int(max(low, -_WHOLE_LIMIT)), int(min(high, _WHOLE_LIMIT)))
            whole.setSuffix(suffix)
            whole.valueChanged.connect(self.edited)
            return whole
        if field.type is float:
            number = QDoubleSpinBox(self)
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
        if isinstance(control, QSpinBox | QDoubleSpinBox):
            return control.value()
        return control.text() if isinstance(control, QLineEdit) else field.default

    def _default(self, field: SettingField) -> Any:
        """The default as the control can show it, rounded to its decimals."""
        control = self._controls[field.name]
        if isinstance(control, QDoubleSpinBox):
            return round(float(field.default), control.decimals())
        return field.default


def _title(field: SettingField) -> str:
    """The name in words, without the unit's suffix: the control itself shows the unit."""
    name = field.name.rpartition(".")[2]
    unit = field.unit.replace("/", "_")
    if unit and name.endswith(f"_{unit}"):
        name = name.removesuffix(f"_{unit}")
    return name.replace("_", " ").capitalize()


def _decimals(*values: float) -> int:
    """Decimals enough to show all of these values, 2 to 8."""
    for count in range(2, 8):
        if all(abs(value - round(value, count)) <= 1e-9 * abs(value) for value in values):
            return count
    return 8
