"""The step of the floor."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QStackedWidget, QVBoxLayout, QWidget

from app.core.i18n import tr
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import UserSettings
from app.features.setup import floor_presenter
from app.features.setup.board_fields import BoardFields
from app.features.setup.calibration_presenter import with_board
from app.features.setup.controller import SetupEditor
from app.features.setup.points_table import PointsTable
from app.features.setup.scene import FloorMethod, SetupPicture, SetupScene, SetupState, Step
from app.features.setup.step_page import StepPage, choose, fit_stack, named, plain
from tracking.calibration.floor import FloorEstimate
from tracking.progress import Progress
from tracking.recording.limits import MOST_HEIGHT_M

_PAGES: dict[FloorMethod, int] = {
    "measured": 0,
    "typed": 1,
    "points": 2,
    "distances": 2,
    "pose": 3,
    "board": 4,
}
_DEGREE = "\N{DEGREE SIGN}"


class FloorPage(StepPage):
    """Where the floor is: measured, typed, clicked, by a board, or from a file with the pose."""

    step = Step.FLOOR

    def __init__(self, editor: SetupEditor, remembered: UserSettings, parent: QWidget) -> None:
        said = tr("How high the left camera is, and how it looks down. The figure is 1.7 m tall.")
        super().__init__(editor, tr("Floor"), said, parent)
        self._remembered = remembered
        form = self.form()
        methods = (
            ("measured", tr("Measure it")),
            ("typed", tr("Type it")),
            ("points", tr("Points with known places")),
            ("distances", tr("Points with known distances")),
            ("board", tr("A board that lies on it")),
            ("pose", tr("From a file with the pose")),
        )
        self.method = self.choice(methods, self._choose_method)
        form.addRow(tr("Method"), named(self.method, tr("Method of finding the floor")))
        self.rows.addLayout(form)
        self.pages = QStackedWidget(self.widget())
        self.points = PointsTable(self)
        self.pages.addWidget(self._measure_panel())
        for page in (QWidget(self), self.points, self._pose_panel(), self._board_panel()):
            self.pages.addWidget(page)
        self.rows.addWidget(self.pages)
        self._build_fields()
        self.told, self.doubt = plain("", self), plain("", self, "warning")
        for label in (self.problem, self.told, self.doubt):
            self.rows.addWidget(label)
        self.rows.addStretch(1)

    def _measure_panel(self) -> QWidget:
        panel = QWidget(self)
        rows = QVBoxLayout(panel)
        rows.setContentsMargins(0, 0, 0, 0)
        self.measure_told = plain("", panel)
        self.measure = self.button(tr("Measure the floor"), self._measure)
        rows.addWidget(self.measure_told)
        rows.addWidget(self.measure)
        return panel

    def _pose_panel(self) -> QWidget:
        panel = QWidget(self)
        rows = QVBoxLayout(panel)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.addWidget(plain(tr("R and t, or a 4 x 4 matrix, in JSON, TOML, YAML or text."), panel))
        across = QHBoxLayout()
        self.pose = plain("", panel, "")
        across.addWidget(self.pose, 1)
        self.pose_file = self.button(tr("Choose..."), self._ask_pose, tr("Choose the pose file"))
        across.addWidget(self.pose_file)
        rows.addLayout(across)
        self.convention = QLineEdit(panel)
        self.convention.setAccessibleName(tr("Convention of the pose"))
        self.convention.setPlaceholderText(tr("e.g. world-from-camera mm"))
        self.convention.editingFinished.connect(self._type_convention)
        form = self.form()
        form.addRow(tr("Convention"), self.convention)
        rows.addLayout(form)
        return panel

    def _board_panel(self) -> QWidget:
        panel = QWidget(self)
        rows = QVBoxLayout(panel)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.addWidget(plain(tr("Seen by the left camera in some images, and still."), panel))
        form = self.form()
        self.board = BoardFields(self, form, self._change_board)
        rows.addLayout(form)
        self.find_board = self.button(tr("Find the board"), self._find_board)
        rows.addWidget(self.find_board)
        return panel

    def _build_fields(self) -> None:
        form = self.form()
        self.height_m = self.number(" m", 0.0, MOST_HEIGHT_M, 3, self._type)
        self.height_m.setSpecialValueText(tr("not known"))
        self.tilt_deg = self.number(_DEGREE, -45.0, 90.0, 2, self._type)
        self.roll_deg = self.number(_DEGREE, -90.0, 90.0, 2, self._type)
        for box in (self.height_m, self.tilt_deg, self.roll_deg):
            box.setSingleStep(0.1)
        self.height_m.setToolTip(tr("Of the left camera above the floor."))
        self.tilt_deg.setToolTip(
            tr("Of the optical axis below the horizon; 90 looks straight down.")
        )
        self.roll_deg.setToolTip(
            tr("About the optical axis, clockwise as the camera sees the world.")
        )
        form.addRow(tr("Height"), named(self.height_m, tr("Height of the camera")))
        form.addRow(tr("Tilt"), named(self.tilt_deg, tr("Tilt of the camera")))
        form.addRow(tr("Roll"), named(self.roll_deg, tr("Roll of the camera")))
        self.rows.addLayout(form)

    def fill(self, scene: SetupScene) -> None:
        """The form of the method that is chosen, and the floor."""
        state, plan = scene.state, scene.state.plan
        choose(self.method, state.floor_method)
        self.pages.setCurrentIndex(_PAGES[state.floor_method])
        self.points.fill(scene)
        calibrated = scene.checked.calibration is not None
        stereo = calibrated and getattr(scene.checked.calibration, "right", None) is not None
        self.measure_told.setText(_measure_told(calibrated, stereo))
        self.measure.setEnabled(calibrated and not scene.busy)
        self.board.fill(state.board)
        self.find_board.setEnabled(calibrated and not scene.busy)
        self.pose.setText(state.pose_file.name if state.pose_file else tr("No file yet."))
        if not self.convention.hasFocus():
            self.convention.setText(state.convention)
        ground = plan.ground if plan is not None else None
        self.height_m.setValue(ground.height_m if ground else 0.0)
        if ground is not None:
            self.tilt_deg.setValue(ground.tilt_deg)
            self.roll_deg.setValue(ground.roll_deg)
        self.told.setText(state.floor_told)
        self.doubt.setText(state.floor_doubt)
        self.doubt.setVisible(bool(state.floor_doubt))
        fit_stack(self.pages, seen=state.floor_method != "typed")

    def picture(self, scene: SetupScene) -> SetupPicture:
        """The grid, the horizon and the figure."""
        return floor_presenter.floor_picture(scene, self.pointer, self.points.chosen)

    # gestures

    def click(self, x: float, y: float) -> None:
        """One more point of the floor."""
        state = self.editor.state
        if state.floor_method in ("points", "distances"):
            self.points.chosen = len(state.points)
            self.editor.change(floor_presenter.with_point(state, x, y))

    def move_handle(self, number: int, x: float, y: float) -> None:
        """A point lies elsewhere."""
        self.points.chosen = number
        self.editor.change(floor_presenter.with_point_moved(self.editor.state, number, x, y))
        self.estimate(quietly=True)

    def choose_handle(self, number: int) -> None:
        """A point is the one that keys move."""
        self.points.choose_row(number)
        self.redrawn.emit()

    def delete(self) -> None:
        """Take the chosen point away."""
        state, row = self.editor.state, self.points.chosen
        if state.floor_method in ("points", "distances") and 0 <= row < len(state.points):
            self.points.chosen = -1
            self.editor.change(floor_presenter.without_point(state, row))

    def estimate(self, *, quietly: bool = False) -> None:
        """The floor of what was clicked or read; `quietly`: what lacks is not told yet."""
        if quietly and not self.points.is_complete(self.editor.state):
            return

        def change() -> object:
            found = floor_presenter.estimated(self.editor.scene)
            return floor_presenter.with_estimate(self.editor.state, found)

        self.editor.try_change(self.step, change)  # type: ignore[arg-type]

    def _choose_method(self, method: FloorMethod) -> None:
        self.editor.tell(self.step, "")
        self.editor.change(replace(self.editor.state, floor_method=method))

    def _measure(self) -> None:
        self._run(tr("Measuring the floor"), floor_presenter.measured)

    def _change_board(self, *_: object) -> None:
        state = self.editor.state
        self.editor.change(with_board(state, self.board.read(state.board)))

    def _find_board(self) -> None:
        self._run(tr("Looking for the board"), floor_presenter.measured_by_board)

    def _run(self, what: str, find: Callable[[SetupState, Progress], FloorEstimate]) -> None:
        """Find the floor beside the window's thread."""
        state = self.editor.state

        def done(found: FloorEstimate) -> None:
            self.editor.change(floor_presenter.with_estimate(self.editor.state, found))

        self.editor.run(self.step, what, lambda progress: find(state, progress), done)

    def _type(self) -> None:
        values = self.height_m.value(), self.tilt_deg.value(), self.roll_deg.value()
        state = self.editor.state
        self.editor.try_change(self.step, lambda: floor_presenter.with_typed(state, *values))

    def _ask_pose(self) -> None:
        last = self._remembered.last_folder("calibration")
        choose_file(self, tr("The file with the camera's pose"), "", self.take_pose, last)

    def take_pose(self, path: Path) -> None:
        """Take a pose file that was chosen."""
        self.editor.change(replace(self.editor.state, pose_file=path))
        self.estimate()

    def _type_convention(self) -> None:
        text = self.convention.text().strip()
        if text != self.editor.state.convention:
            self.editor.change(replace(self.editor.state, convention=text))
            if self.editor.state.pose_file is not None:
                self.estimate()


def _measure_told(calibrated: bool, stereo: bool) -> str:
    if not calibrated:
        return tr("Calibrate the camera first, or leave the floor open.")
    if stereo:
        return tr("By stereo, from what does not move. People may walk.")
    return tr("By people who walk alone and are seen whole; takes a minute or so.")
