"""F6 leads to every part of the window, Tab to every control in it, Esc back to the image."""

from __future__ import annotations

from pathlib import Path

import pytest
from accessible import acted_on, control_with_keyboard, named
from person import Person
from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication, QStatusBar, QWidget
from pytestqt.qtbot import QtBot

from app.core.drawing.canvas import Canvas
from app.features.history.panel import HistoryPanel
from app.features.scoring.controller import ScoreController
from app.shell.features import FEATURES
from app.shell.main_window import MainWindow
from app.shell.panel_docks import Dock

_PANELS = [f"view.{feature.id}" for feature in FEATURES if feature.opens]
_TOOLS = ["labels.parts", "labels.occluders", "labels.lines", "labels.regions", "labels.reviewed"]
_MOST = 80


@pytest.fixture
def one(window: MainWindow, qtbot: QtBot, parted_session: Path) -> Person:
    window.resize(1280, 800)
    with qtbot.waitActive(window):
        window.activateWindow()
    window.files.open_path(parted_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    controller = window.controller
    assert controller is not None
    controller.editing.pick(controller.document.tracks.ids[0])
    controller.editing.rename(controller.document.tracks.ids[0], "Anna")
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    return Person(window, qtbot)


def _settle(one: Person) -> None:
    one.qtbot.wait(40)
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def _walk(one: Person) -> set[QWidget]:
    """All that has the keyboard on a walk through all parts, by F6 and Tab alone."""
    _settle(one)
    one.window.activateWindow()
    one.wait(one.window.isActiveWindow)
    one.window.workspace.left.setFocus()
    met: set[QWidget] = set()
    for _ in range(_MOST):
        one.press("F6")
        pane = one.window.workspace._ring.pane
        if pane is one.window.workspace.left:
            return met | {pane, _now()}
        assert pane is not None
        met |= _walk_inside(one, pane)
    raise AssertionError("F6 does not come back to the left image")


def _walk_inside(one: Person, pane: QWidget) -> set[QWidget]:
    met = {_now()}
    if isinstance(pane, Canvas):  # there Tab selects people
        return met
    inside = [widget for widget in acted_on(pane.window()) if pane.isAncestorOf(widget)]
    for _ in range(len(inside) + 3 if inside else 0):
        one.press("Tab")
        assert pane is _now() or pane.isAncestorOf(_now()), f"Tab leads out to {named(_now())}"
        met.add(control_with_keyboard(_now()))
    return met


def _now() -> QWidget:
    now = QApplication.focusWidget()
    assert now is not None
    return now


def _missed(one: Person, met: set[QWidget]) -> list[str]:
    """Controls of the workspace, and of windows that panels stand in, that were not come to."""
    space = one.window.workspace
    windows = {one.window, *(panel.window() for panel in space.docks.panels.values())}
    wanted = [widget for window in windows for widget in acted_on(window)]
    inside = [one for one in wanted if not _has_other_keys(space, one)]
    met = met | {around for widget in met if isinstance(around := widget.parentWidget(), Canvas)}
    return [named(widget) for widget in inside if widget not in met]


def _has_other_keys(space: QWidget, widget: QWidget) -> bool:
    """Menu bar and search have Alt and Ctrl+K, the status bar Ctrl+J; F6 brings tabs forward."""
    below = widget.window() is space.window() and not space.isAncestorOf(widget)
    bar = widget.parentWidget()
    while bar is not None and not isinstance(bar, QStatusBar):
        bar = bar.parentWidget()
    notice = getattr(space, "messages", ())
    in_notice = any(part.isAncestorOf(widget) for part in notice)
    tabs = type(widget).__name__ == "QTabBar"
    return (below and not in_notice) or bar is not None or tabs


@pytest.mark.parametrize("command", ["", "tracks.swap", "tracks.delete_range", *_TOOLS, *_PANELS])
def test_every_control_is_reached_by_keys(one: Person, command: str) -> None:
    if command:
        one.window.run_command(command)
    if command == "view.score":
        one.wait(lambda: one.controller.of(ScoreController).known)
    met = _walk(one)
    assert "\n".join(_missed(one, met)) == ""


def test_panels_behind_each_other_and_in_windows_of_their_own_are_reached(one: Person) -> None:
    for name in ("view.score", "view.counting"):
        one.window.run_command(name)
    one.window.workspace.docks.move("history", Dock.WINDOW)
    space = one.window.workspace
    assert space.panels["score"].isVisible() is not space.panels["counting"].isVisible()
    met = _walk(one)
    for panel in (space.panels["score"], space.panels["counting"], space.of(HistoryPanel)):
        inside = [widget for widget in met if panel is widget or panel.isAncestorOf(widget)]
        assert inside, panel.accessibleName()
    assert one.window.isActiveWindow()


def test_a_message_is_reached_and_its_button_pressed(one: Person) -> None:
    done = []
    one.window.notice.say("Something is to be decided", "Do it", lambda: done.append(1))
    one.press("Shift+F6")
    assert one.window.workspace._ring.pane is one.window.notice
    one.press("Tab")
    assert named(_now()).startswith("QPushButton 'Do it'")
    one.press("Space")
    assert done == [1]
    assert one.window.notice.isHidden()
    assert _now() is one.window.workspace.left


def test_space_presses_a_button_only_where_one_has_gone_to_it_by_keys(one: Person) -> None:
    history = one.window.workspace.of(HistoryPanel)
    session = one.controller.document.session
    assert session is not None
    assert len(session.history) == 1
    _go_to(one, history)
    while _now() is not history._undo:
        one.press("Tab")
    one.press("Space")
    assert session.history.next_undo is None
    assert not _plays(one)
    assert history.isAncestorOf(_now()) or _now() is history  # greyed, and the walk goes on
    one.press("Tab")
    assert history.isAncestorOf(_now())
    one.press("Esc")
    assert _now() is one.window.workspace.left
    one.press("Space")
    assert _plays(one)
    one.press("Space")


def test_a_row_of_the_queue_is_chosen_by_arrow_keys_and_enter(one: Person) -> None:
    queue = one.controller.reviewing.queue
    if len(queue.items) < 2:
        pytest.skip("fewer than two review items")
    _go_to(one, one.window.workspace.review)
    one.press("Down", "Down", "Return")
    shown = one.window.workspace.review._scene
    assert shown.current == one.window.workspace.review._list.currentIndex().row() >= 0


def test_esc_leaves_a_panel_and_only_then_the_selection(one: Person) -> None:
    selected = one.controller.document.selection.track
    _go_to(one, one.window.workspace.card)
    one.press("Tab", "Esc")
    assert _now() is one.window.workspace.left
    assert one.controller.document.selection.track == selected
    one.press("Esc")
    assert not one.controller.document.selection.track


def test_tab_selects_people_where_a_part_was_come_to_with_the_mouse(one: Person) -> None:
    selected = one.controller.document.selection.track
    history = one.window.workspace.of(HistoryPanel)
    one.click(history._list.viewport())
    one.press("Tab")
    assert one.controller.document.selection.track != selected


def _plays(one: Person) -> bool:
    return one.controller.playback.clock.playing


def _go_to(one: Person, pane: QWidget) -> None:
    one.window.workspace.left.setFocus()
    for _ in range(_MOST):
        one.press("F6")
        if one.window.workspace._ring.pane is pane:
            return
    raise AssertionError("not reached")
