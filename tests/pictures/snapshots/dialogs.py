"""Every dialog and every question over an open recording."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QInputDialog, QMessageBox, QWidget

from app.core.i18n import tr
from app.core.jobs.job_list import JobState
from app.core.widgets.jobs_dialog import JobsDialog
from app.core.widgets.questions import ask_unit
from app.features.correction.attribute_controller import AttributeController
from app.features.correction.schema_dialog import SchemaDialog
from app.features.doctor.dialog import DoctorDialog
from app.features.files.backup_dialog import BackupDialog
from app.features.files.export_dialog import ExportDialog
from app.features.files.import_dialog import ImportDialog
from app.features.keys.dialog import KeysDialog
from app.features.parts.result_dialog import ResultDialog
from app.features.parts.train_dialog import TrainDialog
from app.features.pictures.clip_dialog import ClipDialog
from app.features.review.alike_dialog import AlikeDialog
from app.features.runs.runs_dialog import RunsDialog
from app.features.runs.track_dialog import TrackDialog
from app.shell.shortcuts import ShortcutsDialog
from tests.pictures.snapshots.material import SCHEMA
from tests.pictures.snapshots.snapshot import On, snapshot
from tests.pictures.snapshots.stage import Stage
from tracking.editing import SchemaChange
from tracking.trackers import TRACKERS

DIALOGS, QUESTIONS = "dialogs", "questions"


@snapshot(DIALOGS, On.SESSION, TrackDialog)
def track(stage: Stage) -> Iterator[QWidget]:
    stage.run("tracks.track")
    yield stage.seen(TrackDialog)


def _settings(tracker: str, stage: Stage) -> Iterator[QWidget]:
    """The settings of a tracker, those for experts, too."""
    stage.run("tracks.track")
    dialog = stage.seen(TrackDialog)
    dialog._expert.setChecked(True)
    dialog._choice.setCurrentIndex(list(TRACKERS).index(tracker))
    yield dialog
    dialog._expert.setChecked(False)


for _tracker in TRACKERS:
    snapshot(DIALOGS, On.SESSION, TrackDialog, name=f"track settings of {_tracker}")(
        partial(_settings, _tracker)
    )


@snapshot(DIALOGS, On.SESSION, TrackDialog)
def track_again(stage: Stage) -> Iterator[QWidget]:
    stage.run("review.again")
    yield stage.seen(TrackDialog)


@snapshot(DIALOGS, On.SESSION, RunsDialog)
def runs(stage: Stage) -> Iterator[QWidget]:
    stage.run("tracks.runs")
    yield stage.seen(RunsDialog)


@snapshot(DIALOGS, On.SESSION, AlikeDialog)
def decide_for_all_alike(stage: Stage) -> Iterator[QWidget]:
    stage.run("review.next")
    stage.run("review.alike")
    yield stage.seen(AlikeDialog)


@snapshot(DIALOGS, On.SESSION, ExportDialog)
def export_tracks(stage: Stage) -> Iterator[QWidget]:
    stage.run("file.export")
    yield stage.seen(ExportDialog)


@snapshot(DIALOGS, On.SESSION, ClipDialog)
def export_a_clip(stage: Stage) -> Iterator[QWidget]:
    stage.run("file.export_clip")
    yield stage.seen(ClipDialog)


@snapshot(DIALOGS, On.SESSION, ImportDialog)
def import_tracks(stage: Stage) -> Iterator[QWidget]:
    stage.window.files.importing.read(stage.material.tracks)
    dialog = stage.seen(ImportDialog)
    stage.wait(lambda: dialog._why_not.text() != tr("Looking..."))
    yield dialog


@snapshot(DIALOGS, On.SESSION, BackupDialog)
def restore_a_backup(stage: Stage) -> Iterator[QWidget]:
    stage.run("file.restore")
    dialog = stage.seen(BackupDialog)
    stage.rest(500)
    yield dialog


@snapshot(DIALOGS, On.SESSION, JobsDialog)
def jobs(stage: Stage) -> Iterator[QWidget]:
    """Work that runs, that ended with a file, that was stopped, that failed."""
    listed = stage.window.work.jobs
    title = tr("Exporting {name}", name=stage.material.tracks.name)
    running = listed.begin(title, cancel=lambda: None)
    listed.show(running, 0.4, 95.0)
    without_end = listed.begin(tr("Scoring"))
    for state, place in (
        (JobState.DONE, stage.material.tracks),
        (JobState.STOPPED, None),
        (JobState.FAILED, None),
    ):
        word = tr("Could not be written") if state is JobState.FAILED else ""
        listed.end(listed.begin(title), state, place, word)
    stage.run("view.jobs")
    stage.rest(300)
    yield stage.seen(JobsDialog)
    for number in (running, without_end):
        listed.end(number, JobState.DONE)
    listed.forget()


@snapshot(DIALOGS, On.SESSION, JobsDialog)
def no_jobs(stage: Stage) -> Iterator[QWidget]:
    stage.window.work.jobs.forget()
    stage.run("view.jobs")
    yield stage.seen(JobsDialog)


@snapshot(DIALOGS, On.SESSION, KeysDialog)
def keys(stage: Stage) -> Iterator[QWidget]:
    stage.run("edit.keys")
    yield stage.seen(KeysDialog)


@snapshot(DIALOGS, On.SESSION, KeysDialog)
def keys_in_conflict(stage: Stage) -> Iterator[QWidget]:
    """A key that another command has is asked for."""
    from PySide6.QtTest import QTest

    stage.run("edit.keys")
    dialog = stage.seen(KeysDialog)
    dialog.table.setCurrentCell(3, 0)
    dialog.add.click()
    QTest.keyClick(dialog.field, Qt.Key.Key_X)
    yield dialog
    dialog.leave.click()


@snapshot(DIALOGS, On.SESSION, SchemaDialog)
def no_attributes(stage: Stage) -> Iterator[QWidget]:
    stage.run("tracks.schema")
    yield stage.seen(SchemaDialog)


def _attribute(at: int, stage: Stage) -> Iterator[QWidget]:
    """The dialog at one attribute; there is more to tell where its name was changed."""
    stage.controller.of(AttributeController).change(SchemaChange(SCHEMA))
    stage.run("tracks.schema")
    dialog = stage.seen(SchemaDialog)
    dialog.list.setCurrentRow(at)
    if dialog.choices.isVisible():
        dialog.choices.setPlainText("\n".join(SCHEMA[at].choices[:-1]))
        dialog.name.setText("years")
        dialog.name.textEdited.emit("years")
    yield dialog
    dialog.reject()
    stage.controller.editing.undo()


for _at in (0, 2, 3, 4):
    snapshot(DIALOGS, On.SESSION, SchemaDialog, name=f"attributes-{SCHEMA[_at].type.value}")(
        partial(_attribute, _at)
    )


@snapshot(DIALOGS, On.SESSION, ShortcutsDialog)
def all_shortcuts(stage: Stage) -> Iterator[QWidget]:
    stage.run("help.keys")
    yield stage.seen(ShortcutsDialog)


@snapshot(DIALOGS, On.SESSION, DoctorDialog)
def check_of_a_sound_recording(stage: Stage) -> Iterator[QWidget]:
    yield from _checked(stage)


def _checked(stage: Stage) -> Iterator[QWidget]:
    stage.run("help.doctor")
    dialog = stage.seen(DoctorDialog)
    stage.wait(lambda: dialog.again.isEnabled() and dialog.progress.isHidden())
    yield dialog
    dialog.reject()
    stage.wait(lambda: stage.window.files.doctor.page is None)


@snapshot(DIALOGS, On.SESSION, DoctorDialog)
def check_of_a_recording(stage: Stage) -> Iterator[QWidget]:
    """One whose calibration is wrong; the session is opened again afterwards."""
    stage.open_session(stage.material.turned)
    yield from _checked(stage)
    stage.open_session()


@snapshot(DIALOGS, On.SESSION, TrainDialog)
def train_the_detector(stage: Stage) -> Iterator[QWidget]:
    stage.run("detector.train")
    dialog = stage.seen(TrainDialog)
    stage.wait(lambda: dialog._job is None)
    yield dialog


@snapshot(DIALOGS, On.SESSION, ResultDialog)
def result_of_the_training(stage: Stage) -> Iterator[QWidget]:
    if stage.window.files.detectors.result is None:
        stage.run("detector.train")
        dialog = stage.seen(TrainDialog)
        stage.wait(lambda: dialog._job is None)
        dialog._form.put("search_samples", 100)
        dialog._form.put("folds", 2)
        dialog._train.click()
    else:
        stage.run("detector.result")
    shown = stage.seen(ResultDialog)
    stage.wait(lambda: shown.mistakes._job is None)
    yield shown


# questions


@snapshot(QUESTIONS, On.SESSION, "app.shell.author:ask")
def your_name(stage: Stage) -> Iterator[QWidget]:
    stage.run("file.author")
    yield stage.seen(QInputDialog)


@snapshot(QUESTIONS, On.SESSION, "app.core.widgets.questions:ask_unit")
def unit_of_lengths(stage: Stage) -> Iterator[QWidget]:
    ask_unit(stage.window, stage.material.tracks.name, lambda _: None)
    yield stage.seen(QMessageBox, "unit")


@snapshot(QUESTIONS, On.SESSION, "app.core.widgets.questions:ask_about_unsaved")
def changes_not_saved(stage: Stage) -> Iterator[QWidget]:
    track = stage.pick(1)
    stage.controller.editing.rename(track, "bicycle")
    stage.run("file.close")
    yield stage.seen(QMessageBox, "unsaved")
    stage.tidy()
    stage.controller.editing.undo()


def _file(command: str, stage: Stage) -> Iterator[QWidget]:
    stage.run(command)
    yield stage.seen(QFileDialog)


snapshot(QUESTIONS, On.SESSION, "app.core.widgets.questions:choose_file", name="file to open")(
    partial(_file, "file.open")
)
snapshot(QUESTIONS, On.SESSION, "app.core.widgets.questions:choose_new_file", name="file to write")(
    partial(_file, "file.save_as")
)
