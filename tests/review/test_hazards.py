"""Hazards: what is known of rows, the trees that judge it, and the stretches it is summed over."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from walks_on_a_floor import BLUE, FPS, RED, SIZE, Walk, crossing, made_run, straight, swapped

from tracking.review import find_review_items
from tracking.review.core.evidence import gather_evidence
from tracking.review.core.material import Material
from tracking.review.hazard import FEATURES, NOTICED, Hazards, Trees, built_in_trees, features
from tracking.tracks import Run, TrackTable

MEETING = 80


def material(run: Run, table: TrackTable | None = None, seen: bool = True) -> Material:
    tracks = TrackTable(run.tracks) if table is None else table
    return Material.of(gather_evidence(tracks, run if seen else None, FPS), SIZE, ())


def column(of: Material, name: str) -> np.ndarray:
    return features(of)[:, FEATURES.index(name)]


def test_trees_come_back_from_their_text() -> None:
    trees = built_in_trees()
    assert Trees.from_text(trees.as_text()) == trees


def test_a_tree_is_walked_by_threshold_and_unknown() -> None:
    leaves = ((-1, 1.0, 0, 0, 0), (-1, 2.0, 0, 0, 0))
    trees = Trees(("a",), 10.0, (((0, 0.5, 1, 2, 2), *leaves), (leaves[0],)))
    values = np.array([[0.4], [0.5], [0.6], [np.nan]], np.float32)
    assert trees.log_odds(values).tolist() == [12.0, 12.0, 13.0, 13.0]


def test_of_a_run_that_noticed_nothing_only_that_is_unknown() -> None:
    run = made_run(crossing())
    known, bare = features(material(run)), features(material(run, seen=False))
    assert known.shape == (len(run.tracks["frame"]), len(FEATURES))
    noticed = [FEATURES.index(name) for name in NOTICED if not name.startswith("margin")]
    assert np.isnan(bare[:, noticed]).all()
    others = np.setdiff1d(np.arange(len(FEATURES)), noticed)
    np.testing.assert_array_equal(known[:, others], bare[:, others])


def test_a_jump_is_told_in_the_frames_beside_it_and_of_its_own_track() -> None:
    path = straight((-3, 5), (1, 0), 160)
    path[MEETING:, 1] += 0.5
    of = material(made_run([Walk(path), Walk(straight((-3, 9), (1, 0), 160))]))
    jump, evidence = column(of, "jump"), of.evidence
    clear = (evidence.track == 1) & (np.abs(evidence.frame - MEETING) <= 2)
    assert (jump[clear] > 0.4).all()
    assert np.nanmax(jump[~clear]) < 0.1


def test_the_hazard_of_a_swap_is_greatest_where_it_is() -> None:
    run = made_run(crossing())
    hazards = Hazards.of(material(run, swapped(run, 1, 2, MEETING)))
    worst = hazards.evidence.frame[hazards.hazard.argmax()]
    assert abs(worst - MEETING) <= 3
    assert hazards.hazard.max() > 20 * np.median(hazards.hazard)


@given(
    st.lists(st.tuples(st.integers(0, 2), st.integers(-5, 150), st.integers(0, 40)), min_size=1),
    st.integers(0, 9),
)
def test_every_row_counts_for_the_first_stretch_that_holds_it(
    stretches: list[tuple[int, int, int]], seed: int
) -> None:
    hazards = CROSSING
    track, start, length = np.array(stretches).T
    tracks = np.stack((track, np.zeros_like(track)), axis=1)
    order = np.random.default_rng(seed).permutation(len(track))
    once = hazards.once(tracks, start, start + length, order)
    left = hazards.hazard.copy()
    for place in order:
        evidence = hazards.evidence
        inside = (evidence.track == track[place]) & (evidence.frame >= start[place])
        inside &= evidence.frame < start[place] + length[place]
        assert once[place] == pytest.approx(left[inside].sum(), abs=1e-9)
        left[inside] = 0.0


CROSSING = Hazards.of(material(made_run(crossing())))


def test_a_hidden_meeting_is_watched_from_where_they_met_to_where_they_are_seen_again() -> None:
    """Who is taken for whom is decided anywhere while one of them is out of sight."""
    hidden = range(MEETING - 8, MEETING + 6)
    one, other = crossing()
    run = made_run([one, Walk(other.path, looks=BLUE, predicted=hidden)])
    vague = ("margin", "shared", "crossing")
    told = find_review_items(TrackTable(run.tracks), run, FPS, size=SIZE)
    watched = [each for each in told if each.kind in vague and len(each.tracks) == 2]
    assert any(each.start <= MEETING and each.end > hidden[-1] for each in watched)


def test_people_dressed_alike_who_walk_on_straight_are_hardly_flagged() -> None:
    alike = [Walk(each.path, looks=RED) for each in crossing()]
    run = made_run(alike)
    wrong = find_review_items(swapped(run, 1, 2, MEETING), run, FPS, size=SIZE)[0].likelihood
    right = max(
        each.likelihood for each in find_review_items(TrackTable(run.tracks), run, FPS, size=SIZE)
    )
    assert right < 0.3 < wrong
