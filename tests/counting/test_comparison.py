"""Passages found against those that happened."""

from __future__ import annotations

import math
from itertools import permutations

from hypothesis import given
from hypothesis import strategies as st
from walks import together, walk

from tracking.counting import CountingLine, Hits, compare_passages, passages

GATE = CountingLine("gate", (0.0, -1.0), (0.0, 1.0))
OTHER = CountingLine("other", (5.0, -1.0), (5.0, 1.0))


def passing(*frames: int, back: bool = False) -> dict:
    """People who pass the gate between a frame and the next."""
    way = [(-1.0, 0.0), (1.0, 0.0)]
    ways = way[::-1] if back else way
    return together(*(walk(ways, track, frame) for track, frame in enumerate(frames, 1)))


def hits(found: dict, truth: dict, latest_s: float = 1.0) -> Hits:
    lines = [GATE, OTHER]
    return compare_passages(passages(found, 10.0, lines), passages(truth, 10.0, lines), latest_s)


def test_the_same_passages_are_all_hit() -> None:
    found = hits(passing(3, 8, 30), passing(3, 8, 30))
    assert (found, found.rate, found.precision) == (Hits(3, 3, 3), 1.0, 1.0)


def test_a_passage_found_stands_for_one_only() -> None:
    assert hits(passing(10), passing(8, 12)) == Hits(2, 1, 1)


def test_what_is_too_late_is_no_hit() -> None:
    assert hits(passing(25), passing(10)) == Hits(1, 1, 0)


def test_the_other_direction_is_no_hit() -> None:
    assert hits(passing(10, back=True), passing(10)) == Hits(1, 1, 0)


def test_nothing_has_no_rate() -> None:
    none = passing(3)
    none = {name: column[:0] for name, column in none.items()}
    assert math.isnan(hits(none, none).rate)


@given(
    st.lists(st.integers(0, 40), max_size=5, unique=True),
    st.lists(st.integers(0, 40), max_size=5, unique=True),
    st.integers(1, 15),
)
def test_as_many_are_paired_as_can_be(said: list[int], was: list[int], late: int) -> None:
    few, many = sorted((said, was), key=len)
    most = max(
        sum(abs(a - b) <= late for a, b in zip(few, chosen, strict=True))
        for chosen in permutations(many, len(few))
    )
    empty = {name: column[:0] for name, column in passing(1).items()}
    found = hits(
        passing(*said) if said else empty, passing(*was) if was else empty, late / 10 + 0.01
    )
    assert found.hit == most
