"""Ids of a truth over the picture: they name who is missed and hide nobody else."""

from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QRectF

from app.core.drawing.truth_marks import IdPlate, shown_ids
from tracking.scoring import ErrorKind

AREA = QRectF(0, 0, 400, 300)


def _plate(number: int, x: float, y: float, wrong: ErrorKind | None = None) -> IdPlate:
    body = QRectF(x, y, 20, 60)
    return IdPlate(f"T{number}", QRectF(x, y + 61, 30, 16), body, wrong)


def test_people_who_stand_apart_are_all_named():
    shown = shown_ids([_plate(1, 10, 10), _plate(2, 100, 10)], AREA)
    assert [label for label, _ in shown] == ["T1", "T2"]


def test_of_two_behind_each_other_the_one_who_is_missed_is_named():
    plates = [_plate(1, 50, 50), _plate(2, 55, 55, ErrorKind.MISS)]
    assert [label for label, _ in shown_ids(plates, AREA)] == ["T2"]


@given(
    st.lists(
        st.tuples(st.integers(0, 350), st.integers(0, 200), st.sampled_from([None, ErrorKind.MISS]))
    )
)
def test_no_id_of_somebody_found_hides_anybody(places):
    plates = [_plate(number, *place) for number, place in enumerate(places)]
    by_label = {one.label: one for one in plates}
    shown = shown_ids(plates, AREA)
    assert {one.label for one in plates if one.wrong} <= {label for label, _ in shown}
    for label, rect in shown:
        if by_label[label].wrong is None:
            bodies = [one.body for one in plates if one.label != label]
            ids = [other for name, other in shown if name != label]
            assert not any(map(rect.intersects, [*bodies, *ids]))
