"""The set-up's window: the list of steps, a page for each, and the picture beside it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QUrl, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QKeyEvent,
    QKeySequence,
    QShortcut,
)
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QDialog,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QSlider,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.core.droppable import no_footage
from app.core.i18n import tr
from app.core.widgets.tab_order import tab_in_reading_order
from app.core.widgets.user_settings import UserSettings
from app.core.widgets.work_line import WorkLine
from app.features.setup.calibration_page import CalibrationPage
from app.features.setup.cameras_page import CamerasPage
from app.features.setup.controller import SetupEditor
from app.features.setup.drafts import Drafts
from app.features.setup.floor_page import FloorPage
from app.features.setup.picture_view import PictureView
from app.features.setup.presenter import STEPS, mark_of, may_write
from app.features.setup.region_page import RegionPage
from app.features.setup.scene import SetupState, Step
from app.features.setup.step_list import StepList
from app.features.setup.step_page import StepPage
from app.features.setup.write_page import WritePage
from tracking.recording.images import VIDEO_SUFFIXES
from tracking.setup import SetupPlan
from tracking.setup.files import is_document

_FORM_LETTERS = 50
_SHARES = 1000
_MARGIN_PX = 40
_LEAST = QSize(900, 520)
_UNDO = QKeySequence.StandardKey.Undo
_REDO = QKeySequence.StandardKey.Redo


class SetupDialog(QDialog):
    """Five steps, entered and left at will; Ctrl+Page Down and Ctrl+Page Up go on and back.

    Signals: `planned(plan)`, the plan is to be written and opened. Whoever has written it calls
    :meth:`finish`; until then nothing that was entered is lost.
    """

    planned = Signal(object)

    def __init__(
        self,
        remembered: UserSettings,
        parent: QWidget,
        state: SetupState | None = None,
        drafts: Drafts | None = None,
    ) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("Set up a recording"))
        self.setAcceptDrops(True)
        drafts = drafts or Drafts()
        self.editor = SetupEditor(state or SetupState(), drafts, self)
        interrupted = drafts.latest() if state is None else None
        self.cameras = CamerasPage(self.editor, remembered, interrupted, self)
        self.calibration = CalibrationPage(self.editor, remembered, self)
        self.floor = FloorPage(self.editor, remembered, self)
        self.region = RegionPage(self.editor, self)
        self.write = WritePage(self.editor, self)
        self.pages: tuple[StepPage, ...] = (
            self.cameras, self.calibration, self.floor, self.region, self.write
        )  # fmt: skip
        self.steps = StepList(self)
        self.picture = PictureView(self)
        self.work = WorkLine(tr("Cancel the running work"), self)
        self._build()
        self._connect()
        self._show()
        self.resize(_fitting(parent))

    # building

    def _build(self) -> None:
        self._stack = QStackedWidget(self)
        for page in self.pages:
            self._stack.addWidget(page)
        form = QWidget(self)
        column = QVBoxLayout(form)
        column.setContentsMargins(0, 0, 8, 0)
        column.addWidget(self._stack, 1)
        column.addWidget(self.work)
        column.addLayout(self._buttons())
        form.setMinimumWidth(_FORM_LETTERS * self.fontMetrics().averageCharWidth())
        seen = QWidget(self)
        right = QVBoxLayout(seen)
        right.setContentsMargins(0, 0, 0, 0)
        right.addWidget(self.picture, 1)
        self.instant = QSlider(Qt.Orientation.Horizontal, seen)
        self.instant.setRange(0, _SHARES)
        self.instant.setPageStep(_SHARES // 10)
        self.instant.setAccessibleName(tr("Instant of the footage"))
        self.instant.setToolTip(tr("The instant that the picture shows"))
        self.instant.setValue(round(self.editor.share * _SHARES))
        right.addWidget(self.instant)
        across = QSplitter(Qt.Orientation.Horizontal, self)
        across.setChildrenCollapsible(False)
        across.addWidget(form)
        across.addWidget(seen)
        across.setStretchFactor(0, 0)
        across.setStretchFactor(1, 1)
        whole = QHBoxLayout(self)
        whole.setSpacing(12)
        whole.addWidget(self.steps)
        whole.addWidget(across, 1)
        tab_in_reading_order(self)

    def _buttons(self) -> QHBoxLayout:
        row = QHBoxLayout()
        self.undo_button = self._button(tr("Undo"), self.editor.undo, tr("Undo the last change"))
        self.redo_button = self._button(tr("Redo"), self.editor.redo, tr("Redo what was undone"))
        self.close_button = self._button(tr("Close"), self.reject, tr("Close; nothing is lost"))
        self.close_button.setToolTip(tr("What was entered is kept, and offered again."))
        self.next = self._button(tr("Next"), self.go_on, tr("Next step"))
        self.next.setProperty("primary", True)
        for button in (self.undo_button, self.redo_button):
            row.addWidget(button)
        row.addStretch(1)
        row.addWidget(self.close_button)
        row.addWidget(self.next)
        return row

    def _button(self, text: str, pressed: Callable[[], object], name: str) -> QPushButton:
        button = QPushButton(text, self)
        button.setAutoDefault(False)
        button.setAccessibleName(name)
        button.clicked.connect(lambda: pressed())
        return button

    def _connect(self) -> None:
        self.editor.drawn.connect(self._show)
        self.editor.worked.connect(self._show_work)
        self.work.cancelled.connect(self.editor.cancel)
        self.steps.chosen.connect(self._enter)
        self.instant.valueChanged.connect(lambda value: self.editor.show_at(value / _SHARES))
        self.write.write_asked.connect(self._write)
        self.region.picture_wanted.connect(self.picture.setFocus)
        for page in self.pages:
            page.redrawn.connect(self._draw_picture)
        view = self.picture
        view.clicked.connect(lambda x, y: self.page.click(x, y))
        view.hovered.connect(lambda x, y: self.page.hover(x, y))
        view.handle_moved.connect(lambda number, x, y: self.page.move_handle(number, x, y))
        view.handle_chosen.connect(lambda number: self.page.choose_handle(number))
        view.ended.connect(lambda: self.page.end())
        view.given_up.connect(lambda: self.page.give_up())
        view.deleted.connect(lambda: self.page.delete())
        for keys, run in (
            (QKeySequence(_UNDO), self.editor.undo),
            (QKeySequence(_REDO), self.editor.redo),
            (QKeySequence("Ctrl+PgDown"), self.go_on),
            (QKeySequence("Ctrl+PgUp"), self.go_back),
        ):
            QShortcut(keys, self).activated.connect(run)
        for kind in (QLineEdit, QAbstractSpinBox):
            for field in self.findChildren(kind):
                field.installEventFilter(self)

    # showing

    @property
    def page(self) -> StepPage:
        """The page that is shown."""
        return self.pages[self._stack.currentIndex()]

    @property
    def plan(self) -> SetupPlan | None:
        """What would be written."""
        return self.editor.state.plan

    def go_to(self, step: Step) -> None:
        """Show a step."""
        self.steps.choose(STEPS.index(step))

    def go_to_first_open(self) -> None:
        """Show the first step that metres still need."""
        plan = self.plan
        if plan is not None:
            self.go_to(Step.FLOOR if plan.calibration else Step.CALIBRATION)

    def go_on(self) -> None:
        """The next step; at the last one it is written."""
        if self.page is self.write:
            self._write()
        elif not (self.page is self.calibration and self.calibration.holds_back()):
            self.steps.choose(self._stack.currentIndex() + 1)

    def go_back(self) -> None:
        """The step before."""
        self.steps.choose(max(self._stack.currentIndex() - 1, 0))

    def _enter(self, row: int) -> None:
        if row != self._stack.currentIndex():
            self.page.leave()
        self._stack.setCurrentIndex(row)
        self._show()
        self.page.ensureVisible(0, 0)

    def _show(self) -> None:
        scene = self.editor.scene
        self.steps.show_marks([mark_of(step, scene) for step in STEPS])
        self.page.show_scene(scene)
        self.undo_button.setEnabled(self.editor.may_undo)
        self.redo_button.setEnabled(self.editor.may_redo)
        self.next.setVisible(self.page is not self.write)
        self.next.setEnabled(scene.state.plan is not None)
        self.instant.setEnabled(scene.images is not None)
        self._draw_picture()

    def _draw_picture(self) -> None:
        self.picture.show_picture(self.page.picture(self.editor.scene))

    def _show_work(self, text: str, share: float) -> None:
        self.work.show_work(text, None if share < 0 else share)

    # gestures

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
        """Undo in a field undoes the last change, not letters of one that was taken already."""
        if isinstance(event, QKeyEvent) and isinstance(watched, QLineEdit | QAbstractSpinBox):
            back, again = event.matches(_UNDO), event.matches(_REDO)
            if (back or again) and event.type() == QEvent.Type.ShortcutOverride:
                event.accept()
                return True
            if (back or again) and event.type() == QEvent.Type.KeyPress:
                _take_typed(watched)
                (self.editor.undo if back else self.editor.redo)()
                return True
            if event.type() == QEvent.Type.KeyPress and event.key() in (
                Qt.Key.Key_Return,
                Qt.Key.Key_Enter,
            ):
                _take_typed(watched)
                return True  # it would press a button of the dialog
        return super().eventFilter(watched, event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:  # noqa: N802
        """Files from this machine."""
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:  # noqa: N802
        """Videos or a folder are the cameras; at the step of the calibration other files it."""
        event.acceptProposedAction()
        self.take_dropped([url for url in event.mimeData().urls() if url.isLocalFile()])

    def take_dropped(self, urls: Sequence[QUrl]) -> None:
        """Take what was dropped."""
        paths = [Path(url.toLocalFile()) for url in urls]
        if self.page is self.calibration and not any(map(_is_footage, paths)):
            self.calibration.take_files(tuple(sorted(paths)[:2]))
            return
        footage = [path for path in paths if not is_document(path)]
        if paths:
            self.go_to(Step.CAMERAS)
        if footage:
            self.editor.take_paths(footage)
        elif paths:
            self.editor.tell(Step.CAMERAS, no_footage(paths[0].name))

    def _write(self) -> None:
        if may_write(self.editor.scene):
            self.planned.emit(self.editor.state.plan)

    def finish(self) -> None:
        """It was written: nothing is to be kept for another time."""
        self.editor.forget_draft()
        self.accept()

    def done(self, result: int) -> None:
        """Close; what still works is asked to end."""
        self.calibration.stop()
        self.editor.stop()
        super().done(result)

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802
        """The same by the window's own button."""
        self.calibration.stop()
        self.editor.stop()
        super().closeEvent(event)


def _is_footage(path: Path) -> bool:
    """Whether a path is a folder or named as a video: it is not looked into here."""
    return path.is_dir() or path.suffix.lower() in VIDEO_SUFFIXES


def _take_typed(field: QLineEdit | QAbstractSpinBox) -> None:
    """Take what was typed and not taken yet."""
    around = field.parentWidget()
    if isinstance(field, QAbstractSpinBox):
        field.interpretText()
    elif isinstance(around, QAbstractSpinBox):
        around.interpretText()
    elif field.isModified():
        field.setModified(False)
        field.editingFinished.emit()


def _fitting(parent: QWidget) -> QSize:
    """Nearly as large as the window."""
    window = parent.window().size()
    return QSize(window.width() - _MARGIN_PX, window.height() - _MARGIN_PX).expandedTo(_LEAST)
