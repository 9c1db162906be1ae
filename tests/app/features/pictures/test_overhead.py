from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import RED, floor_person, overhead
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QImage, QPainter

from app.core.drawing.particles import draw_particles, soft_dot
from app.core.look.theme import scaled_font
from app.core.scenes import LegendEntry, PreviewTrail
from app.core.scenes.flow_map import FlowScene
from app.core.scenes.ground_truth import FlooredTruth
from app.features.pictures.floor import nice_step
from app.features.pictures.floor_painter import person_radius
from app.features.pictures.overhead_view import OverheadView

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def view(qtbot, theme):
    widget = OverheadView()
    qtbot.addWidget(widget)
    widget.resize(600, 600)
    widget.show_scene(overhead())
    widget.grab()
    return widget


def test_forward_is_up_and_right_is_right(view):
    here, forward, right = (view.viewport.point(*at) for at in ((0, 0), (0, 1), (1, 0)))
    assert forward.y() < here.y()
    assert right.x() > here.x()


def test_a_click_picks_the_nearest_person(view, qtbot):
    view.show_scene(overhead(floor_person(3, (0, 5)), floor_person(4, (0.3, 5))))
    with qtbot.waitSignal(view.track_picked) as picked:
        qtbot.mouseClick(view, LEFT, pos=view.viewport.point(0.35, 5.05).toPoint())
    assert picked.args == [4]


def test_a_click_on_a_number_picks_whose_it_is(view, qtbot):
    view.show_scene(overhead(floor_person(3, (0, 5)), floor_person(4, (0, 5.02))))
    view.grab()
    spots = dict(view._painter.naming.plates)
    for track in (3, 4):
        with qtbot.waitSignal(view.track_picked) as picked:
            qtbot.mouseClick(view, LEFT, pos=spots[track].center().toPoint())
        assert picked.args == [track]


def test_a_click_on_the_empty_floor_tells_where_in_metres(view, qtbot, heard):
    view.show_scene(overhead(floor_person(3, (0, 5))))
    picked, clicked = heard(view.track_picked), heard(view.floor_clicked)
    qtbot.mouseClick(view, LEFT, pos=view.viewport.point(-3, 8).toPoint())
    assert picked == [0]
    assert clicked == [pytest.approx((-3, 8), abs=0.02)]


def test_the_wheel_keeps_the_metre_under_the_cursor(view, wheel):
    at = QPointF(420, 130)
    before = view.viewport.to_content(at)
    wheel(view, at, -2)
    wheel(view, at, 5)
    after = view.viewport.to_content(at)
    assert (after.x(), after.y()) == pytest.approx((before.x(), before.y()))


def test_particles_show_in_their_persons_colour_the_heavy_ones_stronger(view, drawn):
    scene = overhead(
        particles=np.array([[-2, 5], [2, 5]], np.float32),
        particle_colours=np.array([RED, RED], np.uint8),
        particle_weights=np.array([1.0, 0.05], np.float32),
    )
    view.show_scene(scene)
    shot = drawn(view)
    heavy, light = (shot.pixelColor(view.viewport.point(x, 5).toPoint()) for x in (-2, 2))
    assert heavy.red() > heavy.green() + 100
    assert heavy.red() - heavy.green() > 2 * (light.red() - light.green()) > 0


def test_where_particles_lie_over_each_other_the_heaviest_is_on_top(dark):
    image = QImage(20, 20, QImage.Format.Format_RGB32)
    image.fill(0)
    painter = QPainter(image)
    colours = np.array([(255, 0, 0), (0, 255, 0), (0, 0, 255)], np.uint8)
    weights = np.array([0.3, 1.0, 0.6], np.float32)
    draw_particles(painter, np.full((3, 2), 10.0), colours, weights, (20, 20), 1.5)
    painter.end()
    assert image.pixelColor(10, 10) == QColor(0, 255, 0)


def test_particles_outside_the_view_are_left_out(dark):
    image = QImage(20, 20, QImage.Format.Format_RGB32)
    image.fill(0)
    painter = QPainter(image)
    points = np.array([[-500.0, 4.0], [1e7, 3.0], [np.nan, 2.0]])
    white = np.full((3, 3), 255, np.uint8)
    draw_particles(painter, points, white, np.ones(3, np.float32), (20, 20), 1.5)
    painter.end()
    assert {image.pixel(x, y) for x in range(20) for y in range(20)} == {0xFF000000}


def test_a_dot_covers_its_area():
    area = sum(share * len(columns) for share, columns, _ in soft_dot(3.0))
    assert area == pytest.approx(np.pi * 9, rel=0.1)


def test_measured_positions_are_black_dots_with_a_light_rim(view, drawn):
    view.show_scene(overhead(measured=np.array([[1.0, 5.0]])))
    shot, at = drawn(view), view.viewport.point(1.0, 5.0).toPoint()
    assert shot.pixelColor(at).lightness() < 30
    rim = [shot.pixelColor(at + QPoint(dx, 0)).lightness() for dx in range(2, 6)]
    assert max(rim) > 140


def test_an_arrow_points_where_the_person_walks(view, drawn, theme, inked):
    view.show_scene(overhead(floor_person(1, (0, 5), velocity=(1.0, 0.0))))
    shot, at = drawn(view), view.viewport.point(0, 5).toPoint()
    assert all(inked(shot, at + QPoint(dx, 0), theme.track(RED)) for dx in range(18, 45))
    assert not any(inked(shot, at - QPoint(dx, 0), theme.track(RED)) for dx in range(18, 45))


def test_the_dashes_of_who_is_not_seen_stand_out_among_the_particles(view, drawn, theme, near):
    cloud = np.random.default_rng(1).normal((0, 5), 0.3, (9000, 2)).astype(np.float32)
    red = np.full((9000, 3), theme.track(RED).getRgb()[:3], np.uint8)
    person = floor_person(1, (0, 5), predicted=True)
    view.show_scene(
        overhead(person, particles=cloud, particle_colours=red, particle_weights=np.ones(9000))
    )
    shot, at, radius = drawn(view), view.viewport.point(0, 5), person_radius(view.viewport)
    round_it = np.linspace(0, 2 * np.pi, 200)
    ring = [
        shot.pixelColor((at + radius * QPointF(np.cos(one), np.sin(one))).toPoint())
        for one in round_it
    ]
    assert sum(near(one, theme.sunken) for one in ring) > 40
    assert sum(near(one, theme.track(RED)) for one in ring) > 40


def test_somebody_whose_velocity_is_unknown_is_drawn_without_an_arrow(view, drawn):
    view.show_scene(overhead(floor_person(1, (0, 5), velocity=(float("nan"), 0.0))))
    assert not drawn(view).isNull()


def test_trails_of_an_edit_have_the_colour_that_their_person_has_on_the_floor(
    view, drawn, theme, near
):
    pale, points = (250, 240, 120), np.array([[-3.0, 5.1], [3.0, 5.1]])
    view.show_scene(overhead(preview=(PreviewTrail(points, pale, after=True),)))
    at = view.viewport.point(0.13, 5.1).toPoint()
    assert near(drawn(view).pixelColor(at), theme.track(pale))


def test_the_field_of_view_is_softly_shaded(view, drawn):
    corners = np.array([[-4.0, 2.0], [4.0, 2.0], [4.0, 9.0], [-4.0, 9.0]])
    at = view.viewport.point(0.13, 5.13).toPoint()
    before = drawn(view).pixelColor(at)
    view.show_scene(overhead(field_of_view=corners))
    assert drawn(view).pixelColor(at) != before


def test_zooming_draws_the_floor_anew(view, wheel, drawn):
    before = drawn(view)
    wheel(view, QPointF(300, 300), 2)
    assert drawn(view) != before


def test_without_calibration_the_reason_is_said(view, drawn):
    floor = drawn(view)
    view.show_scene(overhead(message="No calibration: there are no metres to show."))
    assert drawn(view) != floor
    assert view.content() == QRectF()


def test_people_are_told_with_their_place_and_speed(view):
    view.show_scene(overhead(floor_person(3, (1.0, 5.0), velocity=(0.6, 0.8))))
    assert view.name_at(view.viewport.point(1, 5)) == "3 at 1.0, 5.0 m, 1.0 m/s"


@pytest.mark.parametrize(("least", "step"), [(0.7, 1.0), (1.0, 1.0), (1.1, 2.0), (0.03, 0.05)])
def test_grid_steps_are_one_two_or_five_times_a_power_of_ten(least, step):
    assert nice_step(least) == pytest.approx(step)


def test_the_floor_is_fitted_to_the_truth_while_that_is_shown(view):
    before = view.viewport
    view.show_truth(FlooredTruth(bounds=(-2.0, 3.0, 2.0, 14.0)))
    assert view.content() == QRectF(-5, 0, 10, 14)
    assert view.rect().contains(view.viewport.point(0, 14).toPoint())
    view.show_truth(FlooredTruth())
    assert view.viewport == before


def test_a_floor_that_was_zoomed_by_hand_is_not_fitted_to_the_truth(view, wheel):
    wheel(view, QPointF(420, 130), 2)
    before = view.viewport
    view.show_truth(FlooredTruth(bounds=(-2.0, 3.0, 2.0, 14.0)))
    assert view.viewport == before


def test_what_the_truths_marks_mean_is_told_above_what_the_flow_map_means(view, drawn):
    told = FlooredTruth(legend=(LegendEntry(RED, "truth"),))
    view.show_flow(FlowScene(0.0, 0.0, 1.0, np.zeros((0, 0, 4), np.uint8)))
    alone = lowest_red(drawn(view))
    view.show_truth(told)
    foot = lowest_red(drawn(view))
    other = (LegendEntry((0, 0, 255), "few"), LegendEntry((0, 255, 0), "many"))
    view.show_flow(FlowScene(0.0, 0.0, 1.0, np.zeros((0, 0, 4), np.uint8), legend=other))
    assert alone == -1
    assert 0 < lowest_red(drawn(view)) < foot - 20


def lowest_red(shot):
    """The lowest line with the legend's red at the left; -1 where there is none."""
    red = QColor(*RED).rgb()
    lines = range(shot.height())
    return max((y for y in lines for x in range(120) if shot.pixel(x, y) == red), default=-1)


def test_signs_on_the_floor_are_explained_where_they_are_seen(view, drawn):
    view.show_scene(overhead(floor_person(3, (0, 5))))
    explained = drawn(view)
    view.show_legend(False)
    assert drawn(view) != explained
    view.show_scene(overhead())
    empty = drawn(view)
    view.show_legend(True)
    assert drawn(view) == empty


def test_what_is_explained_hides_no_number_of_the_grid(view, drawn):
    view.show_scene(overhead(floor_person(3, (0, 5))))
    explained = drawn(view)
    view.show_legend(False)
    bare = drawn(view)
    metrics = QFontMetricsF(scaled_font(view.font(), 0.85))
    right, bottom = round(6 + metrics.horizontalAdvance("-10")), round(600 - 6 - metrics.height())
    where = [(x, y) for x in range(600) for y in range(600)]
    changed = [(x, y) for x, y in where if explained.pixel(x, y) != bare.pixel(x, y)]
    assert min(x for x, _ in changed) >= right
    assert max(y for _, y in changed) <= bottom


def test_beside_a_truth_people_are_explained_too_where_there_is_room(view, drawn):
    view.show_truth(FlooredTruth(legend=(LegendEntry(RED, "truth"),)))
    view.show_scene(overhead(floor_person(3, (0, 5))))
    both = drawn(view)
    view.show_legend(False)
    assert drawn(view) != both


def test_a_view_without_room_explains_nothing(view, drawn):
    view.show_scene(overhead(floor_person(3, (0, 5))))
    view.resize(300, 90)
    low = drawn(view)
    view.show_legend(False)
    assert drawn(view) == low


def test_arrows_and_trails_are_explained_too(view, drawn):
    def above(**walking):
        view.show_scene(overhead(floor_person(3, (4, 9.5), **walking)))
        view.show_legend(True)
        explained = drawn(view)
        view.show_legend(False)
        return highest_change(explained, drawn(view))

    alone = above()
    with_arrow = above(velocity=(1.0, 0.0))
    trail = np.array([[4.0, 9.0], [4.0, 9.5]])
    assert above(velocity=(1.0, 0.0), trail=trail) < with_arrow - 10
    assert with_arrow < alone - 10


def test_a_low_view_explains_what_is_guessed_least_easily(view, drawn):
    walker = floor_person(
        3, (4, 9.5), velocity=(1.0, 0.0), trail=np.array([[4.0, 9.0], [4.0, 9.5]])
    )
    view.show_scene(overhead(walker))
    view.resize(600, 230)
    explained = drawn(view)
    view.show_legend(False)
    assert highest_change(explained, drawn(view)) < 230


def highest_change(one, other):
    """The highest line in which two pictures differ; their height where they are the same."""
    lines, across = range(one.height()), range(one.width())
    differs = (y for y in lines if any(one.pixel(x, y) != other.pixel(x, y) for x in across))
    return next(differs, one.height())


def test_somebody_far_from_all_others_is_not_fitted_and_yet_brought_into_view(view):
    far = overhead(floor_person(3, (0, 5)), floor_person(4, (0, 40)))
    left, bottom, right, top = far.bounds
    view.show_scene(replace(far, all_bounds=(left, bottom, right, 41.0)))
    view.fit()
    assert view.content().top() + view.content().height() == top
    assert not view.rect().contains(view.viewport.point(0, 40).toPoint())
    view.show_person(4)
    assert view.rect().contains(view.viewport.point(0, 40).toPoint())
