"""Why people are not kept, told of truth and tracks whose faults are known."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable

import numpy as np
import pytest

from tests.benchmarks.stereo import loss_context, reasons
from tests.benchmarks.stereo.measures import told
from tests.benchmarks.stereo.reasons import NotKept, not_kept
from tests.benchmarks.stereo.truth import Truth, visible_for
from tracking.tracks import Columns

FPS, SIZE = 20.0, (640, 480)
_BOX_PX = (40.0, 100.0)
_PX_PER_M = 100.0

Walk = Callable[[int], tuple[float, float]]
Row = tuple[int, int, float, float]


def _table(rows: Iterable[Row]) -> dict[str, np.ndarray]:
    """Rows of frame, id, x, y as boxes: 100 px a metre to the right, and up with the distance."""
    found = np.array(sorted(rows), float).reshape(-1, 4)
    left = 320.0 + _PX_PER_M * found[:, 2] - _BOX_PX[0] / 2
    return {
        "frame": found[:, 0].astype(np.int64),
        "track": found[:, 1].astype(np.int64),
        "left": left,
        "top": 300.0 - 20.0 * found[:, 3],
        "width": np.full(len(found), _BOX_PX[0]),
        "height": np.full(len(found), _BOX_PX[1]),
        "x": found[:, 2],
        "y": found[:, 3],
    }


def _walks(walks: dict[int, Walk], frames: int = 80) -> list[Row]:
    return [(n, who, *walk(n)) for who, walk in walks.items() for n in range(frames)]


def _truth(rows: list[Row], hidden: dict[tuple[int, int], float] | None = None) -> Truth:
    """Everybody is seen whole, but for those who are hidden in a frame."""
    columns = _table(rows)
    named = zip(columns["frame"].tolist(), columns["track"].tolist(), strict=True)
    share = np.array([(hidden or {}).get(one, 1.0) for one in named])
    columns["confidence"] = (share >= 0.3).astype(float)
    box = np.column_stack([columns[name] for name in ("left", "top", "width", "height")])
    place = np.column_stack((columns["x"], columns["y"]))
    return Truth(columns["frame"], columns["track"], box, place, share, columns, SIZE, FPS)


def _stands(x: float, y: float = 3.0) -> Walk:
    return lambda _: (x, y)


def _tracks(rows: list[Row], ids: dict[int, Callable[[int], int]]) -> Columns:
    """The true rows under these ids by frame; 0: nobody follows."""
    named = [(n, ids[who](n), x, y) for n, who, x, y in rows]
    return _table(row for row in named if row[1])


def _with(tracks: Columns, more: list[Row]) -> Columns:
    names = ("frame", "track", "x", "y")
    return _table([*zip(*(tracks[name].tolist() for name in names), strict=True), *more])


def _always(track: int) -> Callable[[int], int]:
    return lambda _: track


def _turns(first: int, second: int, at: int, gap: int = 0) -> Callable[[int], int]:
    return lambda n: first if n < at - gap else 0 if n < at else second


def _told(found: tuple[NotKept, ...]) -> dict[int, str]:
    """What went wrong by person, as the page's JSON has it."""
    kept = json.loads(json.dumps([told(one, "clip") for one in found]))
    return {one["person"]: one["what"] for one in kept}


TWO = _walks({1: _stands(-1.0), 2: _stands(1.0)})


def test_whoever_keeps_an_id_of_their_own_is_not_told() -> None:
    assert not_kept(_truth(TWO), _tracks(TWO, {1: _always(5), 2: _always(6)})) == ()


def test_two_who_exchange_their_tracks_are_swapped_with_each_other() -> None:
    found = not_kept(_truth(TWO), _tracks(TWO, {1: _turns(5, 6, 40), 2: _turns(6, 5, 40)}))
    assert _told(found) == {1: reasons.SWAPPED, 2: reasons.SWAPPED}
    assert [one.other for one in found] == [2, 1]
    assert (found[0].last, found[0].frame, found[0].tracks) == (39, 40, (5, 6))


def test_whoever_takes_the_track_of_somebody_makes_two_who_are_not_kept() -> None:
    found = not_kept(_truth(TWO), _tracks(TWO, {1: _turns(5, 6, 40), 2: _turns(6, 9, 40)}))
    assert _told(found) == {1: reasons.TAKEN, 2: reasons.TAKEN}


def test_whoever_comes_back_under_another_id_is_told_with_what_was_in_the_way() -> None:
    rows = _walks({1: _stands(0.0, 4.0), 2: lambda n: (3.0 - n * 0.075, 3.0)})
    hidden = {(n, 1): 0.1 for n in range(38, 43)}
    tracks = _tracks(rows, {1: _turns(5, 7, 44, gap=6), 2: _always(6)})
    (one,) = not_kept(_truth(rows, hidden), tracks)
    assert (one.person, one.what, one.tracks) == (1, reasons.RENAMED, (5, 7))
    around = one.context
    assert (around.where, around.neighbour) == (loss_context.HIDDEN_BY_PERSON, 2)
    assert around.share == pytest.approx(0.1)


def test_somebody_hidden_by_nobody_is_behind_a_thing() -> None:
    hidden = {(n, 1): 0.0 for n in range(35, 44)}
    tracks = _tracks(TWO, {1: _turns(5, 7, 44, gap=9), 2: _always(6)})
    (one,) = not_kept(_truth(TWO, hidden), tracks)
    assert (one.what, one.context.where) == (reasons.RENAMED, loss_context.HIDDEN_BY_THINGS)


def test_somebody_half_out_of_the_picture_is_at_its_edge() -> None:
    rows = _walks({1: _stands(-3.2)})
    hidden = {(n, 1): 0.5 for n in range(80)}
    (one,) = not_kept(_truth(rows, hidden), _tracks(rows, {1: _turns(5, 7, 40)}))
    assert one.context.where == loss_context.AT_EDGE


def test_a_newcomer_under_the_track_of_somebody_gone_has_an_old_track() -> None:
    rows = [row for row in TWO if row[0] < 30 or row[1] == 2]
    rows += _walks({3: _stands(-0.5)})[40:]
    tracks = _tracks(rows, {1: _always(5), 2: _always(6), 3: _always(5)})
    found = not_kept(_truth(rows), tracks)
    assert _told(found) == {3: reasons.INHERITED}
    assert found[0].other == 1


def test_a_second_track_on_the_same_person_is_told_from_one_found_again() -> None:
    tracks = _tracks(TWO, {1: _turns(5, 8, 40), 2: _always(6)})
    doubled = [(n, 8, -0.5, 3.0) for n in range(30, 40)]
    (one,) = not_kept(_truth(TWO), _with(tracks, doubled))
    assert (one.person, one.what) == (1, reasons.DOUBLED)


def test_a_track_that_stands_on_somebody_else_is_a_false_match() -> None:
    rows = _walks({1: _stands(0.0, 3.0), 2: _stands(0.1, 4.0)})
    tracks = _tracks(rows, {1: _turns(5, 0, 40), 2: _always(6)})
    beside = [(n, 7, 0.05, 3.55) for n in range(40, 60)]
    (one,) = not_kept(_truth(rows), _with(tracks, beside))
    assert (one.person, one.what, one.other) == (1, reasons.FALSE, 2)


def test_whoever_is_followed_for_a_quarter_of_the_time_is_lost() -> None:
    (one,) = not_kept(_truth(TWO), _tracks(TWO, {1: _turns(5, 0, 20), 2: _always(6)}))
    assert (one.what, one.last, one.frame) == (reasons.LOST, 19, 20)


def test_only_who_is_seen_for_a_second_without_a_break_must_be_found() -> None:
    hidden = {(n, 2): 0.0 for n in range(0, 80, 15)}
    truth = _truth(TWO, hidden)
    assert visible_for(truth, 1.0) == {1}
    found = not_kept(truth, _tracks(TWO, {1: _always(0), 2: _always(0)}))
    assert _told(found) == {1: reasons.NEVER}
