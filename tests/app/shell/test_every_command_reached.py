"""Every command is run by keys alone and by the mouse alone, in the real window."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import pytest
from correcting_window import CROWDED, open_for_correcting
from person import Person
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from run_with_parts import with_parts
from shifted_runs import swapped

from app.core.commands import Command
from app.core.document import document_loader
from app.core.keymap import keys_of
from app.features.keys.scene import SHIPPED, OwnKeys
from app.features.parts.controller import PartsController
from app.features.project import controller as project_controller
from app.features.scoring.controller import ScoreController
from app.shell import main_window
from app.shell.commands import COMMANDS
from app.shell.main_window import MainWindow
from tests.project.projects import ReaderHere, make_project
from tracking.editing import SchemaChange, plan_label_part, plan_new_track
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import Attribute, AttributeType, PartLabel, Run

NINE = Attribute("gate", AttributeType.CHOICE, tuple("abcdefghi"))
"""Digit keys set as many options."""


@dataclass
class Spy:
    """Notes which commands are run; runs them while `through`, else only opens the search.

    Attributes:
        ran: ids, in order.
    """

    through: bool = True
    ran: list[str] = field(default_factory=list)

    def watched(self, command: Command) -> Command:
        """The command, with its function watched."""

        def run(app: object) -> object:
            self.ran.append(command.id)
            if self.through or command.id == "edit.commands":
                return command.run(app)
            return None

        return replace(command, run=run)


@pytest.fixture
def spy(monkeypatch: pytest.MonkeyPatch) -> Spy:
    """Sees what the window runs; named before the window."""
    made = Spy()
    monkeypatch.setattr(main_window, "COMMANDS", tuple(map(made.watched, COMMANDS)))
    return made


@pytest.fixture(autouse=True)
def own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """What was read of recordings is kept among the files of the test, and read in this process."""
    place = tmp_path_factory.mktemp("cache")
    monkeypatch.setattr(project_controller, "user_cache_path", lambda *_, **__: place)
    monkeypatch.setattr(project_controller, "ReaderProcess", ReaderHere)


@pytest.fixture(scope="module")
def project_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two recordings; two people reviewed the first one, and one labelled a part of a body."""
    folder = make_project(tmp_path_factory.mktemp("walk") / "walks")
    (folder / "bo").mkdir()
    (folder / "bo" / "a.h5").write_bytes((folder / "a.h5").read_bytes())
    with closing(Session.open(folder / "a.h5")) as session:
        parts = session.corrected_run.parts
        frame, track = (int(parts[column][0]) for column in ("frame", "track"))
        label = PartLabel(frame, track, 0, (1.0, 1.0, 9.0, 9.0))
        session.apply(plan_label_part(session.labels, label))
        session.save()
    return folder


@pytest.fixture
def session_path(tiny_recording: Path, tiny_run: Run, tmp_path: Path) -> Path:
    """A session with two runs with body parts; two people are swapped in the corrected one."""
    path, run = tmp_path / "swapped.h5", with_parts(swapped(tiny_run)[0])
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [replace(tiny_run, seed=7), run], path)
        document_loader.remember_place(session, recording)
        session.close()
    return path


@pytest.fixture
def hand_made_path(tiny_recording: Path, tmp_path: Path) -> Path:
    """A session without runs, in which somebody drew one person."""
    path = tmp_path / "drawn.h5"
    with open_recording(tiny_recording) as recording:
        session = Session.create(recording, [], path)
        session.apply(plan_new_track(session.tracks, 10, (100.0, 60.0, 40.0, 90.0)))
        session.save()
        document_loader.remember_place(session, recording)
        session.close()
    return path


State = Callable[[Person], None]
"""Brings the window into a state in which commands are possible."""


@pytest.fixture
def pretended() -> Iterator[pytest.MonkeyPatch]:
    """Work that is pretended to go on, as what ends by itself is no state to walk in."""
    with pytest.MonkeyPatch.context() as patch:
        yield patch


@pytest.fixture
def states(
    project_folder: Path,
    session_path: Path,
    hand_made_path: Path,
    pretended: pytest.MonkeyPatch,
) -> dict[str, State]:
    """One after the other, in the same window."""
    return {
        "first page": lambda _: None,
        "project": lambda one: _open_project(one, project_folder),
        "recording of a project": _open_first,
        "batch at work": lambda one: _show_batch(one, pretended),
        "session": lambda one: _open_session(one, session_path),
        "digit keys set an attribute": lambda one: one.press("Shift+M"),
        "panel in use": _go_to_panel,
        "edit in preview": _move_a_box,
        "tracker at work": lambda one: _show_tracker(one, pretended),
        "drawn by hand": lambda one: _open_hand_made(one, hand_made_path, pretended),
    }


def _open_project(one: Person, folder: Path) -> None:
    projects = one.window.files.projects
    projects.open(folder)
    one.wait(lambda: projects.project.found is not None and not projects.project.found.wanted)
    one.wait(lambda: bool(projects.project.compared) and bool(projects.project.labelled))


def _open_first(one: Person) -> None:
    page = one.window.project_page
    page.table.choose("a")
    page.open_asked.emit(page.table.chosen()[0])
    one.wait(lambda: one.window.controller is not None)


def _show_batch(one: Person, pretended: pytest.MonkeyPatch) -> None:
    projects = one.window.files.projects
    pretended.setattr(type(projects), "is_batch_at_work", property(lambda _: True))


def _open_session(one: Person, path: Path) -> None:
    """A swap is looked at, a range was watched, an edit is undone, runs are compared."""
    window = one.window
    window.files.projects.close_project()
    window.files.close_without_asking()
    controller = open_for_correcting(window, one.qtbot, path)
    one.wait(lambda: bool(controller.reviewing.queue.items) and not controller.reviewing.busy)
    one.press("Shift+S")
    one.wait(lambda: controller.of(ScoreController).known)
    track = controller.document.tracks.of_frame(CROWDED)["track"].tolist()[0]
    controller.editing.pick(track)
    controller.describing.change(SchemaChange((NINE,)))
    one.press("Ctrl+C", "H", "Return", "H", "Return", "Ctrl+Z")
    window.files.detectors.result = SimpleNamespace()  # only whether there is one is asked
    controller.of(PartsController).presenter.truth_known = True
    _compare_runs(one)
    for _ in controller.reviewing.queue.items:
        controller.reviewing.walk(1)
        if controller.reviewing.fixable:
            break
    controller.editing.pick(track)
    controller.playback.step(1)
    controller.playback.step(1)
    one.wait(lambda: controller.reviewing.watching.stretch[1] > 0)


def _compare_runs(one: Person) -> None:
    one.controller.comparing.open(0, 1)
    one.wait(lambda: one.controller.comparing.shown)
    one.window.files.beside.divide(0.5)


def _go_to_panel(one: Person) -> None:
    one.press("Shift+M")  # the digit keys are commands again
    docks = one.window.workspace.docks
    while not docks.with_keyboard(QApplication.focusWidget()):
        one.press("F6")


def _move_a_box(one: Person) -> None:
    one.window.workspace.left.setFocus()
    one.press("V")
    one.wait(lambda: one.controller.document.flow is not None)


def _show_tracker(one: Person, pretended: pytest.MonkeyPatch) -> None:
    one.press("Esc")
    pretended.setattr(type(one.controller.live), "running", property(lambda _: True))


def _open_hand_made(one: Person, path: Path, pretended: pytest.MonkeyPatch) -> None:
    pretended.undo()
    one.window.files.close_without_asking()
    open_for_correcting(one.window, one.qtbot, path, 10)


@dataclass(frozen=True, slots=True)
class Walk:
    """Goes through the states and notes what could not be done.

    Attributes:
        wrong: in words.
    """

    one: Person
    spy: Spy
    states: dict[str, State]
    wrong: list[str] = field(default_factory=list)

    def __iter__(self) -> Iterator[list[str]]:
        """The commands that become possible, state by state; at the end those that never did."""
        done: set[str] = set()
        for begin in self.states.values():
            self.spy.through = True
            begin(self.one)
            self.spy.through = False
            self.one.look()
            self.one.window.bring_up_to_date()
            items = self.one.window.registry.items()
            new = [item.command for item in items if item.enabled and item.command not in done]
            yield new
            done.update(new)
        never = [item for item in items if item.command not in done]
        self.wrong.extend(f"{one.command} is possible in no state: {one.why_not}" for one in never)

    def run(self, command: str, how: str, way: Callable[[], None]) -> None:
        """Run a command in some way, and see that it was this one alone."""
        self.spy.ran.clear()
        try:
            way()
        except AssertionError as error:
            self.wrong.append(f"{command}, {how}: {error}".splitlines()[0])
        if set(self.spy.ran) - {"edit.commands"} != {command} - {"edit.commands"}:
            self.wrong.append(f"{command}, {how}: was run {self.spy.ran}")
        if QApplication.activePopupWidget() is not None:
            self.one.leave_popups()


@pytest.fixture
def walk(spy: Spy, window: MainWindow, qtbot: QtBot, states: dict[str, State]) -> Walk:
    with qtbot.waitActive(window):
        window.activateWindow()
    return Walk(Person(window, qtbot), spy, states)


def test_every_command_is_run_from_the_menus_with_the_mouse_alone(walk: Walk) -> None:
    for commands in walk:
        for name in commands:
            walk.run(name, "menu", partial(walk.one.choose, name))
    assert not walk.wrong, "\n".join(walk.wrong)


def test_every_command_is_found_and_run_with_the_keyboard_alone(walk: Walk) -> None:
    for commands in walk:
        for name in commands:
            walk.run(name, "search", partial(walk.one.search, name))
    assert not walk.wrong, "\n".join(walk.wrong)


def test_every_key_that_is_shown_runs_its_command_in_every_profile(walk: Walk) -> None:
    for commands in walk:
        for profile in SHIPPED:
            walk.one.window.key_choice.use(OwnKeys(profile))
            for name in commands:
                for key in keys_of(name):
                    walk.run(name, f"{key} of {profile or 'ours'}", partial(walk.one.press, key))
        walk.one.window.key_choice.use(OwnKeys())
    assert not walk.wrong, "\n".join(walk.wrong)
