"""The window: it holds the parts together and passes commands on, nothing more."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QApplication,
    QLabel,
    QMainWindow,
    QMenuBar,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from app.core.commands import CommandRegistry
from app.core.drawing.canvas import Canvas
from app.core.error_messages import explain
from app.core.i18n import language_in_use, tr
from app.core.keymap import first_key
from app.core.look.icons import application_icon
from app.core.widgets.command_list import native_keys
from app.core.widgets.desktop_programs import open_place
from app.core.widgets.jobs_dialog import JobsButton, JobsDialog
from app.core.widgets.notice import NoticeBar
from app.core.widgets.parts import quiet
from app.core.widgets.progress_strip import ProgressStrip
from app.core.widgets.user_settings import UserSettings
from app.core.widgets.work import Work
from app.features.welcome.welcome import WelcomePage
from app.shell.command_palette import CommandPalette
from app.shell.commands import COMMANDS
from app.shell.context_menu import ContextMenu
from app.shell.files import Files
from app.shell.key_choice import KeyChoice
from app.shell.language_choice import LanguageChoice, why_unreadable
from app.shell.listed_work import ListedWork
from app.shell.look_choice import LookChoice
from app.shell.menus import Menus, TypingGuard
from app.shell.recording_controller import RecordingController
from app.shell.refusal_notice import RefusalNotice
from app.shell.screen_fit import fit_to_screen, keep_on_screen
from app.shell.window_app import WindowApp
from app.shell.workspace import Workspace

if TYPE_CHECKING:
    from app.features.project.page import ProjectPage

_FIRST_SIZE = QSize(1440, 900)
_NOTE_MS = 6000
_PROGRESS_MS = 200
_MARGIN = 8


class MainWindow(QMainWindow):
    """One window on one recording or session."""

    def __init__(self, remembered: UserSettings) -> None:
        super().__init__()
        self.remembered: UserSettings = remembered
        self.setWindowIcon(application_icon())
        self.welcome = WelcomePage(self)
        self.workspace: Workspace = Workspace(self)
        self._project_page: ProjectPage | None = None
        self.notice = NoticeBar(self)
        self.progress = ProgressStrip(self)
        self.meter: QLabel = quiet("", self)
        self.work = Work(self.progress, self)
        self.jobs_button = JobsButton(self.work.jobs, self)
        self.listed = ListedWork(self.work.jobs)
        self.files = Files(self, self.work, remembered)
        self.app = WindowApp(self)
        self.registry = CommandRegistry(COMMANDS, self.app)
        self.key_choice: KeyChoice = KeyChoice(self, remembered)
        self.menus = Menus(self, self.registry.commands)
        self.look_choice = LookChoice(remembered, self)
        self.language_choice: LanguageChoice = LanguageChoice(remembered, self)
        self.palette_of_commands = CommandPalette(self)
        self.context_menu = ContextMenu(self)
        self._pages = QStackedWidget(self)
        self._guard = TypingGuard(self)
        self._told = RefusalNotice(self, self._guard)
        self._refreshing = QTimer(self, singleShot=True, interval=0)
        self._progressing = QTimer(self, singleShot=True, interval=_PROGRESS_MS)
        self._lay_out()
        self._connect()
        self._show_keys()
        self._restore()
        self.show_welcome()

    def _lay_out(self) -> None:
        self._pages.addWidget(self.welcome)
        self._pages.addWidget(self.workspace)
        centre = QWidget(self)
        column = QVBoxLayout(centre)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._pages, 1)
        self.setCentralWidget(centre)
        line = self.statusBar()  # keeps its height: nothing above moves when work begins or ends
        line.setSizeGripEnabled(False)
        line.addWidget(self.meter)
        line.addPermanentWidget(self.progress, 3)
        line.addPermanentWidget(self.jobs_button)
        line.setMinimumHeight(max(line.sizeHint().height(), self.notice.least_height))
        self.notice.stand_over(centre, line, self.progress, self.jobs_button)
        self.workspace.messages = (self.notice,)
        self._search = search = QPushButton(self)
        search.setProperty("search", True)
        search.setAccessibleName(tr("Search commands"))
        search.clicked.connect(lambda: self.run_command("edit.commands"))
        bar: QMenuBar = self.menuBar()
        bar.setCornerWidget(search)
        self.setAcceptDrops(True)
        names = ("tracks.swap", "tracks.split", "tracks.merge", "tracks.end_here", "tracks.draw")
        self.workspace.card.set_actions([self.menus.actions[name] for name in names])
        said = {"right": tr("Accept"), "fix": tr("Correct..."), "dismiss": tr("Dismiss")}
        self.workspace.review.set_actions(
            [(self.menus.actions[f"review.{name}"], word) for name, word in said.items()]
        )

    def _connect(self) -> None:
        self.menus.asked.connect(self.run_command)
        self.palette_of_commands.run_asked.connect(self.run_command)
        self.palette_of_commands.left.connect(self.activateWindow)
        self.welcome.open_asked.connect(self.files.ask_open)
        self.welcome.project_asked.connect(self.files.projects.ask)
        self.welcome.setup_asked.connect(self.files.setup.ask)
        self.workspace.setup_asked.connect(self.files.setup.metres)
        self.welcome.demo_asked.connect(self.files.open_demo)
        self.welcome.path_chosen.connect(self.files.open_recent)
        self.welcome.dropped.connect(self.files.open_dropped)
        self.workspace.camera_switch.mode_chosen.connect(
            lambda mode: self.run_command(f"view.{mode}")
        )
        for panel in self.workspace.panels.values():
            panel.command_asked.connect(self.run_command)
        self.workspace.docks.close_asked.connect(self._close_panel)
        self.workspace.docks.changed.connect(self.refresh)
        self.workspace.transport.tracker_clicked.connect(lambda: self.run_command("tracks.track"))
        self.files.changed.connect(self.refresh)
        self.files.failed.connect(self.tell_error)
        self.files.said.connect(self.say)
        self.work.changed.connect(self.refresh)
        self.work.succeeded.connect(self.notice.settle)
        self.work.failed.connect(self.files.open_recovery.tell)
        self.work.said.connect(self.say)
        self.work.ended.connect(self.tell_ended)
        self.jobs_button.drawn.connect(lambda: self._make_room(self.statusBar().currentMessage()))
        self.jobs_button.clicked.connect(lambda: self.run_command("view.jobs"))
        self.progress.cancelled.connect(self._cancel)
        self.progress.stopped.connect(lambda: self.run_command("tracks.stop"))
        self.files.progressed.connect(self._progress_soon)
        self.statusBar().messageChanged.connect(self._make_room)
        self._refreshing.timeout.connect(self._refresh_now)
        self._progressing.timeout.connect(self._show_progress)
        self.look_choice.changed.connect(self.menus.draw_icons)
        self.key_choice.changed.connect(self._show_keys)
        application = QApplication.instance()
        if application is not None:
            application.installEventFilter(self._guard)

    # what is shown

    @property
    def project_page(self) -> ProjectPage:
        """The page of a project, made when it is first asked for: few windows need it."""
        if self._project_page is None:
            from app.features.project.page import ProjectPage

            self._project_page = page = ProjectPage(
                lambda name: self.files.projects.project.image_of(name)
            )
            page.command_asked.connect(self.run_command)
            self._pages.addWidget(page)
        return self._project_page

    @property
    def controller(self) -> RecordingController | None:
        """The open recording; None while the welcome page is shown."""
        return self.files.controller

    def show_welcome(self) -> None:
        """Show the first page."""
        self.welcome.show_scene(self.files.welcome_scene())
        self._pages.setCurrentWidget(self.welcome)
        self.refresh()

    def show_start(self) -> None:
        """Show what there is without a recording: the open project, else the first page."""
        if not self.files.projects.is_open:
            self.show_welcome()
            return
        self._pages.setCurrentWidget(self.project_page)
        self.project_page.focus_table()
        self.files.projects.project.begin()
        self.refresh()

    def show_workspace(self) -> None:
        """Show the open recording."""
        self.files.projects.pause()
        self._pages.setCurrentWidget(self.workspace)
        self.workspace.left.setFocus()
        self.refresh()

    def refresh(self) -> None:
        """Bring commands, title and progress up to date, once, before the next event."""
        if not self._refreshing.isActive():
            self._refreshing.start()

    def bring_up_to_date(self) -> None:
        """The same at once, for what is about to be shown."""
        self._refreshing.stop()
        self._refresh_now()

    def _refresh_now(self) -> None:
        items = self.registry.items()
        self.menus.show_items(items)
        if (page := self._project_page) is not None:
            page.enable_all({item.command: item.why_not for item in items})
        self.setWindowTitle(self.files.title())
        self.setWindowModified(self.files.saving.unsaved)
        self.meter.setText(self.controller.work_text if self.controller else "")
        self._show_progress()
        self._told.settle()
        self.files.leaving.settle()

    def _show_keys(self) -> None:
        """Give the commands their keys, wherever they are shown."""
        self.menus.use_keys()
        self.welcome.name_keys()
        key = native_keys(first_key("edit.commands"))
        self._search.setText(f"{tr('Search commands')}   {key}".rstrip())
        self.refresh()

    def _progress_soon(self) -> None:
        if not self._progressing.isActive():
            self._progressing.start()

    def _show_progress(self) -> None:
        """Show how far the tracker at work is; other work shows itself."""
        live = self.controller.live if self.controller is not None else None
        found = self.files.tracker_found_some
        keep = partial(self.run_command, "tracks.stop") if found else None
        self.listed.take_tracking(live, self._drop_tracking, keep)
        if (batches := self.files.projects.batches) is not None:
            self.listed.take_batch(batches)
        if self.work.busy:
            return
        if live is not None and live.running:
            text = tr("Tracking with {tracker}: {status}", tracker=live.tracker, status=live.status)
            left, stops = live.seconds_left, live.stopping
            self.progress.show_scene(text, live.share, left, stoppable=found, stopping=stops)
        else:
            self.progress.finish()

    # messages

    def _make_room(self, said: str) -> None:
        """Let the progress give way to a passing word, which stands left of it."""
        self.meter.setVisible(not said)  # hidden by Qt alone it is back when the line gets higher
        words = self.fontMetrics().horizontalAdvance(said) + 6 * _MARGIN if said else 0
        self.progress.give_way(words, self.width() - self.jobs_button.sizeHint().width())

    def say(self, text: str) -> None:
        """A passing word."""
        self.statusBar().showMessage(text, _NOTE_MS)

    def tell_error(self, error: Exception) -> None:
        """Tell what went wrong."""
        self.notice.say(explain(error), is_error=True)

    def tell_ended(self, text: str, place: Path | None, passing: bool = True) -> None:
        """Tell what came of long work, and offer to open it."""
        if place is None:
            self.say(text)
        else:
            self.notice.say(text, tr("Open"), lambda: self.open_place(place), passing=passing)

    def open_place(self, place: Path) -> None:
        """Open a file or folder that was written in the program that the desktop has for it."""
        if not open_place(place):
            self.say(tr("No program opens {path}", path=place))

    def show_jobs(self) -> None:
        """List all long work; where the list is open, it comes to the front."""
        dialog = self.findChild(JobsDialog)
        if dialog is None:
            dialog = JobsDialog(self.work.jobs, self)
            dialog.open_asked.connect(self.open_place)
            dialog.finished.connect(self.activateWindow)
        dialog.show()
        dialog.raise_()
        dialog.activateWindow()

    def tell_of_letters(self) -> None:
        """Tell where no font can show the letters of the language in use."""
        if why := why_unreadable(language_in_use()):
            self.notice.say(why, is_error=True)

    # commands

    def run_command(self, name: str) -> None:
        """Do a command of the catalogue, where it can be done now; else say why not."""
        item = self.registry.item(name)
        if not item.enabled:
            self._told.refuse(item)
            return
        self.notice.give_way()
        self.registry.run(name)
        self.refresh()

    def _close_panel(self, name: str) -> None:
        """Close a panel by its command, which switches."""
        own = f"view.panel_{name}"
        self.run_command(own if own in self.menus.actions else f"view.{name}")

    def keyPressEvent(self, event: QKeyEvent) -> None:  # noqa: N802 - Qt's name
        """Esc leaves the panel that was gone to by keys; of a key that can do nothing say why."""
        if event.key() == Qt.Key.Key_Escape and self.workspace.pane_keys.leave():
            return
        typed = self._guard.typed  # into a field, which passes Enter on
        name = "" if typed else self.menus.command_of(QKeySequence(event.keyCombination()))
        if name and not self.menus.actions[name].isEnabled():
            self.run_command(name)
        else:
            super().keyPressEvent(event)

    def focusNextPrevChild(self, next: bool) -> bool:  # noqa: N802, A002 - Qt's names
        """Tab selects people: while a tracker has found none yet it leaves the keyboard there.

        `keyPressEvent` says why then. Qt asks, too, where the control that has it is hidden.
        """
        if self.workspace.isVisible() and self.workspace.pane_keys.stay(self.focusWidget()):
            return True
        at_work = self.controller is not None and self.controller.live.running
        if at_work and isinstance(self.focusWidget(), Canvas):
            return False
        return super().focusNextPrevChild(next)

    def _cancel(self) -> None:
        """End what is under way and keep nothing of it."""
        if self.work.busy:
            self.work.cancel()
        elif self.controller is not None and self.controller.live.running:
            self._drop_tracking()

    def _drop_tracking(self) -> None:
        """End the tracker at work and keep nothing of it."""
        if self.controller is not None and self.controller.live.running:
            self.controller.tracking.drop()
            self.say(tr("Tracking was cancelled; its result is not kept"))
            self.refresh()

    # coming and going

    def _restore(self) -> None:
        fit_to_screen(self, _FIRST_SIZE)
        geometry = self.remembered.state("window/geometry")
        if geometry is not None:
            self.restoreGeometry(geometry)
            keep_on_screen(self)
        self.workspace.restore(self.remembered)

    def remember_layout(self) -> None:
        """Keep size and place of the window and of its parts."""
        self.remembered.set_state("window/geometry", self.saveGeometry())
        self.workspace.remember(self.remembered)

    def closeEvent(self, event: QCloseEvent) -> None:  # noqa: N802 - Qt's name
        """Ask about what is not saved; then end all work and remember the layout."""
        if not self.files.projects.may_close(self.close) or not self.files.may_leave(self.close):
            event.ignore()
            return
        self.remember_layout()
        self.files.drops.close()
        self.files.projects.end()
        self.work.close()
        self.files.close()
        application = QApplication.instance()
        if application is not None:
            application.removeEventFilter(self._guard)
        self.look_choice.close()
        self.language_choice.close()
        super().closeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:  # noqa: N802
        """Take files."""
        if event.mimeData().hasUrls():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:  # noqa: N802
        """Open what was dropped."""
        self.files.open_dropped(event.mimeData().urls())
