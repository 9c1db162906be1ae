"""The frame in which two people changed over is found."""

from __future__ import annotations

import numpy as np
import pytest
from tables_of_people import table_of

from tracking.editing import apply_change, plan_swap, propose_swap_frames
from tracking.errors import EditError
from tracking.tracks import CORRECTED_COLUMNS, Labels, TrackTable

FPS = 20.0


def crossing(random: np.random.Generator, in_metres: bool = True) -> tuple[TrackTable, int]:
    """Two people who pass each other within about 20 cm, and the frame where they are nearest."""
    count = int(random.integers(60, 300))
    meet = int(random.integers(15, count - 15))
    course = random.uniform(0, 2 * np.pi)
    walks = [
        walk(random, count, meet, angle)
        for angle in (course, course + random.uniform(0.5, 2 * np.pi - 0.5))
    ]
    rows = {name: np.zeros(2 * count, dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    rows["frame"], rows["track"] = np.repeat(np.arange(count), 2), np.tile([1, 2], count)
    x, y = ("x", "y") if in_metres else ("left", "top")
    rows["x"][:] = rows["y"][:] = np.nan
    for person, places in enumerate(walks):
        rows[x][person::2], rows[y][person::2] = places.T * (1 if in_metres else 80)
    return TrackTable(rows), meet


def walk(random: np.random.Generator, count: int, meet: int, angle: float) -> np.ndarray:
    way = random.uniform(0.6, 1.6) * np.array([np.cos(angle), np.sin(angle)])
    sway = np.cumsum(random.normal(0, 0.02, (count, 2)), axis=0)
    off = random.normal(0, 0.15, 2) + random.normal(0, 0.03, (count, 2)) + sway - sway[meet]
    return off + way * ((np.arange(count) - meet) / FPS)[:, None]


@pytest.mark.parametrize("in_metres", [True, False])
def test_injected_swaps_are_found_within_two_frames(in_metres: bool) -> None:
    random = np.random.default_rng(7)
    off = []
    for _ in range(120):
        table, meet = crossing(random, in_metres)
        swapped = meet + int(random.integers(-3, 4))
        apply_change(table, Labels(), plan_swap(table, 1, 2, swapped))
        off.append(abs(propose_swap_frames(table, 1, 2)[0].frame - swapped))
    assert np.mean(np.array(off) <= 2) >= 0.95


def test_of_two_crossings_the_one_looked_at_is_proposed() -> None:
    count = 200
    rows = {name: np.zeros(2 * count, dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    rows["frame"], rows["track"] = np.repeat(np.arange(count), 2), np.tile([1, 2], count)
    time = np.arange(count)
    rows["x"][0::2] = np.abs(np.cos(time * np.pi / 100)) * 3  # bounce off each other at 50 and 150
    rows["x"][1::2] = -rows["x"][0::2]
    table = TrackTable(rows)
    assert propose_swap_frames(table, 1, 2, near=60)[0].frame == pytest.approx(50, abs=2)
    assert propose_swap_frames(table, 1, 2, near=140)[0].frame == pytest.approx(150, abs=2)


def test_tracks_that_never_meet_change_over_where_the_later_begins() -> None:
    assert propose_swap_frames(table_of({1: [(0, 10)], 2: [(15, 20)]}), 1, 2)[0].frame == 15


@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_the_shortest_meetings_have_a_frame_too(count: int) -> None:
    table = table_of({1: [(5, 5 + count)], 2: [(5, 5 + count)]})
    assert 5 <= propose_swap_frames(table, 1, 2)[0].frame < 5 + count


def test_nonsense_is_refused_in_words() -> None:
    table = table_of({1: [(0, 5)]})
    with pytest.raises(EditError, match="with itself"):
        propose_swap_frames(table, 1, 1)
    with pytest.raises(EditError, match="track 2"):
        propose_swap_frames(table, 1, 2)
