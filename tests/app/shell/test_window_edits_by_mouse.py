"""Every edit of tracks done in the real window with the mouse alone."""

import time
from statistics import median

import numpy as np
import pytest
from correcting_window import CROWDED, LEFT, NO_KEY, SHIFT, Hands, open_for_correcting
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolButton

from app.core.editing import EditScope
from app.core.scenes import Side
from tests.pace import pace
from tracking.tracks import Source


@pytest.fixture
def hands(window, qtbot, tiny_session) -> Hands:
    return Hands(window, open_for_correcting(window, qtbot, tiny_session), qtbot)


@pytest.fixture
def someone(hands) -> int:
    return hands.apart()


def _apply(hands) -> None:
    QTest.mouseClick(hands.window.workspace.preview._confirm, LEFT)


def _chip(hands, text: str) -> QToolButton:
    hands.qtbot.wait(5)
    chips = hands.window.workspace.preview.findChildren(QToolButton)
    return next(chip for chip in chips if chip.text() == text and chip.isVisible())


def test_a_swap_from_the_menu_of_a_picture_with_a_chip_for_the_other(hands, someone):
    view, other = hands.window.workspace.left, None
    hands.choose_in_menu(view, hands.box_on(someone).center(), "tracks.swap")
    other = hands.controller.document.flow.others[0]
    QTest.mouseClick(_chip(hands, str(other)), LEFT)
    cut = hands.controller.document.flow.cut
    before = hands.row(someone, cut), hands.row(other, cut)
    _apply(hands)
    after = hands.row(other, cut), hands.row(someone, cut)
    assert [row.get("left") for row in after] == [row.get("left") for row in before]


@pytest.mark.parametrize("where", ["overhead", "timeline", "right"])
def test_the_menu_of_every_view_is_about_who_was_clicked(hands, someone, where):
    view = hands.window.workspace
    if where == "overhead":
        hands.choose_in_menu(view.overhead, hands.place_on(someone), "tracks.end_here")
    elif where == "timeline":
        lane = hands.lane_of(someone)
        hands.choose_in_menu(view.timeline.area, lane, "tracks.end_here")
    else:
        hands.controller.set_cameras("both")
        hands.qtbot.wait(5)
        people = view.right._scene.people
        mark = next(person for person in people if person.track == someone)
        left, top, width, height = mark.box
        middle = view.right.viewport.point(left + width / 2, top + height / 2)
        hands.choose_in_menu(view.right, middle, "tracks.end_here")
    _apply(hands)
    assert max(hands.frames(someone)) == CROWDED - 1


def test_the_menu_of_a_person_is_whole_each_time_it_opens(hands, someone):
    overhead = hands.window.workspace.overhead
    for _ in range(3):
        hands.choose_in_menu(overhead, hands.place_on(someone), "tracks.delete_track")
        hands.window.menus.actions["tracks.none"].trigger()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        assert hands.controller.document.flow is None


def test_the_menu_key_over_the_timeline_is_about_who_is_selected(hands, someone):
    hands.controller.editing.pick(someone)
    area = hands.window.workspace.timeline.area
    nobodys = QPointF(30, area.height() - 4)
    hands.choose_in_menu(area, nobodys, "tracks.delete_track", by_key=True)
    assert hands.controller.document.flow.everybody == (someone,)


def test_a_new_id_is_given_by_its_chip_over_a_range_chosen_by_its_button(hands, someone):
    before = hands.frames(someone)
    hands.choose_in_menu(
        hands.window.workspace.overhead, hands.place_on(someone), "tracks.reassign"
    )
    new = hands.controller.document.session.tracks.highest_track + 1
    QTest.mouseClick(_chip(hands, f"new {new}"), LEFT)
    QTest.mouseClick(_chip(hands, "this range"), LEFT)
    flow = hands.controller.document.flow
    assert flow.scope is EditScope.RANGE
    _apply(hands)
    assert hands.frames(new) == [frame for frame in before if flow.cut <= frame < flow.end]


def test_a_box_is_moved_by_its_inside_and_resized_by_a_corner(hands, someone):
    view = hands.window.workspace.left
    hands.click(view, hands.box_on(someone).center())
    before, box = hands.row(someone, CROWDED), hands.box_on(someone)
    scale = view.viewport.scale
    hands.drag(view, box.center(), box.center() + QPointF(40, 0))
    moved = hands.row(someone, CROWDED)
    assert moved["left"] == pytest.approx(before["left"] + 40 / scale, abs=2 / scale)
    assert moved["width"] == pytest.approx(before["width"])
    assert moved["source"] == Source.PERSON
    assert moved["x"] != before["x"]  # the place on the floor goes with it
    box = hands.box_on(someone)
    hands.drag(view, box.topLeft(), box.topLeft() - QPointF(20, 30))
    larger = hands.row(someone, CROWDED)
    assert larger["height"] == pytest.approx(moved["height"] + 30 / scale, abs=2 / scale)
    assert larger["left"] + larger["width"] == pytest.approx(moved["left"] + moved["width"])
    assert len(hands.controller.document.session.history) == 2


def test_a_box_is_moved_at_once_though_nobody_or_somebody_else_is_selected(hands, someone):
    view, other = hands.window.workspace.left, hands.people()[0]
    for selected in (0, other if other != someone else hands.people()[1]):
        hands.controller.editing.pick(selected)
        hands.qtbot.wait(5)
        fitted, before, box = view.viewport, hands.row(someone, CROWDED), hands.box_on(someone)
        hands.drag(view, box.center(), box.center() + QPointF(20, 0))
        moved = hands.row(someone, CROWDED)
        by = 20 / view.viewport.scale
        assert moved["left"] == pytest.approx(before["left"] + by, abs=2 / view.viewport.scale)
        assert moved["width"] == pytest.approx(before["width"])
        assert hands.controller.document.selection.track == someone
        assert view.viewport == fitted


def test_a_move_that_waits_for_enter_is_not_lost_by_a_drag_on_somebody_else(hands, someone):
    view = hands.window.workspace.left
    other = next(one for one in hands.people() if one != someone)
    hands.controller.editing.pick(other)
    hands.press(Qt.Key.Key_V)
    hands.press(Qt.Key.Key_Right)
    view.zoom(2.0, hands.box_on(someone).center())
    flow, zoomed, start = (
        hands.controller.document.flow,
        view.viewport,
        hands.box_on(someone).center(),
    )
    hands.drag(view, start, start + QPointF(40, 0))
    assert hands.controller.document.flow == flow
    assert view.viewport != zoomed  # panned
    before = hands.row(other, CROWDED)
    hands.press(Qt.Key.Key_Return)
    assert hands.row(other, CROWDED)["left"] == before["left"] + 1


def test_a_move_that_waits_for_enter_is_not_lost_by_a_drag_over_the_floor(hands, someone):
    view = hands.window.workspace.overhead
    hands.controller.editing.pick(someone)
    hands.press(Qt.Key.Key_V)
    hands.press(Qt.Key.Key_Right)
    view.zoom(2.0, hands.place_on(someone))
    flow, zoomed, start = hands.controller.document.flow, view.viewport, hands.place_on(someone)
    before = hands.row(someone, CROWDED)
    hands.drag(view, start, start + QPointF(40, 0))
    assert hands.controller.document.flow == flow
    assert view.viewport != zoomed  # panned
    hands.press(Qt.Key.Key_Return)
    assert hands.row(someone, CROWDED)["left"] == before["left"] + 1


def test_escape_while_somebodys_box_is_dragged_leaves_it_where_it_was(hands, someone):
    view, row = hands.window.workspace.left, hands.row(someone, CROWDED)
    start = hands.box_on(someone).center()
    hands.drag(view, start, start + QPointF(40, 0), drop=False)
    hands.press(Qt.Key.Key_Escape)
    QTest.mouseRelease(view, LEFT, NO_KEY, (start + QPointF(80, 0)).toPoint())
    assert hands.row(someone, CROWDED) == row
    assert hands.controller.document.flow is None


def test_while_another_person_is_waited_for_a_drag_pans(hands, someone):
    view, row = hands.window.workspace.left, hands.row(someone, CROWDED)
    hands.choose_in_menu(view, hands.box_on(someone).center(), "tracks.swap")
    view.zoom(2.0, hands.box_on(someone).center())
    before, start = view.viewport, hands.box_on(someone).center()
    hands.drag(view, start, start + QPointF(40, 0))
    assert view.viewport != before
    assert hands.row(someone, CROWDED) == row


def test_dragging_beside_the_selected_box_pans_and_edits_nothing(hands, someone):
    view = hands.window.workspace.left
    view.zoom(2.0, hands.box_on(someone).center())
    hands.click(view, hands.box_on(someone).center())
    before = view.viewport
    corner = QPointF(view.rect().bottomRight()) - QPointF(12, 12)
    hands.drag(view, corner, corner - QPointF(60, 60))
    assert view.viewport != before
    assert not len(hands.controller.document.session.history)


def test_a_box_is_drawn_for_a_new_person(hands):
    view = hands.window.workspace.left
    hands.window.run_command("tracks.new")
    hands.qtbot.wait(5)
    start, end = view.viewport.point(100, 60), view.viewport.point(130, 140)
    QTest.mouseMove(view, start.toPoint())
    assert view.cursor().shape() is Qt.CursorShape.CrossCursor
    hands.drag(view, start, end)
    row = hands.row(hands.controller.document.selection.track, CROWDED)
    drawn = [row[name] for name in ("left", "top", "width", "height")]
    assert drawn == pytest.approx([100, 60, 30, 80], abs=1.5)
    assert np.isfinite(row["x"] + row["y"])
    assert hands.controller.document.flow is None


def test_a_person_dragged_over_the_floor_is_followed_in_both_cameras_until_dropped(hands, someone):
    view = hands.window.workspace
    hands.window.resize(1920, 1000)  # half a metre is more than a click there
    hands.controller.set_cameras("both")
    hands.qtbot.wait(100)  # until the images have their room
    before = _seen(view, someone)
    start, row = hands.place_on(someone), hands.row(someone, CROWDED)
    end = start + QPointF(0.5 * view.overhead.viewport.scale, 0)
    hands.drag(view.overhead, start, end, drop=False)
    during = _seen(view, someone)
    assert all(now[0] > was[0] for was, now in zip(before, during, strict=True))
    assert hands.row(someone, CROWDED) == row
    QTest.mouseRelease(view.overhead, LEFT, NO_KEY, end.toPoint())
    after = hands.row(someone, CROWDED)
    assert after["x"] == pytest.approx(row["x"] + 0.5, abs=0.05)
    assert after["source"] == Source.PERSON
    for now, was in zip(_seen(view, someone), during, strict=True):
        assert now == pytest.approx(was)


def test_the_boxes_of_a_dragged_person_lie_on_one_epipolar_line(hands, someone):
    controller, start = hands.controller, hands.row(someone, CROWDED)
    controller.dragging.grab_person(someone)
    controller.dragging.drag_person(start["x"] + 0.4, start["y"] + 0.3)
    state, pictures = controller.document.frame_state(CROWDED), controller.scenes.pictures
    frame, rectification = controller.playback.frame, controller.document.recording.rectification
    cameras = [
        pictures.scene(side, frame, state, controller.view_options)
        for side in (Side.LEFT, Side.RIGHT)
    ]
    left, right = (next(one.box for one in side.people if one.track == someone) for side in cameras)
    assert rectification is not None
    assert rectification.identity
    assert [right[1], right[3]] == pytest.approx([left[1], left[3]], abs=0.01)  # the same rows
    assert left[0] > right[0]


def test_escape_while_dragging_leaves_the_person_where_they_were(hands, someone):
    view, row = hands.window.workspace.overhead, hands.row(someone, CROWDED)
    start = hands.place_on(someone)
    hands.drag(view, start, start + QPointF(40, 0), drop=False)
    hands.press(Qt.Key.Key_Escape)
    QTest.mouseMove(view, (start + QPointF(80, 0)).toPoint())
    QTest.mouseRelease(view, LEFT, NO_KEY, (start + QPointF(80, 0)).toPoint())
    assert hands.row(someone, CROWDED) == row
    assert hands.controller.document.flow is None


def test_shift_and_click_select_several_in_all_views_who_are_deleted_together(hands):
    views, (a, b) = hands.window.workspace, hands.people()[:2]
    hands.click(views.overhead, hands.place_on(a))
    hands.click(views.timeline.area, hands.lane_of(b), SHIFT)
    selected = {p.track for p in views.left._scene.people if p.selected}
    lanes = {lane.track for lane in views.timeline.area._scene.lanes if lane.selected}
    assert selected == lanes == {a, b}
    hands.choose_in_menu(views.overhead, hands.place_on(a), "tracks.delete_track")
    _apply(hands)
    assert not set(hands.controller.document.session.tracks.track_ids) & {a, b}
    hands.window.run_command("edit.undo")
    assert set(hands.controller.document.session.tracks.track_ids) >= {a, b}


def test_several_are_merged_into_the_one_picked_first(hands):
    a, b, *_ = hands.people()
    hands.controller.editing.pick(a)
    hands.controller.editing.add(b)
    hands.window.run_command("tracks.merge")
    assert hands.controller.document.planned.scene.ready
    _apply(hands)
    assert b not in hands.controller.document.session.tracks
    assert a in hands.controller.document.session.tracks


def test_the_preview_shows_what_goes_zoomed_is_done(hands, someone):
    views = hands.window.workspace
    hands.choose_in_menu(views.overhead, hands.place_on(someone), "tracks.delete_frame")
    for scene in (views.left._scene, views.overhead._scene):
        assert someone not in [person.track for person in scene.people]
        assert [person.track for person in scene.ghosts] == [someone]
    hands.choose_in_menu(views.overhead, QPointF(5, 5), "tracks.none")
    assert someone in [person.track for person in views.left._scene.people]


def test_a_click_is_answered_in_a_moment(hands, someone):
    view, middle = hands.window.workspace.left, hands.box_on(someone).center()
    taken = []
    for _ in range(7):
        began_s = time.monotonic()
        QTest.mouseClick(view, LEFT, NO_KEY, middle.toPoint())
        lasted_s = time.monotonic() - began_s  # waiting for others counts, too
        taken.append(lasted_s / pace(time.monotonic))
        hands.controller.editing.pick(0)
    assert median(taken) < 6


def _seen(view, track: int) -> list[tuple[float, ...]]:
    """A person's box in the left and the right camera."""
    scenes = view.left._scene, view.right._scene
    return [next(p.box for p in scene.people if p.track == track) for scene in scenes]
