"""Panels close, move, stand in windows of their own, and come back; layouts for a trade."""

import itertools

import pytest
from PySide6.QtWidgets import QAbstractButton, QApplication

from app.core.look.icons import IconButton
from app.features.history.panel import HistoryPanel
from app.features.scoring.controller import ScoreController
from app.shell.layout_commands import LAYOUTS
from app.shell.layout_shares import screen_key
from app.shell.panel_docks import Dock, PanelWindow


def _checked(window, command):
    return window.registry.item(command).checked


@pytest.mark.parametrize("name", ["review", "card", "history"])
def test_a_panel_closes_and_comes_back(window, controller, name):
    panel = window.workspace.docks.panels[name]
    assert panel.isVisible()
    window.run_command(f"view.panel_{name}")
    assert not panel.isVisible()
    assert not _checked(window, f"view.panel_{name}")
    window.run_command(f"view.panel_{name}")
    assert panel.isVisible()


@pytest.mark.parametrize("name", ["history", "counting"])
def test_the_menu_at_a_panels_head_moves_and_closes_it(window, controller, name):
    docks = window.workspace.docks
    if not docks.is_open(name):
        window.run_command(f"view.{name}")
    button = next(
        one for one in docks.panels[name].findChildren(IconButton) if one.menu() is not None
    )
    button.menu().aboutToShow.emit()
    actions = {action.text(): action for action in button.menu().actions()}
    actions["In a window of its own"].trigger()
    assert docks.stands(name) is Dock.WINDOW
    actions["Close"].trigger()
    assert not docks.is_open(name)


def test_without_any_panel_the_images_and_the_floor_have_the_room(window, controller, qtbot):
    space = window.workspace
    for name in ("review", "card", "history"):
        window.run_command(f"view.panel_{name}")
    qtbot.waitUntil(lambda: not space._side.isVisible())
    controller.editing.pick(controller.document.tracks.ids[0])
    window.run_command("tracks.end_here")
    assert space.preview.isVisible()
    window.run_command("tracks.none")
    assert not space._side.isVisible()


def test_a_panel_stands_in_a_window_of_its_own_and_goes_back_when_that_is_closed(
    window, controller, qtbot
):
    docks, panel = window.workspace.docks, window.workspace.of(HistoryPanel)
    docks.move("history", Dock.WINDOW)
    own = panel.window()
    assert isinstance(own, PanelWindow)
    assert own.isVisible()
    assert own.windowTitle() == "History"
    window.run_command("view.panel_history")
    assert not own.isVisible()
    window.run_command("view.panel_history")
    own.close()
    assert panel.window() is window
    assert docks.stands("history") is Dock.SIDE
    assert panel.isVisible()


def test_a_panel_moves_below_the_floor_and_one_from_there_to_the_right(window, controller):
    docks, space = window.workspace.docks, window.workspace
    docks.move("history", Dock.BELOW)
    assert space.of(HistoryPanel).isVisible()
    window.run_command("view.counting")
    docks.move("counting", Dock.SIDE)
    assert docks.panels["counting"].isVisible()
    assert space.of(HistoryPanel).isVisible()
    window.run_command("view.counting")
    assert not docks.panels["counting"].isVisible()


def test_the_panel_with_the_keyboard_moves_by_commands_alone(window, controller, qtbot):
    docks, panel = window.workspace.docks, window.workspace.of(HistoryPanel)
    assert "go to a panel first (F6)" in window.registry.item("view.panel_window").why_not
    window.activateWindow()
    for _ in range(12):
        window.run_command("view.next_pane")
        if docks.with_keyboard(QApplication.focusWidget()) == "history":
            break
    window.run_command("view.panel_below")
    assert docks.stands("history") is Dock.BELOW
    assert panel.isVisible()


@pytest.mark.parametrize("layout", LAYOUTS, ids=lambda one: one.id)
def test_a_layout_opens_what_its_trade_needs_and_reset_brings_all_back(
    window, controller, qtbot, layout
):
    docks = window.workspace.docks
    docks.move("review", Dock.WINDOW)
    window.run_command(f"view.layout_{layout.id}")
    if "score" in layout.panels:
        qtbot.waitUntil(lambda: window.controller.of(ScoreController).known)
    open_now = {name for name in docks.panels if docks.is_open(name)}
    assert open_now == layout.panels
    assert window.workspace.overhead.isVisible() == layout.overhead
    window.run_command("view.layout_reset")
    assert {name for name in docks.panels if docks.is_open(name)} == {"review", "card", "history"}
    assert docks.stands("review") is Dock.SIDE
    assert window.workspace.overhead.isVisible()


def test_places_and_shares_are_kept_for_a_screen(window, controller, remembered):
    space = window.workspace
    space.docks.move("history", Dock.BELOW)
    window.run_command("view.panel_card")
    window.run_command("view.panel_overhead")
    whole = space._shares.splitters["whole"]
    whole.setSizes([500, 300])
    share = whole.sizes()[1] / sum(whole.sizes())
    space.remember(remembered)
    window.run_command("view.layout_reset")
    space.restore(remembered)
    assert space.docks.stands("history") is Dock.BELOW
    assert not space.docks.is_open("card")
    assert not space.overhead.isVisible()
    assert whole.sizes()[1] / sum(whole.sizes()) == pytest.approx(share, abs=0.02)
    key = f"shares/{screen_key(window.screen())}/whole"
    assert remembered.text(key)
    remembered.set_text(key, "nan 7 -1")
    space.restore(remembered)
    assert whole.sizes()[1] / sum(whole.sizes()) == pytest.approx(share, abs=0.02)


SIZES = ((1000, 640), (3840, 2160), (1280, 800), (1920, 1080), (1000, 640))


@pytest.mark.parametrize("layout", LAYOUTS, ids=lambda one: one.id)
def test_nothing_is_cut_off_at_any_size_in_any_order(window, controller, qtbot, layout):
    controller.editing.pick(controller.document.tracks.ids[0])
    window.run_command(f"view.layout_{layout.id}")
    for size, panel in itertools.product(SIZES, ("counting", "curves")):
        window.resize(*size)
        window.run_command(f"view.{panel}")
        qtbot.waitUntil(lambda size=size: window.width() == size[0] and not _cut_off(window))
        assert window.height() == size[1]
        window.run_command(f"view.{panel}")


@pytest.mark.parametrize("layout", LAYOUTS, ids=lambda one: one.id)
def test_the_images_have_half_in_every_layout(window, controller, qtbot, layout):
    """A panel below the floor that needs the room takes an eighth of it at most."""
    window.run_command(f"view.layout_{layout.id}")
    for size in SIZES:
        window.resize(*size)
        top = window.workspace._shares.splitters["top"]
        least = 0.369 if "score" in layout.panels else 0.499
        qtbot.waitUntil(lambda top=top, least=least: top.sizes()[0] >= least * sum(top.sizes()))


def _cut_off(window):
    """Buttons of open panels that end outside of their panel or of the window."""
    outside = []
    for panel in window.workspace.docks.panels.values():
        for button in panel.findChildren(QAbstractButton):
            if not button.isVisible() or button.visibleRegion().isEmpty():
                continue
            right = button.mapTo(window, button.rect().topRight()).x()
            if right >= window.width() or button.width() < min(
                button.minimumSizeHint().width(), button.maximumWidth()
            ):
                outside.append(button)
    return outside


def test_a_closed_part_keeps_the_share_it_had(window, controller, remembered, qtbot):
    space = window.workspace
    shared = space._shares.splitters["floor and panels"]
    key = f"shares/{screen_key(window.screen())}/floor and panels"
    window.run_command("view.counting")
    qtbot.waitUntil(lambda: shared.sizes()[1] > 0)
    space.remember(remembered)
    share = float(remembered.text(key).split()[1])
    window.run_command("view.counting")
    qtbot.waitUntil(lambda: shared.sizes()[1] == 0)
    space.remember(remembered)
    assert float(remembered.text(key).split()[1]) == share > 0


def test_a_window_of_a_panel_waits_for_the_window_it_belongs_to(window, controller):
    """Shown before that it would lie behind it."""
    docks = window.workspace.docks
    docks.move("history", Dock.WINDOW)
    own = docks.panels["history"].window()
    assert own.isVisible()
    window.workspace.hide()
    assert not own.isVisible()
    docks.set_open("history", False)
    docks.set_open("history", True)
    assert not own.isVisible()
    window.workspace.show()
    assert own.isVisible()
