"""Truth beside the result in the real window."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from correcting_window import open_for_correcting
from PySide6.QtCore import Qt

from app.features.history.panel import HistoryPanel
from app.features.scoring.controller import ScoreController
from app.features.scoring.panel import ScorePanel
from tracking.editing import plan_delete, plan_swap
from tracking.scoring import ErrorKind

Key, SHIFT = Qt.Key, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


@pytest.fixture
def scored(window, controller, press, qtbot):
    """The recording's controller once its score is shown."""
    press(Key.Key_S, SHIFT)
    at_rest(controller, qtbot)
    return controller


def at_rest(controller, qtbot) -> None:
    scoring = controller.of(ScoreController)
    qtbot.waitUntil(lambda: not scoring._search.busy and scoring.known)
    qtbot.wait(5)


def test_a_key_shows_score_truth_and_errors_and_takes_them_away(window, scored, press):
    view = window.workspace
    assert view.of(ScorePanel).isVisible()
    assert view.of(ScorePanel).table.item(0, 0).text() == "HOTA"
    assert view.timeline.errors.isVisible()
    assert view.left._truth.people
    assert view.overhead._truth.people
    press(Key.Key_S, SHIFT)
    assert not view.of(ScorePanel).isVisible()
    assert not view.timeline.errors.isVisible()
    assert not view.left._truth.people
    press(Key.Key_G, SHIFT)
    assert view.left._truth.people
    assert not view.of(ScorePanel).isVisible()


def test_keys_go_from_error_to_error(window, scored, press, qtbot):
    scored.playback.go(0)
    events = scored.of(ScoreController).presenter.events
    first = events.next_start(0, 1)
    press(Key.Key_F4)
    assert scored.playback.clock.frame == first
    assert window.statusBar().currentMessage() == "; ".join(events.beginning_at(first).words())
    second = events.next_start(first, 1)
    press(Key.Key_F4)
    press(Key.Key_F4, SHIFT)
    assert second != first
    assert scored.playback.clock.frame == first


def test_an_edit_is_scored_at_once_and_told_in_the_history(window, scored, press, qtbot):
    document = scored.document
    before = scored.of(ScoreController).presenter.scored
    longest = max(document.tracks.ids, key=lambda one: len(document.tracks.of_track(one)["frame"]))
    document.apply(plan_delete(document.session.tracks, longest))
    scored.draw()
    qtbot.waitUntil(lambda: scored.of(ScoreController).presenter.scored is not before)
    at_rest(scored, qtbot)
    assert window.workspace.of(ScorePanel).table.item(0, 3).text().startswith("\u25bc")
    (told,) = [item for item in window.workspace.of(HistoryPanel)._model._items if item.moved]
    assert told.moved.startswith("HOTA \u25bc")


def test_a_report_is_written_into_a_folder_of_its_own(window, scored, qtbot, tmp_path):
    place = tmp_path / "reports"
    place.mkdir()
    window.files.exporting.report_in(place)
    qtbot.waitUntil(lambda: not window.work.busy)
    (folder,) = place.iterdir()
    told = json.loads((folder / "report.json").read_text())
    mota = scored.of(ScoreController).presenter.scored.whole.clear.mota
    assert f'"MOTA": {mota}' in json.dumps(told)
    assert "Corrected tracks" in (folder / "report.html").read_text()
    assert str(folder / "report.html") in window.notice.text
    assert window.notice.action_text == "Open"


def test_a_report_can_be_had_before_anything_was_scored(window, controller, qtbot, tmp_path):
    assert controller.of(ScoreController).presenter.scored is None
    assert window.menus.actions["file.export_report"].isEnabled()
    window.files.exporting.report_in(tmp_path)
    qtbot.waitUntil(lambda: bool([*tmp_path.glob("*/report.html")]))
    qtbot.waitUntil(lambda: not window.work.busy)


def test_a_run_that_cannot_be_scored_is_left_out_of_the_report_and_it_is_said_why(
    window, scored, qtbot, tiny_run, tmp_path
):
    boxless = {**tiny_run.tracks, "left": np.full_like(tiny_run.tracks["left"], np.nan)}
    session = scored.document.session
    session.add_run(replace(tiny_run, tracks=boxless, tracker="no-boxes"), adopt=False)
    session.add_run(replace(tiny_run, frames=(0, 79), tracker="shorter"), adopt=False)
    window.files.exporting.report_in(tmp_path)
    qtbot.waitUntil(lambda: bool(window.notice.text))
    (page,) = tmp_path.glob("*/report.html")
    assert "Corrected tracks" in page.read_text()
    assert "no-boxes" not in page.read_text()
    said = window.notice.text.splitlines()
    assert said[1:] == [
        "Not in the report: Run 2: shorter (it covers other frames).",
        "Not in the report: Run 1: no-boxes (the result has no boxes).",
    ]


def test_what_is_chosen_otherwise_is_scored_anew(window, scored, qtbot, tmp_path):
    presenter, view = scored.of(ScoreController).presenter, window.workspace
    view.timeline.area.stretch.zoom(8.0)
    first, end = presenter.visible
    qtbot.waitUntil(lambda: presenter.scored.subject.visible == (first, end))
    assert presenter.scored.visible.frames == end - first < 40
    view.of(ScorePanel).floor_chosen.emit(True)
    qtbot.waitUntil(lambda: presenter.scored.subject.matching.on_floor)
    view.of(ScorePanel)._kinds[ErrorKind.MISS].click()
    qtbot.wait(5)
    assert ErrorKind.MISS not in [lane.kind for lane in view.timeline.errors._scene.lanes]
    noise = tmp_path / "noise.txt"
    noise.write_bytes(bytes(range(256)))
    scored.of(ScoreController).choose_file(noise)
    qtbot.waitUntil(lambda: "noise.txt" in view.of(ScorePanel)._message.text())
    assert not view.timeline.errors.isVisible()


def test_an_empty_truth_opens_the_score_with_everything_a_false_alarm(
    window, scored, qtbot, tmp_path
):
    truth, view = tmp_path / "nobody.txt", window.workspace
    truth.write_text("")
    scored.of(ScoreController).choose_file(truth)
    qtbot.waitUntil(
        lambda: "everybody tracked counts as a false alarm" in view.of(ScorePanel)._notes.text()
    )
    assert not view.of(ScorePanel)._message.text()
    assert view.of(ScorePanel).table.isVisible()
    lanes = {lane.kind: lane.count for lane in view.timeline.errors._scene.lanes}
    assert lanes[ErrorKind.FALSE_ALARM] == sum(lanes.values()) > 0


def test_the_track_panel_tells_of_whom_an_error_is_about(window, scored, press, qtbot):
    tracks = scored.document.session.tracks
    one, other = tracks.of_frame(60)["track"].tolist()[:2]
    scored.document.apply(plan_swap(tracks, one, other, 60))
    at_rest(scored, qtbot)
    scored.playback.go(0)
    card = window.workspace.card
    assert card._empty.isVisible()
    for _ in range(20):  # until an error is about somebody of the result
        press(Key.Key_F4)
        if scored.document.selection:
            break
    assert not card._empty.isVisible()
    assert card._id.text() == str(scored.document.selection.track)
