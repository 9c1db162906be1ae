from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from drawn_scenes import RED, person, picture
from hypothesis import example, given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QFont, QFontMetricsF

from app.core.drawing.name_places import Name, place_names, place_plates
from app.core.drawing.name_plates import plate_rect, plate_text
from app.core.look.theme import contrast, ink_on
from app.core.scenes import Side
from app.features.pictures import box_names
from app.features.pictures.picture_view import PictureView

AREA = QRectF(0, 0, 800, 600)
CORNERS = st.tuples(st.floats(-50, 850), st.floats(-50, 650))


def overlapping(plates: list[QRectF]) -> int:
    return sum(one.intersects(other) for one, other in combinations(plates, 2))


@given(st.lists(CORNERS, max_size=15))
@example([(0.0, 562.5), (0.0, 563.0)])  # there is room for the second one only half a pixel lower
def test_fifteen_plates_never_overlap_and_stay_inside(corners):
    plates = place_plates([QRectF(x, y, 60, 18) for x, y in corners], AREA)
    assert overlapping(plates) == 0
    assert all(AREA.contains(plate) for plate in plates)


def test_a_plate_that_is_free_is_left_where_it_is():
    wanted = [QRectF(10, 10, 50, 18), QRectF(10, 100, 50, 18)]
    assert place_plates(wanted, AREA) == wanted


def test_of_two_at_one_place_the_first_stays():
    first, second = place_plates([QRectF(10, 100, 50, 18)] * 2, AREA)
    assert first.top() == 100
    assert abs(second.top() - 100) == pytest.approx(20)


def test_where_there_is_no_room_plates_overlap_rather_than_vanish():
    plates = place_plates([QRectF(0, 0, 50, 18)] * 9, QRectF(0, 0, 50, 40))
    assert len(plates) == 9


def test_the_usual_side_is_taken_of_the_first_size_that_has_one_free():
    sides = np.arange(24.0).reshape(2, 3, 4) * 30.0
    closed = np.array([[True, True, True], [True, False, False]])
    for usual, side in ((2, 2), (0, 1)):
        (stands,) = place_names([Name(sides, closed, usual=usual)], AREA)
        assert (stands.size, stands.side) == (1, side)
    assert place_names([Name(sides[:1], closed[:1])], AREA) == [None]


def test_a_name_stands_where_it_rather_does_not_before_it_is_left_out_and_gives_way_to_none():
    sides = np.array([[[0.0, 0.0, 20.0, 10.0]]])
    rather_not = Name(sides, np.zeros((1, 1), bool), np.ones((1, 1), bool))
    first, second = place_names([rather_not, rather_not], AREA)
    assert first.rect == QRectF(0, 0, 20, 10)
    assert second is None


def test_a_crowd_at_one_spot_has_a_plate_each(qtbot, dark, drawn):
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.resize(640, 480)
    crowd = [person(track, (150, 100, 30, 90), label=f"{track} name") for track in range(1, 6)]
    view.show_scene(picture(*crowd))
    metrics = QFontMetricsF(view.font())
    wanted = [plate_rect(metrics, one.label, view.viewport.point(150, 100)) for one in crowd]
    assert overlapping(place_plates(wanted, QRectF(view.rect()))) == 0
    assert not drawn(view).isNull()


@given(st.tuples(*[st.integers(0, 255)] * 3))
def test_a_plate_is_readable_in_any_colour(colour):
    ground = QColor(*colour)
    assert contrast(ink_on(ground), ground) >= 4.3


def test_red_plates_take_the_better_of_black_and_white():
    assert ink_on(QColor(*RED)).lightness() > 200


@pytest.mark.usefixtures("qtbot")
def test_a_long_name_is_cut_at_its_end_and_a_short_one_is_not():
    metrics = QFontMetricsF(QFont())
    cut = plate_text(metrics, "3 Bob Mueller with a very long name indeed")
    assert cut.startswith("3 Bob M")
    assert cut.endswith("\u2026")
    assert plate_rect(metrics, cut, QPointF()).width() < 18 * metrics.averageCharWidth() + 10
    assert plate_text(metrics, "3 Bob") == "3 Bob"


def test_who_is_out_of_sight_has_no_plate_at_the_edge(qtbot, monkeypatch):
    drawn = []
    monkeypatch.setattr(box_names, "draw_plate", lambda *it: drawn.append(it[2]))
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.resize(640, 480)
    view.show_scene(picture(person(1, (10, 10, 20, 60)), person(2, (250, 150, 20, 60))))
    view.show_close(QRectF(250, 150, 20, 60))
    view.grab()
    assert drawn == ["2"]
