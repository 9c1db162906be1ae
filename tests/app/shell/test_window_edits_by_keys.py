"""Every edit of tracks done in the real window with the keyboard alone."""

import pytest
from correcting_window import CROWDED, CTRL, SHIFT, Hands, open_for_correcting
from PySide6.QtCore import Qt

from app.core.editing import EditScope, edits
from app.core.editing.edit_options import LongestGap
from app.features.correction.attributes import AttributesTable
from tracking.tracks import Source

Key = Qt.Key
ALT = Qt.KeyboardModifier.AltModifier


@pytest.fixture
def hands(window, qtbot, tiny_session) -> Hands:
    hands = Hands(window, open_for_correcting(window, qtbot, tiny_session), qtbot)
    hands.press(Key.Key_Tab)
    return hands


@pytest.fixture
def track(hands) -> int:
    return hands.controller.document.selection.track


def test_a_range_is_set_by_brackets_and_deleted(hands, track):
    hands.press(Key.Key_BracketLeft)
    hands.go(64)
    hands.press(Key.Key_BracketRight)
    assert hands.controller.document.correcting.marked == (60, 65)
    hands.press(Key.Key_Delete, ALT)
    assert "frames 60 to 64" in hands.controller.document.planned.scene.title
    hands.press(Key.Key_Return)
    gone = set(hands.frames(track)) & set(range(59, 66))
    assert gone == {59, 65}


def test_the_end_of_a_range_moves_with_ctrl_and_arrows(hands, track):
    before = hands.frames(track)
    hands.press(Key.Key_Delete, ALT)
    stop = hands.controller.document.flow.end
    hands.press(Key.Key_Left, CTRL)
    hands.press(Key.Key_Left, CTRL)
    assert hands.controller.document.flow.end == stop - 2
    hands.press(Key.Key_Return)
    assert hands.frames(track) == [f for f in before if not CROWDED <= f < stop - 2]


@pytest.mark.parametrize(("modifiers", "left"), [(SHIFT, "others"), (CTRL, "nothing")])
def test_this_frame_or_the_whole_track_is_deleted(hands, track, modifiers, left):
    before = hands.frames(track)
    hands.press(Key.Key_Delete, modifiers)
    hands.press(Key.Key_Return)
    kept = [frame for frame in before if frame != CROWDED] if left == "others" else []
    assert hands.frames(track) == kept


def test_a_track_is_given_to_a_new_id_that_is_typed(hands, track):
    before = hands.frames(track)
    hands.press(Key.Key_A)
    hands.type("42")
    hands.press(Key.Key_Return)
    assert hands.controller.document.planned.scene.ready
    hands.press(Key.Key_Return)
    assert hands.frames(42) == [frame for frame in before if frame >= CROWDED]
    assert hands.frames(track) == [frame for frame in before if frame < CROWDED]


def test_a_box_is_moved_and_resized_by_arrows_until_enter(hands, track):
    before = hands.row(track, CROWDED)
    hands.press(Key.Key_V)
    hands.press(Key.Key_Right)
    hands.press(Key.Key_Down, SHIFT)
    hands.press(Key.Key_Up, CTRL)
    assert hands.row(track, CROWDED) == before  # nothing is done before Enter
    seen = hands.controller.document.frame_state(CROWDED).tracks.of_frame(CROWDED)
    at = seen["track"].tolist().index(track)
    assert seen["left"][at] == before["left"] + 1
    hands.press(Key.Key_Return)
    after = hands.row(track, CROWDED)
    assert (after["left"], after["top"]) == (before["left"] + 1, before["top"] + 10)
    assert (after["width"], after["height"]) == (before["width"], before["height"] - 1)
    assert after["source"] == Source.PERSON
    hands.press(Key.Key_Z, CTRL)
    assert hands.row(track, CROWDED) == before


def test_a_person_is_moved_on_the_floor_by_arrows(hands, track):
    before = hands.row(track, CROWDED)
    hands.press(Key.Key_V, SHIFT)
    hands.press(Key.Key_Right, SHIFT)
    hands.press(Key.Key_Up)
    hands.press(Key.Key_Return)
    after = hands.row(track, CROWDED)
    assert after["x"] == pytest.approx(before["x"] + 0.5)
    assert after["y"] == pytest.approx(before["y"] + 0.05)
    assert after["left"] > before["left"]


def test_escape_leaves_a_moved_box_where_it_was(hands, track):
    before = hands.row(track, CROWDED)
    hands.press(Key.Key_V)
    hands.press(Key.Key_Right, SHIFT)
    hands.press(Key.Key_Escape)
    assert hands.row(track, CROWDED) == before
    assert not hands.controller.document.session.dirty


def test_keyframes_are_made_and_the_frames_between_them_interpolated(hands, track):
    hands.press(Key.Key_V)
    hands.press(Key.Key_Return)
    hands.go(70)
    hands.press(Key.Key_W, SHIFT)
    hands.press(Key.Key_Return)
    hands.go(65)
    hands.press(Key.Key_I)
    hands.press(Key.Key_C)  # straight in the picture
    hands.press(Key.Key_Return)
    first, middle, last = (hands.row(track, frame) for frame in (60, 65, 70))
    assert [row["source"] for row in (first, middle, last)] == [1, 2, 1]
    assert middle["left"] == pytest.approx((first["left"] + last["left"]) / 2)
    lane = next(one for one in hands.controller.scenes.timeline(65, 65).lanes if one.track == track)
    assert lane.keyframes.tolist() == [60, 70]
    hands.go(70)
    hands.press(Key.Key_W, CTRL | SHIFT)
    hands.press(Key.Key_Return)
    assert hands.row(track, 70).get("source") != Source.PERSON


def test_a_gap_is_filled(hands, track):
    hands.press(Key.Key_Delete, SHIFT)
    hands.press(Key.Key_Return)
    assert CROWDED not in hands.frames(track)
    hands.press(Key.Key_I, SHIFT)
    hands.press(Key.Key_Return)
    assert hands.row(track, CROWDED)["source"] == Source.INTERPOLATED


def test_all_short_gaps_of_several_are_filled_at_once_and_gone_through_first(hands, track):
    other = next(one for one in hands.people() if one != track)
    for person, frame in ((track, 50), (other, 56)):
        hands.controller.editing.pick(person)
        hands.go(frame)
        hands.press(Key.Key_Delete, SHIFT)
        hands.press(Key.Key_Return)
    hands.controller.editing.add(track)
    hands.go(CROWDED)
    hands.press(Key.Key_I, CTRL)
    assert hands.controller.playback.clock.frame == 56  # the nearest
    hands.press(Key.Key_Up)
    assert hands.controller.playback.clock.frame == 50
    hands.press(Key.Key_R)
    assert hands.controller.document.flow.longest is LongestGap.SECONDS
    hands.press(Key.Key_Return)
    filled = [hands.row(track, 50)["source"], hands.row(other, 56)["source"]]
    assert filled == [Source.INTERPOLATED] * 2


def test_escape_goes_back_to_where_the_edit_was_begun(hands, track):
    for press in ((Key.Key_X, Key.Key_Tab, Key.Key_Right), (Key.Key_S, Key.Key_Left, Key.Key_Left)):
        for key in press:
            hands.press(key)
        assert hands.controller.playback.clock.frame != CROWDED
        hands.press(Key.Key_Escape)
        assert hands.controller.document.flow is None
        assert hands.controller.playback.clock.frame == CROWDED


def test_occluded_and_visible_are_marked_over_a_scope(hands, track):
    before, after = (hands.row(track, frame)["visibility"] for frame in (59, 68))
    hands.press(Key.Key_H)
    hands.press(Key.Key_R)
    assert hands.controller.document.flow.scope is EditScope.RANGE
    hands.press(Key.Key_Return)
    marked = [hands.row(track, frame)["visibility"] for frame in (59, 60, 67, 68)]
    assert marked == [before, 0, 0, after]
    hands.press(Key.Key_H, SHIFT)
    hands.press(Key.Key_Return)
    assert [hands.row(track, frame)["visibility"] for frame in (60, 61)] == [1, 0]


def test_a_new_person_is_drawn_and_selected_and_their_next_box_joins_the_first(hands):
    count = len(hands.people())
    hands.press(Key.Key_Insert)
    hands.press(Key.Key_Right, SHIFT)
    hands.press(Key.Key_Return)
    new = hands.controller.document.selection.track
    assert len(hands.people()) == count + 1
    assert hands.frames(new) == [CROWDED]
    hands.go(CROWDED + 5)
    hands.press(Key.Key_W)
    hands.press(Key.Key_Right, SHIFT)
    hands.press(Key.Key_Return)
    assert hands.frames(new) == list(range(CROWDED, CROWDED + 6))
    assert hands.row(new, CROWDED + 2)["source"] == Source.INTERPOLATED


def test_who_was_selected_is_so_again_when_nobody_new_is_drawn(hands, track):
    hands.press(Key.Key_Insert)
    assert hands.controller.document.selection.track == 0
    hands.press(Key.Key_Escape)
    assert hands.controller.document.selection.all == (track,)


def test_several_are_marked_as_reviewed_at_once(hands, track):
    other = next(one for one in hands.people() if one != track)
    hands.controller.editing.add(other)
    hands.press(Key.Key_Y)
    hands.press(Key.Key_Return)
    reviewed = hands.controller.document.session.labels
    assert reviewed.is_reviewed(track, CROWDED)
    assert reviewed.is_reviewed(other, CROWDED)


def test_the_nearest_person_is_the_first_that_tab_gives_a_swap(hands, track):
    nearest = hands.controller.document.correcting
    hands.press(Key.Key_X)
    others = nearest.flow.others
    assert set(others) == set(hands.people()) - {track}
    hands.press(Key.Key_Tab)
    assert nearest.flow.other == others[0]
    hands.press(Key.Key_Tab)
    assert nearest.flow.other == others[1]


def test_the_frames_found_for_a_swap_are_stepped_through(hands, track):
    hands.press(Key.Key_X)
    hands.press(Key.Key_Tab)
    flow = hands.controller.document.flow
    frames = [cut.frame for cut in flow.cuts]
    assert flow.cut == frames[0]
    hands.press(Key.Key_Down)
    assert hands.controller.document.flow.cut == frames[1 % len(frames)]
    hands.press(Key.Key_Up)
    assert hands.controller.document.flow.cut == frames[0]
    assert hands.controller.playback.clock.frame == frames[0]


def test_after_enter_the_keyboard_is_where_it_was_and_the_next_edit_one_key_away(hands, track):
    where = hands.window.focusWidget()
    for _ in range(2):
        hands.press(Key.Key_X)
        hands.press(Key.Key_Tab)
        hands.press(Key.Key_Return)
        assert hands.window.focusWidget() is where
    assert len(hands.controller.document.session.history) == 2
    hands.press(Key.Key_S)
    assert hands.controller.document.flow.spec is edits.SPLIT


def test_notes_are_reached_by_keys(hands, track):
    hands.press(Key.Key_F2, CTRL)
    hands.type("limps")
    hands.press(Key.Key_Escape)
    assert hands.controller.document.label(track).notes == "limps"


def _history(hands) -> list[str]:
    return [entry.text for entry in hands.controller.document.session.history]


def test_an_attribute_is_typed_whole_before_it_becomes_one_edit(hands, track):
    hands.press(Key.Key_F2, SHIFT)
    hands.type("bag")
    hands.press(Key.Key_Return)
    assert _history(hands) == []
    hands.type("yab")
    assert _history(hands) == []
    hands.press(Key.Key_Return)
    assert dict(hands.controller.document.label(track).attributes) == {"bag": "yab"}
    assert _history(hands) == [f"Set bag of {track} to yab"]
    assert hands.controller.document.flow is None
    assert hands.window.statusBar().currentMessage().startswith("Done")


def test_an_attribute_without_a_value_is_no_edit(hands, track):
    hands.press(Key.Key_F2, SHIFT)
    hands.type("bag")
    hands.press(Key.Key_Return)
    hands.press(Key.Key_Return)  # asks again
    hands.press(Key.Key_Escape)
    assert _history(hands) == []
    assert hands.window.workspace.card.findChild(AttributesTable).rowCount() == 0


def test_tab_goes_through_attributes_and_begins_another(hands, track):
    hands.press(Key.Key_F2, SHIFT)
    for typed in ("bag", "yes", "hat", "no"):
        hands.type(typed)
        hands.press(Key.Key_Tab)
    hands.press(Key.Key_Escape)
    assert dict(hands.controller.document.label(track).attributes) == {"bag": "yes", "hat": "no"}
    assert len(_history(hands)) == 2


def test_the_attribute_that_is_typed_is_seen(hands, track):
    hands.press(Key.Key_F2, SHIFT)
    table = hands.window.workspace.card.findChild(AttributesTable)
    field = hands.window.focusWidget()
    assert table.isAncestorOf(field)
    assert field.visibleRegion().boundingRect().height() > field.height() // 2


def test_letters_on_the_attributes_are_typed_also_between_the_cells(hands, track):
    hands.controller.editing.set_attributes(track, (("bag", "no"),))
    table = hands.window.workspace.card.findChild(AttributesTable)
    table.setFocus()
    table.setCurrentCell(0, 1)
    hands.type("y")
    hands.press(Key.Key_Return)
    assert dict(hands.controller.document.label(track).attributes) == {"bag": "y"}
    assert hands.controller.document.session.labels.reviewed == ()


def test_enter_in_the_frame_field_runs_no_command(hands):
    hands.press(Key.Key_G)
    hands.type("12")
    hands.press(Key.Key_Return)
    assert hands.controller.playback.clock.frame == 12
    assert hands.window.statusBar().currentMessage() == ""


def test_a_typed_id_is_shown_at_once_and_enter_does_it(hands, track):
    other = next(one for one in hands.people() if one != track)
    hands.press(Key.Key_X)
    hands.type(str(other))
    planned = hands.controller.document.correcting
    hands.qtbot.waitUntil(lambda: planned.flow is not None and planned.flow.other == other)
    assert hands.window.focusWidget() is hands.window.workspace.preview._other
    hands.press(Key.Key_Return)
    assert hands.controller.document.flow is None
    assert [entry.kind for entry in hands.controller.document.session.history] == ["swap"]


def test_an_id_nobody_has_shows_nothing_until_it_is_whole(hands, track):
    other = next(one for one in hands.people() if one != track)
    hands.press(Key.Key_X)
    hands.type(str(other))
    correcting = hands.controller.document.correcting
    hands.qtbot.waitUntil(lambda: correcting.flow.other == other)
    hands.type("99")
    hands.qtbot.waitUntil(lambda: correcting.flow.other == 0)
    field = hands.window.workspace.preview._other
    assert field.text() == f"{other}99"
    hands.press(Key.Key_Backspace)
    hands.press(Key.Key_Backspace)
    hands.qtbot.waitUntil(lambda: correcting.flow.other == other)


def test_of_several_selected_the_panel_names_all_and_what_can_be_done(hands, track):
    other = next(one for one in hands.people() if one != track)
    said = hands.window.workspace.card._several
    assert said.isHidden()
    hands.controller.editing.add(other)
    first, second = sorted((track, other))
    assert said.text().startswith(f"2 selected: {first}, {second}. You can swap or merge")
    assert said.isVisibleTo(hands.window)


def test_undoing_the_deletion_of_a_track_selects_it_again(hands, track):
    hands.press(Key.Key_Delete, CTRL)
    hands.press(Key.Key_Return)
    assert not hands.controller.document.selection
    hands.press(Key.Key_Z, CTRL)
    assert hands.controller.document.selection.all == (track,)
    hands.press(Key.Key_Z, CTRL | SHIFT)
    assert not hands.controller.document.selection


def test_a_name_typed_after_f2_was_refused_runs_no_command(hands):
    hands.press(Key.Key_Escape)
    before = len(hands.controller.document.session.history), hands.controller.view_options
    hands.press(Key.Key_F2)
    assert "select a person first" in hands.window.notice.text
    hands.type("Bow Xzs z")
    hands.press(Key.Key_Return)
    assert (len(hands.controller.document.session.history), hands.controller.view_options) == before
    assert hands.controller.document.flow is None
    assert not hands.controller.playback.clock.playing
    hands.press(Key.Key_Tab)  # Enter ended that: keys are commands again
    assert hands.controller.document.selection
    assert hands.window.notice.text == ""  # and what was told is over
