"""Truth beside the result in the real window."""

from __future__ import annotations

import json

import pytest
from correcting_desk import opened_desk
from PySide6.QtCore import Qt

from tracking.editing import plan_delete
from tracking.scoring import ErrorKind

Key, SHIFT = Qt.Key, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def desk(window, qtbot, tiny_session):
    return opened_desk(window, qtbot, tiny_session)


@pytest.fixture
def scored(window, desk, press, qtbot):
    """The desk once its score is shown."""
    press(Key.Key_S, SHIFT)
    at_rest(desk, qtbot)
    return desk


def at_rest(desk, qtbot) -> None:
    scoring = desk.scoring
    qtbot.waitUntil(lambda: not scoring._search.busy and scoring.known, timeout=20_000)
    qtbot.wait(5)


def test_a_key_shows_score_truth_and_errors_and_takes_them_away(window, scored, press):
    view = window.workspace
    assert view.score.isVisible()
    assert view.score.table.item(0, 0).text() == "HOTA"
    assert view.timeline.errors.isVisible()
    assert view.left._truth.people
    assert view.overhead._truth.people
    press(Key.Key_S, SHIFT)
    assert not view.score.isVisible()
    assert not view.timeline.errors.isVisible()
    assert not view.left._truth.people


def test_the_truth_can_be_drawn_without_the_panel(window, desk, press, qtbot):
    press(Key.Key_G, SHIFT)
    at_rest(desk, qtbot)
    assert window.workspace.left._truth.people
    assert not window.workspace.score.isVisible()


def test_without_tracks_it_is_said_what_to_do(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.desk is not None)
    window.run_command("view.truth")
    assert "Track the recording first" in window.statusBar().currentMessage()


def test_keys_go_from_error_to_error(window, scored, press, qtbot):
    scored.playback.go(0)
    events = scored.scoring.presenter.events
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
    before = scored.scoring.presenter.scored
    longest = max(document.tracks.ids, key=lambda one: len(document.tracks.of_track(one)["frame"]))
    document.apply(plan_delete(document.session.tracks, longest))
    scored.draw()
    qtbot.waitUntil(lambda: scored.scoring.presenter.scored is not before, timeout=20_000)
    at_rest(scored, qtbot)
    assert window.workspace.score.table.item(0, 3).text().startswith("\u25bc")
    assert document.history()[-1].moved == ""
    (told,) = [item for item in window.workspace.history._model._items if item.moved]
    assert told.moved.startswith("HOTA \u25bc")


def test_other_frames_on_the_timeline_are_scored(window, scored, qtbot):
    scored.window_page.timeline.area.stretch.zoom(8.0)
    first, end = scored.scoring.presenter.visible
    assert end - first < 40
    qtbot.waitUntil(lambda: scored.scoring.presenter.scored.subject.visible == (first, end))
    assert scored.scoring.presenter.scored.visible.frames == end - first


def test_a_file_without_tracks_is_told_in_the_panel(window, scored, tmp_path, qtbot):
    noise = tmp_path / "noise.txt"
    noise.write_bytes(bytes(range(256)))
    scored.scoring.choose_file(noise)
    qtbot.waitUntil(lambda: not scored.scoring.known, timeout=20_000)
    qtbot.wait(100)
    assert "noise.txt" in window.workspace.score._message.text()
    assert not window.workspace.timeline.errors.isVisible()


def test_pairing_by_places_scores_anew(window, scored, qtbot):
    before = scored.scoring.presenter.scored
    window.workspace.score.floor_chosen.emit(True)
    qtbot.waitUntil(lambda: scored.scoring.presenter.scored is not before, timeout=20_000)
    assert scored.scoring.presenter.scored.subject.matching.on_floor
    window.workspace.score._kinds[ErrorKind.MISS].click()
    qtbot.wait(5)
    lanes = window.workspace.timeline.errors._scene.lanes
    assert ErrorKind.MISS not in [lane.kind for lane in lanes]


def test_a_report_is_written_into_a_folder_of_its_own(window, scored, qtbot, tmp_path):
    place = tmp_path / "reports"
    place.mkdir()
    window.files.exporting.report_in(place)
    qtbot.waitUntil(lambda: not window.work.busy, timeout=30_000)
    (folder,) = place.iterdir()
    told = json.loads((folder / "report.json").read_text())
    mota = scored.scoring.presenter.scored.whole.clear.mota
    assert f'"MOTA": {mota}' in json.dumps(told)
    assert "Corrected tracks" in (folder / "report.html").read_text()
    assert str(folder / "report.html") in window.statusBar().currentMessage()
