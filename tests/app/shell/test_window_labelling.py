"""Labels given with keys and mouse in the real window."""

import pytest
from correcting_window import CROWDED, open_for_correcting
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest

from app.core.scenes.labels import Tool

Key = Qt.Key
_CTRL, _ALT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.AltModifier
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


@pytest.fixture
def labels(controller):
    return lambda: controller.document.session.labels


def _click(layer, x: float, y: float) -> None:
    """Click at shares of the layer's width and height."""
    QTest.mouseClick(layer, LEFT, pos=QPoint(int(x * layer.width()), int(y * layer.height())))


def _drag(layer, start: QPoint, end: QPoint) -> None:
    QTest.mousePress(layer, LEFT, pos=start)
    QTest.mouseMove(layer, end)
    QTest.mouseRelease(layer, LEFT, pos=end)


def _draw(layer, corners) -> None:
    for corner in corners:
        _click(layer, *corner)


TRIANGLE = ((0.3, 0.3), (0.5, 0.3), (0.4, 0.6))


def test_parts_are_said_to_be_on_off_or_unsure_by_one_key_each(
    window, controller, press, labels, qtbot
):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    for key in (Key.Key_4, Key.Key_5, Key.Key_6):
        press(key)
    said = [labels().parts[CROWDED, track, part].on_part for part in range(3)]
    assert said == [True, False, None]
    assert (
        controller.playback.clock.frame == CROWDED + 1
    )  # after the last part, on to the next frame
    qtbot.waitUntil(lambda: controller.playback.number == CROWDED + 1)
    press(Key.Key_8)
    press(Key.Key_4)
    assert labels().parts[CROWDED + 1, track, 1].on_part is True
    panel = window.workspace.labelling
    assert panel.isVisible()
    counts = {
        (part, answer): panel.parts._answers[part, answer].text().split()[-1]
        for part, answer in ((0, True), (1, True), (1, False), (2, None))
    }
    assert set(counts.values()) == {"1"}
    for _ in range(4):
        press(Key.Key_Z, _CTRL)
    assert len(labels().parts) == 0


def test_without_labels_the_parts_lie_in_the_box_from_head_to_feet(controller, press):
    press(Key.Key_Tab)
    press(Key.Key_1, _ALT)
    marks = controller.labelling._parts._marks
    row = controller.document.session.tracks.of_track(
        controller.document.selection.track, CROWDED, CROWDED + 1
    )
    tops = [mark.box[1] for mark in marks]
    assert [mark.part for mark in marks] == [0, 1, 2]
    assert tops == sorted(tops)
    assert tops[0] == row["top"][0]
    foot = marks[2].box[1] + marks[2].box[3]
    assert foot == pytest.approx(row["top"][0] + row["height"][0])
    assert not any(mark.given for mark in marks)


def test_a_part_is_dragged_to_its_place_and_drawn_anew(controller, press, labels):
    press(Key.Key_Tab)
    track = controller.document.selection.track
    press(Key.Key_1, _ALT)
    layer = controller.labelling._parts
    mark = next(one for one in layer._marks if one.part == 1)
    view = layer.canvas.viewport
    middle = view.point(mark.box[0] + mark.box[2] / 2, mark.box[1] + mark.box[3] / 2).toPoint()
    _drag(layer, middle, middle + QPoint(30, 0))
    moved = labels().parts[CROWDED, track, 1]
    assert moved.box[0] == pytest.approx(mark.box[0] + 30 / view.scale, abs=1.5 / view.scale)
    assert moved.box[2:] == pytest.approx(mark.box[2:])
    assert (moved.source, moved.on_part) == ("person", True)
    press(Key.Key_7)
    corner = view.point(2.0, 200.0).toPoint()
    _drag(layer, corner, corner + QPoint(40, 30))
    drawn = labels().parts[CROWDED, track, 0]
    assert drawn.box == pytest.approx((2.0, 200.0, 40 / view.scale, 30 / view.scale), abs=1.0)
    press(Key.Key_Backspace, _ALT)
    assert (CROWDED, track, 0) not in labels().parts


def test_a_click_beside_the_parts_selects_another_person(controller, press):
    press(Key.Key_Tab)
    press(Key.Key_1, _ALT)
    here = controller.document.tracks.of_frame(CROWDED)
    other = int(here["track"][-1])
    layer = controller.labelling._parts
    foot = layer.canvas.viewport.point(
        float(here["left"][-1] + here["width"][-1] / 2),
        float(here["top"][-1] + here["height"][-1] / 2),
    )
    QTest.mouseClick(layer, LEFT, pos=foot.toPoint())
    assert controller.document.selection.track == other
    assert controller.labelling.tool is Tool.PARTS


@pytest.mark.parametrize("closing", ["Enter", "double click", "first corner"])
def test_an_occluder_is_drawn_by_its_corners(controller, press, labels, closing):
    press(Key.Key_2, _ALT)
    layer = controller.labelling._shapes.on_picture
    _draw(layer, TRIANGLE)
    assert labels().occluders == ()
    if closing == "Enter":
        QTest.keyClick(layer, Key.Key_Return)
    elif closing == "double click":
        QTest.mouseDClick(layer, LEFT, pos=QPoint(10, 10))
    else:
        _click(layer, *TRIANGLE[0])
    (occluder,) = labels().occluders
    assert occluder.name == "occluder 1"
    first = layer.canvas.viewport.to_content(
        QPointF(int(0.3 * layer.width()), int(0.3 * layer.height()))
    )
    assert occluder.polygon[0] == pytest.approx((first.x(), first.y()))
    assert len(occluder.polygon) == 3


def test_a_corner_is_dragged_and_what_is_picked_is_taken_away(controller, press, labels):
    press(Key.Key_2, _ALT)
    layer = controller.labelling._shapes.on_picture
    _draw(layer, TRIANGLE)
    QTest.keyClick(layer, Key.Key_Enter)
    before = labels().occluders[0].polygon
    at = layer.canvas.viewport.point(*before[1]).toPoint()
    _drag(layer, at, at + QPoint(25, 10))
    after = labels().occluders[0].polygon
    assert (after[0], after[2]) == (before[0], before[2])
    scale = layer.canvas.viewport.scale
    assert after[1][0] == pytest.approx(before[1][0] + 25 / scale, abs=2 / scale)
    QTest.keyClick(layer, Key.Key_Delete)
    assert labels().occluders == ()
    press(Key.Key_Z, _CTRL)
    press(Key.Key_Z, _CTRL)
    assert labels().occluders[0].polygon == before


def test_esc_drops_what_is_half_drawn_and_then_leaves_the_tool(window, controller, press, labels):
    press(Key.Key_2, _ALT)
    layer = controller.labelling._shapes.on_picture
    _draw(layer, TRIANGLE)
    QTest.keyClick(layer, Key.Key_Backspace)
    QTest.keyClick(layer, Key.Key_Return)
    assert labels().occluders == ()  # two corners are no polygon
    QTest.keyClick(layer, Key.Key_Escape)
    assert controller.labelling.tool is Tool.OCCLUDERS
    QTest.keyClick(layer, Key.Key_Escape)
    assert controller.labelling.tool is None
    assert not layer.isVisible()
    assert not window.workspace.labelling.isVisible()
    press(Key.Key_2, _ALT)
    window.workspace.timeline.setFocus()
    press(Key.Key_Escape)  # also from elsewhere in the window
    assert controller.labelling.tool is None


def test_a_counting_line_has_its_forward_arrow_to_the_right_of_its_way(
    window, controller, press, labels
):
    press(Key.Key_3, _ALT)
    layer = controller.labelling._shapes.on_floor
    _click(layer, 0.3, 0.5)
    _click(layer, 0.7, 0.5)
    (line,) = labels().lines
    assert line.start[0] < line.end[0]
    (outline,) = window.workspace.overhead._labels.outlines
    tail, tip = outline.arrow
    assert tip[1] < tail[1]  # from left to right: forward is towards the camera
    seen = [one.name for one in window.workspace.left._labels.outlines]
    assert seen == ["line 1"]


def test_a_region_is_named_and_one_whose_edges_cross_is_refused(window, controller, press, labels):
    press(Key.Key_4, _ALT)
    layer = controller.labelling._shapes.on_floor
    _draw(layer, TRIANGLE)
    QTest.keyClick(layer, Key.Key_Return)
    drawn = window.workspace.labelling.drawn
    drawn._list.item(0).setText("waiting area")
    assert labels().regions[0].name == "waiting area"
    _draw(layer, ((0.6, 0.6), (0.8, 0.8), (0.8, 0.6), (0.6, 0.8)))
    QTest.keyClick(layer, Key.Key_Return)
    assert len(labels().regions) == 1
    assert "cross" in window.notice._text.text()
    assert drawn._list.count() == 1


def test_reviewed_ranges_are_listed_marked_and_unmarked(window, controller, press, labels, qtbot):
    press(Key.Key_5, _ALT)
    ranges = window.workspace.labelling.ranges
    ranges._first.setValue(10)
    ranges._last.setValue(19)
    ranges._all.click()
    assert [(one.track, one.start, one.end) for one in labels().reviewed] == [(0, 10, 20)]
    assert ranges._list.item(0).text() == "Everybody: frames 10 to 19"
    ranges._list.itemClicked.emit(ranges._list.item(0))
    assert controller.playback.clock.frame == 10
    ranges._list.setCurrentRow(0)
    ranges._unmark.click()
    assert labels().reviewed == ()


def test_no_more_than_a_second_is_proposed_as_reviewed_or_the_range_that_is_set(
    window, controller, press
):
    press(Key.Key_5, _ALT)
    ranges = window.workspace.labelling.ranges
    frame, fps = controller.playback.number, controller.document.recording.fps
    assert ranges._first.value() == frame
    assert (
        ranges._last.value()
        == min(frame + round(fps), controller.document.recording.frame_count) - 1
    )
    assert ranges._unmark.isHidden()
    controller.document.correcting.marked = (5, 9)
    controller.draw()
    assert (ranges._first.value(), ranges._last.value()) == (5, 8)


def test_a_click_where_a_tool_does_not_draw_is_answered(window, controller, press):
    said = []
    controller.labelling.said.connect(said.append)
    press(Key.Key_2, _ALT)
    window.workspace.right.picture_clicked.emit(5.0, 5.0)
    assert said == ["Occluders are drawn in the left image"]
    controller.labelling.leave()
    window.workspace.right.picture_clicked.emit(5.0, 5.0)
    assert len(said) == 1


def test_labels_can_be_hidden_and_an_edit_takes_over_from_a_tool(window, controller, press):
    press(Key.Key_2, _ALT)
    _draw(controller.labelling._shapes.on_picture, TRIANGLE)
    QTest.keyClick(controller.labelling._shapes.on_picture, Key.Key_Return)
    controller.labelling.leave()
    assert len(window.workspace.left._labels.outlines) == 1
    press(Key.Key_U)
    assert window.workspace.left._labels.outlines == ()
    press(Key.Key_Tab)
    press(Key.Key_2, _ALT)
    press(Key.Key_X)
    assert controller.document.flow is not None
    assert controller.labelling.tool is None
