from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import BLUE, RED, person, picture
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor

from app.core.scenes import LegendEntry, PictureScene, PreviewTrail, Side
from app.core.scenes.ground_truth import PicturedTruth
from app.features.pictures.picture_view import PictureView

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def view(qtbot, theme):
    widget = PictureView(Side.LEFT)
    qtbot.addWidget(widget)
    widget.resize(640, 480)
    widget.show_scene(picture())
    widget.grab()
    return widget


def on_widget(view, x, y) -> QPoint:
    return view.viewport.point(x, y).toPoint()


def test_blue_green_red_pictures_are_shown_in_their_colours(view, drawn, near):
    view.show_scene(picture(bgr=(10, 100, 240)))
    assert near(drawn(view).pixelColor(320, 240), QColor(240, 100, 10))


def test_a_picture_outlives_the_array_it_came_from(view, drawn, near):
    scene = picture(bgr=(0, 0, 250))
    view.show_scene(scene)
    scene.image[:] = 0
    assert near(drawn(view).pixelColor(320, 240), QColor(250, 0, 0))


def test_boxes_are_drawn_in_their_track_colour(view, drawn, inked):
    view.show_scene(picture(person(1, (100, 80, 60, 100))))
    assert inked(drawn(view), on_widget(view, 100, 130), QColor(*RED))
    assert not inked(drawn(view), on_widget(view, 130, 130), QColor(*RED))


def test_predicted_boxes_are_dashed(view, drawn):
    def reds(predicted: bool) -> np.ndarray:
        view.show_scene(picture(person(1, (100, 80, 60, 100), predicted=predicted)))
        shot, top = drawn(view), on_widget(view, 100, 95)
        return np.array([shot.pixelColor(top + QPoint(0, y)).red() for y in range(120)])

    assert np.ptp(reds(False)) < 10
    assert np.ptp(reds(True)) > 50


def test_a_selected_person_glows(view, drawn):
    plain, glowing = (
        drawn(view).pixelColor(on_widget(view, 100, 130) - QPoint(4, 0))
        for selected in (False, True)
        if view.show_scene(picture(person(1, (100, 80, 60, 100), selected=selected))) is None
    )
    assert glowing.red() - glowing.green() > plain.red() - plain.green() + 20


def test_trails_fade_with_age(view, drawn):
    trail = np.column_stack([np.linspace(20, 300, 60), np.full(60, 40.0)])
    view.show_scene(picture(person(1, (280, 50, 20, 40), trail=trail)))
    shot = drawn(view)
    old, new = (shot.pixelColor(on_widget(view, x, 40)) for x in (40, 280))
    assert new.red() - new.green() > old.red() - old.green() + 50


def test_overlays_lie_over_the_picture(view, drawn, near):
    overlay = np.zeros((240, 320, 4), np.uint8)
    overlay[100:140, 100:140] = (0, 255, 0, 255)
    scene = picture()
    view.show_scene(PictureScene(Side.LEFT, 7, scene.image, overlay=overlay))
    shot = drawn(view)
    assert near(shot.pixelColor(on_widget(view, 120, 120)), QColor(0, 255, 0))
    assert near(shot.pixelColor(on_widget(view, 200, 120)), QColor(200, 200, 200))


def test_the_floor_grid_is_drawn_and_points_behind_the_camera_are_not(view, drawn):
    grid = np.array([[[0.0, 120.0], [319.0, 120.0]], [[np.nan, 0.0], [10.0, 10.0]]])
    dark = np.zeros((240, 320, 3), np.uint8)
    view.show_scene(PictureScene(Side.LEFT, 7, dark, grid=grid))
    rows = [drawn(view).pixelColor(320, y).lightness() for y in range(200, 280)]
    assert max(rows) > 40
    assert np.median(rows) == 0


def test_the_floor_grid_ends_where_the_picture_does(view, drawn):
    view.resize(640, 800)
    before = drawn(view)
    grid = np.array([[[160.0, -200.0], [160.0, 500.0]]])
    view.show_scene(PictureScene(Side.LEFT, 7, picture().image, grid=grid))
    after, x = drawn(view), on_widget(view, 160, 120).x()
    changed = {
        y
        for y in range(800)
        for dx in (-1, 0, 1)
        if before.pixel(x + dx, y) != after.pixel(x + dx, y)
    }
    assert changed
    top, bottom = (on_widget(view, 160, y).y() for y in (-0.5, 239.5))
    assert top - 1 <= min(changed)
    assert max(changed) <= bottom + 1


def test_an_edit_preview_shows_the_trail_before_wider_than_after(view, drawn, near):
    points = np.array([[50.0, 120.0], [270.0, 120.0]])
    trails = (PreviewTrail(points, RED, after=False), PreviewTrail(points, BLUE, after=True))
    view.show_scene(PictureScene(Side.LEFT, 7, picture().image, preview=trails))
    shot, middle = drawn(view), on_widget(view, 160, 120)
    assert near(shot.pixelColor(middle), QColor(*BLUE))
    below = [shot.pixelColor(middle + QPoint(dx, 3)) for dx in range(12)]
    assert any(one.red() > one.green() + 40 for one in below)


def test_without_a_picture_the_message_is_said(view, drawn):
    view.show_scene(PictureScene(Side.LEFT, 7, None))
    blank = drawn(view)
    view.show_scene(PictureScene(Side.LEFT, 7, None, message="Reading frame 7"))
    assert drawn(view) != blank


def test_a_message_over_a_picture_stands_on_a_plate(view, drawn, near, theme):
    view.show_scene(replace(picture(), message="Frame 8 cannot be read"))
    shot = drawn(view)
    rows = [shot.pixelColor(320, y) for y in range(440, 480)]
    assert min(abs(one.lightness() - theme.window.lightness()) for one in rows) < 50


def test_a_click_on_a_person_picks_them(view, qtbot):
    view.show_scene(picture(person(1, (20, 20, 40, 80)), person(2, (200, 60, 40, 80))))
    with qtbot.waitSignal(view.track_picked) as picked:
        qtbot.mouseClick(view, LEFT, pos=on_widget(view, 220, 100))
    assert picked.args == [2]


def test_a_click_on_a_name_picks_whose_it_is_also_over_somebody_else(view, drawn, qtbot):
    view.show_scene(picture(person(1, (100, 80, 60, 100)), person(2, (95, 30, 80, 60))))
    drawn(view)
    for track, plate in view._painter.naming.plates:
        with qtbot.waitSignal(view.track_picked) as picked:
            qtbot.mouseClick(view, LEFT, pos=plate.center().toPoint())
        assert picked.args == [track]
    assert len(view._painter.naming.plates) == 2


def test_of_people_over_each_other_the_nearest_is_picked(view, qtbot):
    view.show_scene(picture(person(1, (100, 60, 60, 120)), person(2, (130, 60, 60, 120))))
    with qtbot.waitSignal(view.track_picked) as picked:
        qtbot.mouseClick(view, LEFT, pos=on_widget(view, 135, 120))
    assert picked.args == [1]


def test_a_click_beside_all_people_picks_nobody_and_tells_the_pixel(view, qtbot, heard):
    view.show_scene(picture(person(1, (20, 20, 40, 80))))
    picked, clicked = heard(view.track_picked), heard(view.picture_clicked)
    qtbot.mouseClick(view, LEFT, pos=on_widget(view, 250, 200))
    assert picked == [0]
    assert clicked == [pytest.approx((250, 200), abs=0.5)]


def test_the_wheel_keeps_the_point_under_the_cursor(view, wheel):
    at = QPointF(150, 333)
    before = view.viewport.to_content(at)
    wheel(view, at, 3)
    after = view.viewport.to_content(at)
    assert view.viewport.scale > 2
    assert (after.x(), after.y()) == pytest.approx((before.x(), before.y()))


def test_dragging_pans_and_picks_nobody(view, qtbot):
    view.show_scene(picture(person(1, (100, 60, 60, 120))))
    view.zoom(2.0)
    start = on_widget(view, 130, 120)
    before = view.viewport.point(0, 0)
    with qtbot.assertNotEmitted(view.track_picked):
        qtbot.mousePress(view, LEFT, pos=start)
        qtbot.mouseMove(view, start + QPoint(20, 0))
        qtbot.mouseMove(view, start + QPoint(60, 30))
        qtbot.mouseRelease(view, LEFT, pos=start + QPoint(60, 30))
    moved = view.viewport.point(0, 0) - before
    assert (moved.x(), moved.y()) == (60, 30)


def test_a_double_click_fits_the_picture_again(view, wheel, qtbot):
    fitted = view.viewport
    wheel(view, QPointF(10, 10), 4)
    qtbot.mouseDClick(view, LEFT, pos=QPoint(300, 200))
    assert view.viewport == fitted


def test_a_fitted_picture_stays_fitted_when_the_widget_grows(view):
    view.resize(1280, 960)
    view.grab()
    assert view.viewport.scale == pytest.approx(4.0)


def _hidden_and_empty(view) -> tuple[bool, bool]:
    """Whether some of the picture is not seen, and whether some of the widget is empty."""
    place, area = view.viewport.rect(view.content()), QRectF(view.rect())
    inner = area.adjusted(0.01, 0.01, -0.01, -0.01)
    return not area.adjusted(-0.01, -0.01, 0.01, 0.01).contains(place), not place.contains(inner)


@pytest.mark.parametrize("corner", [QPoint(0, 0), QPoint(639, 0), QPoint(0, 479)])
def test_a_zoomed_picture_covers_its_pane_also_after_it_is_resized_to_and_fro(view, corner):
    view.zoom(3.0, QPointF(corner))
    for size in ((500, 480), (640, 300), (900, 700), (640, 480), (300, 480), (640, 480)):
        view.resize(*size)
        view.grab()
        assert _hidden_and_empty(view) == (True, False)


@pytest.mark.parametrize("size", [(1280, 960), (320, 240)])
def test_a_zoomed_picture_shows_the_same_part_when_the_pane_grows_or_shrinks(view, size):
    view.zoom(3.0, QPointF(200, 300))
    part = view.viewport.to_content(QPointF(0, 0)), view.viewport.to_content(QPointF(640, 480))
    view.resize(*size)
    view.grab()
    now = view.viewport.to_content(QPointF(0, 0)), view.viewport.to_content(QPointF(*size))
    for one, other in zip(part, now, strict=True):
        assert (other.x(), other.y()) == pytest.approx((one.x(), one.y()))


def test_somebody_at_the_edge_is_brought_into_view_without_ground_beside_them(view):
    view.show_scene(picture(person(1, (290, 190, 30, 50))))
    view.zoom(3.0, QPointF(0, 0))
    view.show_person(1)
    assert _hidden_and_empty(view) == (True, False)
    assert QRectF(view.rect()).contains(view.viewport.rect(QRectF(290, 190, 29, 49)))


def test_a_close_look_at_a_corner_shows_no_ground(view):
    view.show_close(QRectF(0, 0, 20, 20))
    assert _hidden_and_empty(view) == (True, False)


def test_a_zoomed_picture_cannot_be_dragged_off_its_pane(view, qtbot):
    view.zoom(2.0)
    qtbot.mousePress(view, LEFT, pos=QPoint(20, 20))
    for _ in range(2):
        qtbot.mouseMove(view, QPoint(630, 470))
    qtbot.mouseRelease(view, LEFT, pos=QPoint(630, 470))
    assert _hidden_and_empty(view) == (True, False)
    corner = view.viewport.point(-0.5, -0.5)
    assert (corner.x(), corner.y()) == pytest.approx((0, 0))


def test_zooming_out_at_an_edge_leaves_no_ground(view, wheel):
    wheel(view, QPointF(320, 240), 6)
    wheel(view, QPointF(639, 479), -3)
    assert _hidden_and_empty(view) == (True, False)
    wheel(view, QPointF(639, 479), -3)
    assert _hidden_and_empty(view) == (False, False)


@pytest.mark.parametrize("share", [0.2, 0.5, 0.8])
def test_who_stands_partly_outside_a_zoomed_picture_is_shown_whole(view, share):
    box = QRectF(140, 60, 40, 80)
    view.show_scene(picture(person(1, (140, 60, 40, 80))))
    view.zoom(2.0, QPointF(0, 0))
    edge = view.viewport.rect(box).right() - share * view.viewport.rect(box).width()
    view._viewport = view.viewport.moved(QPointF(view.width() - edge, 0))
    view.show_person(1)
    assert QRectF(view.rect()).contains(view.viewport.rect(box))
    seen = view.viewport
    view.show_person(1)
    assert view.viewport == seen  # seen whole: nothing moves


def test_people_are_named_under_the_cursor(view):
    view.show_scene(picture(person(4, (100, 60, 60, 120), label="4 red coat", predicted=True)))
    assert view.name_at(view.viewport.point(120, 100)) == "4 red coat (predicted)"
    assert view.name_at(view.viewport.point(300, 230)) == ""


def test_the_camera_is_told_to_screen_readers(view):
    view.show_scene(PictureScene(Side.RIGHT, 7, None))
    assert view.accessibleName() == "Right camera"


def test_the_one_camera_of_a_recording_is_not_called_a_camera(view):
    view.set_alone(True)
    assert view.accessibleName() == "Image"
    view.set_alone(False)
    assert view.accessibleName() == "Left camera"


def test_a_low_picture_explains_the_truth_where_no_floor_does(view, drawn):
    view.resize(320, 120)
    plain = drawn(view)
    truth = PicturedTruth(legend=(LegendEntry(RED, "truth"),))
    view.show_truth(truth)
    assert drawn(view) == plain
    view.show_truth(replace(truth, floor_tells=False))
    assert drawn(view) != plain
