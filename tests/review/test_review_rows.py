"""What review items are looked for in: rows, who is near whom, and greatest moments."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from walks_on_a_floor import FPS, Walk, crossing, made_run, straight, swapped

from tracking.editing import apply_change, plan_move_box
from tracking.review.core.evidence import LOOKS, gather_evidence
from tracking.review.core.findings import peaks
from tracking.review.core.material import neighbours
from tracking.tracks import Labels, TrackTable


def test_rows_keep_what_was_noticed_of_them_when_they_change_tracks() -> None:
    run = made_run(crossing())
    evidence = gather_evidence(swapped(run, 1, 2, 80), run, FPS)
    assert np.isfinite(evidence.looks).all()
    red = evidence.looks[LOOKS.index("upper_b")] > 0
    first = evidence.track == 1
    assert (red == (first == (evidence.frame < 80))).all()


def test_nothing_was_noticed_of_rows_a_person_drew() -> None:
    run = made_run(crossing())
    table = TrackTable(run.tracks)
    apply_change(table, Labels(), plan_move_box(table, 1, 40, (10.0, 10.0, 40.0, 120.0)))
    evidence = gather_evidence(table, run, FPS)
    drawn = (evidence.track == 1) & (evidence.frame == 40)
    assert np.isnan(evidence.looks[:, drawn]).all()
    assert np.isfinite(evidence.looks[:, ~drawn]).all()


def test_signals_are_found_though_they_stand_in_another_order() -> None:
    run = made_run(crossing())
    expected = gather_evidence(TrackTable(run.tracks), run, FPS).looks
    order = np.random.default_rng(3102).permutation(len(run.signals["frame"]))
    for name in run.signals:
        run.signals[name] = run.signals[name][order]
    np.testing.assert_array_equal(gather_evidence(TrackTable(run.tracks), run, FPS).looks, expected)


@given(st.integers(0, 2**32 - 1), st.integers(1, 12), st.floats(0.2, 2.0))
def test_neighbours_are_all_pairs_within_the_radius(seed: int, people: int, radius: float) -> None:
    random = np.random.default_rng(seed)
    walks = [
        Walk(random.uniform(0, 3, (5, 2)), start=int(random.integers(3))) for _ in "x" * people
    ]
    evidence = gather_evidence(TrackTable(made_run(walks).tracks), None, FPS)
    near = neighbours(evidence, radius)
    apart = np.linalg.norm(evidence.place[:, None] - evidence.place[None], axis=2)
    together = (evidence.frame[:, None] == evidence.frame[None]) & (apart <= radius)
    wanted = np.argwhere(np.triu(together, 1)).tolist()
    assert sorted(zip(near.first.tolist(), near.second.tolist(), strict=True)) == [
        tuple(pair) for pair in wanted
    ]
    np.fill_diagonal(together, False)
    nearest = np.where(together, apart, radius).min(axis=1)
    np.testing.assert_allclose(near.nearest_m, np.minimum(nearest, radius))


@given(
    st.lists(st.tuples(st.integers(1, 3), st.integers(0, 60), st.integers(0, 9)), max_size=40),
    st.integers(1, 10),
)
def test_peaks_are_apart_and_nothing_greater_is_near_them(
    rows: list[tuple[int, int, int]], apart: int
) -> None:
    rows = sorted(set(rows))
    group, frame, value = (np.array([row[i] for row in rows], np.int64) for i in range(3))
    taken = peaks(group, frame, value.astype(float), apart).tolist()
    for one in taken:
        for other in taken:
            if one != other and group[one] == group[other]:
                assert abs(frame[one] - frame[other]) > apart
    for row in set(range(len(rows))) - set(taken):
        near = [
            peak
            for peak in taken
            if group[peak] == group[row] and abs(frame[peak] - frame[row]) <= apart
        ]
        assert any(value[peak] >= value[row] for peak in near)


def test_people_far_from_each_other_are_no_neighbours() -> None:
    walks = [Walk(straight((x, 5), (0, 0), 10)) for x in (0.0, 3.0)]
    evidence = gather_evidence(TrackTable(made_run(walks).tracks), None, FPS)
    assert len(neighbours(evidence, 1.2).first) == 0
