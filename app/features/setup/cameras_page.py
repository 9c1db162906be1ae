"""The step of the cameras."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QFrame, QHBoxLayout, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import UserSettings
from app.features.setup import cameras_presenter
from app.features.setup.cameras_presenter import arrangement_of, arrangements, lag_told
from app.features.setup.controller import SetupEditor
from app.features.setup.scene import Arrangement, SetupScene, SetupState, Step
from app.features.setup.step_page import StepPage, choose, named, plain
from tracking.recording.image_pairs import MOST_LAG


class CamerasPage(StepPage):
    """Files, which camera is left, how both lie in one image, the lag."""

    step = Step.CAMERAS

    def __init__(
        self,
        editor: SetupEditor,
        remembered: UserSettings,
        interrupted: SetupState | None,
        parent: QWidget,
    ) -> None:
        said = tr("Choose the video of one camera, or of both. You can also drop files here.")
        super().__init__(editor, tr("Cameras"), said, parent)
        self._remembered = remembered
        self._interrupted = interrupted
        self._build_files()
        self._build_resume()
        form = self.form()
        self.left, self.right = (plain("", self, "") for _ in range(2))
        form.addRow(tr("Left"), self.left)
        form.addRow(tr("Right"), self.right)
        self.arrangement = self.choice((), self._arrange)
        form.addRow(tr("Cameras"), named(self.arrangement, tr("How the cameras lie in the files")))
        self.arrangement_told = plain("", self)
        form.addRow(self.arrangement_told)
        self.rows.addLayout(form)
        self._build_left()
        lag_form = self.form()
        self.lag = self.whole(-MOST_LAG, MOST_LAG, self._set_lag)
        self.lag.setSuffix(tr(" frames"))
        self.lag.setToolTip(tr("Frames by which the right camera is late; below 0: the left one."))
        lag_form.addRow(tr("Right late by"), named(self.lag, tr("Lag of the right camera")))
        self.lag_told = plain("", self)
        lag_form.addRow(self.lag_told)
        self.lag_rows = lag_form
        self.rows.addLayout(lag_form)
        rate = self.form()
        self.fps = self.number(tr(" frames/s"), 0.0, 1000.0, 3, self._set_fps)
        self.fps.setSpecialValueText(tr("as the files say"))
        rate.addRow(tr("Frame rate"), named(self.fps, tr("Frames a second")))
        self.rows.addLayout(rate)
        self.found = plain("", self)
        self.doubts = plain("", self, "warning")
        for label in (self.problem, self.doubts, self.found):
            self.rows.addWidget(label)
        self.rows.addStretch(1)

    def _build_files(self) -> None:
        row = QHBoxLayout()
        self.files = self.button(tr("Choose files..."), self._ask_files)
        self.folder = self.button(tr("Choose a folder..."), self._ask_folder)
        row.addWidget(self.files)
        row.addWidget(self.folder)
        self.rows.addLayout(row)

    def _build_resume(self) -> None:
        self.resume = QFrame(self.widget())
        self.resume.setProperty("card", True)
        rows = QVBoxLayout(self.resume)
        self.resume_told = plain("", self.resume, "")
        self.resume_button = self.button(tr("Continue"), self._resume)
        rows.addWidget(self.resume_told)
        rows.addWidget(self.resume_button, 0, Qt.AlignmentFlag.AlignLeft)
        self.rows.addWidget(self.resume)

    def _build_left(self) -> None:
        self.asked = plain(tr("Is this the left camera?"), self, "")
        self.exchange = self.button(
            tr("Exchange left and right"), self._exchange, tr("Exchange left and right camera")
        )
        self.left_told = plain("", self)
        for widget in (self.asked, self.exchange, self.left_told):
            self.rows.addWidget(widget)

    def fill(self, scene: SetupScene) -> None:
        """Files, findings, and what was set."""
        state, plan = scene.state, scene.state.plan
        stereo = plan is not None and plan.is_stereo
        self._fill_resume(state)
        self.left.setText(plan.left.name if plan is not None else tr("none yet"))
        self.right.setText(_right_text(state))
        self._fill_arrangement(state)
        for widget in (self.asked, self.exchange, self.left_told):
            widget.setVisible(stereo)
        self.exchange.setEnabled(not scene.busy)
        by_hand = "left" in state.by_hand
        self.left_told.setText(tr("Set by hand.") if by_hand else tr("Found from the images."))
        for row in range(self.lag_rows.rowCount()):
            self.lag_rows.setRowVisible(row, stereo)
        self.lag.setValue((plan.lag or 0) if plan is not None else 0)
        self.lag_told.setText(lag_told(state))
        self.fps.setValue((plan.fps or 0.0) if plan is not None else 0.0)
        self.fps.setEnabled(plan is not None)
        self.found.setText("\n".join(state.found))
        self.doubts.setText("\n".join(state.doubts))
        self.doubts.setVisible(bool(state.doubts))
        for button in (self.files, self.folder):
            button.setEnabled(not scene.busy)

    def _fill_resume(self, state: SetupState) -> None:
        other = self._interrupted
        if self.editor.resumed:
            self.resume_told.setText(
                tr("You began this set-up earlier and did not write it. What you entered is here.")
            )
            self.resume_button.setText(tr("Begin anew"))
        elif state.plan is None and other is not None and other.plan is not None:
            name = other.plan.name or other.plan.left.name
            self.resume_told.setText(
                tr("You began to set up {name} earlier, and did not write it.", name=name)
            )
            self.resume_button.setText(tr("Continue"))
        self.resume.setVisible(self.editor.resumed or (state.plan is None and other is not None))

    def _fill_arrangement(self, state: SetupState) -> None:
        plan = state.plan
        known = () if plan is None else arrangements(plan)
        if [self.arrangement.itemData(row) for row in range(self.arrangement.count())] != [*known]:
            self.arrangement.clear()
            for value in known:
                self.arrangement.addItem(_arrangement_text(value), value)
        if plan is not None:
            choose(self.arrangement, arrangement_of(plan))
        self.arrangement.setEnabled(plan is not None)
        told = tr("Set by hand.") if "arrangement" in state.by_hand else tr("Found from the files.")
        self.arrangement_told.setText(told if plan is not None else "")

    def _ask_files(self) -> None:
        dialog = QFileDialog(self, tr("Videos of one camera, or of a pair"))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        last = self._remembered.last_folder("open")
        dialog.setDirectory(str(last.folder or last.remembered.recent_folder or Path.home()))

        def take(names: list[str]) -> None:
            last.note(Path(names[0]))
            self.editor.take_paths([Path(name) for name in names])

        dialog.filesSelected.connect(take)
        dialog.open()

    def _ask_folder(self) -> None:
        def take(path: Path) -> None:
            self.editor.take_paths([path])

        last = self._remembered.last_folder("open")
        choose_file(self, tr("The folder with the videos"), "", take, last, folder=True)

    def _resume(self) -> None:
        if self.editor.resumed:
            self.editor.begin_anew()
        elif self._interrupted is not None:
            self.editor.resumed = True
            self.editor.change(self._interrupted)

    def _exchange(self) -> None:
        self.editor.change(cameras_presenter.exchanged(self.editor.state))

    def _arrange(self, value: Arrangement) -> None:
        self.editor.change(cameras_presenter.with_arrangement(self.editor.state, value))

    def _set_fps(self) -> None:
        state, fps = self.editor.state, self.fps.value() or None
        self.editor.try_change(self.step, lambda: cameras_presenter.with_fps(state, fps))

    def _set_lag(self) -> None:
        self.editor.change(cameras_presenter.with_lag(self.editor.state, self.lag.value()))


def _right_text(state: SetupState) -> str:
    plan = state.plan
    if plan is None:
        return ""
    if plan.right is not None:
        return plan.right.name
    return tr("in the same image") if plan.layout else tr("none: one camera")


def _arrangement_text(value: Arrangement) -> str:
    return {
        "pair": tr("A file each"),
        "one": tr("One camera"),
        "side-by-side": tr("Both in one image, side by side"),
        "top-bottom": tr("Both in one image, one above the other"),
        "row-interleaved": tr("Both in one image, rows by turns"),
        "frame-sequential": tr("Both in one video, images by turns"),
    }[value]
