"""The window as a whole: first page, layouts, comparisons, messages, menus."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QMenu, QWidget

from app.core.commands import menu_of
from app.core.i18n import tr
from app.core.jobs.job_list import JobState
from app.core.widgets.notice import NoticeBar
from app.core.widgets.progress_strip import ProgressStrip
from app.features.comparison.compare_panel import ComparePanel
from app.features.comparison.panel import DifferencesPanel
from app.features.welcome.welcome import WelcomePage
from app.shell.command_palette import CommandPalette
from app.shell.commands import COMMANDS
from app.shell.workspace import Workspace
from tests.pictures.snapshots.snapshot import On, snapshot
from tests.pictures.snapshots.stage import Stage

PAGES, MENUS = "pages", "menus"


@snapshot(PAGES, On.NOTHING, WelcomePage)
def welcome_without_recordings(stage: Stage) -> Iterator[QWidget]:
    yield stage.window


@snapshot(PAGES, On.NOTHING, WelcomePage)
def welcome(stage: Stage) -> Iterator[QWidget]:
    """With some that were opened before, one of them gone."""
    remembered = stage.window.remembered
    for path in (stage.material.recording, stage.material.session, stage.material.project):
        remembered.add_recent(path)
    remembered.add_recent(stage.material.folder / "A long name of a recording that has gone")
    stage.window.show_welcome()
    yield stage.window


@snapshot(PAGES, On.SESSION, Workspace)
def workspace(stage: Stage) -> Iterator[QWidget]:
    yield stage.window


def _layout(name: str, stage: Stage) -> Iterator[QWidget]:
    stage.run(f"view.layout_{name}")
    yield stage.window
    stage.run("view.layout_reset")


for _name in ("operator", "annotator", "engineer"):
    snapshot(PAGES, On.SESSION, Workspace, name=f"layout-{_name}")(partial(_layout, _name))


@snapshot(PAGES, On.SESSION)
def left_camera_alone(stage: Stage) -> Iterator[QWidget]:
    stage.run("view.left")
    yield stage.window
    stage.run("view.both")


@snapshot(PAGES, On.SESSION)
def all_overlays(stage: Stage) -> Iterator[QWidget]:
    """Everything that can be laid over the pictures."""
    names = [
        f"view.{name}"
        for name in ("grid", "particles", "trails", "foreground", "disparity", "parts", "truth")
    ]
    items = {name: stage.window.registry.item(name) for name in names}
    switched = [name for name, item in items.items() if item.enabled and not item.checked]
    for name in switched:
        stage.run(name)
    laid, kinds = stage.controller.overlaying.laid, stage.controller.view_options.kinds
    stage.wait(lambda: laid(kinds).image is not None)
    yield stage.window
    for name in switched:
        stage.run(name)


@snapshot(PAGES, On.SESSION, DifferencesPanel)
def runs_compared(stage: Stage) -> Iterator[QWidget]:
    comparing = stage.controller.comparing
    comparing.open(1)
    stage.wait(lambda: comparing.shown and stage.controller.document.comparison.current is not None)
    stage.run("view.divide")
    yield stage.window
    stage.run("view.divide")
    comparing.close()


@snapshot(PAGES, On.SESSION, ComparePanel)
def session_compared(stage: Stage) -> Iterator[QWidget]:
    stage.window.files.beside.compare_with(stage.material.other)
    stage.wait(stage.window.workspace.compare.isVisible)
    yield stage.window
    stage.window.workspace.compare.left.emit()


@snapshot(PAGES, On.SESSION, NoticeBar)
def notice_with_a_button(stage: Stage) -> Iterator[QWidget]:
    """A report was written."""
    stage.window.files.exporting.report_in(stage.material.folder)
    stage.wait(lambda: not stage.window.work.busy and bool(stage.window.notice.action_text))
    yield stage.window


@snapshot(PAGES, On.SESSION, NoticeBar)
def notice_of_an_error(stage: Stage) -> Iterator[QWidget]:
    stage.window.files.open_path(stage.material.folder / "none.h5")
    stage.wait(stage.window.notice.isVisible)
    yield stage.window


@snapshot(PAGES, On.SESSION, NoticeBar)
def notice_of_a_bug(stage: Stage) -> Iterator[QWidget]:
    """Longer than two lines: a button shows the rest."""
    stage.window.tell_error(ValueError("index 7 is out of bounds for axis 0 with size 7. " * 4))
    yield stage.window


@snapshot(PAGES, On.SESSION, ProgressStrip)
def work_in_progress(stage: Stage) -> Iterator[QWidget]:
    """What the line at the lower edge says while something is written."""
    jobs, progress = stage.window.work.jobs, stage.window.progress
    title = tr("Exporting {name}", name=stage.material.tracks.name)
    number = jobs.begin(title)
    jobs.show(number, 0.4, 95.0)
    progress.show_scene(title, 0.4, 95.0, stoppable=True)
    stage.rest(300)
    yield stage.window
    progress.finish()
    jobs.end(number, JobState.DONE)
    jobs.forget()


@snapshot(PAGES, On.SESSION, CommandPalette)
def command_palette(stage: Stage) -> Iterator[QWidget]:
    stage.run("edit.commands")
    yield stage.seen(CommandPalette)


def _menu(name: tuple[str, str], stage: Stage) -> Iterator[QWidget]:
    stage.window.bring_up_to_date()
    menu = stage.window.menus.menus[name]
    menu.popup(stage.window.mapToGlobal(QPoint(20, 30)))
    yield menu
    menu.close()


for _menu_name in dict.fromkeys(menu_of(command) for command in COMMANDS):
    snapshot(MENUS, On.SESSION, name=" ".join(filter(None, _menu_name)).lower().replace(" ", "-"))(
        partial(_menu, _menu_name)
    )


@snapshot(MENUS, On.SESSION)
def menu_of_a_person(stage: Stage) -> Iterator[QWidget]:
    stage.window.context_menu.open(stage.people()[0], QPoint(60, 60))
    yield stage.seen(QMenu)


@snapshot(MENUS, On.SESSION)
def menu_of_nobody(stage: Stage) -> Iterator[QWidget]:
    stage.run("tracks.none")
    stage.window.context_menu.open(0, QPoint(60, 60))
    yield stage.seen(QMenu)
