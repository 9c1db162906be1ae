"""Overhead people and a truth are named beside each other."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from drawn_scenes import floor_person, overhead
from PySide6.QtCore import QPointF

from app.core.scenes.ground_truth import FlooredTruth, TruthPlace
from app.features.pictures import floor_name_painter
from app.features.pictures.overhead_view import OverheadView
from tracking.scoring import ErrorKind

HEAP = [(0.0, 5.0), (0.4, 5.1), (-0.3, 5.4), (0.1, 4.6)]


@pytest.fixture
def view(qtbot, theme):
    widget = OverheadView()
    qtbot.addWidget(widget)
    widget.resize(600, 600)
    return widget


def true_person(number: int, at: tuple[float, float], wrong: ErrorKind | None = None):
    return TruthPlace(np.array([at]), f"T{number}", wrong)


def show(view, places, truth) -> None:
    view.show_scene(overhead(*(floor_person(*one) for one in enumerate(places, 1))))
    view.show_truth(FlooredTruth(truth))
    view.grab()


def test_names_of_a_truth_and_of_tracks_at_the_same_places_lie_on_none_of_each_other(view):
    show(view, HEAP, tuple(true_person(*one) for one in enumerate(HEAP, 1)))
    people, truth = view._painter.naming.plates, view._painter.naming.truth_plates
    assert len(people) == len(truth) == len(HEAP)
    rects = [rect for _, rect in (*people, *truth)]
    assert not any(one.intersects(other) for one, other in combinations(rects, 2))


def test_a_name_of_the_truth_hides_no_ring_and_one_of_a_track_no_cross(view):
    crosses = [(x + 0.5, y + 0.2) for x, y in HEAP]
    show(view, HEAP, tuple(true_person(*one) for one in enumerate(crosses, 1)))
    rects = [rect for _, rect in (*view._painter.naming.plates, *view._painter.naming.truth_plates)]
    assert rects
    for at in (*HEAP, *crosses):
        middle = view.viewport.point(*at)
        assert not any(rect.contains(middle) for rect in rects)


def test_who_is_missed_is_named_before_anybody_who_is_found(view):
    crowd = [(x / 4, y / 4) for x in range(-20, 20) for y in range(40)]
    missed = true_person(9, (0.1, 5.1), ErrorKind.MISS)
    show(view, crowd, (true_person(8, (0.6, 5.1)), missed))
    assert [name for name, _ in view._painter.naming.truth_plates] == ["T9"]


def test_names_are_placed_once_for_a_picture_that_is_painted_again(view, monkeypatch):
    placed = []
    place = floor_name_painter.place_floor_names
    monkeypatch.setattr(
        floor_name_painter, "place_floor_names", lambda *it: placed.append(1) or place(*it)
    )
    scene = overhead(floor_person(1, (0, 5)))
    view.show_scene(scene)
    view.grab()
    view.grab()
    assert len(placed) == 1
    view.show_scene(replace(scene, frame=8))
    view.grab()
    view.zoom(2.0, QPointF(300, 300))
    view.grab()
    assert len(placed) == 3
