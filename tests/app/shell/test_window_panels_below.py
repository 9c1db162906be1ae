"""Panels below the floor: one is shown at a time, however many are open."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from PySide6.QtWidgets import QAbstractButton, QLineEdit, QTabBar

from app.core.look.icons import IconButton
from app.features.counting.panel import CountingPanel
from app.features.parts.panel import CurvesPanel
from app.shell.below_floor import BelowFloor
from app.shell.features import FEATURES
from app.shell.panel_docks import Dock


def _tabs(window):
    bar = window.workspace.findChild(BelowFloor, "below floor").findChild(QTabBar)
    return [bar.tabText(at) for at in range(bar.count())] if bar.isVisible() else []


def test_the_panel_opened_last_is_shown_and_the_other_is_a_tab_away(window, controller):
    view = window.workspace
    window.run_command("view.counting")
    assert _tabs(window) == []
    room = view.overhead.height()
    window.run_command("view.curves")
    assert _tabs(window) == ["Counting", "Parts over time"]
    assert (view.of(CountingPanel).isVisible(), view.of(CurvesPanel).isVisible()) == (False, True)
    assert view.overhead.height() > 0.8 * room
    view.findChild(BelowFloor, "below floor").findChild(QTabBar).setCurrentIndex(0)
    assert (view.of(CountingPanel).isVisible(), view.of(CurvesPanel).isVisible()) == (True, False)


def test_the_queue_below_the_floor_has_its_buttons_in_sight_and_no_scroll_bar_across(
    window, controller, qtbot
):
    window.resize(1280, 800)
    qtbot.waitUntil(lambda: bool(controller.reviewing.queue.items))
    docks = window.workspace.docks
    docks.move("review", Dock.BELOW)
    controller.reviewing.walk(1)
    panel = docks.panels["review"]
    page = panel.parent().parent()
    qtbot.waitUntil(lambda: not page.horizontalScrollBar().isVisible())
    assert panel._tools
    qtbot.waitUntil(
        lambda: all(tool.visibleRegion().boundingRect() == tool.rect() for tool in panel._tools)
    )


def test_closing_a_panel_shows_the_one_that_is_left_and_then_none(window, controller):
    view = window.workspace
    for name in ("counting", "curves", "curves"):
        window.run_command(f"view.{name}")
    assert view.of(CountingPanel).isVisible()
    assert _tabs(window) == []
    window.run_command("view.counting")
    assert not view.findChild(BelowFloor, "below floor").isVisible()


@pytest.mark.parametrize("feature", [one for one in FEATURES if one.opens], ids=lambda one: one.id)
def test_the_panel_of_every_feature_opens_by_command_has_names_and_closes_by_its_button(
    window, controller, feature
):
    panel = window.workspace.panels[feature.id]
    assert panel.isHidden()
    window.run_command(f"view.{feature.id}")
    assert panel.isVisible()
    controls = panel.findChildren(QLineEdit) + panel.findChildren(QAbstractButton)
    ours = [one for one in controls if not one.objectName().startswith("qt_")]
    assert [one for one in ours if not (one.accessibleName() or one.text())] == []
    next(
        one for one in panel.findChildren(IconButton) if one.accessibleName()[:4] == "Hide"
    ).click()
    assert panel.isHidden()


def test_labelling_and_a_comparison_share_one_place_and_neither_squeezes_the_other(
    window, controller, qtbot, tiny_session, tmp_path
):
    view = window.workspace
    bar = view.findChild(BelowFloor, "labelling and comparison").findChild(QTabBar)
    window.resize(1000, 640)
    window.run_command("labels.parts")
    qtbot.wait(1)
    alone = view.labelling.height()
    assert view.labelling.isVisible()
    assert not bar.isVisible()
    window.files.beside.compare_with(Path(shutil.copy(tiny_session, tmp_path / "other.h5")))
    qtbot.waitUntil(view.compare.isVisible)
    assert not view.labelling.isVisible()
    assert bar.count() == 2
    bar.setCurrentIndex(0)
    qtbot.wait(1)
    assert view.labelling.isVisible()
    assert not view.compare.isVisible()
    assert view.labelling.height() >= alone - 2 * bar.height()
