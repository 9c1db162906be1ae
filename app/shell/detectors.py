"""The failure detector in a window: labelled for, trained, saved, and chosen for tracking."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.core.controller import Controller
from app.core.document.detector_choice import DetectorChoice, restore_choice
from app.core.document.document import Document
from app.core.document.document_loader import known_recordings
from app.core.i18n import N_, tr
from app.core.widgets.questions import choose_file, choose_new_file
from app.core.widgets.user_settings import UserSettings
from app.core.widgets.work import Work
from app.features.parts.kept_detectors import detector_file_name, keep_detector
from app.features.parts.mistake_pictures import Here, Search, crop_surroundings, is_of
from app.features.parts.result_dialog import ResultDialog
from app.features.parts.train_dialog import TrainDialog
from app.features.parts.training_result import MistakeItem, TrainingResult
from app.features.parts.training_set import Source, TrainingSet, with_labels
from app.features.parts.training_settings import TrainingSettings, train_on
from app.features.parts.truth_labels import plan_truth_labels
from app.shell.export_controller import beside
from app.shell.recording_controller import RecordingController
from tracking.editing import Change
from tracking.errors import TrackwrightError
from tracking.failure import Trained, load_detector, no_samples, save_detector
from tracking.recording import Recording
from tracking.session import Session

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

_DETECTORS = N_("trackwright (*.h5)")
_REMEMBERED = "detector"


class Detectors(Controller):
    """Trains and chooses the failure detector.

    Signals: `changed()`, another one is used, or one was trained.
    """

    def __init__(
        self, window: MainWindow, work: Work, remembered: UserSettings, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._window, self._work, self._remembered = window, work, remembered
        self.choice: DetectorChoice = restore_choice(remembered.text(_REMEMBERED))
        self.result: TrainingResult | None = None
        self._saved: tuple[str, DetectorChoice] = ("", DetectorChoice())  # fingerprint, where
        self._learnt: tuple[Path, ...] = ()
        self._dialog: ResultDialog | None = None

    def begin(self, controller: RecordingController) -> None:
        """A recording was opened: it is tracked with the detector in use."""
        controller.document.detector = self.choice

    def close(self) -> None:
        """The recording is closed: its pictures are not read any more."""
        if self._dialog is not None:
            self._dialog.close()

    @property
    def _document(self) -> Document | None:
        return None if self._window.controller is None else self._window.controller.document

    # training

    def ask_train(self) -> None:
        """Ask which labels are learnt from, then train."""
        document = self._document
        session = document.session if document is not None else None
        here = None
        if document is not None and session is not None:
            here = _labels_here(session, document.recording)
        own = session.path if session is not None else None
        self._ask(here, [path for path in self._learnt if path != own and path.is_file()])

    def ask_train_on(self, sessions: Sequence[Path]) -> None:
        """The same for the labels of these sessions, whatever is open."""
        self._ask(None, sessions)

    def _ask(self, here: Callable[[], Source] | None, before: Sequence[Path]) -> None:
        dialog = TrainDialog(here, before, self._remembered.last_folder("samples"), self._window)
        dialog.accepted.connect(lambda: self._begin(dialog))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _begin(self, dialog: TrainDialog) -> None:
        try:
            training_set, settings = dialog.answer()
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        self.train(training_set, settings)

    def train(self, training_set: TrainingSet, settings: TrainingSettings) -> None:
        """Train in the background, then show what came of it.

        What is learnt from is proposed again the next time, also where training is cancelled.
        """
        self._learnt = tuple(one.path for one in training_set.sources if one.path is not None)
        work = partial(train_on, training_set.samples, settings)
        self._work.run(
            tr("Training the part-failure detector"), work, partial(self._take, training_set)
        )

    def _take(self, training_set: TrainingSet, trained: Trained) -> None:
        self.result = TrainingResult(trained, training_set)
        self.changed.emit()
        self.show_result()

    def show_result(self) -> None:
        """Show what the last training measured."""
        if self.result is None:
            return
        self.close()
        cut = partial(crop_surroundings, self._here(), Search(known_recordings()))
        dialog = ResultDialog(self.result, cut, self._window)
        dialog.use_asked.connect(self.use_trained)
        dialog.save_asked.connect(self.ask_save)
        dialog.mistake_sought.connect(self._go_to)
        dialog.finished.connect(lambda _: self._forget(dialog))
        self._dialog = dialog
        dialog.show()

    def _here(self) -> Here | None:
        document = self._document
        if document is None or document.session is None:
            return None
        return Here.of(document.recording, document.session)

    def _forget(self, dialog: ResultDialog) -> None:
        if self._dialog is dialog:
            self._dialog = None
        dialog.deleteLater()

    def _go_to(self, item: MistakeItem) -> None:
        """Look at a mistake, where it is of what is open: elsewhere the id is another person's."""
        controller = self._window.controller
        session = None if controller is None else controller.document.session
        path = None if session is None else session.path
        if controller is None or not is_of(controller.document.recording, path, item):
            where = item.source.path or item.recording
            self._tell(tr("This sample is in {where}: open it first", where=where))
            return
        controller.playback.pause()
        controller.playback.go(item.frame)  # first: it may show the session's tracks again
        controller.document.selection.choose(item.track)
        controller.labelling.choose_part(item.part)
        controller.draw()

    # which one is used

    def use_trained(self) -> None:
        """Track with what was trained, from now on."""
        if self.result is None:
            return
        try:
            fingerprint, saved = self._saved
            same = fingerprint == self.result.detector.fingerprint
            self._use(
                saved
                if same and Path(saved.path).is_file()
                else keep_detector(self.result.detector)
            )
        except (TrackwrightError, OSError) as error:
            self.failed.emit(error)

    def ask_open(self) -> None:
        """Ask for the file of a detector."""
        last = self._remembered.last_folder("detector")
        choose_file(
            self._window, tr("Use a part-failure detector"), tr(_DETECTORS), self.use_file, last
        )

    def use_file(self, path: Path) -> None:
        """Track with the detector of a file, once it has been looked over."""

        def work(_: object) -> DetectorChoice:
            load_detector(path)
            return DetectorChoice(str(path.resolve()))

        self._work.run(tr("Opening {name}", name=path.name), work, self._use)

    def use_built_in(self) -> None:
        """Track with the built-in detector."""
        self._use(DetectorChoice())

    def _use(self, choice: DetectorChoice) -> None:
        self.choice = choice
        self._remembered.set_text(_REMEMBERED, choice.path)
        if self._window.controller is not None:
            self.begin(self._window.controller)
            self._window.controller.document.detector_chosen = True
        self._tell(tr("Body parts are now tracked with: {name}", name=choice.name))
        self.changed.emit()

    def ask_save(self) -> None:
        """Ask where the trained detector is kept."""
        start = Path.home() / "detector.h5"
        document = self._document
        if document is not None:
            start = beside(document, "detector.h5")
        last, title = self._remembered.last_folder("detector"), tr("Save the part-failure detector")
        choose_new_file(self._window, title, start, tr(_DETECTORS), self.save_to, last)

    def save_to(self, path: Path) -> None:
        """Write the trained detector with the operating point as it stands."""
        if self.result is None:
            return
        try:
            save_detector(path, self.result.detector)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        fingerprint, saved = self.result.detector.fingerprint, DetectorChoice(str(path.resolve()))
        self._saved = (fingerprint, saved)
        if Path(self.choice.path).name == detector_file_name(self.result.detector):
            self._use(saved)  # the same one, which the user has given a name
        self._tell(tr("Saved: {path}", path=path))

    def _tell(self, text: str) -> None:
        self.said.emit(text)
        if self._dialog is not None:
            self._dialog.tell(text)

    # labels

    def label_from_truth(self) -> None:
        """Label what rendered truth knows, as one edit."""
        document = self._document
        if document is None or document.session is None:
            return
        session, recording = document.session, document.recording
        table, labels, run = session.tracks.snapshot(), session.labels, session.corrected_run

        def work(_: object) -> Change:
            return plan_truth_labels(recording, table, run, labels)

        def apply(change: Change) -> None:
            document.apply(change)
            self.said.emit(tr("Done: {what}", what=change.text))
            if self._window.controller is not None:
                self._window.controller.draw()

        self._work.run(tr("Labelling from ground truth"), work, apply)


def _labels_here(session: Session, recording: Recording) -> Callable[[], Source]:
    """Reads the labels as they are now, off the GUI thread: later edits are left out."""
    run, table, labels = session.corrected_run, session.tracks.snapshot(), session.labels
    footage, name, fps = session.recording.footage, recording.name, recording.fps
    source = Source(tr("This session"), None, no_samples(), footage, name, fps)
    return lambda: with_labels(source, labels, table, run)
