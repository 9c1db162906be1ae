"""Annotating fast in the real window: box after box, copies, ghosts, suggestions, keys."""

import cv2
import numpy as np
import pytest
from correcting_window import CTRL, LEFT, NO_KEY, SHIFT, Hands, open_for_correcting
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel

from tracking.tracks import Source

Key = Qt.Key
ALT = Qt.KeyboardModifier.AltModifier
SIDES = ("left", "top", "width", "height")
FRAMES = 60


@pytest.fixture
def folder(tmp_path):
    """Six seconds of nothing, filmed by one camera."""
    folder = tmp_path / "one-camera"
    folder.mkdir()
    for number in range(FRAMES):
        picture = np.full((192, 256, 3), 40 + number, np.uint8)
        assert cv2.imwrite(str(folder / f"{number:03d}.png"), picture)
    (folder / "recording.toml").write_text(
        'format = 1\nname = "one camera"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    )
    return folder


@pytest.fixture
def hands(window, qtbot, folder) -> Hands:
    return Hands(window, open_for_correcting(window, qtbot, folder, 2), qtbot)


@pytest.fixture
def drawing(hands) -> Hands:
    hands.press(Key.Key_D, SHIFT)
    return hands


def _drag(hands, left: float, top: float = 20, width: float = 20, height: float = 60) -> None:
    view = hands.window.workspace.left
    hands.drag(
        view, view.viewport.point(left, top), view.viewport.point(left + width, top + height)
    )


def _shown(hands, frame: int) -> None:
    hands.qtbot.waitUntil(lambda: hands.controller.playback.number == frame)


def _box(hands, track: int, frame: int) -> list[float]:
    row = hands.row(track, frame)
    return [row[name] for name in SIDES]


def _said(hands) -> str:
    return hands.window.workspace.left._scene.message


def _suggested(hands) -> list[tuple[str, bool]]:
    return [(mark.label, mark.ghost) for mark in hands.window.workspace.left._suggested]


def _edits(hands) -> int:
    return len(hands.controller.document.session.history)


# box after box


def test_boxes_are_drawn_one_after_the_other_without_a_key_between_them(drawing):
    for left in (20, 80, 140):
        _drag(drawing, left)
    assert drawing.people(2) == [1, 2, 3]
    assert _box(drawing, 3, 2)[0] == pytest.approx(140, abs=1)


def test_in_another_frame_the_next_box_goes_on_with_who_is_selected_filled_between(drawing):
    _drag(drawing, 20)
    drawing.go(12)
    assert "Drag to draw 1" in _said(drawing)
    _drag(drawing, 120)
    assert drawing.people(12) == [1]
    assert _box(drawing, 1, 7)[0] == pytest.approx(70, abs=1)
    assert drawing.row(1, 7)["source"] == Source.INTERPOLATED
    assert drawing.row(1, 12)["source"] == Source.PERSON


def test_a_later_keyframe_drawn_over_what_was_interpolated_takes_both_sides_along(drawing):
    _drag(drawing, 20)
    drawing.go(12)
    _drag(drawing, 120)
    drawing.go(7)
    _drag(drawing, 20)
    assert drawing.people(7) == [1]
    assert _box(drawing, 1, 4)[0] == pytest.approx(20, abs=1)


def test_the_picture_says_whose_the_next_box_is(drawing):
    assert "a new person" in _said(drawing)
    _drag(drawing, 20)
    assert "a new person" in _said(drawing)  # theirs is drawn here
    drawing.press(Key.Key_W)
    assert "Drag to draw 1" in _said(drawing)
    _drag(drawing, 30)
    assert drawing.people(2) == [1]
    drawing.go(5)
    drawing.press(Key.Key_Insert)
    assert "a new person" in _said(drawing)
    _drag(drawing, 30)
    assert drawing.people(5) == [2]


def test_a_box_drawn_where_somebody_is_expected_is_theirs_and_elsewhere_a_new_person_s(drawing):
    _drag(drawing, 20)
    _drag(drawing, 140)
    drawing.go(7)
    assert "who is expected there, else 2" in _said(drawing)
    _drag(drawing, 30)
    assert drawing.people(7) == [1]
    assert drawing.controller.document.selection.track == 1
    assert "who is expected there, else a new person" in _said(drawing)
    _drag(drawing, 150)
    assert drawing.people(7) == [1, 2]
    assert "a new person" in _said(drawing)  # nobody is waited for any more
    _drag(drawing, 80)
    assert drawing.people(7) == [1, 2, 3]
    assert drawing.frames(1) == list(range(2, 8))


def test_a_box_of_a_new_person_is_theirs_wherever_it_lies(drawing):
    _drag(drawing, 20)
    drawing.go(7)
    drawing.press(Key.Key_Insert)
    _drag(drawing, 22)
    assert drawing.people(7) == [2]


def test_a_click_says_who_goes_on_and_escape_ends_drawing_first(drawing):
    _drag(drawing, 20)
    _drag(drawing, 80)
    view = drawing.window.workspace.left
    drawing.click(view, view.viewport.point(30, 50))
    drawing.go(4)
    assert "Drag to draw 1" in _said(drawing)
    drawing.press(Key.Key_Escape)
    assert not drawing.controller.document.correcting.mode.drawing
    assert drawing.controller.document.selection.track == 1
    assert _said(drawing) == ""


def test_escape_while_a_box_is_dragged_leaves_drawing_on_and_the_selection(drawing):
    _drag(drawing, 20)
    view = drawing.window.workspace.left
    start, end = view.viewport.point(80, 20), view.viewport.point(110, 90)
    drawing.drag(view, start, end, drop=False)
    drawing.press(Key.Key_Escape)
    QTest.mouseRelease(view, LEFT, NO_KEY, end.toPoint())
    assert drawing.people(2) == [1]
    assert drawing.controller.document.correcting.mode.drawing
    assert drawing.controller.document.selection.track == 1


def test_after_each_box_the_playhead_goes_on_as_far_as_was_chosen(drawing):
    drawing.window.run_command("tracks.step_10")
    assert "then 10 frames on" in _said(drawing)
    for left, frame in ((20, 2), (60, 12), (100, 22)):
        _shown(drawing, frame)
        _drag(drawing, left)
    assert drawing.controller.playback.clock.frame == 32
    assert drawing.frames(1) == list(range(2, 23))
    drawing.go(55)
    _drag(drawing, 20)
    assert drawing.controller.playback.clock.frame == FRAMES - 1


def test_each_box_is_undone_alone(drawing):
    _drag(drawing, 20)
    drawing.go(12)
    _drag(drawing, 120)
    drawing.press(Key.Key_Z, CTRL)
    assert drawing.frames(1) == [2]


# without a preview


def test_an_edit_of_one_person_is_done_at_once_where_that_is_wanted(drawing):
    _drag(drawing, 20)
    drawing.go(12)
    _drag(drawing, 120)
    drawing.press(Key.Key_P, SHIFT)
    drawing.go(8)
    drawing.press(Key.Key_Delete)
    assert drawing.controller.document.flow is None
    assert drawing.frames(1) == list(range(2, 8))
    drawing.press(Key.Key_Z, CTRL)
    assert drawing.frames(1) == list(range(2, 13))


def test_the_status_bar_says_that_edits_have_no_preview(drawing, qtbot):
    drawing.press(Key.Key_P, SHIFT)
    assert drawing.window.statusBar().currentMessage() == "Edits without preview"
    assert drawing.controller.work_text == "Edits without preview"
    drawing.press(Key.Key_P, SHIFT)
    assert drawing.window.statusBar().currentMessage() == "Edits are shown before they are done"
    assert drawing.controller.work_text == ""


def test_the_cross_begins_where_the_mouse_is_not_where_a_box_was_drawn_last(drawing, qtbot):
    _drag(drawing, 20)
    view = drawing.window.workspace.left
    drawing.press(Key.Key_Escape)
    drawing.press(Key.Key_Escape)
    _point(drawing, 200, 20)
    drawing.press(Key.Key_D, SHIFT)
    assert view._hover == view.pointed_at
    assert view.viewport.to_content(view._hover).x() == pytest.approx(200, abs=1)


@pytest.mark.parametrize("two", [False, True])
def test_edits_of_two_people_keep_the_preview_unless_they_are_meant_too(drawing, two):
    _drag(drawing, 20)
    _drag(drawing, 100)
    drawing.press(Key.Key_P, SHIFT)
    if two:
        drawing.window.run_command("tracks.two_at_once")
    drawing.window.run_command("tracks.none")
    drawing.press(Key.Key_X)
    view = drawing.window.workspace.left
    drawing.click(view, view.viewport.point(30, 50))
    assert (drawing.controller.document.flow is None) is two
    assert _box(drawing, 1, 2)[0] == pytest.approx(100 if two else 20, abs=1)


def test_an_id_that_is_still_typed_is_not_taken_for_another(drawing):
    for left in (20, 60, 100):
        _drag(drawing, left)
    drawing.window.run_command("tracks.two_at_once")
    drawing.window.run_command("tracks.none")
    drawing.press(Key.Key_X)
    drawing.type("1")
    assert drawing.controller.document.flow is not None
    drawing.press(Key.Key_Return)
    assert drawing.controller.document.flow is None


# copies and ghosts


def test_a_box_is_copied_and_put_in_another_frame(drawing):
    _drag(drawing, 20)
    drawing.press(Key.Key_C, CTRL)
    drawing.go(9)
    drawing.press(Key.Key_V, CTRL)
    assert _box(drawing, 1, 9) == _box(drawing, 1, 2)
    assert drawing.frames(1) == list(range(2, 10))


def test_a_box_put_while_nobody_is_selected_is_a_new_person_s(drawing):
    _drag(drawing, 20)
    drawing.press(Key.Key_C, CTRL)
    drawing.go(9)
    drawing.controller.editing.pick(0)
    drawing.press(Key.Key_V, CTRL)
    assert drawing.people(9) == [2]


def test_a_box_is_copied_onto_the_next_frames_whose_range_is_said_before(drawing):
    _drag(drawing, 20)
    drawing.press(Key.Key_B, CTRL)
    planned = drawing.controller.document.planned.scene
    assert (planned.frame, planned.end) == (2, 12)
    drawing.press(Key.Key_Right, CTRL)
    drawing.press(Key.Key_Return)
    assert drawing.frames(1) == list(range(2, 13))
    assert _box(drawing, 1, 12) == _box(drawing, 1, 2)


def test_the_ghost_of_the_last_box_is_shown_and_accepted_where_it_is(drawing):
    _drag(drawing, 20)
    assert _suggested(drawing) == []
    drawing.go(6)
    assert _suggested(drawing) == [("1 in frame 2", True)]
    drawing.press(Key.Key_Return, CTRL)
    assert _suggested(drawing) == []
    assert _box(drawing, 1, 6) == _box(drawing, 1, 2)
    assert _edits(drawing) == 2
    drawing.go(FRAMES - 1)
    assert _suggested(drawing) == []  # five seconds later nobody waits for them


def test_who_has_left_is_waited_for_no_more_until_they_are_drawn_again(drawing):
    _drag(drawing, 20)
    _drag(drawing, 140)
    drawing.go(6)
    assert _suggested(drawing) == [("1?", True), ("2 in frame 2", True)]
    _point(drawing, 30, 50)
    drawing.press(Key.Key_Backspace, SHIFT)
    assert _suggested(drawing) == [("2 in frame 2", True)]
    _point(drawing, 250, 180)
    drawing.press(Key.Key_Backspace, SHIFT)
    assert _suggested(drawing) == []
    _drag(drawing, 22)
    assert drawing.people(6) == [2]  # whoever is selected goes on, where nobody is waited for
    drawing.go(8)
    assert _suggested(drawing) == [("2 in frame 6", True)]
    drawing.press(Key.Key_Escape)
    drawing.press(Key.Key_Escape)
    drawing.press(Key.Key_Backspace, SHIFT)
    assert "No last box is shown" in drawing.window.statusBar().currentMessage()


# moved by keys


@pytest.mark.parametrize(
    ("key", "modifiers", "moved"),
    [
        (Key.Key_Left, CTRL | SHIFT, (-1, 0, 0, 0)),
        (Key.Key_Down, CTRL | SHIFT, (0, 1, 0, 0)),
        (Key.Key_End, CTRL | SHIFT, (10, 0, 0, 0)),
        (Key.Key_PageUp, CTRL | SHIFT, (0, -10, 0, 0)),
        (Key.Key_Right, ALT | SHIFT, (0, 0, 1, 0)),
        (Key.Key_Up, ALT | SHIFT, (0, 0, 0, -1)),
        (Key.Key_Home, ALT | SHIFT, (0, 0, -10, 0)),
        (Key.Key_PageDown, ALT | SHIFT, (0, 0, 0, 10)),
    ],
)
def test_the_selected_box_is_moved_and_resized_by_keys(drawing, key, modifiers, moved):
    _drag(drawing, 40)
    before = _box(drawing, 1, 2)
    drawing.press(key, modifiers)
    after = [b - a for a, b in zip(before, _box(drawing, 1, 2), strict=True)]
    assert after == pytest.approx(moved, abs=1e-4)
    drawing.press(Key.Key_Z, CTRL)
    assert _box(drawing, 1, 2) == before


def test_where_the_selected_person_has_no_box_a_key_says_so(drawing):
    _drag(drawing, 40)
    drawing.go(6)
    drawing.press(Key.Key_Left, CTRL | SHIFT)
    assert "no box in this frame" in drawing.window.statusBar().currentMessage()
    assert _edits(drawing) == 1


# suggestions


@pytest.fixture
def detected(window, qtbot, folder) -> Hands:
    """Two people walk to the right, four pixels a frame; a detector saw them in each."""
    rows = [
        f"{frame + 1},-1,{left + 1 + 4 * frame},{top + 1},20,60,0.9,-1,-1,-1"
        for frame in range(FRAMES)
        for left, top in ((4, 10), (30, 100))
    ]
    (folder / "det.txt").write_text("\n".join(rows) + "\n")
    hands = Hands(window, open_for_correcting(window, qtbot, folder, 2), qtbot)
    hands.press(Key.Key_D, SHIFT)
    qtbot.waitUntil(lambda: len(_suggested(hands)) == 2)
    return hands


def _point(hands, x: float, y: float) -> None:
    view = hands.window.workspace.left
    for near in (2, 0):  # a mouse that stands there already would not be told to move
        QTest.mouseMove(view, view.viewport.point(x + near, y).toPoint())
    hands.qtbot.wait(1)


def test_a_suggested_box_under_the_mouse_is_accepted_as_a_new_person(detected):
    _point(detected, 20, 40)
    detected.press(Key.Key_Return, SHIFT)
    assert _box(detected, 1, 2) == pytest.approx([12, 10, 20, 60])
    assert _suggested(detected) == [("", False)]  # the other one is still nobody's


def test_the_suggestion_beside_the_ghost_of_the_selected_person_is_accepted_by_a_key(detected):
    _point(detected, 20, 40)
    detected.press(Key.Key_Return, SHIFT)
    _point(detected, 250, 180)
    detected.go(6)
    assert ("1?", False) in _suggested(detected)
    detected.press(Key.Key_Return, SHIFT)
    assert _box(detected, 1, 6) == pytest.approx([28, 10, 20, 60])
    assert detected.row(1, 4)["source"] == Source.INTERPOLATED


def test_those_of_everybody_are_accepted_as_one_edit_and_the_playhead_goes_on(detected):
    for at in ((20, 40), (45, 130)):
        _point(detected, *at)
        detected.press(Key.Key_Return, SHIFT)
    detected.window.run_command("tracks.step_5")
    detected.go(6)
    _point(detected, 250, 10)
    for frame in (6, 11, 16):
        _shown(detected, frame)
        detected.press(Key.Key_Return, CTRL | SHIFT)
    assert detected.frames(1) == detected.frames(2) == list(range(2, 17))
    assert _box(detected, 2, 16) == pytest.approx([94, 100, 20, 60])
    assert _edits(detected) == 5


def test_where_no_suggestion_is_near_a_key_says_so_and_changes_nothing(detected):
    _point(detected, 250, 180)
    detected.press(Key.Key_Return, SHIFT)
    assert "point at one" in detected.window.statusBar().currentMessage()
    detected.press(Key.Key_Return, CTRL | SHIFT)
    assert "No suggested box" in detected.window.statusBar().currentMessage()
    assert detected.controller.document.session is None


def test_suggestions_are_shown_without_drawing_where_they_are_switched_on(detected):
    detected.press(Key.Key_Escape)
    assert _suggested(detected) == []
    detected.press(Key.Key_K, SHIFT)
    assert len(_suggested(detected)) == 2


def test_suggestions_are_accepted_by_keys_where_they_are_not_shown(detected):
    detected.press(Key.Key_Escape)
    assert _suggested(detected) == []
    _point(detected, 20, 40)
    detected.press(Key.Key_Return, SHIFT)
    assert _box(detected, 1, 2) == pytest.approx([12, 10, 20, 60])


def test_those_whose_track_of_a_tracker_ends_just_before_are_continued(detected):
    for at in ((20, 40), (45, 130)):
        _point(detected, *at)
        detected.press(Key.Key_Return, SHIFT)
    detected.press(Key.Key_Escape)
    table = detected.controller.document.session.tracks
    for track in (1, 2):
        rows = table.of_track(track)
        tracked = {**rows, "source": np.full_like(rows["source"], Source.TRACKER)}
        table.rewrite(rows, np.zeros((0, 4), np.int64), tracked)
    detected.go(3)
    detected.press(Key.Key_Return, CTRL | SHIFT)
    assert detected.people(3) == [1, 2]


def test_a_file_of_detections_that_cannot_be_read_is_told_of(window, qtbot, folder):
    (folder / "det.txt").write_text("no, numbers, here\n")
    hands = Hands(window, open_for_correcting(window, qtbot, folder, 2), qtbot)
    hands.press(Key.Key_D, SHIFT)
    qtbot.waitUntil(lambda: "det.txt" in window.notice._said)
    _drag(hands, 20)
    assert hands.people(2) == [1]


def test_marks_are_drawn_on_the_picture(detected, qtbot):
    before = detected.window.workspace.left.grab().toImage()
    _point(detected, 20, 40)
    detected.press(Key.Key_Return, SHIFT)
    detected.go(6)
    detected.controller.editing.pick(0)
    assert detected.window.workspace.left.grab().toImage() != before
    at = detected.window.workspace.left.viewport.point(28, 30)
    colour = detected.window.workspace.left.grab().toImage().pixelColor(QPointF(at).toPoint())
    assert colour.value() != 46  # not the picture's own grey: the suggestion's line


def test_the_status_bar_tells_how_much_was_done(drawing, qtbot):
    assert drawing.window.meter.text() == ""
    _drag(drawing, 20)
    drawing.go(12)
    _drag(drawing, 120)
    qtbot.waitUntil(lambda: drawing.window.meter.text().startswith("11 boxes"))


def test_a_passing_word_is_not_written_over_how_much_was_done(drawing, qtbot):
    window = drawing.window
    _drag(drawing, 20)
    qtbot.waitUntil(lambda: window.meter.text().startswith("1 box"))
    window.say("A passing word")
    higher = QLabel(window)
    higher.setFixedHeight(2 * window.statusBar().height())
    window.statusBar().addPermanentWidget(higher)  # which lays out the line anew
    QApplication.processEvents()
    assert higher.isVisible()
    assert not window.meter.isVisible()
    window.statusBar().clearMessage()
    assert window.meter.isVisible()
