"""The open document's way from disk and back: open, save, export, close."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer, QUrl, Signal

from app.core.controller import Controller
from app.core.document import document_loader
from app.core.document.detector_choice import DETECTOR, restore_choice
from app.core.document.document_loader import OpenedDocument
from app.core.droppable import no_footage
from app.core.i18n import N_, tr
from app.core.memory import give_back
from app.core.scenes import WelcomeScene
from app.core.tracks.frame_state import parse_view_options
from app.core.widgets.literal import literal_title
from app.core.widgets.questions import choose_file
from app.core.widgets.user_settings import UserSettings
from app.core.widgets.work import Work
from app.features.correction.attribute_controller import schema_notes
from app.features.files import left_behind
from app.features.files.demonstration import Demonstration
from app.features.files.first_page import first_page
from app.features.runs.run_summary import describe_coming_run, list_tracking_notes
from app.features.runs.track_dialog import TrackDialog
from app.features.scoring.controller import ScoreController
from app.shell.author import Author
from app.shell.backup_controller import BackupController
from app.shell.clip_controller import ClipController
from app.shell.close_prompts import ClosePrompts, Then
from app.shell.detectors import Detectors
from app.shell.doctor_page import DoctorPage
from app.shell.drops import Drops
from app.shell.export_controller import ExportController
from app.shell.import_controller import ImportController
from app.shell.open_recovery import OpenRecovery
from app.shell.path_contents import Instead, read_path
from app.shell.project_navigation import ProjectNavigation
from app.shell.recording_controller import RecordingController
from app.shell.result_storage import ResultStorage
from app.shell.save_controller import SaveController
from app.shell.sessions_beside import SessionsBeside
from app.shell.setup_controller import SetupController
from app.shell.whereabouts import Whereabouts
from tracking.recording import OpenOptions
from tracking.session import Session
from tracking.tracks import Run

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

_OPENABLE = N_(
    "Recordings and sessions (recording.toml *.h5 *.mp4 *.avi *.mkv *.mov *.ts *.m4v *.bag *.mcap "
    "*.db3 *.tar)"
)
GIVE_BACK_MS = 500
"""After a recording is closed: by then jobs that were stopped have let their arrays go."""


class Files(Controller):
    """Opens recordings and sessions in the window, saves and closes them.

    Attributes: `opening`, something is being opened.

    Signals: `changed()`, another document, title or save state; `progressed()`, the tracker at
    work is further.
    """

    progressed = Signal()

    def __init__(self, window: MainWindow, work: Work, remembered: UserSettings) -> None:
        super().__init__(window)
        self._window = window
        self._work = work
        self._remembered = remembered
        self.open_recovery = OpenRecovery(self, window, work)
        self.whereabouts: Whereabouts = Whereabouts(remembered, self)
        self._greeting = ""
        self.leaving: ClosePrompts = ClosePrompts(self, window)
        self.controller: RecordingController | None = None
        self.author: Author = Author(window, remembered, self)
        self.exporting: ExportController = ExportController(window, work, self)
        self.clips: ClipController = ClipController(window, work, self)
        self.importing: ImportController = ImportController(window, work, self)
        self.detectors: Detectors = Detectors(window, work, remembered, self)
        self.detectors.changed.connect(self.changed)
        self.backups: BackupController = BackupController(window, work, self)
        self.backups.changed.connect(self.changed)
        self.setup: SetupController = SetupController(window, work, self)
        self.doctor: DoctorPage = DoctorPage(window, self)
        self.drops: Drops = Drops(self, work)
        self.projects: ProjectNavigation = ProjectNavigation(window, self)
        self.projects.changed.connect(self.changed)
        self.opening = False
        self.beside: SessionsBeside = SessionsBeside(window, work, self)
        self.keeping: ResultStorage = ResultStorage(window, work, self)
        self.keeping.changed.connect(self.changed)
        self.saving: SaveController = SaveController(self, window, work, remembered)
        self.saving.changed.connect(self.changed)

    # opening

    def ask_open(self) -> None:
        """Ask for a file."""
        last = self._remembered.last_folder("open")
        choose_file(self._window, tr("Open"), tr(_OPENABLE), self.open_path, last)

    def ask_open_folder(self) -> None:
        """Ask for a folder: a recording, or pictures."""
        last = self._remembered.last_folder("open")
        choose_file(self._window, tr("Open folder"), "", self.open_path, last, folder=True)

    def open_recent(self, path: Path) -> None:
        """Open what was opened before, as what it was: a project's folder as a project."""
        if self._remembered.is_recent_project(path) and path.is_dir():
            self.projects.open(path)
        else:
            self.open_path(path)

    def open_dropped(self, urls: Sequence[QUrl]) -> None:
        """Open what was dropped: tracks go into the recording shown, several videos are set up."""
        self.drops.take(urls)

    def refuse_dropped(self, name: str) -> None:
        """Say of a dropped file that cannot be opened what can be dropped."""
        self._window.notice.say(no_footage(name), passing=True)

    def open_path(
        self,
        path: Path,
        recording: Path | None = None,
        options: OpenOptions | None = None,
        *,
        play: bool = False,
        save_at: Path | None = None,
    ) -> None:
        """Open a recording or a session; what is open stays where the other one does not open.

        A folder with videos that are no recording yet is set up, one that holds several recordings
        is opened as a project.

        Args:
            path: what to open.
            recording: where a session's recording is by now.
            options: what a bare recording does not say of itself.
            play: play at once, and track what has no tracks yet.
            save_at: the place that is proposed for the session; beside the recording if None.
        """
        self._window.workspace.take_typed()
        asks = self.leaving.asks()
        self.open_recovery.begin_opening(path)
        if not asks:
            self._remembered.note_closed()  # what crashes as it opens is not opened again unasked

        def show(opened: OpenedDocument | Instead) -> None:
            self.opening = False
            if opened is Instead.SETUP:
                self.setup.begin([path])
                return
            if opened is Instead.PROJECT:
                self.projects.open(path)
                return
            if asks:  # it does open: only now is it worth asking what becomes of the other one
                opened.close()
                if self.may_leave(again):
                    again()
                return
            self._show(opened, from_start=play)
            self.saving.proposed = save_at
            if play and self.controller is not None:
                self.controller.toggle()

        again = partial(self.open_path, path, recording, options, play=play, save_at=save_at)
        work = partial(read_path, path, recording, options)
        if not self._work.refuses():
            self.opening = True
            self._work.run(tr("Opening {name}", name=path.name), work, show, self._end_opening)

    def _end_opening(self) -> None:
        self.opening = False

    def open_demo(self) -> None:
        """Make the built-in recording where it is not there yet, and play it."""
        demo = Demonstration.of_user()
        play = partial(self.open_path, play=True, save_at=demo.session)
        self._work.run(tr("Making the demo recording"), demo.make, play)

    def _show(self, opened: OpenedDocument, from_start: bool) -> None:
        self.close()
        path = opened.path
        if not document_loader.is_unsaved_place(path):
            self._remembered.add_recent(path.resolve(), opened.document.recording.name)
        controller = self.begin(opened)
        self._tell_oddities(opened)
        controller.view_options = parse_view_options(self._remembered.text("pictured"))
        controller.set_cameras(self._remembered.text("eyes", "both"))
        self.whereabouts.begin(controller, path, from_start)

    def begin(self, opened: OpenedDocument) -> RecordingController:
        """Show a document in the window."""
        self.controller = controller = RecordingController(
            opened.document, self._window.workspace, self
        )
        self.saving.begin(controller.document.session)
        self.author.sign()
        self.detectors.begin(controller)
        controller.changed.connect(self.changed)
        controller.drawn.connect(self.beside.draw)
        controller.progressed.connect(self.progressed)
        controller.tracking.tracked.connect(self.keeping.keep)
        controller.tracking.began.connect(self._window.notice.settle)
        controller.tracking.noted.connect(self._tell_of_tracking)
        controller.of(ScoreController).truth_asked.connect(self._ask_truth)
        self._window.workspace.show_whole()  # how another recording was zoomed says nothing here
        self._window.show_workspace()
        return controller

    def greet_after_crash(self) -> None:
        """Say, with what is opened next, that it was open when the program ended in a crash."""
        self._greeting = tr("trackwright ended unexpectedly. Here is where you were.")

    def _tell_oddities(self, opened: OpenedDocument) -> None:
        session = opened.document.session
        greeting, self._greeting = self._greeting, ""
        lines = [
            *([greeting] if greeting else []),
            *(() if session is None else map(tr, session.notes)),
            *map(tr, opened.document.recording.notes),
            *([] if session is None else list_tracking_notes(session)),
            *schema_notes(opened.document),
        ]
        if opened.unsaved is not None:
            lines.append(tr("Work on this recording was never saved, and is kept."))
            go_on = partial(self.open_path, opened.unsaved)
            self._window.notice.say("\n".join(lines), tr("Continue with it"), go_on)
        elif lines:
            self._window.notice.say("\n".join(lines), passing=True)
        else:
            self._window.notice.hide()

    def _ask_truth(self, filters: str) -> None:
        """Ask for a file to score against."""
        if self.controller is not None:
            last, take = (
                self._remembered.last_folder("truth"),
                self.controller.of(ScoreController).choose_file,
            )
            choose_file(self._window, tr("The ground truth"), filters, take, last)

    # tracking

    def _tell_of_tracking(self, lines: Sequence[str], passes: bool) -> None:
        """How it went; what warns of something stays until closed, or another run is corrected."""
        session = self.session
        run = session.adopted_run if session is not None else None

        def holds() -> bool:
            return session is None or (self.session is session and session.adopted_run == run)

        self._window.notice.say("\n".join(lines), passing=passes, holds=holds)

    def ask_track(self, like: Run | None = None) -> None:
        """Ask for tracker and settings, then put it to work.

        Filled in is what made the run `like`, where one is given.
        """
        controller = self.controller
        if controller is None:
            return
        if self.keeping.holds:
            self.keeping.offer()
            return
        warning = describe_coming_run(self.session) if self.session is not None else ""
        document = controller.document
        asked = document.parts_asked
        if like is not None:
            detector = restore_choice(str(like.settings.get(DETECTOR, "")))
            asked = replace(asked, choice=detector)
        dialog = TrackDialog(
            document.recording,
            controller.tracking.propose_tracker,
            self._remembered,
            warning,
            self._window,
            asked,
        )
        if like is not None:
            dialog.put_settings(like.tracker, like.settings, like.seed)
            dialog.put_frames(like.frames[0], like.frames[1] - 1)
        elif (failed := controller.tracking.failed_order) is not None:
            dialog.put_answer(*failed)
        dialog.accepted.connect(lambda: self._track(dialog))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _track(self, dialog: TrackDialog) -> None:
        if self.controller is not None:
            self.controller.tracking.track(*dialog.answer())

    @property
    def session(self) -> Session | None:
        """The open session."""
        return self.controller.document.session if self.controller is not None else None

    @property
    def tracker_found_some(self) -> bool:
        """Whether a tracker is at work and has come past its first frame."""
        return (
            self.controller is not None
            and self.controller.live.running
            and self.controller.live.done > 0
        )

    # leaving

    def may_leave(self, again: Then, stay: Then | None = None) -> bool:
        """Whether the open document can be let go; if not, ask, and do `again` afterwards.

        stay: done where the answer is to keep it open.
        """
        self._window.workspace.take_typed()
        return self.leaving.may_leave(again, stay or (lambda: None))

    def close_recording(self) -> None:
        """Close what is open and go back to the project, or to the first page."""
        if self.may_leave(self.close_recording):
            self._window.notice.hide()
            self.close()
            self._window.show_start()

    def quit(self) -> None:
        """Close the window."""
        self._window.close()

    def close(self, *, keep_open: bool = False) -> None:
        """Let the open document go; its threads have ended when this returns.

        keep_open: its files stay open, for another window.
        """
        if self.controller is not None:
            controller, self.controller = self.controller, None
            self._work.leave_behind()  # it reads from this recording
            self.keeping.drop()
            self.beside.close()
            self.backups.close()
            self.doctor.close()
            self.detectors.close()
            if controller.document.recording.is_stereo:  # one camera leaves nothing to choose
                self._remembered.set_text("eyes", controller.cameras)
            self._remembered.set_text("pictured", controller.view_options.lasting)
            self.whereabouts.end()
            controller.end()
            if not keep_open:
                controller.close()
            controller.deleteLater()
            QTimer.singleShot(GIVE_BACK_MS, give_back)

    def describe_unsaved(self) -> list[str]:
        """What is to be known where the program ends without asking: where unsaved work is."""
        held = self.keeping.holds and not self.keeping.at_work
        at_work = self.controller is not None and self.controller.live.running
        return left_behind.describe_unsaved(self.session, held=held, tracking=at_work)

    def close_without_asking(self) -> None:
        """Let the open document go for a picture or a test: what is not saved stays as it is."""
        self.leaving.agree()
        self.projects.agree()
        self.close()

    # words

    def title(self) -> str:
        """The window's title, with Qt's place for the mark of unsaved changes."""
        if self.controller is None:
            return f"{name} \u2013 trackwright" if (name := self.projects.name) else "trackwright"
        recording, session = self.controller.document.recording, self.session
        name = literal_title(recording.name)
        if session is not None and session.path is not None:
            kept = not document_loader.is_unsaved_place(session.path)
            place = literal_title(session.path.name) if kept else tr("not saved yet")
            name = f"{name} \u2013 {place}"
        return f"{name}[*] \u2013 trackwright"

    def welcome_scene(self) -> WelcomeScene:
        """The first page: what was opened before, and what a crash left behind."""
        remembered = self._remembered
        names = {path: remembered.recent_name(path) for path in remembered.recent}
        return first_page(names, [path for path in names if remembered.is_recent_project(path)])
