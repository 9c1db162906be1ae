"""Fields for numbers that let anything be typed and tell when it is out of range."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox, QWidget

_State = QValidator.State
Validated = tuple[QValidator.State, str, int]
"""What Qt wants of a check: the state, and the text with the cursor as they are to be."""


class WholeBox(QSpinBox):
    """A whole number; out of range, the nearest that is within is taken once it is left.

    Signals: `typed(refused)`, somebody typed: what is out of range, else "".
    """

    typed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        _watch(self)

    def validate(self, text: str, pos: int) -> Validated:
        """Qt would swallow the key that leads out of range, unsaid."""
        return _lenient(self, super().validate(text, pos), text, pos)


class NumberBox(QDoubleSpinBox):
    """A number with decimals; the same as `WholeBox` in all else."""

    typed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        _watch(self)

    def validate(self, text: str, pos: int) -> Validated:
        """Qt would swallow the key that leads out of range, unsaid."""
        return _lenient(self, super().validate(text, pos), text, pos)


def _watch(box: WholeBox | NumberBox) -> None:
    refused: list[float] = []

    def type_in() -> None:
        refused[:] = _refused_by(box)
        box.typed.emit(box.cleanText() if refused else "")

    def leave() -> None:
        if refused:
            low, high = box.minimum(), box.maximum()
            nearest = min(max(refused.pop(), low), high)
            if isinstance(box, WholeBox):
                box.setValue(int(nearest))
            else:
                box.setValue(nearest)

    box.lineEdit().textEdited.connect(type_in)
    box.editingFinished.connect(leave)


def _refused_by(box: WholeBox | NumberBox) -> list[float]:
    """The number in a field where it is out of range."""
    return _beyond(box, box.cleanText())


def _lenient(box: WholeBox | NumberBox, found: Validated, text: str, pos: int) -> Validated:
    """Let a number out of range be typed; what is no number would be lost unsaid later on."""
    bare = text.removeprefix(box.prefix()).removesuffix(box.suffix()).strip()
    if found[0] is _State.Invalid and _beyond(box, bare):
        return _State.Intermediate, text, pos
    return found


def _beyond(box: WholeBox | NumberBox, text: str) -> list[float]:
    """The number that a text is, if it is one of the field's kind and out of its range."""
    locale = box.locale()
    value, is_number = (
        locale.toLongLong(text) if isinstance(box, WholeBox) else locale.toDouble(text)
    )
    return [value] if is_number and not box.minimum() <= value <= box.maximum() else []
