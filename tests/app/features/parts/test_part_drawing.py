"""Particles and curves of parts are seen, each where it belongs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import person, picture
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF, QSizeF
from PySide6.QtGui import QImage, QPainter

from app.core.drawing.part_cards import leaders
from app.core.look.theme import contrast, current_theme
from app.core.plots.axis import TimeAxis
from app.core.plots.curves import whole_span
from app.core.scenes import Side
from app.core.scenes.part_curve import LaneScore, PartCurve
from app.core.scenes.pictured_parts import CardLine, PartBox, PartCard, PicturedParts, Verdict
from app.features.pictures import box_names, picture_painter
from app.features.pictures import picture_view as picture_view
from app.features.pictures.picture_view import PictureView
from app.features.timeline.lane_score import _ink, draw_score

FIRST, LAST = 40, 59
PURPLE = (110, 70, 180)


def pixels(image: QImage) -> np.ndarray:
    """(h, w, 3) of an image."""
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    flat = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return flat[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


@pytest.mark.parametrize("ground", [(0, 0, 0), (255, 255, 255), PURPLE[::-1]])
@pytest.mark.parametrize("close", [False, True])
def test_even_light_particles_are_seen_on_any_clothes_from_far_and_near(
    qtbot, dark, drawn, ground, close
):
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.resize(300, 240)
    view.show_scene(picture(bgr=ground))
    if close:
        middle = view.content().center()
        view.show_close(QRectF(middle.x() - 7, middle.y() - 7, 14, 14))
    without = pixels(drawn(view))
    middle = view.content().center()
    one = np.array([[middle.x(), middle.y()]])
    parts = PicturedParts(particles=one, weights=np.zeros(1, np.float32), colour=PURPLE)
    view.show_parts(parts)
    change = np.abs(pixels(drawn(view)) - without).max(axis=2)
    assert (change > 60).sum() >= 4
    view.show_parts(replace(parts, weights=np.ones(1, np.float32)))
    heavy = np.abs(pixels(drawn(view)) - without).max(axis=2)
    assert heavy.max() >= change.max()


def test_in_a_crowd_parts_of_one_hide_no_number_of_another(qtbot, dark, drawn, monkeypatch):
    plates = []
    draw = box_names.draw_plate
    monkeypatch.setattr(box_names, "draw_plate", lambda *it: (plates.append(it[1]), draw(*it)))
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.resize(640, 480)
    view.show_scene(picture(person(8, (100, 80, 60, 100), colour=PURPLE)))
    without = pixels(drawn(view))
    over = QRectF(view.viewport.to_content(plates[-1].center()), QSizeF(40, 40))
    parts = [PartBox(5, 0, over.getRect(), (255, 0, 0), True, False, "", chosen=True)]
    view.show_parts(PicturedParts(boxes=tuple(parts)))
    left, top, right, bottom = (
        round(side) for side in plates[-1].adjusted(2, 2, -2, -2).getCoords()
    )
    change = np.abs(pixels(drawn(view)) - without).max(axis=2)
    assert change.max() > 100
    assert change[top:bottom, left:right].max() < 40  # a plate is a little translucent


def test_cards_of_others_are_left_out_of_a_low_picture(qtbot, dark, monkeypatch):
    shown = []
    monkeypatch.setattr(picture_painter, "draw_cards", lambda _, cards, *__: shown.append(cards))
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.show_scene(picture())
    line = CardLine(0, "head: on", Verdict.ON, (10.0, 10.0, 8.0, 8.0))
    own = PartCard(1, PURPLE, (line,), selected=True)
    view.show_parts(PicturedParts(cards=(own, replace(own, track=2, selected=False))))
    for height in (700, 150):
        view.resize(400, height)
        view.grab()
    assert [[one.track for one in cards] for cards in (shown[0], shown[-1])] == [[1, 2], [1]]


@given(st.integers(0, 320), st.integers(0, 220))
def test_each_line_of_a_card_goes_straight_from_it_to_its_rectangle(left, top):
    parts = [QRectF(150 + 4 * at, 80 + 30 * at, 20, 26) for at in range(3)]
    card = QRectF(left, top, 170, 60)
    lines = leaders(card, parts, 16)
    assert len(lines) == sum(not card.intersects(part) for part in parts)
    for line in lines:
        middle = line.pointAt(0.5)
        assert card.contains(line.p1())
        assert not card.adjusted(0.5, 0.5, -0.5, -0.5).contains(middle)
        assert any(part.contains(line.p2()) for part in parts)
        assert not any(part.adjusted(1, 1, -1, -1).contains(line.p2()) for part in parts)


def test_lines_of_a_card_below_somebody_leave_it_upwards_not_at_the_edge_of_the_picture():
    head, torso = QRectF(150, 10, 20, 20), QRectF(145, 40, 30, 40)
    card = QRectF(30, 100, 170, 60)  # to the picture's right edge
    lines = leaders(card, (head, torso), 16)
    assert [line.p1() for line in lines] == [QPointF(156, 100), QPointF(164, 100)]
    assert [line.p2() for line in lines] == [QPointF(156, 30), QPointF(164, 80)]


@given(st.lists(st.floats(-50, 50), min_size=1))
def test_no_value_of_a_curve_lies_beyond_its_scale(values):
    low, high = whole_span([np.array([*values, np.nan])], (-1.0, 1.0))
    assert low <= min(values)
    assert high >= max(values)


def test_the_threshold_of_a_lane_runs_only_where_the_person_was_tracked(dark):
    frames = np.arange(FIRST, LAST + 1)
    no, low = np.zeros(len(frames), bool), np.full(len(frames), -1.5)
    curve = PartCurve(frames, low, low, low, no, no)
    image = QImage(1000, 20, QImage.Format.Format_RGB32)
    image.fill(0)
    painter = QPainter(image)
    axis = TimeAxis(0.0, 1000.0, 0.0, 100.0, 100)
    draw_score(painter, LaneScore(1, 0, curve), QRectF(0, 0, 1000, 20), axis, current_theme())
    painter.end()
    red = np.array(current_theme().danger.getRgb()[:3])
    dashes = np.flatnonzero((np.abs(pixels(image) - red).max(axis=2) < 40).any(axis=0))
    assert len(dashes)
    assert dashes.min() >= axis.x_of(FIRST) - 1
    assert dashes.max() <= axis.x_of(LAST + 1) + 1
    words = pixels(image)[:, : int(axis.x_of(FIRST)) - 2].any()
    assert words  # which part it is, before its curve


@pytest.mark.parametrize("part", [0, 1, 2])
def test_a_score_over_a_lane_is_read_in_both_looks(theme, part):
    assert contrast(_ink(theme, part), theme.sunken) >= 3.9
