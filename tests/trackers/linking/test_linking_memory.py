"""Runs of hours are linked in the memory of minutes, and alike."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from linked_runs import BLUE, FPS, RED, VIEW, Stretch, link_run, run_of, straight
from scipy.optimize import linear_sum_assignment

from tracking.trackers.linking import candidates
from tracking.trackers.linking.link_selection import _cheapest
from tracking.trackers.linking.links import Links

RIGHT, LEFT = straight((-2, 6), (2, 6.5), 80), straight((2, 6), (-2, 6.5), 80)


def test_links_weighed_in_portions_give_the_same_people(monkeypatch: pytest.MonkeyPatch) -> None:
    lost = range(30, 45)
    run = run_of(
        *(Stretch(n + 1, 20 * n, RIGHT if n % 2 else LEFT, (RED, BLUE)[n % 2], lost=lost)
          for n in range(6))
    )  # fmt: skip
    whole = link_run(run, VIEW, FPS)
    monkeypatch.setattr(candidates, "_AT_ONCE", 3)
    portions = link_run(run, VIEW, FPS)
    assert portions.tracks["track"].tolist() == whole.tracks["track"].tolist()


@pytest.mark.parametrize("seed", range(20))
def test_the_links_chosen_cost_as_little_as_those_of_a_full_matrix(seed: int) -> None:
    random = np.random.default_rng(seed)
    count = 12
    matrix = np.where(random.random((count, count)) < 0.3, random.normal(0, 4, (count, count)), 0)
    end, start = np.nonzero(matrix)
    following = _cheapest(Links(end, start, matrix[end, start]), matrix[end, start], count)
    led = np.flatnonzero(following >= 0)
    assert len(np.unique(following[led])) == len(led)
    least = np.minimum(matrix, 0.0)
    assert matrix[led, following[led]].sum() == pytest.approx(
        least[linear_sum_assignment(least)].sum()
    )


def test_a_chain_of_thousands_of_tracklets_takes_no_matrix_of_them() -> None:
    count = 4000
    end = np.arange(count - 1)
    links = Links(end, end + 1, np.full(count - 1, -1.0))
    tracemalloc.start()
    following = _cheapest(links, links.cost, count)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert following.tolist() == [*range(1, count), -1]
    assert most < 8 * count**2 / 20
