"""The review queue walked, decided and put right with keys in the real window."""

import re
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit
from shiboken6 import isValid
from shifted_runs import SWAPPED_AT

from app.core.document import document_loader
from app.core.editing import EditScope, edits
from app.core.playback.clock import LONGEST_STALL_S
from app.features.review.alike_dialog import AlikeDialog
from app.features.review.panel import ReviewPanel
from app.features.review.scene import Order
from tracking.editing import plan_mark_reviewed, plan_rename
from tracking.recording import open_recording
from tracking.session import IMPORTED, Session
from tracking.tracks import SIGNAL_COLUMNS, TRACK_COLUMNS, empty

Key = Qt.Key
_CTRL, _SHIFT, _ALT = (
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)


@pytest.fixture
def controller(window, qtbot, swapped_session):
    window.files.open_path(swapped_session[0])
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    with qtbot.waitActive(window):
        window.activateWindow()
    qtbot.waitUntil(lambda: bool(window.controller.reviewing.queue.items))
    qtbot.waitUntil(lambda: window.menus.actions["review.next"].isEnabled())
    return window.controller


@pytest.fixture
def press(window, controller, qtbot):
    def press(key, modifiers=Qt.KeyboardModifier.NoModifier) -> None:
        qtbot.wait(1)  # commands are enabled before the next event
        QTest.keyClick(window.focusWidget() or window, key, modifiers)
        qtbot.wait(1)

    return press


@pytest.fixture
def to_the_swap(controller, press, swapped_session):
    """Walk until the swap is looked at."""

    def walk():
        for _ in controller.reviewing.queue.items:
            press(Key.Key_N)
            current = controller.reviewing.queue.current
            there = current.start <= SWAPPED_AT < current.end
            if there and current.fix == "swap" and set(current.tracks) == swapped_session[1]:
                return current
        raise AssertionError("the swap is not among the review items")

    return walk


def _verdicts(controller):
    return {one.key: one.decision for one in controller.document.session.labels.verdicts.values()}


def test_opening_a_session_fills_the_queue_and_marks_the_timeline(controller, window):
    panel = window.workspace.review
    assert panel._left.text() == f"{len(controller.reviewing.queue.open)} left"
    scene = controller.scenes.timeline(0, controller.playback.number)
    marked = {(mark.frame, mark.track) for lane in scene.lanes for mark in lane.marks}
    assert marked == {
        (one.frame, track) for one in controller.reviewing.queue.open for track in one.tracks
    }


def test_n_goes_just_before_the_review_item_and_selects_its_people(controller, to_the_swap):
    current = to_the_swap()
    assert controller.playback.clock.frame == current.start
    assert set(controller.document.selection.all) == set(current.tracks)
    assert abs(current.frame - SWAPPED_AT) <= 4


def test_p_goes_back_to_the_one_before(controller, press):
    press(Key.Key_N)
    first = controller.reviewing.queue.current
    press(Key.Key_N)
    press(Key.Key_P)
    assert controller.reviewing.queue.current == first


def test_z_says_that_it_is_right_and_goes_on_to_the_next(controller, press):
    press(Key.Key_N)
    first, left = controller.reviewing.queue.current, len(controller.reviewing.queue.open)
    press(Key.Key_Z)
    assert _verdicts(controller)[first.key] == "right"
    assert len(controller.reviewing.queue.open) < left
    assert controller.reviewing.queue.current != first
    assert controller.document.session.history.next_undo.kind == "verdict"


def test_a_decision_can_be_undone_and_is_asked_for_again(controller, press):
    press(Key.Key_N)
    first, left = controller.reviewing.queue.current, len(controller.reviewing.queue.open)
    press(Key.Key_Backspace)
    assert _verdicts(controller)[first.key] == "dismissed"
    press(Key.Key_Z, _CTRL)
    assert _verdicts(controller) == {}
    assert len(controller.reviewing.queue.open) == left


def test_undoing_a_decision_looks_at_its_review_item_and_its_people_again(controller, press):
    press(Key.Key_N)
    first = controller.reviewing.queue.current
    press(Key.Key_Backspace)
    assert controller.reviewing.queue.current != first
    press(Key.Key_Z, _CTRL)
    assert controller.reviewing.queue.current == first
    assert set(controller.document.selection.all) == set(first.tracks)
    assert first.start <= controller.playback.clock.frame <= first.end


def test_undoing_what_put_a_review_item_right_looks_at_it_again(
    controller, press, to_the_swap, qtbot
):
    current = to_the_swap()
    press(Key.Key_E)
    press(Key.Key_Return)
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    press(Key.Key_N)
    press(Key.Key_Z, _CTRL)
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    qtbot.waitUntil(lambda: controller.reviewing.queue.current is not None)
    assert controller.reviewing.queue.current.key == current.key


def test_e_and_enter_put_a_swap_right_and_remember_it_in_one_edit(
    controller, press, to_the_swap, qtbot
):
    current = to_the_swap()
    press(Key.Key_E)
    flow = controller.document.flow
    assert flow.spec is edits.SWAP
    assert {flow.track, flow.other} == set(current.tracks)
    assert abs(flow.cut - SWAPPED_AT) <= 2
    press(Key.Key_Return)
    assert _verdicts(controller)[current.key] == "fixed"
    assert len(controller.document.session.history) == 1
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    assert current.key not in {one.key for one in controller.reviewing.queue.open}
    press(Key.Key_Z, _CTRL)
    assert _verdicts(controller) == {}


def test_an_edit_that_is_left_settles_nothing(controller, press, to_the_swap):
    current = to_the_swap()
    press(Key.Key_E)
    press(Key.Key_Escape)
    press(Key.Key_S)  # another edit, of one of them alone
    press(Key.Key_Return)
    assert len(controller.document.session.history) <= 1
    assert current.key not in _verdicts(controller)


def test_each_stretch_is_played_to_its_end_where_that_is_wanted(controller, window, press, qtbot):
    window.run_command("review.plays")
    qtbot.waitUntil(lambda: window.menus.actions["review.plays"].isChecked())
    controller.playback.set_speed(4.0)
    clock, played = controller.playback.clock, []
    controller.playback.moved.connect(lambda: played.append(clock.playing))
    press(Key.Key_N)  # on a busy machine a short stretch is over by the time this is back
    current = controller.reviewing.queue.current
    qtbot.waitUntil(lambda: any(played) and not clock.playing)
    end, stalled = min(current.end, clock.frame_count), LONGEST_STALL_S * clock.fps * clock.speed
    assert end - 1 <= clock.frame < end + 4 + stalled


def test_what_was_watched_is_marked_as_reviewed_for_everybody_and_unmarked(
    controller, window, press, qtbot
):
    for frame in range(30, 36):
        controller.playback.go(frame)
        qtbot.waitUntil(lambda frame=frame: controller.playback.number == frame)
    press(Key.Key_Z, _ALT)
    (seen,) = controller.document.session.labels.reviewed
    assert (seen.track, seen.start, seen.end) == (0, 30, 36)
    window.run_command("review.unmark")
    assert controller.document.session.labels.reviewed == ()


def test_what_was_watched_is_marked_for_who_is_selected(controller, press, qtbot):
    track = controller.document.tracks.of_frame(30)["track"].tolist()[0]
    controller.document.selection.choose(track)
    for frame in range(30, 36):
        controller.playback.go(frame)
        qtbot.waitUntil(lambda frame=frame: controller.playback.number == frame)
    controller.changed.emit()
    press(Key.Key_Z, _SHIFT)
    assert [seen.track for seen in controller.document.session.labels.reviewed] == [track]


def test_marking_a_whole_track_leaves_the_playhead_and_marks_only_its_frames(
    controller, window, qtbot
):
    tracks = controller.document.session.tracks
    late = max(tracks.track_ids, key=lambda one: tracks.frame_range(one)[0])
    first, stop = tracks.frame_range(late)
    assert first > 0
    controller.playback.go(stop - 1)
    controller.document.selection.choose(late)
    for choose in (True, False):
        controller.editing.begin(edits.REVIEW, EditScope.WHOLE)
        if choose:
            assert controller.playback.clock.frame == stop - 1
        controller.editing.confirm()
        assert controller.playback.clock.frame == stop - 1
        reviewed = controller.document.session.labels.reviewed
        assert (reviewed[0].start, reviewed[-1].end) == (first, stop)
        controller.editing.undo()
        assert controller.playback.clock.frame == stop - 1
        assert controller.document.session.labels.reviewed == ()


def test_undoing_an_edit_goes_back_to_the_item_it_was_made_at(
    controller, press, to_the_swap, qtbot
):
    current = to_the_swap()
    controller.editing.begin(edits.SWAP)  # by hand, not with E
    controller.playback.go(current.frame)
    controller.editing.put_cut(current.frame)
    controller.editing.confirm()
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    assert controller.document.session.history.next_undo.kind == "swap"
    press(Key.Key_N)
    assert (
        controller.reviewing.queue.current is None or controller.reviewing.queue.current != current
    )
    press(Key.Key_Z, _CTRL)
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    assert controller.reviewing.queue.current.tracks == current.tracks
    assert (
        abs(controller.reviewing.queue.current.frame - current.frame)
        <= controller.playback.clock.fps
    )


def test_undoing_an_edit_of_somebody_else_leaves_the_queue_where_it_is(controller, press, qtbot):
    press(Key.Key_N)
    first = controller.reviewing.queue.current
    other = next(t for t in controller.document.tracks.ids if t not in first.tracks)
    controller.editing.rename(other, "red coat")
    press(Key.Key_N)
    second = controller.reviewing.queue.current
    press(Key.Key_Z, _CTRL)
    assert controller.reviewing.queue.current == second


def test_labels_alone_make_no_new_search(controller, qtbot):
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    session = controller.document.session
    track = session.tracks.track_ids[0]
    controller.document.apply(plan_rename(session.tracks, session.labels, track, "red coat"))
    controller.draw()
    assert not controller.reviewing.busy
    titles = {who.label for item in controller.reviewing.queue.items for who in item.people}
    assert f"{track} red coat" in titles


def test_after_an_edit_review_items_are_looked_for_again(controller, window, qtbot):
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    session = controller.document.session
    controller.document.selection.choose(session.tracks.of_frame(50)["track"].tolist()[0])
    controller.playback.go(50)
    controller.editing.begin(edits.SPLIT)
    controller.editing.confirm()
    assert controller.reviewing.busy
    before = controller.reviewing.queue.items
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    assert controller.reviewing.queue.items is not before


def test_the_meter_tells_what_was_done_and_nothing_of_the_truth(controller, press, window, qtbot):
    press(Key.Key_N)
    press(Key.Key_Z)
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    said = window.workspace.review._meter.text()
    assert "1 decided" in said
    assert "truth" not in said


def test_the_panel_tells_how_far_the_review_is_and_what_risk_is_left(
    controller, press, window, qtbot
):
    meter, queue = window.workspace.review._meter, controller.reviewing.queue
    begun = meter.text()
    assert begun.startswith(
        f"Reviewed: 0% of the footage; 0 of {len(queue.open)} items decided or reviewed."
    )
    assert re.search(r"About \d+ errors? left \(likely \d+ to \d+\)", begun)
    press(Key.Key_N)
    press(Key.Key_Z)
    assert meter.text() != begun
    assert "0% of the footage" not in meter.text()
    frames, labels = controller.playback.clock.frame_count, controller.document.session.labels
    table = controller.document.session.tracks
    controller.document.apply(plan_mark_reviewed(labels, 0, 0, frames, table))
    controller.draw()
    assert "Reviewed: 100% of the footage" in meter.text()
    assert "About 0 errors left (likely 0 to 0)." in meter.text()


def test_how_good_the_queue_is_is_told_where_that_is_asked_and_as_long(controller, window, qtbot):
    meter, action = window.workspace.review._meter, window.menus.actions["review.measure"]
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    window.run_command("review.measure")
    qtbot.waitUntil(lambda: "identity errors" in meter.text())
    qtbot.waitUntil(action.isChecked)
    window.run_command("review.measure")
    assert "truth" not in meter.text()
    qtbot.waitUntil(lambda: not action.isChecked())


@pytest.mark.parametrize("command", ["help.keys", "edit.commands"])
def test_after_a_list_of_commands_was_left_n_goes_on_at_once(
    controller, press, window, qtbot, command
):
    press(Key.Key_N)
    before = controller.reviewing.queue.place
    window.run_command(command)
    top = QApplication.activePopupWidget() or QApplication.activeModalWidget()
    assert top is not None
    qtbot.waitUntil(lambda: QApplication.focusWidget() in top.findChildren(QLineEdit))
    with qtbot.waitActive(window):
        QTest.keyClick(QApplication.focusWidget(), Key.Key_Escape)
    assert not isValid(top) or not top.isVisible()
    press(Key.Key_N)
    assert controller.reviewing.queue.place == before + 1


def test_the_list_can_be_narrowed_sorted_and_clicked(controller, window, qtbot):
    panel: ReviewPanel = window.workspace.review
    panel.order_chosen.emit(Order.TIME.value)
    frames = [item.frame for item in controller.reviewing.queue.items]
    assert frames == sorted(frames)
    kind = controller.reviewing.queue.kinds()[0]
    panel.kind_chosen.emit(kind.kind)
    assert len(controller.reviewing.queue.items) == kind.count
    item = controller.reviewing.queue.items[0]
    at = panel._list.visualRect(panel._model.index(0)).center()
    qtbot.mouseClick(panel._list.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert controller.reviewing.queue.current.key == item.key


def test_many_are_decided_in_one_step_and_undone_to_the_one_it_was_asked_at(
    controller, window, press, qtbot
):
    reviewing = controller.reviewing
    press(Key.Key_N)
    press(Key.Key_N)
    first, left = reviewing.queue.current, len(reviewing.queue.open)
    window.run_command("review.alike")
    dialog = window.findChild(AlikeDialog)
    frame = controller.playback.clock.frame
    assert dialog is not None
    group = max(reviewing.groups_alike(), key=lambda one: len(one.items))
    many = len(group.items)
    dialog.choices.button(
        [one.title for one in reviewing.groups_alike()].index(group.title)
    ).click()
    assert controller.playback.clock.frame == frame
    dialog.right.click()
    decided = _verdicts(controller)
    assert len(decided) == many
    assert set(decided.values()) == {"right"}
    assert len(reviewing.queue.open) <= left - many
    controller.editing.undo()
    assert _verdicts(controller) == {}
    assert len(reviewing.queue.open) == left
    assert reviewing.queue.current == first


def test_the_panel_says_what_came_of_the_kind_and_an_edit_by_hand_counts_as_an_error(
    controller, window, press, to_the_swap, qtbot
):
    current, learned = to_the_swap(), window.workspace.review.learned
    assert learned.isHidden()
    controller.editing.begin(edits.SWAP)
    controller.playback.go(current.frame)
    controller.editing.put_cut(current.frame)
    controller.editing.confirm()
    records = controller.reviewing.queue.records
    assert (records[current.kind].decided, records[current.kind].errors) == (1, 1)
    controller.editing.undo()
    assert not controller.reviewing.queue.records
    press(Key.Key_Z)
    queue = controller.reviewing.queue
    assert sum(one.decided for one in queue.records.values()) == 1
    assert any("0 of 1 was an error here" in said for said in queue.learned_texts())


def test_pictures_of_the_current_item_come_with_it_and_go_with_it(controller, window, press, qtbot):
    strip = window.workspace.review.strip
    assert strip.isHidden()
    press(Key.Key_N)
    qtbot.waitUntil(lambda: len(strip._images) == 3)
    current = controller.reviewing.queue.current
    assert all(str(track) in strip.accessibleDescription() for track in current.tracks)
    before = strip._scene
    press(Key.Key_N)
    qtbot.waitUntil(lambda: strip._scene is not before and len(strip._images) == 3)
    window.files.close_without_asking()
    assert not strip._images


def test_the_queue_is_empty_again_once_the_recording_is_closed(controller, window):
    window.files.close_without_asking()
    assert window.workspace.review._model.rowCount() == 0


@pytest.fixture
def imported(window, qtbot, swapped_session, tiny_recording, request, tmp_path):
    """Tracks with the swap as another program gives them, sure of all rows alike or of each."""
    with open_recording(tiny_recording) as recording:
        source = Session.open(swapped_session[0])
        (run,) = source.runs
        source.close()
        tracks = {**run.tracks, "confidence": request.param(run.tracks["confidence"])}
        made = replace(run, tracker=IMPORTED, tracks=tracks)
        session = Session.create(recording, [made], tmp_path / "imported.h5")
        document_loader.remember_place(session, recording)
        session.close()
    window.files.open_path(session.path)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    return window.controller


@pytest.mark.parametrize("imported", [np.ones_like], indirect=True, ids=["ground truth"])
def test_nothing_is_flagged_in_imported_ground_truth_unless_asked(imported, window, qtbot):
    reviewing, panel = imported.reviewing, window.workspace.review
    qtbot.wait(500)  # twice as long as a search waits
    assert not reviewing.queue.items
    assert panel._title.text() == "Imported labels"
    assert panel._ask.isVisible()
    qtbot.mouseClick(panel._ask, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: bool(reviewing.queue.items))
    assert not panel._ask.isVisible()


@pytest.mark.parametrize("imported", [np.ones_like], indirect=True, ids=["ground truth"])
def test_what_was_made_by_hand_is_flagged_as_long_as_that_is_asked(imported, window, qtbot):
    reviewing, action = imported.reviewing, window.menus.actions["review.hand_made"]
    qtbot.waitUntil(action.isEnabled)
    action.trigger()
    qtbot.waitUntil(lambda: bool(reviewing.queue.items))
    qtbot.waitUntil(action.isChecked)
    action.trigger()
    assert not reviewing.queue.items
    assert window.workspace.review._ask.isVisible()


@pytest.mark.parametrize("imported", [np.asarray], indirect=True, ids=["a tracker's"])
def test_what_another_tracker_found_is_looked_through_unasked(imported, qtbot):
    qtbot.waitUntil(lambda: bool(imported.reviewing.queue.items))


def test_where_nobody_is_tracked_there_is_nothing_to_review(
    window, qtbot, tiny_recording, tiny_run
):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    controller = window.controller
    nobody = replace(tiny_run, tracks=empty(TRACK_COLUMNS), signals=empty(SIGNAL_COLUMNS))
    controller.document.take_session(Session.create(controller.document.recording, [nobody]))
    controller.reviewing.refresh()
    panel = window.workspace.review
    qtbot.waitUntil(lambda: panel._title.text() == "Nobody is tracked")
    assert "nothing to review" in panel._text.text()
    assert "decided" not in panel._text.text()
