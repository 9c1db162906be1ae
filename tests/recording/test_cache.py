"""The frame cache: bounded, ahead of the playing position, safe between threads."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Lock

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracking.recording import FrameCache, StereoFrame

FRAME_BYTES = 2 * 8 * 10 * 3


class CountedReader:
    """Frames that cost nothing, and a record of which were asked for."""

    frame_count = 100

    def __init__(self) -> None:
        self.reads: list[int] = []
        self._lock = Lock()

    def read(self, number: int) -> StereoFrame:
        with self._lock:
            self.reads.append(number)
        image = np.full((8, 10, 3), number, np.uint8)
        return StereoFrame(number, number / 20, image, image)


def cache_of(frames: int) -> tuple[FrameCache, CountedReader]:
    reader = CountedReader()
    return FrameCache(reader, frames * FRAME_BYTES), reader


def fetch_all(cache: FrameCache) -> None:
    while cache.prefetch():
        pass


@given(
    st.lists(st.tuples(st.integers(0, 99), st.sampled_from([-1, 0, 1])), max_size=60),
    st.integers(0, 12),
)
def test_it_never_holds_more_than_its_bytes(moves: list[tuple[int, int]], capacity: int) -> None:
    cache, _ = cache_of(capacity)
    for number, direction in moves:
        cache.point_at(number, direction)
        assert cache.read(number).number == number
        cache.prefetch()
        assert cache.bytes_used <= capacity * FRAME_BYTES
        assert cache.bytes_used == FRAME_BYTES * sum(b - a for a, b in cache.kept_ranges())


def test_a_kept_frame_is_given_without_reading() -> None:
    cache, reader = cache_of(4)
    cache.read(5)
    assert cache.get(5) is cache.read(5)
    assert cache.get(6) is None
    assert reader.reads == [5]


def test_it_runs_ahead_in_the_play_direction_and_then_has_enough() -> None:
    cache, reader = cache_of(8)
    cache.point_at(50, 1)
    fetch_all(cache)
    assert reader.reads == [50, 51, 52, 53, 54, 55]
    cache.point_at(50, -1)
    fetch_all(cache)
    assert cache.kept_ranges()[0][0] == 45


def test_standing_it_fetches_both_sides() -> None:
    cache, _ = cache_of(7)
    cache.point_at(50, 0)
    fetch_all(cache)
    assert cache.kept_ranges() == [(47, 54)]


def test_what_lies_behind_goes_first_but_not_the_frame_just_left() -> None:
    cache, _ = cache_of(8)
    cache.point_at(50, 1)
    fetch_all(cache)
    for number in range(51, 60):
        cache.point_at(number, 1)
        cache.read(number)
        fetch_all(cache)
    kept = {n for a, b in cache.kept_ranges() for n in range(a, b)}
    assert kept == set(range(58, 65)) | {57}


def test_at_the_ends_it_asks_for_no_frame_that_is_not_there() -> None:
    cache, reader = cache_of(8)
    for number, direction in ((98, 1), (1, -1), (0, 0)):
        cache.point_at(number, direction)
        fetch_all(cache)
    assert set(reader.reads) <= set(range(100))


def test_a_frame_larger_than_the_cache_is_given_but_not_kept() -> None:
    cache, _ = cache_of(0)
    assert cache.read(3).number == 3
    assert cache.kept_ranges() == []


def test_clearing_forgets_everything() -> None:
    cache, _ = cache_of(4)
    cache.read(1)
    cache.clear()
    assert (cache.bytes_used, cache.get(1)) == (0, None)


def test_threads_may_share_it() -> None:
    cache, _ = cache_of(6)

    def visit(number: int) -> bool:
        cache.point_at(number % 100, 1)
        cache.prefetch()
        return cache.read(number % 100).number == number % 100

    with ThreadPoolExecutor(4) as pool:
        assert all(pool.map(visit, range(400)))
    assert cache.bytes_used <= 6 * FRAME_BYTES
