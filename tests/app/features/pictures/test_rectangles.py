"""Rectangles as arrays say what Qt's say."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QRectF

from app.core.drawing.rectangles import as_rect, beyond, coords, covers, within

SIDES = st.integers(1, 60)
RECTS = st.builds(QRectF, st.integers(-20, 120), st.integers(-20, 90), SIDES, SIDES)
AREA = QRectF(0, 0, 100, 70)


@given(st.lists(RECTS, min_size=1, max_size=6), st.lists(RECTS, max_size=6))
def test_they_lie_on_each_other_where_qts_do(rects, others):
    found = covers(coords(rects), coords(others))
    assert found.tolist() == [any(map(rect.intersects, others)) for rect in rects]


@given(st.lists(RECTS, min_size=1, max_size=6))
def test_what_is_not_inside_is_beyond_until_it_is_moved_within(rects):
    assert beyond(coords(rects), AREA).tolist() == [not AREA.contains(rect) for rect in rects]
    assert not beyond(coords([within(rect, AREA) for rect in rects]), AREA).any()


@given(RECTS)
def test_there_and_back_is_the_same(rect):
    assert as_rect(coords([rect])[0]) == rect
