import numpy as np
import pytest
from correcting_window import CROWDED, open_for_correcting
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox, QPlainTextEdit

from app.core.editing import Way
from app.features.correction.attributes import AttributesTable
from app.features.history.controller import HistoryWalk
from tracking.session import Session

Key = Qt.Key
_CTRL, _SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


def _ids(controller) -> list[int]:
    return controller.document.session.tracks.track_ids


def _place(controller, track: int, frame: int) -> float:
    rows = controller.document.session.tracks.of_track(track, frame, frame + 1)
    return float(rows["x"][0])


def test_keys_step_through_the_frames(controller, press, qtbot):
    for key, modifiers, frame in (
        (Key.Key_Right, Qt.KeyboardModifier.NoModifier, 61),
        (Key.Key_Left, _SHIFT, 51),
        (Key.Key_Right, _CTRL, 59),
        (Key.Key_End, Qt.KeyboardModifier.NoModifier, 79),
        (Key.Key_Home, Qt.KeyboardModifier.NoModifier, 0),
    ):
        press(key, modifiers)
        assert controller.playback.clock.frame == frame
    qtbot.waitUntil(lambda: controller.playback.number == 0)


def test_space_and_the_shuttle_keys_play(controller, press):
    press(Key.Key_Space)
    assert controller.playback.clock.playing
    press(Key.Key_Space)
    assert not controller.playback.clock.playing
    press(Key.Key_J)
    assert controller.playback.clock.rate == -1.0
    press(Key.Key_K)
    assert not controller.playback.clock.playing


def test_g_asks_for_a_frame_and_goes_there(window, controller, press, qtbot):
    press(Key.Key_G)
    assert window.focusWidget() is not None
    QTest.keyClicks(window.focusWidget(), "45")
    press(Key.Key_Return)
    assert controller.playback.clock.frame == 45


def test_tab_goes_through_the_people_of_the_frame_and_esc_lets_them_go(controller, press):
    here = controller.document.tracks.of_frame(CROWDED)["track"].tolist()
    press(Key.Key_Tab)
    assert controller.document.selection.track == here[0]
    press(Key.Key_Tab)
    assert controller.document.selection.track == here[1]
    press(Key.Key_Tab, _SHIFT)
    assert controller.document.selection.track == here[0]
    press(Key.Key_Escape)
    assert controller.document.selection.track == 0


def test_a_swap_is_done_by_keys_alone_undone_and_done_again(window, controller, press):
    a, b = controller.document.tracks.of_frame(CROWDED)["track"].tolist()[:2]
    before = _place(controller, a, 79), _place(controller, b, 79)
    press(Key.Key_Tab)
    press(Key.Key_X)
    assert window.workspace.preview.isVisible()
    assert controller.document.flow.needs_other
    press(Key.Key_Tab)
    assert controller.document.flow.other == b
    cut = controller.document.flow.cut
    press(Key.Key_Left)
    assert controller.document.flow.cut == cut - 1
    assert controller.playback.clock.frame == cut - 1
    press(Key.Key_Return)
    assert not window.workspace.preview.isVisible()
    assert (_place(controller, b, 79), _place(controller, a, 79)) == before
    press(Key.Key_Home)
    press(Key.Key_Z, _CTRL)
    assert (_place(controller, a, 79), _place(controller, b, 79)) == before
    assert controller.playback.clock.frame == cut - 1  # undo goes where it changed something
    press(Key.Key_Z, _CTRL | _SHIFT)
    assert (_place(controller, b, 79), _place(controller, a, 79)) == before


def test_tab_shows_who_stands_outside_a_zoomed_view(window, controller, press):
    here = controller.document.tracks.of_frame(CROWDED)
    people = list(zip(here["track"].tolist(), here["left"].tolist(), strict=True))
    views = (window.workspace.left, window.workspace.overhead)
    controller.document.selection.choose(0)
    for view in views:
        assert view.isVisible()
        view.fit()
        view.zoom(6.0, QPointF(view.width(), view.height()))  # at its lower right corner
    seen = [_seen(window, track) for track, _ in people]
    assert not all(seen)
    for _ in people:
        press(Key.Key_Tab)
        assert _seen(window, controller.document.selection.track)
    for view in views:
        view.fit()
    before = [view.viewport for view in views]
    press(Key.Key_Tab)
    assert [view.viewport for view in views] == before  # all is in view: nothing moves


def _seen(window, track):
    """Whether somebody's middle is within the picture and the floor."""
    left, floor = window.workspace.left, window.workspace.overhead
    box = next(one.box for one in left._scene.people if one.track == track)
    place = next(one.position for one in floor._scene.people if one.track == track)
    middle = left.viewport.rect(QRectF(*box)).center()
    on_floor = floor.viewport.point(*place)
    return all(QRectF(view.rect()).contains(at) for view, at in ((left, middle), (floor, on_floor)))


def test_after_a_split_the_new_half_is_selected_and_after_undo_the_whole(controller, press):
    press(Key.Key_Tab)
    before, ids = controller.document.selection.track, set(_ids(controller))
    press(Key.Key_S)
    press(Key.Key_Return)
    (new,) = set(_ids(controller)) - ids
    assert controller.document.selection.all == (new,)
    press(Key.Key_Z, _CTRL)
    assert controller.document.selection.all == (before,)


def test_a_name_given_and_taken_back_leaves_the_playhead_where_its_track_is_seen(controller, press):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    assert controller.document.session.tracks.frame_range(track)[0] < CROWDED
    controller.editing.rename(track, "red coat")
    press(Key.Key_Z, _CTRL)
    assert controller.document.label(track).name == ""
    assert controller.playback.clock.frame == CROWDED


def test_esc_leaves_an_edit_without_doing_it(window, controller, press):
    press(Key.Key_Tab)
    press(Key.Key_X)
    press(Key.Key_Escape)
    assert controller.document.flow is None
    assert not window.workspace.preview.isVisible()
    assert not controller.document.session.dirty


def test_the_scope_key_narrows_a_swap_to_this_frame(controller, press):
    a = controller.document.tracks.of_frame(CROWDED)["track"].tolist()[0]
    press(Key.Key_Tab)
    press(Key.Key_X)
    press(Key.Key_Tab)
    press(Key.Key_R)
    press(Key.Key_R)
    cut = controller.document.flow.cut
    before = _place(controller, a, cut - 1)
    here = _place(controller, a, cut)
    press(Key.Key_Return)
    assert _place(controller, a, cut - 1) == before
    assert _place(controller, a, cut) != here
    assert controller.document.session.history.next_undo.text.endswith(f"in frame {cut}")


def test_split_keeps_the_id_before_the_cut_and_merge_puts_the_parts_together(controller, press):
    a = controller.document.tracks.of_frame(CROWDED)["track"].tolist()[0]
    rows = len(controller.document.session.tracks.frames_of_track(a))
    press(Key.Key_Tab)
    press(Key.Key_S)
    press(Key.Key_Return)
    new = max(_ids(controller))
    assert controller.document.session.tracks.frame_range(a)[1] == CROWDED
    controller.editing.pick(a)
    press(Key.Key_M)
    controller.editing.pick(new)
    press(Key.Key_Return)
    assert new not in _ids(controller)
    assert len(controller.document.session.tracks.frames_of_track(a)) == rows


def test_del_ends_a_track_here(controller, press):
    a = controller.document.tracks.of_frame(CROWDED)["track"].tolist()[0]
    press(Key.Key_Tab)
    press(Key.Key_Delete)
    press(Key.Key_Return)
    assert controller.document.session.tracks.frame_range(a)[1] == CROWDED


def test_a_name_typed_in_the_card_is_shown_everywhere(window, controller, press):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    press(Key.Key_F2)
    QTest.keyClicks(window.focusWidget(), "red sxm coat")  # s, x and m are typed, not obeyed
    press(Key.Key_Return)
    assert controller.document.label(track).name == "red sxm coat"
    assert controller.document.frame_state(CROWDED).label(track) == f"{track} red sxm coat"
    assert controller.document.flow is None


def test_notes_and_attributes_are_edits_too(controller):
    track = _ids(controller)[0]
    controller.editing.write_notes(track, "limps")
    controller.editing.set_attributes(track, (("bag", "yes"), ("hat", "no")))
    label = controller.document.label(track)
    assert (label.notes, dict(label.attributes)) == ("limps", {"bag": "yes", "hat": "no"})
    controller.editing.set_attributes(track, (("bag", "yes"),))
    assert dict(controller.document.label(track).attributes) == {"bag": "yes"}
    assert len(controller.document.session.history) == 4


def test_the_history_goes_back_and_forth_to_any_edit(controller, qtbot):
    track = _ids(controller)[0]
    for name in ("one", "two", "three"):
        controller.editing.rename(track, name)
    controller.of(HistoryWalk).go_back_to(1)
    qtbot.waitUntil(lambda: controller.document.label(track).name == "one")
    controller.of(HistoryWalk).go_back_to(3)
    qtbot.waitUntil(lambda: controller.document.label(track).name == "three")


def test_saving_clears_the_mark_and_the_file_holds_the_edits(window, controller, press, qtbot):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    controller.editing.rename(track, "anna")
    qtbot.waitUntil(lambda: window.isWindowModified())
    press(Key.Key_S, _CTRL)
    qtbot.waitUntil(lambda: not window.files.saving.unsaved and not window.work.busy)
    path = window.files.session.path
    window.run_command("file.close")
    again = Session.open(path)
    assert again.labels.of_track(track).name == "anna"
    again.close()


def test_after_a_crash_the_edits_are_there_and_the_window_says_so(
    window, controller, qtbot, tiny_session
):
    track = _ids(controller)[0]
    controller.editing.rename(track, "anna")
    columns = controller.document.session.tracks.columns()
    window.files.close()  # nothing is saved: only the journal knows
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: window.controller is not None and not window.work.busy)
    document = window.controller.document
    assert document.label(track).name == "anna"
    assert "1 edit" in window.notice.text or "recovered" in window.notice.text
    assert np.array_equal(document.session.tracks.columns()["track"], columns["track"])


def test_picking_in_the_picture_the_floor_and_the_timeline_selects_everywhere(window, controller):
    views = window.workspace
    here = controller.document.tracks.of_frame(CROWDED)["track"].tolist()
    for view, track in zip((views.left, views.overhead, views.timeline), here * 3, strict=False):
        view.track_picked.emit(track)
        assert controller.document.card().track == track
        lanes = controller.scenes.timeline(CROWDED, CROWDED).lanes
        assert [lane.track for lane in lanes if lane.selected] == [track]


@pytest.mark.parametrize("answer", ["Save", "Discard", "Cancel"])
def test_closing_with_edits_asks_first(window, controller, qtbot, answer):
    from PySide6.QtWidgets import QMessageBox

    track = _ids(controller)[0]
    path = window.files.session.path
    controller.editing.rename(track, "anna")
    window.run_command("file.close")
    box = window.findChild(QMessageBox, "unsaved")
    box.button(QMessageBox.StandardButton[answer]).click()
    if answer == "Cancel":
        assert window.controller is controller
        return
    qtbot.waitUntil(lambda: window.controller is None)
    again = Session.open(path)
    assert again.labels.of_track(track).name == ("anna" if answer == "Save" else "")
    assert again.recovered == 0
    again.close()


def test_notes_still_being_typed_are_saved_too(window, controller, press, qtbot):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    notes = window.workspace.card.findChild(QPlainTextEdit)
    notes.setFocus()
    QTest.keyClicks(notes, "limps")
    assert controller.document.label(track).notes == ""
    press(Key.Key_S, _CTRL)
    qtbot.waitUntil(lambda: not window.files.saving.unsaved and not window.work.busy)
    assert controller.document.label(track).notes == "limps"


def test_a_merge_is_done_by_typing_the_others_id(window, controller, press):
    a, b = controller.document.tracks.of_frame(CROWDED)["track"].tolist()[:2]
    press(Key.Key_Tab)
    press(Key.Key_M)
    QTest.keyClicks(window.focusWidget(), "99")
    press(Key.Key_Return)
    assert controller.document.flow.needs_other
    assert "There is no track 99" in window.workspace.preview._details.text()
    QTest.keyClicks(window.focusWidget(), str(b))
    press(Key.Key_Return)
    assert controller.document.flow.other == b
    assert controller.document.flow.way is Way.KEEP_FIRST
    press(Key.Key_R)
    assert controller.document.flow.way is Way.KEEP_SECOND
    press(Key.Key_Return)
    assert b not in _ids(controller)
    assert a in _ids(controller)


def test_while_an_id_is_asked_for_other_keys_stay_shortcuts(window, controller, press):
    press(Key.Key_Tab)
    press(Key.Key_X)
    press(Key.Key_Right)
    assert controller.playback.clock.frame == CROWDED + 1
    press(Key.Key_1)
    assert controller.cameras == "both"  # 1 is typed, not taken for the left camera's key
    press(Key.Key_Backspace)
    press(Key.Key_Escape)
    assert controller.document.flow is None
    press(Key.Key_1)
    assert controller.cameras == "left"


def test_an_edit_that_waits_leaves_the_pictures_as_large_as_they_were(
    window, controller, press, qtbot
):
    controller.set_cameras("both")
    qtbot.wait(1)
    before = window.workspace.left.size(), window.workspace.overhead.size()
    press(Key.Key_Tab)
    press(Key.Key_X)
    press(Key.Key_Tab)
    qtbot.wait(1)
    assert window.workspace.preview.isVisible()
    assert (window.workspace.left.size(), window.workspace.overhead.size()) == before


def test_saving_cannot_be_cancelled_half_way(window, controller, qtbot, tmp_path):
    controller.editing.rename(controller.document.tracks.ids[0], "red coat")
    window.files.saving.save_to(tmp_path / "saved.h5")
    assert window.progress._text.text() == "Saving saved.h5"
    assert window.progress._cancel.isHidden()
    qtbot.waitUntil(lambda: not window.work.busy)
    assert (tmp_path / "saved.h5").is_file()


def test_an_attribute_still_being_typed_is_kept_when_the_window_is_left(window, controller, press):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    table = window.workspace.card.findChild(AttributesTable)
    controller.editing.set_attributes(track, (("bag", "no"),))
    table.setFocus()
    table.editItem(table.item(0, 1))
    QTest.keyClicks(window.focusWidget(), "yes")
    assert dict(controller.document.label(track).attributes) == {"bag": "no"}
    assert not window.files.may_leave(lambda: None)  # asks about what is not saved
    assert dict(controller.document.label(track).attributes) == {"bag": "yes"}
    window.findChild(QMessageBox, "unsaved").reject()
