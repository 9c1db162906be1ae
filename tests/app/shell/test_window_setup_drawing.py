"""Occluders and counting lines drawn in the set-up, and the session that keeps them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot
from setup_fixtures import Begin

from app.features.setup.drafts import Drafts
from app.features.setup.scene import Step
from app.shell.main_window import MainWindow
from tests.benchmarks.setup.user import SetupUser

PILLAR = ((40.0, 60.0), (80.0, 60.0), (80.0, 160.0), (40.0, 160.0))
LINE = ((60.0, 200.0), (260.0, 200.0))


@pytest.fixture
def draw(begin: Begin, with_calibration: Path) -> Callable[[], SetupUser]:
    """Draws a pillar and a line."""

    def draw() -> SetupUser:
        user = begin(with_calibration)
        dialog = user.dialog
        dialog.go_to(Step.REGION)
        user.press(dialog.region.occluder)
        for corner in PILLAR:
            user.click_image(*corner)
        user.key(dialog.picture, Qt.Key.Key_Return)
        user.press(dialog.region.line)
        for end in LINE:
            user.click_image(*end)
        return user

    return draw


def test_a_line_ends_with_its_second_click_and_is_listed_with_the_occluder(
    draw: Callable[[], SetupUser],
) -> None:
    user = draw()
    dialog = user.dialog
    state = dialog.editor.state
    assert [one.name for one in (*state.occluders, *state.lines)] == ["occluder 1", "line 1"]
    assert np.allclose(state.occluders[0].polygon, PILLAR, atol=1.0)
    assert np.allclose((state.lines[0].start, state.lines[0].end), LINE, atol=1.0)
    shown = dialog.region.list
    assert [shown.item(row).text() for row in range(shown.count())] == [
        "Occluder: occluder 1",
        "Counting line: line 1",
    ]
    forward = dialog.picture.picture.outlines[1].arrow
    assert forward[1, 1] > forward[0, 1]  # from left to right: the right-hand side is below
    assert "1 occluder, 1 counting line" in dialog.region.kept.text()
    assert dialog.steps.item(3).text().endswith("done")
    user.key(dialog.picture, Qt.Key.Key_Delete)  # a line without an end is none
    assert dialog.editor.state.lines == ()
    user.press(dialog.undo_button)
    assert len(dialog.editor.state.lines) == 1
    user.wait_for_rest()
    plan = dialog.plan
    assert plan is not None
    assert Drafts().find(plan) == dialog.editor.state


def test_a_line_is_drawn_by_keys_and_taken_by_a_click_at_it(begin: Begin, card: Path) -> None:
    user = begin(card)
    dialog = user.dialog
    dialog.go_to(Step.REGION)
    user.press(dialog.region.line)
    user.key(dialog.picture, Qt.Key.Key_Return)
    (line,) = dialog.editor.state.lines
    assert (line.start, line.end) == ((80.0, 120.0), (240.0, 120.0))
    user.click_image(20, 20)
    assert dialog.region.list.currentRow() == -1
    user.click_image(160, 122)
    assert dialog.region.list.currentRow() == 0


def test_what_is_drawn_is_kept_in_the_recordings_session_and_comes_back(
    draw: Callable[[], SetupUser], window: MainWindow, with_calibration: Path, qtbot: QtBot
) -> None:
    user = draw()
    dialog = user.dialog
    dialog.go_to(Step.FLOOR)
    user.type(dialog.floor.height_m, "2.4")
    user.type(dialog.floor.tilt_deg, "30")
    dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    user.press(dialog.write.write)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy, timeout=20_000)
    assert window.controller is not None
    session = window.controller.document.session
    assert session is not None
    assert np.allclose(session.labels.occluders[0].polygon, PILLAR, atol=1.0)
    (line,) = session.labels.lines
    assert not line.in_picture  # the floor is known
    assert line.start[0] < line.end[0]
    assert "line" not in (with_calibration / "recording.toml").read_text()
    assert window.remembered.recent[0] == with_calibration.resolve()
    window.menus.actions["file.setup_again"].trigger()
    user.wait_for_rest()
    (seen,) = user.dialog.editor.state.lines
    assert np.allclose((seen.start, seen.end), LINE, atol=1.5)
    assert user.dialog.editor.state.occluders == session.labels.occluders


def test_tracking_after_a_set_up_with_drawings_goes_into_their_session(
    draw: Callable[[], SetupUser], window: MainWindow, qtbot: QtBot
) -> None:
    user = draw()
    dialog = user.dialog
    dialog.go_to(Step.WRITE)
    user.wait_for_rest()
    user.press(dialog.write.write)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy, timeout=20_000)
    controller = window.controller
    assert controller is not None
    document = controller.document
    assert controller.tracking.state.status == "play to track"
    controller.toggle()
    qtbot.waitUntil(lambda: controller.live.running)
    assert not document.shows_further_run
    qtbot.waitUntil(lambda: not controller.live.running and not window.work.busy, timeout=60_000)
    assert document.session is not None
    assert document.session.adopted_run == 0
    assert len(document.tracks.ids)
    assert document.session.labels.lines
