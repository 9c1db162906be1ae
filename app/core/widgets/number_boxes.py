"""Fields for numbers that let anything be typed and tell when it is not taken as it is."""

from __future__ import annotations

import math

from PySide6.QtCore import QPoint, Signal
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QSpinBox, QToolTip, QWidget

from app.core.i18n import tr

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
        return _lenient(self, super().validate(_pointed(self, text), pos), text, pos)

    def fixup(self, text: str) -> str:
        """The nearest that can be."""
        return _nearest(self, text)


class NumberBox(QDoubleSpinBox):
    """A number with decimals after a point or a comma; the same as `WholeBox` in all else.

    The sign of the thousands is taken for one where it stands before three digits.
    """

    typed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        _watch(self)

    def validate(self, text: str, pos: int) -> Validated:
        """Qt would swallow a comma, or the key that leads out of range, unsaid."""
        return _lenient(self, super().validate(_pointed(self, text), pos), text, pos)

    def valueFromText(self, text: str) -> float:  # noqa: N802 - Qt's name
        """Qt would read "2,5" as 25 where the comma is the sign of the thousands."""
        value, is_number = _number(self, _bare(self, text))
        return value if is_number else super().valueFromText(text)

    def fixup(self, text: str) -> str:
        """The nearest that can be."""
        return _nearest(self, text)


def tell(box: WholeBox | NumberBox) -> None:
    """Have a field say whether the number in it cannot be."""
    text = box.cleanText()
    box.typed.emit(text if _refused(box, text) else "")


def why_refused(box: WholeBox | NumberBox, text: str) -> str:
    """Why a field cannot have a number, in a sentence."""
    known = {"typed": text, "low": box.minimum(), "high": box.maximum(), "unit": box.suffix()}
    rest = tr("The nearest value is used.")
    if isinstance(box, WholeBox):
        words = tr("{typed} is out of range: whole numbers from {low} to {high}{unit}. {rest}")
    else:
        words = tr("{typed} is out of range: from {low:g} to {high:g}{unit}. {rest}")
    return words.format(**known, rest=rest)


def tell_beside(box: WholeBox | NumberBox) -> None:
    """Have a field say under itself, while it is typed into, why a number cannot be.

    For fields without a line of their own for it.
    """
    said = False

    def say(refused: str) -> None:
        nonlocal said
        # Another field's or button's tip stays: this one is silent unless it spoke itself.
        if refused or said:
            words = why_refused(box, refused) if refused else ""
            QToolTip.showText(box.mapToGlobal(QPoint(0, box.height())), words, box)
        said = bool(refused)

    box.typed.connect(say)


def _watch(box: WholeBox | NumberBox) -> None:
    """Qt's own changes of the text are told by the value alone."""
    for changed in (box.lineEdit().textEdited, box.valueChanged, box.editingFinished):
        changed.connect(lambda *_: tell(box))


def _lenient(box: WholeBox | NumberBox, found: Validated, text: str, pos: int) -> Validated:
    """Let any number be typed; what is no number would be lost unsaid later on."""
    state, bare = found[0], _bare(box, text)
    is_number = _number(box, bare)[1]
    decimals = isinstance(box, WholeBox) and is_number
    if state is _State.Invalid and (decimals or _refused(box, bare)):
        state = _State.Intermediate
    elif state is _State.Acceptable and not is_number:
        # Qt would take "1,800,0" for 18000 and "1,25,000" for 125000.
        state = _State.Intermediate if _may_be_thousands(box, bare) else _State.Invalid
    elif math.isnan(box.locale().toDouble(bare)[0]):
        state = _State.Invalid
    return state, text, pos


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
    """The number that a text is, and whether it is one; Qt takes "nan" and "inf" for numbers."""
    value, is_number = box.locale().toDouble(_pointed(box, text))
    return (value, is_number) if math.isfinite(value) else (0.0, False)


def _may_be_thousands(box: WholeBox | NumberBox, text: str) -> bool:
    """Whether up to three digits more make a number of a text: a group of thousands."""
    return any(box.locale().toDouble(text + "0" * more)[1] for more in (1, 2, 3))


def _bare(box: WholeBox | NumberBox, text: str) -> str:
    return text.removeprefix(box.prefix()).removesuffix(box.suffix()).strip()


def _pointed(box: WholeBox | NumberBox, text: str) -> str:
    """The text with the decimal sign of the locale for a lone comma or point.

    Where that is the locale's sign of the thousands, and stands as such, the text is as it was.
    """
    locale, bare = box.locale(), _bare(box, text)
    point = locale.decimalPoint()
    other = "." if point == "," else ","
    thousands = locale.toDouble(bare)[1] and bare.lstrip("+-").partition(other)[0] != "0"
    lone = text.count(other) == 1 and point not in text
    return text.replace(other, point) if lone and not thousands else text
