"""What a run would change, told before it is taken."""

from __future__ import annotations

import numpy as np
import pytest
from runs_of_people import FPS, Walk, rows_of, run_of, table_of

from tests.pace import spent
from tracking.editing import (
    Difference,
    History,
    apply_change,
    compare_runs,
    differences,
    plan_take,
)
from tracking.errors import CancelledError
from tracking.tracks import Labels, ReviewedRange, TrackTable

TWO = [(1, 0, 100, 0.0), (2, 0, 100, 1.0)]


def told(
    table: TrackTable, again: list[Walk], known: int = 2, reviewed: tuple[ReviewedRange, ...] = ()
) -> tuple[Difference, ...]:
    labels = Labels(reviewed=reviewed)
    run = run_of(again, (20, 120), known)
    return differences(table, labels, History(), run, None, fps=FPS)


def only(table: TrackTable, again: list[Walk], known: int = 2) -> Difference:
    (one,) = told(table, again, known)
    assert not one.protected
    return one


def facts(one: Difference) -> tuple[str, int, int, int, int, int]:
    return one.kind, one.track, one.other, one.start, one.end, one.rows


def test_the_same_people_a_hand_aside_are_no_difference():
    assert told(table_of(TWO), [(1, 20, 100, 0.2), (2, 20, 100, 1.2)]) == ()


def test_somebody_who_stands_elsewhere():
    away = [(1, 20, 50, 0.0), (1, 50, 60, 3.0), (1, 60, 100, 0.0), (2, 20, 100, 1.0)]
    one = only(table_of(TWO), away)
    assert facts(one) == ("moved", 1, 0, 50, 60, 10)
    assert one.text == "1 stands elsewhere for 0.5 s, by up to 3.0 m"


def test_two_who_change_over():
    after = [(1, 20, 60, 0.0), (1, 60, 100, 1.0), (2, 20, 60, 1.0), (2, 60, 100, 0.0)]
    one = only(table_of(TWO), after)
    assert facts(one) == ("identity", 1, 2, 60, 100, 80)
    assert one.tracks == (1, 2)
    assert one.text == "1 and 2 are swapped from frame 60 on"


def test_two_who_change_over_and_back():
    swapped = [(1, 20, 50, 0.0), (1, 50, 80, 1.0), (1, 80, 100, 0.0)]
    swapped += [(2, 20, 50, 1.0), (2, 50, 80, 0.0), (2, 80, 100, 1.0)]
    assert only(table_of(TWO), swapped).text == "1 and 2 are swapped in frames 50 to 79"


def test_somebody_who_becomes_another():
    table = table_of([*TWO, (3, 60, 100, 2.0)])
    again = [(1, 20, 100, 0.0), (2, 20, 100, 1.0), (3, 60, 80, 2.0), (4, 80, 100, 2.0)]
    one = only(table, again, known=3)
    assert facts(one) == ("identity", 3, 4, 80, 100, 20)
    assert one.text == "3 becomes new track 4 from frame 80 on"


def test_somebody_followed_longer():
    table = table_of([(1, 0, 56, 0.0), (2, 0, 100, 1.0)])
    one = only(table, [(1, 20, 120, 0.0), (2, 20, 100, 1.0)])
    assert facts(one) == ("added", 1, 0, 56, 120, 64)
    assert one.text == "1 is tracked 3.2 s longer"


@pytest.mark.parametrize(
    ("before", "after", "text"),
    [
        ([], [(3, 40, 60, 2.0)], "3 is a new track of 1.0 s"),
        ([(3, 60, 100, 2.0)], [(3, 40, 100, 2.0)], "3 is found 1.0 s earlier"),
        (
            [(3, 0, 40, 2.0), (3, 60, 100, 2.0)],
            [(3, 20, 100, 2.0)],
            "3 is found for 1.0 s where it had a gap",
        ),
        ([(3, 0, 100, 2.0)], [(3, 20, 80, 2.0)], "3 ends 1.0 s earlier"),
        ([(3, 0, 100, 2.0)], [(3, 40, 100, 2.0)], "3 is found 1.0 s later"),
        ([(3, 40, 60, 2.0)], [], "3 is not found, for 1.0 s"),
        ([(3, 0, 100, 2.0)], [(3, 20, 50, 2.0), (3, 70, 100, 2.0)], "3 is lost for 1.0 s"),
    ],
)
def test_rows_more_and_rows_less(before: list[Walk], after: list[Walk], text: str):
    walks = [(1, 20, 100, 0.0), (2, 20, 100, 1.0), *after]
    assert only(table_of([*TWO, *before]), walks, known=max(2, len(before) and 3)).text == text


def test_without_a_frame_rate_frames_are_counted():
    run = run_of([*TWO, (3, 40, 60, 2.0)], (0, 100), known=2)
    (one,) = differences(table_of(TWO), Labels(), History(), run, None)
    assert one.text == "3 is a new track of 20 frames"


def test_what_is_protected_is_told_apart():
    away = [(1, 20, 100, 3.0), (2, 20, 100, 1.0)]
    found = told(table_of(TWO), away, reviewed=(ReviewedRange(1, 50, 60),))
    assert [(one.start, one.end, one.protected) for one in found] == [
        (20, 50, False),
        (50, 60, True),
        (60, 100, False),
    ]


def test_two_runs_are_compared_in_the_ids_of_the_first():
    first = run_of(TWO, (0, 100))
    second = run_of([(2, 0, 100, 0.0), (1, 0, 80, 1.0), (3, 80, 100, 1.0)], (0, 100))
    (one,), own, other = compare_runs(first, second, fps=FPS)
    assert one.text == "2 becomes new track 3 from frame 80 on"
    assert own.track_ids == (1, 2)
    assert other.of_frame(0)["x"].tolist() == own.of_frame(0)["x"].tolist()
    assert compare_runs(first, first)[0] == ()


def test_runs_over_other_frames_are_compared_where_both_were():
    first, second = run_of(TWO, (0, 100)), run_of(TWO, (50, 150))
    assert compare_runs(first, second)[0] == ()


def test_comparing_tells_how_far_it_is_and_can_be_stopped():
    first, second = run_of(TWO, (0, 100)), run_of(TWO, (0, 100))
    told: list[tuple[int, int]] = []
    compare_runs(first, second, progress=lambda *step: told.append(step))
    assert told == [(done, 7) for done in range(8)]

    def stop(done: int, _: int) -> None:
        if done == 2:
            raise CancelledError("stopped")

    with pytest.raises(CancelledError):
        compare_runs(first, second, progress=stop)


def test_a_million_rows_are_compared_in_seconds():
    people, frames = 40, 25_000
    frame = np.repeat(np.arange(frames), people)
    track = np.tile(np.arange(1, people + 1), frames)
    rows = {name: np.resize(column, len(frame)) for name, column in rows_of(TWO).items()}
    rows |= {"frame": frame.astype(np.int32), "track": track.astype(np.int32)}
    rows["x"] = track % 8 * 2.0 + np.sin(frame / 50)
    rows["y"] = track // 8 * 2.0 + np.cos(frame / 70)
    run = run_of([], (0, frames), tracks=rows)
    table = TrackTable(rows)
    with spent() as time:
        assert differences(table, Labels(), History(), run, None, fps=FPS) == ()
    assert time.paces < 1000


def jumps(*frames: tuple[int, int], aside: float = 3.0) -> list[Walk]:
    """Two people, of whom the first one stands aside in some ranges of frames."""
    stops = [20, *(frame for each in frames for frame in each), 100]
    lanes = [0.0, aside] * len(frames) + [0.0]
    parts = zip(stops[:-1], stops[1:], lanes, strict=True)
    return [*((1, start, end, lane) for start, end, lane in parts), (2, 20, 100, 1.0)]


def test_short_ones_are_told_with_their_neighbour():
    one = only(table_of(TWO), jumps((40, 41), (52, 54), (70, 90)))
    assert facts(one) == ("moved", 1, 0, 40, 90, 23)
    assert one.text == "1 stands elsewhere for 1.1 s, by up to 3.0 m"


def test_long_ones_and_those_far_off_are_told_apart():
    found = told(table_of(TWO), jumps((30, 40), (50, 60), (85, 87)))
    assert [(one.start, one.end) for one in found] == [(30, 40), (50, 60), (85, 87)]


def test_what_is_told_as_one_is_taken_as_one():
    table, run = table_of(TWO), run_of(jumps((40, 41), (52, 54), (85, 99)), (20, 100), 2)
    first, second = differences(table, Labels(), History(), run, None, fps=FPS)
    change = plan_take(table, Labels(), History(), run, None, only=[first], fps=FPS)
    apply_change(table, Labels(), change)
    assert differences(table, Labels(), History(), run, None, fps=FPS) == (second,)


def test_a_short_step_aside_is_not_told_but_a_long_one_is():
    assert told(table_of(TWO), jumps((40, 43), aside=-0.4)) == ()
    assert only(table_of(TWO), jumps((40, 50), aside=-0.4)).rows == 10


def test_short_changes_of_identity_are_told_as_they_are():
    swapped = [(1, 20, 50, 0.0), (1, 50, 51, 1.0), (1, 51, 60, 0.0), (1, 60, 61, 1.0)]
    swapped += [(2, 20, 50, 1.0), (2, 50, 51, 0.0), (2, 51, 60, 1.0), (2, 60, 61, 0.0)]
    found = told(table_of(TWO), [*swapped, (1, 61, 100, 0.0), (2, 61, 100, 1.0)])
    assert [(one.kind, one.start, one.end) for one in found] == [
        ("identity", 50, 51),
        ("identity", 60, 61),
    ]
