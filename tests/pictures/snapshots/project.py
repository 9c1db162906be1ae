"""The project's page and its dialogs."""

from __future__ import annotations

import shutil
from collections.abc import Iterator

from PySide6.QtWidgets import QMessageBox, QWidget

from app.features.project.agreement_dialog import AgreementDialog
from app.features.project.batch_dialog import BatchDialog
from app.features.project.page import ProjectPage
from tests.pictures.snapshots.snapshot import On, snapshot
from tests.pictures.snapshots.stage import Stage
from tracking.batch import BatchState, Doing, Listener, StateFile, batch_folder

PROJECT = "project"


@snapshot(PROJECT, On.PROJECT, ProjectPage)
def project(stage: Stage) -> Iterator[QWidget]:
    yield stage.window


@snapshot(PROJECT, On.PROJECT, ProjectPage)
def project_in_which_nothing_is_found(stage: Stage) -> Iterator[QWidget]:
    page = stage.window.project_page
    page.filter.setText("nobody")
    yield stage.window
    page.filter.clear()


@snapshot(PROJECT, On.PROJECT, BatchDialog)
def track_recordings(stage: Stage) -> Iterator[QWidget]:
    stage.window.project_page.track.click()
    yield stage.seen(BatchDialog)


@snapshot(PROJECT, On.PROJECT, AgreementDialog)
def agreement(stage: Stage) -> Iterator[QWidget]:
    stage.run("file.agreement")
    yield stage.seen(AgreementDialog)


@snapshot(PROJECT, On.PROJECT, ProjectPage)
def batch_at_work(stage: Stage) -> Iterator[QWidget]:
    """A batch that another program runs in the project."""
    project = stage.material.project
    out = project / "results"
    with batch_folder(out):
        told = StateFile(out, {"Camera 2": project / "Camera 2"}, Listener())
        doing = {"1": Doing("1", "Camera 2", "tracking", 3, 12)}
        told.began(BatchState(4, 1, 1, 0, 0, doing, 30.0))
        stage.window.files.projects.project.look()
        stage.wait(stage.window.project_page.batch.isVisible)
        stage.rest(300)
        yield stage.window
    shutil.rmtree(out)
    stage.wait(lambda: not stage.window.project_page.batch.isVisible())


@snapshot(PROJECT, On.PROJECT, "app.shell.project_navigation:may_close")
def window_closed_while_a_batch_works(stage: Stage) -> Iterator[QWidget]:
    navigation = stage.window.files.projects
    batches = type(navigation.project.batches)
    own = batches.is_own
    batches.is_own = property(lambda _: True)  # type: ignore[method-assign,assignment]
    try:
        navigation.may_close(lambda: None)
        box = stage.seen(QMessageBox, "batch")
        yield box
        box.reject()
    finally:
        batches.is_own = own  # type: ignore[method-assign]
