"""Tracking again from a corrected frame on, and the runs there are by then."""

from __future__ import annotations

from collections.abc import Callable

from app.core.i18n import tr
from app.core.widgets.user_settings import UserSettings
from app.features.runs.presenter import CORRECTED, RunList
from app.features.runs.runs_dialog import RunsDialog
from app.features.runs.track_dialog import TrackDialog
from app.shell.recording_controller import RecordingController
from tracking.errors import TrackwrightError
from tracking.tracks import Run


def ask_again(controller: RecordingController, remembered: UserSettings) -> None:
    """Ask from where on, and with what, the recording is tracked again.

    Proposed are the range that is set, else all from the playhead on, with the tracker and the
    settings of the run that was corrected; with a tracker of parts and the failure detector that
    was chosen since, where one was.
    """
    session, recording = controller.document.session, controller.document.recording
    if session is None:
        return
    told = tr(
        "People keep the ids they have before the first frame. Corrected and reviewed rows are "
        "not overwritten, and you see all changes before they are made."
    )
    run = session.corrected_run
    tracker = controller.tracking.propose_tracker
    asked = controller.document.parts_asked
    dialog = TrackDialog(recording, tracker, remembered, told, controller.window_page, asked)
    dialog.setWindowTitle(tr("Track again"))
    if run is not None and run.tracker == tracker:
        dialog.put_settings(run.tracker, run.settings, run.seed)
    start, end = controller.document.correcting.marked or (
        controller.playback.clock.frame,
        recording.frame_count,
    )
    dialog.put_frames(start, end - 1)
    dialog.accepted.connect(lambda: _begin(controller, dialog))
    dialog.finished.connect(dialog.deleteLater)
    dialog.open()


def _begin(controller: RecordingController, dialog: TrackDialog) -> None:
    try:
        controller.tracking.track_again(*dialog.answer())
    except TrackwrightError as error:
        controller.failed.emit(error)


def show_runs(
    controller: RecordingController,
    divide: Callable[[float], object] = lambda _: None,
    track_like: Callable[[Run], object] = lambda _: None,
) -> None:
    """List the session's runs, to be compared; `divide` divides the pictures between two.

    `track_like` asks about tracking with the settings of a run.
    """
    session = controller.document.session
    if session is None:
        return
    runs = RunList(session, controller.document.recording, live=controller.document.at_work)
    dialog = RunsDialog(runs, controller.window_page)

    def compare(run: int, base: int) -> None:
        controller.comparing.open(run, None if base == CORRECTED else base)

    def compare_beside(run: int, base: int) -> None:
        compare(run, base)
        divide(0.5)

    dialog.compare_asked.connect(compare)
    dialog.beside_asked.connect(compare_beside)
    dialog.correct_asked.connect(controller.comparing.correct)
    dialog.again_asked.connect(lambda run: track_like(session.runs[run]))
    dialog.drop_asked.connect(controller.comparing.drop_run)
    dialog.open()
