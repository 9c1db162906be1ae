"""The program's look, which the widgets under test take their colours from."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt, SignalInstance
from PySide6.QtGui import QColor, QImage, QWheelEvent
from PySide6.QtWidgets import QApplication, QWidget

from app.core.look.theme import Look, Theme, apply_look


@pytest.fixture(params=[Look.DARK, Look.LIGHT], ids=["dark", "light"], scope="module")
def theme(request: pytest.FixtureRequest, qapp: QApplication) -> Theme:
    """Each look in turn."""
    return apply_look(qapp, request.param)


@pytest.fixture
def dark(qapp: QApplication) -> Theme:
    """The dark look."""
    return apply_look(qapp, Look.DARK)


@pytest.fixture
def drawn() -> Callable[[QWidget], QImage]:
    """A widget as it is drawn, in logical pixels."""
    return lambda widget: widget.grab().toImage()


@pytest.fixture
def wheel() -> Callable[[QWidget, QPointF, int], None]:
    """Turn the wheel by notches over a place of a widget."""

    def turn(widget: QWidget, at: QPointF, notches: int) -> None:
        event = QWheelEvent(
            at,
            at,
            QPoint(),
            QPoint(0, 120 * notches),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(widget, event)

    return turn


@pytest.fixture
def near() -> Callable[[QColor, QColor], bool]:
    """Whether two colours are the same but for rounding and soft edges."""
    return lambda one, other: _distance(one, other) <= 12


@pytest.fixture
def inked() -> Callable[[QImage, QPoint, QColor], bool]:
    """Whether a thin line of a colour passes within two pixels of a place."""

    def found(shot: QImage, at: QPoint, colour: QColor) -> bool:
        around = [at + QPoint(dx, dy) for dx in range(-2, 3) for dy in range(-2, 3)]
        return any(_distance(shot.pixelColor(one), colour) <= 70 for one in around)

    return found


@pytest.fixture
def heard() -> Callable[[SignalInstance], list[object]]:
    """What a signal says from now on, as a list that grows."""

    def listen(signal: SignalInstance) -> list[object]:
        said: list[object] = []
        signal.connect(lambda *words: said.append(words[0] if len(words) == 1 else words))
        return said

    return listen


def _distance(one: QColor, other: QColor) -> int:
    return max(abs(a - b) for a, b in zip(one.getRgb()[:3], other.getRgb()[:3], strict=True))
