"""Names overhead stand where they hide nobody."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from drawn_scenes import floor_person, overhead
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF

from app.features.pictures.floor_names import WantedName, discs, place_floor_names
from app.features.pictures.floor_painter import person_radius
from app.features.pictures.overhead_view import OverheadView

AREA = QRectF(0, 0, 400, 300)
RADIUS = 12.0
NONE = np.zeros((0, 2))


def named(*places, sizes=((30.0, 18.0),)):
    return [WantedName(track, at, sizes) for track, at in enumerate(places, 1)]


def placed(names, dots=NONE, before=None):
    rings = np.array([one.at for one in names]).reshape(-1, 2)
    seen = np.concatenate((discs(rings, RADIUS), discs(dots)))
    return place_floor_names(names, seen, RADIUS, AREA, before or {})


def apart(rect: QRectF, x: float, y: float) -> float:
    across = max(rect.left() - x, 0, x - rect.right())
    return float(np.hypot(across, max(rect.top() - y, 0, y - rect.bottom())))


PLACES = st.lists(st.tuples(st.floats(20, 380), st.floats(20, 280)), max_size=30)


@given(PLACES, PLACES)
def test_no_name_lies_on_a_ring_a_dot_another_name_or_beyond_the_view(people, dots):
    found = placed(named(*people), np.array(dots).reshape(-1, 2)).values()
    for one in found:
        assert AREA.contains(one.rect)
        assert all(apart(one.rect, x, y) >= RADIUS - 1e-6 for x, y in people)
        assert all(apart(one.rect, x, y) >= 3.0 - 1e-6 for x, y in dots)
    assert not any(one.rect.intersects(other.rect) for one, other in combinations(found, 2))


def test_who_stands_alone_has_the_name_at_the_upper_right():
    (only,) = placed(named((200, 150))).values()
    assert only.rect.left() == pytest.approx(200 + RADIUS + 3)
    assert only.rect.bottom() == pytest.approx(150 - RADIUS)


def test_a_name_without_room_is_shortened_before_it_is_left_out():
    wall = [(float(x), float(y)) for x in range(20, 400, 30) for y in (120, 180)]
    wall += [(140.0, 150.0), (260.0, 150.0)]
    names = named((200, 150), *wall, sizes=((120.0, 18.0), (16.0, 18.0)))
    assert placed(names)[1].size == 1


def test_a_name_stays_on_its_side_while_that_is_free():
    names = named((200, 150))
    assert placed(names)[1].side == 0
    assert placed(names, before={1: 3})[1].side == 3


def test_in_a_crowd_names_are_left_out_but_that_of_who_is_selected():
    crowd = [(float(x), float(y)) for x in range(0, 420, 14) for y in range(0, 320, 14)]
    names = named((203, 147), *crowd)
    assert not placed(names)
    names[0] = WantedName(1, names[0].at, names[0].sizes, must=True)
    assert list(placed(names)) == [1]


def test_a_name_overhead_hides_no_other_ring(qtbot, dark):
    view = OverheadView()
    qtbot.addWidget(view)
    view.resize(600, 600)
    view.show_scene(overhead(floor_person(12, (0, 5)), floor_person(2, (0.5, 5.45))))
    view.grab()
    ring = view.viewport.point(0.5, 5.45)
    assert len(view._painter.naming.plates) == 2
    for _, plate in view._painter.naming.plates:
        assert apart(plate, ring.x(), ring.y()) >= person_radius(view.viewport)
        assert view.rect().contains(QPointF(plate.center()).toPoint())
