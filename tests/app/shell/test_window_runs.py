"""The runs of a session: listed, scored, corrected, compared with each other."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from shifted_runs import boxes, items, place

from app.features.pictures.divider import halves
from app.features.runs.presenter import CORRECTED
from app.features.runs.runs_dialog import RunsDialog
from app.features.runs.track_dialog import TrackDialog
from app.shell.again import show_runs
from tracking.editing import plan_delete
from tracking.trackers import settings_values


@pytest.fixture
def controller(shifted_controller):
    return shifted_controller


def test_runs_are_listed_with_their_scores_and_compared(window, controller, qtbot, tiny_run):
    controller.document.session.add_run(replace(tiny_run, seed=7), adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    table = dialog._table
    assert [row.number for row in dialog._scene.rows] == [CORRECTED, 0, 1]
    assert table.item(1, 0).text() == "run 0, being corrected"
    dialog.choose(0)
    assert not dialog._compare.isEnabled()
    assert "nothing has been edited yet" in dialog._about.text()
    assert table.item(2, 2).text() == "seed 7"
    qtbot.waitUntil(lambda: bool(table.item(2, 6).text()))
    assert float(table.item(2, 6).text()) >= float(table.item(1, 6).text())
    dialog.choose(0, 1)
    dialog._compare.click()
    qtbot.waitUntil(lambda: bool(items(controller)))
    assert (controller.document.comparison.base, controller.document.comparison.run) == (0, 1)


def test_no_run_is_cut_off_and_the_truth_of_the_scores_is_named(
    window, controller, qtbot, tiny_run
):
    for seed in range(7, 11):
        controller.document.session.add_run(replace(tiny_run, seed=seed), adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    qtbot.waitUntil(dialog.windowHandle().isExposed)
    assert dialog._table.rowCount() == 6
    assert not dialog._table.verticalScrollBar().isVisible()
    last = dialog._table.visualItemRect(dialog._table.item(5, 0))
    assert dialog._table.viewport().rect().contains(last)
    assert "truth.txt beside the recording" in dialog._over.text()


def _late_part(run):
    late = run.tracks["frame"] >= 40
    rows = {name: column[late] for name, column in run.tracks.items()}
    return replace(run, tracks=rows, frames=(40, 80))


def _cells(dialog, title):
    table = dialog._table
    titles = [table.horizontalHeaderItem(one).text() for one in range(table.columnCount())]
    return [table.item(row, titles.index(title)).text() for row in range(table.rowCount())]


def test_people_are_those_of_the_frames_that_are_scored(window, controller, qtbot):
    session = controller.document.session
    early = replace(_late_part(session.runs[0]), frames=(0, 3))
    whole = session.runs[0].tracks
    inside = whole["frame"] < 3
    rows = {name: column[inside] for name, column in whole.items()}
    session.add_run(replace(early, tracks=rows), adopt=False)
    few, many = len(set(rows["track"].tolist())), len(set(whole["track"].tolist()))
    assert few < many
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    assert _cells(dialog, "People")[1] == ""  # not yet known
    qtbot.waitUntil(lambda: all(_cells(dialog, "IDF1")))
    assert _cells(dialog, "People") == [str(few)] * 3
    dialog._share.setChecked(False)
    qtbot.waitUntil(lambda: all(_cells(dialog, "IDF1")))
    assert _cells(dialog, "People")[1:] == [str(many), str(few)]
    dialog.reject()


def test_runs_have_the_figures_that_one_is_chosen_by(window, controller, qtbot):
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    qtbot.waitUntil(lambda: all(_cells(dialog, "IDF1")))
    for title in ("MOTA", "Kept", "Misses", "False alarms", "Position"):
        assert all(_cells(dialog, title)), title
    dialog.reject()


def test_runs_of_other_frames_are_scored_over_those_they_share(window, controller, qtbot):
    session = controller.document.session
    session.add_run(_late_part(session.runs[0]), adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    figures = lambda: [dialog._table.item(row, 6).text() for row in (1, 2)]  # noqa: E731
    qtbot.waitUntil(lambda: all(figures()))
    assert "40 \u2013 79" in dialog._share.text()
    assert figures()[0] == figures()[1]
    dialog._share.setChecked(False)
    assert "Do not compare rows" in dialog._over.text()
    qtbot.waitUntil(lambda: all(figures()))
    assert figures()[0] != figures()[1]
    dialog.reject()


def test_another_run_is_corrected_where_nobody_has_edited(
    window, controller, tiny_run, shifted_run
):
    wrong = place(controller, shifted_run[1], 65)
    controller.document.session.add_run(tiny_run, adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    dialog.choose(0)
    assert not dialog._correct.isEnabled()
    dialog.choose(1)
    dialog._correct.click()
    assert controller.document.session.adopted_run == 1
    assert place(controller, shifted_run[1], 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    assert not controller.comparing.shown


def test_no_run_is_corrected_while_a_tracker_is_at_work(window, controller, tiny_run):
    controller.document.session.add_run(tiny_run, adopt=False)
    controller.document.begin_live()
    show_runs(controller)
    dialog = window.findChild(RunsDialog)
    dialog.choose(1)
    assert not dialog._correct.isEnabled()
    assert "stop it first" in dialog._correct.toolTip()
    dialog.reject()
    errors = []
    controller.comparing.failed.connect(errors.append)
    controller.comparing.correct(1)
    assert "stop tracking first" in str(errors[0])
    assert controller.document.is_live
    assert controller.document.session.adopted_run == 0


def test_people_outside_of_the_frames_of_a_shorter_run_stay(
    window, controller, qtbot, tiny_run, shifted_run
):
    session, track = controller.document.session, shifted_run[1]
    wrong, rows = place(controller, track, 65), len(session.tracks.columns()["x"])
    session.add_run(_late_part(tiny_run), adopt=False)
    controller.comparing.correct(1)
    qtbot.waitUntil(lambda: bool(items(controller)))
    window.workspace.differences.taken.emit(1)
    assert place(controller, track, 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    assert len(session.tracks.columns()["x"]) == rows
    assert len(session.history) == 1


def test_over_edits_another_run_is_taken_as_one_edit_that_can_be_undone(
    window, controller, qtbot, tiny_run, shifted_run
):
    session = controller.document.session
    session.apply(plan_delete(session.tracks, shifted_run[1], 60, 70))
    edits = len(session.history)
    session.add_run(tiny_run, adopt=False)
    controller.comparing.correct(1)
    qtbot.waitUntil(lambda: bool(items(controller)))
    assert all(item.ticked or item.locked for item in items(controller))
    window.workspace.differences.taken.emit(1)
    assert len(session.history) == edits + 1
    controller.editing.undo()
    assert session.history.next_redo is not None


def test_the_better_stretch_is_taken_from_either_of_two_runs(
    window, controller, qtbot, tiny_run, shifted_run
):
    track = shifted_run[1]
    wrong = place(controller, track, 65)
    controller.document.session.add_run(tiny_run, adopt=False)
    controller.comparing.open(1, 0)
    qtbot.waitUntil(lambda: bool(items(controller)))
    panel = window.workspace.differences
    assert not panel._take_solid.isHidden()
    panel.all_ticked.emit(True)
    panel.taken.emit(1)
    assert place(controller, track, 65) == pytest.approx(wrong - 1.0, abs=1e-5)
    panel.taken.emit(0)
    assert place(controller, track, 65) == pytest.approx(wrong, abs=1e-5)


def test_the_boxes_of_both_runs_are_shown_and_not_those_of_the_corrected_tracks(
    window, controller, qtbot, tiny_run, shifted_run
):
    label = str(shifted_run[1])
    session = controller.document.session
    session.apply(plan_delete(session.tracks, shifted_run[1], 60, 70))
    session.add_run(tiny_run, adopt=False)
    controller.comparing.open(1, 0)
    qtbot.waitUntil(lambda: bool(items(controller)))
    controller.playback.go(65)
    picture = window.workspace.left
    qtbot.waitUntil(lambda: picture._scene.frame == 65)
    solid, dashed = boxes(picture._scene.people), boxes(picture._others)
    assert dashed[label][0] == pytest.approx(solid[label][0] - 40.0, abs=0.01)
    assert label in {place.label for place in window.workspace.overhead._others}


def test_the_last_run_is_dropped_from_the_list_but_not_the_one_that_was_corrected(
    window, controller, tiny_run
):
    controller.document.session.add_run(tiny_run, adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    dialog._drop.click()
    assert len(controller.document.session.runs) == 1
    assert not dialog._drop.isEnabled()
    assert "being corrected" in dialog._drop.toolTip()
    dialog.reject()


def test_a_run_is_tracked_again_with_its_own_settings(window, controller, qtbot, tiny_run):
    like = replace(tiny_run, seed=7, frames=(10, 60))
    controller.document.session.add_run(like, adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    dialog.choose(1)
    dialog._again.click()
    asked = window.findChild(TrackDialog)
    tracker, answered, seed, frames = asked.answer()
    assert (tracker, seed, frames) == (tiny_run.tracker, 7, (10, 60))
    assert settings_values(answered).items() >= tiny_run.settings.items()
    asked.reject()


def test_chosen_runs_are_copied_as_a_table(window, controller, qtbot, tiny_run):
    controller.document.session.add_run(replace(tiny_run, seed=7), adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    dialog.choose(1)
    QTest.keyClick(dialog._table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    heading, row = QGuiApplication.clipboard().text().split("\n")
    assert heading.startswith("Tracks\tTracker\tSettings")
    assert row.split("\t")[:3] == ["run 1", tiny_run.tracker, "seed 7"]
    dialog.reject()


def test_settings_are_told_short_and_as_info_tells_them(
    window, controller, qtbot, tiny_run, tmp_path
):
    kept = tmp_path / "a_folder_of_a_long_name" / "trained-15119b51057f0d5d.h5"
    kept.parent.mkdir()
    kept.touch()
    settings = {**tiny_run.settings, "smooth": False, "detector": str(kept)}
    run = replace(tiny_run, tracker="three-part", settings=settings)
    controller.document.session.add_run(run, adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    item = dialog._table.item(2, 2)
    assert "smooth off" in item.text()
    assert "detector trained 20" in item.text()
    assert "a_folder" not in item.text()
    assert item.toolTip() == item.text()
    dialog.reject()


def test_no_column_is_out_of_view_at_1280(window, controller, qtbot, tiny_run):
    settings = {**tiny_run.settings, "occluders": "x" * 300}
    controller.document.session.add_run(replace(tiny_run, settings=settings), adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    qtbot.waitUntil(lambda: all(_cells(dialog, "IDF1")))
    dialog.resize(1240, 500)
    assert not dialog._table.horizontalScrollBar().maximum()
    dialog.reject()


def test_runs_open_with_the_table_in_use_and_a_run_chosen_that_is_not_corrected(
    window, controller, qtbot, tiny_run
):
    controller.document.session.add_run(replace(tiny_run, seed=7), adopt=True)
    assert controller.document.session.adopted_run == 1
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    assert dialog.chosen == [0]
    assert dialog.focusWidget() is dialog._table
    assert dialog._table.currentRow() == 1
    dialog.reject()


def test_two_runs_are_compared_side_by_side_in_the_picture(
    window, controller, qtbot, tiny_run, monkeypatch
):
    controller.document.session.add_run(replace(tiny_run, seed=7), adopt=False)
    window.run_command("tracks.runs")
    dialog = window.findChild(RunsDialog)
    dialog.choose(0, 1)
    dialog._beside.click()
    left = window.workspace.left
    qtbot.waitUntil(lambda: left._divider is not None)
    assert left._divider.share == 0.5
    assert left._divider.left.startswith("run 0")
    assert left._divider.right.startswith("run 1")
    given = left._pictured()
    place = left.viewport.rect(left.content())
    own, other = halves(given.marks.divider, place, given.shown)
    assert own.right() == pytest.approx(other.left()) == pytest.approx(place.center().x())
    middle = place.center().toPoint()
    QTest.mousePress(left, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mouseMove(left, middle + QPoint(40, 0))
    QTest.mouseMove(left, middle + QPoint(60, 0))
    QTest.mouseRelease(left, Qt.MouseButton.LeftButton, pos=middle + QPoint(60, 0))
    qtbot.waitUntil(lambda: left._divider.share > 0.51)
    assert left._divider.share == pytest.approx(0.5 + 60 / place.width(), abs=0.02)
    before = left._divider.share
    window.run_command("view.divide_left")
    assert left._divider.share == pytest.approx(before - 0.05)
    window.run_command("view.divide")
    assert left._divider is None
    controller.comparing.close()
    window.bring_up_to_date()
    assert not window.menus.actions["view.divide"].isEnabled()
