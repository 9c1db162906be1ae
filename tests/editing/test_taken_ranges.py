"""Ranges taken as another person made them."""

import numpy as np
import pytest

from tracking.editing import apply_change, plan_delete, plan_put_box, plan_take_range
from tracking.errors import EditError
from tracking.tracks import Labels, TrackTable


@pytest.fixture
def two() -> tuple[TrackTable, TrackTable]:
    """The same person in frames 0 to 9, drawn farther right by the other one, who has a second."""
    tables = TrackTable(), TrackTable()
    for table, left in zip(tables, (10.0, 60.0), strict=True):
        for frame in (0, 9):
            box = (left + frame, 20.0, 30.0, 80.0)
            known = 1 if frame else None
            apply_change(table, Labels(), plan_put_box(table, known, frame, box))
    apply_change(tables[1], Labels(), plan_put_box(tables[1], None, 5, (200.0, 20.0, 30.0, 80.0)))
    return tables


def test_their_rows_of_the_range_stand_in_place_of_ours_under_our_id(two) -> None:
    ours, theirs = two
    was = ours.columns()
    change = plan_take_range(ours, {1: theirs.of_track(1), 7: theirs.of_track(2)}, 3, 6, "their.h5")
    assert str(change.text) == "Take 1 and 7 in frames 3 to 5 from their.h5"
    apply_change(ours, Labels(), change)
    lefts = ours.of_track(1)["left"].tolist()
    assert lefts == pytest.approx([10, 11, 12, 63, 64, 65, 16, 17, 18, 19])
    assert ours.of_track(7)["frame"].tolist() == [5]
    apply_change(ours, Labels(), change.inverse)
    for name, column in was.items():
        np.testing.assert_array_equal(ours.columns()[name], column)


def test_who_stands_nowhere_there_is_taken_out_and_what_is_the_same_is_refused(two) -> None:
    ours, theirs = two
    apply_change(theirs, Labels(), plan_delete(theirs, 1, 3, 6))
    change = plan_take_range(ours, {1: theirs.of_track(1)}, 3, 6, "their.h5")
    apply_change(ours, Labels(), change)
    assert ours.frames_of_track(1).tolist() == [0, 1, 2, 6, 7, 8, 9]
    with pytest.raises(EditError, match="says the same"):
        plan_take_range(ours, {1: theirs.of_track(1)}, 3, 6, "their.h5")
