"""Tracking again from a corrected frame on, and the runs there are by then."""

from __future__ import annotations

from app.presenters.i18n import tr
from app.presenters.runs.runs import CORRECTED, RunList
from app.views.desk.recording_controller import RecordingController
from app.views.runs.runs_dialog import RunsDialog
from app.views.runs.track_dialog import TrackDialog
from tracking.errors import TrackwrightError


def ask_again(desk: RecordingController) -> None:
    """Ask from where on, and with what, the recording is tracked again.

    Proposed are the range that is set, else all from the playhead on, with the tracker and the
    settings of the run that was corrected; with a tracker of parts and the failure detector that
    was chosen since, where one was.
    """
    session, recording = desk.document.session, desk.document.recording
    if session is None:
        return
    told = tr(
        "People keep the ids they have before the first frame. Nothing that was corrected or "
        "reviewed is overwritten, and you see all changes before they are made."
    )
    run = session.corrected_run
    tracker = desk.tracking.proposed
    asked = desk.document.parts_asked
    dialog = TrackDialog(recording, tracker, told, desk.window_page, asked)
    dialog.setWindowTitle(tr("Track again"))
    if run is not None and run.tracker == tracker:
        dialog.put_settings(run.tracker, run.settings, run.seed)
    start, end = desk.document.correcting.marked or (
        desk.playback.clock.frame,
        recording.frame_count,
    )
    dialog.put_frames(start, end - 1)
    dialog.accepted.connect(lambda: _begin(desk, dialog))
    dialog.open()


def _begin(desk: RecordingController, dialog: TrackDialog) -> None:
    try:
        desk.tracking.track_again(*dialog.answer())
    except TrackwrightError as error:
        desk.failed.emit(error)


def show_runs(desk: RecordingController) -> None:
    """List the session's runs, to be compared."""
    session = desk.document.session
    if session is None:
        return
    runs = RunList(session, desk.document.recording, live=desk.document.at_work)
    dialog = RunsDialog(runs, desk.window_page)
    dialog.compare_asked.connect(
        lambda run, base: desk.comparing.open(run, None if base == CORRECTED else base)
    )
    dialog.correct_asked.connect(desk.comparing.correct)
    dialog.drop_asked.connect(desk.comparing.drop_run)
    dialog.open()
