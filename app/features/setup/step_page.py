"""What the pages of the set-up's steps have in common."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QFrame,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.core.widgets.number_boxes import NumberBox, WholeBox, tell_beside
from app.core.widgets.parts import quiet
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.controller import SetupEditor
from app.features.setup.floor_marks import view_of
from app.features.setup.presenter import problem_of
from app.features.setup.scene import SetupPicture, SetupScene, Step

_LEAST_LABEL_PX = 20
_AROUND_TEXT_PX = 10
_Box = TypeVar("_Box", NumberBox, WholeBox)


class StepPage(QScrollArea):
    """A step's form, which scrolls where it is too high; its picture is drawn beside it.

    Signals: redrawn(), the picture is another one though nothing was entered.

    Attributes:
        pointer: where the mouse is on the picture, px of the image; None: it was not there yet.
    """

    step = Step.CAMERAS
    redrawn = Signal()

    def __init__(self, editor: SetupEditor, title: str, said: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.editor = editor
        self._filling = False
        self.pointer: tuple[float, float] | None = None
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setAccessibleName(title)
        inside = QWidget(self)
        inside.setAutoFillBackground(False)
        self.viewport().setAutoFillBackground(False)
        self.rows = QVBoxLayout(inside)
        self.rows.setContentsMargins(0, 0, 4, 0)
        self.rows.setSpacing(8)
        self.rows.addWidget(plain(said, inside))
        self.problem = plain("", inside, "warning")
        self._inside = inside
        self.setWidget(inside)
        inside.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """The form's content has another height by now."""
        if watched is self._inside and event.type() == QEvent.Type.LayoutRequest:
            self._fit_height()
        return super().eventFilter(watched, event)

    def resizeEvent(self, event: QResizeEvent) -> None:  # noqa: N802
        """Words wrap at other places."""
        super().resizeEvent(event)
        self._fit_height()

    def leave(self) -> None:
        """Another step is shown next: what was begun is ended."""

    def _fit_height(self) -> None:
        """As high as the words are at this width; Qt would take their height at the least one."""
        width = self.viewport().width()
        self._inside.setMinimumHeight(self.rows.totalHeightForWidth(width))

    def show_scene(self, scene: SetupScene) -> None:
        """Show what is known now."""
        told = problem_of(self.step, scene)
        self.problem.setText(told)
        self.problem.setVisible(bool(told))
        self._filling = True
        self.fill(scene)
        self._filling = False

    def fill(self, scene: SetupScene) -> None:
        """Put the scene into the fields."""

    def picture(self, scene: SetupScene) -> SetupPicture:
        """What stands beside the form: the cameras, where a step has nothing else to show."""
        return cameras_picture(scene, self.pointer)

    def click(self, x: float, y: float) -> None:
        """The picture was clicked, px of the image."""

    def hover(self, x: float, y: float) -> None:
        """The mouse is over the picture: the figure on the floor follows it."""
        self.pointer = (x, y)
        if view_of(self.editor.scene) is not None:
            self.redrawn.emit()

    def move_handle(self, number: int, x: float, y: float) -> None:
        """A handle was moved."""

    def choose_handle(self, number: int) -> None:
        """A handle was clicked."""

    def end(self) -> None:
        """Enter was pressed in the picture."""

    def give_up(self) -> None:
        """Escape was pressed in the picture."""

    def delete(self) -> None:
        """Delete was pressed in the picture."""

    # pieces

    def form(self) -> QFormLayout:
        """Rows of names and fields."""
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        return form

    def button(self, text: str, pressed: Callable[[], object], name: str = "") -> QPushButton:
        """A button; `name` for screen readers where the text says too little."""
        button = QPushButton(text, self.widget())
        button.setAutoDefault(False)
        button.setAccessibleName(name or text)
        button.clicked.connect(lambda: pressed())
        return button

    def number(
        self, unit: str, low: float, high: float, decimals: int, changed: Callable[[], object]
    ) -> NumberBox:
        """A field for a number, which tells once it is left or Enter is pressed."""
        box = NumberBox(self.widget())
        box.setRange(low, high)
        box.setDecimals(decimals)
        box.setSuffix(unit)
        return self._field(box, changed)

    def whole(self, low: int, high: int, changed: Callable[[], object]) -> WholeBox:
        """The same for a whole number."""
        box = WholeBox(self.widget())
        box.setRange(low, high)
        return self._field(box, changed)

    @property
    def _field_height(self) -> int:
        """As high as fields for text are."""
        return self.fontMetrics().height() + _AROUND_TEXT_PX

    def _field(self, box: _Box, changed: Callable[[], object]) -> _Box:
        box.setKeyboardTracking(False)
        box.setMinimumHeight(self._field_height)
        tell_beside(box)
        box.valueChanged.connect(lambda: None if self._filling else changed())
        return box

    def choice(
        self, options: Sequence[tuple[str, str]], changed: Callable[[Any], object]
    ) -> QComboBox:
        """A list to choose one of: (value, text) each."""
        box = QComboBox(self.widget())
        box.setMinimumHeight(self._field_height)
        for value, text in options:
            box.addItem(text, value)
        box.currentIndexChanged.connect(
            lambda: None if self._filling else changed(box.currentData())
        )
        return box


def plain(text: str, parent: QWidget, role: str = "muted") -> QLabel:
    """Words that wrap, and are never read as markup."""
    label = quiet(text, parent, role)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setWordWrap(True)
    label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.MinimumExpanding)
    label.setMinimumWidth(_LEAST_LABEL_PX)
    return label


def fit_stack(stack: QStackedWidget, *, seen: bool = True) -> None:
    """Make a stack as high as the page of it that is shown; nothing where that is not `seen`."""
    page = stack.currentWidget()
    layout = page.layout() if page is not None else None
    width = max(stack.width(), 1)
    height = 0
    if seen and layout is not None:
        height = layout.totalHeightForWidth(width) if layout.hasHeightForWidth() else -1
        height = height if height >= 0 else layout.totalSizeHint().height()
    stack.setFixedHeight(height)


def choose(box: QComboBox, value: str) -> None:
    """Have a value chosen."""
    row = box.findData(value)
    if row >= 0 and row != box.currentIndex():
        box.setCurrentIndex(row)


def named(widget: QWidget, name: str) -> QWidget:
    """The widget with a name for screen readers."""
    widget.setAccessibleName(name)
    return widget
