"""The views close up on who is concerned, and show all again, in the real window."""

from __future__ import annotations

import shutil
from contextlib import closing

import pytest
from correcting_window import open_for_correcting
from PySide6.QtCore import QPointF, QRectF, Qt

from app.core.projection.concern import CONCERNED, Concern, parts_concerned
from app.features.scoring.controller import ScoreController
from app.shell.files import Files
from tracking.editing import plan_delete
from tracking.session import Session

Key, SHIFT = Qt.Key, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def controller(window, qtbot, tiny_session):
    controller = open_for_correcting(window, qtbot, tiny_session)
    controller.set_cameras("both")
    qtbot.waitUntil(lambda: bool(controller.reviewing.queue.items))
    qtbot.waitUntil(lambda: window.menus.actions["review.next"].isEnabled())
    return controller


@pytest.fixture
def views(window):
    work = window.workspace
    return work.left, work.right, work.overhead


@pytest.fixture
def looked(controller, press, qtbot, views):
    """N, once the first item's frame is there and the views are close."""
    press(Key.Key_N)
    qtbot.waitUntil(lambda: all(view.is_close for view in views))
    return controller.reviewing.current


def _shows_people(view, marks):
    area = QRectF(view.rect())
    return marks and all(area.contains(view.viewport.rect(QRectF(*box))) for box in marks)


def test_n_closes_up_on_its_people_in_both_pictures_and_overhead(looked, views, controller):
    for view in views[:2]:
        boxes = [one.box for one in view._scene.people if one.track in looked.tracks]
        assert _shows_people(view, boxes)
        assert view.viewport.scale > _whole_scale(view) * 1.01
    floor = views[2]
    places = [p.position for p in floor._scene.people if p.track in looked.tracks]
    assert places
    assert all(QRectF(floor.rect()).contains(floor.viewport.point(*at)) for at in places)
    assert floor.viewport.scale > _whole_scale(floor)


def _whole_scale(view):
    area, content = view._area(), view.content()
    return min(area.width() / content.width(), area.height() / content.height())


def test_whoever_fills_the_image_is_not_shown_smaller_than_all_of_it(controller):
    recording = controller.document.recording
    width, height = recording.size
    rows = controller.document.tracks.of_frame(40)
    large = {name: rows[name][:1].copy() for name in CONCERNED}
    large["left"][:], large["top"][:] = -0.1 * width, 0.1 * height
    large["width"][:], large["height"][:] = 0.9 * width, 1.2 * height
    left, top, across, along = parts_concerned(recording, Concern(large, 40, 41)).left
    assert min(left, top) >= 0
    assert across <= width
    assert along <= height


def test_esc_goes_back_and_leaves_the_playhead(looked, views, press, controller):
    frame = controller.playback.clock.frame
    press(Key.Key_Escape)
    assert all(view._fitted and not view.is_close for view in views)
    assert controller.playback.clock.frame == frame


def test_show_the_whole_image_goes_back(looked, views, window):
    window.run_command("view.whole")
    assert all(view._fitted and not view.is_close for view in views)


def test_another_frame_farther_away_shows_all_again(looked, views, controller):
    frames, fps = controller.playback.clock.frame_count, controller.playback.clock.fps
    far = frames - 1 if looked.end + fps < frames - 1 else 0
    assert not looked.start - fps <= far < looked.end + fps
    controller.playback.go(far)
    assert all(view._fitted for view in views)


def test_the_view_a_user_had_comes_back_and_one_changed_meanwhile_stays(
    controller, views, press, qtbot
):
    left, right, _ = views
    left.zoom(2.0)
    before = left.viewport
    press(Key.Key_N)
    qtbot.waitUntil(lambda: left.is_close and right.is_close)
    right.zoom(1.5, QPointF(20, 20))
    own = right.viewport
    press(Key.Key_Escape)
    assert left.viewport.scale == pytest.approx(before.scale)
    assert left.viewport.origin_x == pytest.approx(before.origin_x)
    assert right.viewport == own


def test_the_last_decision_shows_all_again(looked, views, press, controller, qtbot):
    for _ in range(len(controller.reviewing.queue.open)):
        press(Key.Key_Z)
    assert controller.reviewing.current is None
    assert all(view._fitted for view in views)


def test_undoing_a_decision_closes_up_on_its_people_again(looked, views, press, qtbot, controller):
    press(Key.Key_Backspace)
    press(Key.Key_Escape)
    assert not controller.close_up.active
    press(Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert controller.reviewing.current == looked
    assert controller.close_up.active


def test_it_can_be_switched_off_and_that_is_kept(controller, window, press, views, qtbot):
    window.run_command("view.close_up")
    press(Key.Key_N)
    qtbot.waitUntil(lambda: controller.playback.number == controller.playback.clock.frame)
    assert all(view._fitted for view in views)
    files: Files = window.files
    path = controller.document.session.path
    files.close_without_asking()
    files.open_path(path)
    qtbot.waitUntil(lambda: window.controller is not None)
    assert not window.controller.view_options.close_up


def test_f4_closes_up_on_who_the_error_is_about(controller, press, qtbot, views):
    press(Key.Key_S, SHIFT)
    scoring = controller.of(ScoreController)
    qtbot.waitUntil(lambda: not scoring._search.busy and scoring.known)
    controller.playback.go(0)
    press(Key.Key_F4)
    qtbot.waitUntil(lambda: controller.playback.number == controller.playback.clock.frame)
    frame = controller.playback.number
    wanted = scoring.presenter.concern_at(frame)
    assert len(wanted.rows["track"])
    assert views[0].is_close
    boxes = zip(*(wanted.rows[n].tolist() for n in ("left", "top", "width", "height")), strict=True)
    content = views[0].content()
    assert all(
        QRectF(views[0].rect())
        .adjusted(-1, -1, 1, 1)
        .contains(views[0].viewport.rect(QRectF(*box).intersected(content)))
        for box in boxes
    )


def test_differences_close_up_on_their_people_and_all_is_shown_once_they_are_left(
    shifted_controller, tiny_run, qtbot, views
):
    session = shifted_controller.document.session
    session.add_run(tiny_run, adopt=False)
    shifted_controller.comparing.open(1, 0)
    qtbot.waitUntil(lambda: shifted_controller.close_up.active)
    qtbot.waitUntil(lambda: views[0].is_close)
    shifted_controller.comparing.close()
    assert not views[0].is_close


def test_what_two_annotators_disagree_about_is_closed_up_on(
    controller, window, qtbot, tiny_session, tmp_path, views
):
    path = tmp_path / "ann.h5"
    shutil.copy(tiny_session, path)
    with closing(Session.open(path)) as session:
        track = session.tracks.of_frame(60)["track"].tolist()[0]
        session.apply(plan_delete(session.tracks, track, 60, 70))
        session.save()
    window.files.beside.compare_with(path)
    qtbot.waitUntil(lambda: window.workspace.compare.isVisible())
    row = window.workspace.compare._model.rows[0]
    window.files.beside._go(row.frame, row.track)
    qtbot.waitUntil(lambda: views[0].is_close)
