"""Errors against a truth as stretches one walks through."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.scenes.error_events import events_of
from tracking.scoring import ErrorKind, ErrorTable, ScoringTable, errors


def table(*rows: tuple[int, int, float]) -> ScoringTable:
    """Boxes of 10 by 10 px: frame, track, left."""
    frame, track, left = (np.array(one) for one in zip(*rows, strict=True))
    ten = np.full(len(frame), 10.0)
    columns = {"frame": frame, "track": track, "left": left, "top": 0 * ten}
    return ScoringTable.from_columns(columns | {"width": ten, "height": ten})


@pytest.fixture
def events():
    """Person 1 is missed in frames 2 to 4 then found as 8; 9 is a false alarm in 3 to 6."""
    truth = table(*((frame, 1, 0.0) for frame in range(10)))
    found = [(frame, 7, 0.0) for frame in range(2)] + [(frame, 8, 0.0) for frame in range(5, 10)]
    result = table(*found, *((frame, 9, 90.0) for frame in range(3, 7)))
    return events_of(errors(truth, result))


def test_misses_of_one_person_in_a_row_are_one_stretch(events):
    misses = events.of_kinds([ErrorKind.MISS])
    assert [(int(misses.start[0]), int(misses.end[0]))] == [(2, 5)]
    assert misses.words() == ["person 1 is missed in frames 2 to 4"]


def test_each_kind_is_told_in_words(events):
    assert set(events.words()) == {
        "person 1 is missed in frames 2 to 4",
        "person 1 changes from track 7 to 8",
        "person 1 is found again as track 8",
        "track 9 is a false alarm in frames 3 to 6",
    }


def test_one_walks_from_first_frame_to_first_frame(events):
    assert [events.next_start(frame, 1) for frame in (0, 2, 3, 5)] == [2, 3, 5, None]
    assert [events.next_start(frame, -1) for frame in (9, 5, 2)] == [5, 3, None]
    assert set(events.beginning_at(5).tracks) == {7, 8}


@given(st.lists(st.tuples(st.integers(1, 3), st.integers(0, 12)), unique=True))
def test_stretches_hold_as_many_misses_as_there_are(missed: list[tuple[int, int]]) -> None:
    rows = np.array(sorted(missed, key=lambda one: one[1]), np.int64).reshape(-1, 2)
    count, nobody = len(rows), np.zeros(len(rows), np.int64)
    found = ErrorTable(
        kind=np.full(count, ErrorKind.MISS, np.uint8),
        frame=rows[:, 1],
        truth=rows[:, 0],
        result=nobody,
        earlier=nobody,
        earlier_frame=rows[:, 1],
        position=np.zeros((count, 2)),
        box=np.zeros((count, 4)),
    )
    events = events_of(found)
    assert int((events.end - events.start).sum()) == count
    assert sum(len(events.at(frame, frame + 1)) for frame in range(13)) == count
