"""Fields for numbers that let anything be typed and tell when it is not taken as it is."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox, QWidget

_State = QValidator.State
Validated = tuple[QValidator.State, str, int]
"""What Qt wants of a check: the state, and the text with the cursor as they are to be."""


class WholeBox(QSpinBox):
    """A whole number; of any other number the nearest that can be is taken once it is left.

    Signals: `typed(refused)`, the field says something else: the number that cannot be, else "".
    """

    typed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        _watch(self)

    def validate(self, text: str, pos: int) -> Validated:
        """Qt would swallow the key that leads out of range, or to decimals, unsaid."""
        return _lenient(self, super().validate(text, pos), text, pos)

    def fixup(self, text: str) -> str:
        """The nearest that can be."""
        return _nearest(self, text)


class NumberBox(QDoubleSpinBox):
    """A number with decimals after a point or a comma; the same as `WholeBox` in all else."""

    typed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        _watch(self)

    def validate(self, text: str, pos: int) -> Validated:
        """Qt would swallow a comma, or the key that leads out of range, unsaid."""
        text = _pointed(self, text)
        return _lenient(self, super().validate(text, pos), text, pos)

    def fixup(self, text: str) -> str:
        """The nearest that can be."""
        return _nearest(self, text)


def tell(box: WholeBox | NumberBox) -> None:
    """Have a field say whether the number in it cannot be."""
    text = box.cleanText()
    box.typed.emit(text if _refused(box, text) else "")


def _watch(box: WholeBox | NumberBox) -> None:
    """Qt's own changes of the text are told by the value alone."""
    for changed in (box.lineEdit().textEdited, box.valueChanged, box.editingFinished):
        changed.connect(lambda *_: tell(box))


def _lenient(box: WholeBox | NumberBox, found: Validated, text: str, pos: int) -> Validated:
    """Let any number be typed; what is no number would be lost unsaid later on."""
    bare = _bare(box, text)
    decimals = isinstance(box, WholeBox) and _number(box, bare)[1]
    if found[0] is _State.Invalid and (decimals or _refused(box, bare)):
        return _State.Intermediate, text, pos
    return found


def _nearest(box: WholeBox | NumberBox, text: str) -> str:
    """The text of the number nearest to what was typed; the text itself where that is none."""
    value, is_number = _number(box, _bare(box, text))
    if not is_number:
        return text
    value = min(max(value, box.minimum()), box.maximum())
    taken = (
        box.textFromValue(round(value)) if isinstance(box, WholeBox) else box.textFromValue(value)
    )
    return f"{box.prefix()}{taken}{box.suffix()}"


def _refused(box: WholeBox | NumberBox, text: str) -> bool:
    """Whether a text is a number that the field cannot have."""
    value, is_number = _number(box, text)
    whole = not isinstance(box, WholeBox) or value == round(value)
    return is_number and not (whole and box.minimum() <= value <= box.maximum())


def _number(box: WholeBox | NumberBox, text: str) -> tuple[float, bool]:
    """The number that a text is, and whether it is one."""
    return box.locale().toDouble(_pointed(box, text))


def _bare(box: WholeBox | NumberBox, text: str) -> str:
    return text.removeprefix(box.prefix()).removesuffix(box.suffix()).strip()


def _pointed(box: WholeBox | NumberBox, text: str) -> str:
    """The text with the decimal sign of the locale for a lone comma or point."""
    point = box.locale().decimalPoint()
    other = "." if point == "," else ","
    return text.replace(other, point) if text.count(other) == 1 and point not in text else text
