"""What speaks for two pieces of a track being one person's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from linked_runs import BLUE, FPS, RED, VIEW, Stretch, run_of, straight

from tracking.pipeline.track_embeddings import embedding_columns
from tracking.trackers.linking.appearance import TrackletAppearance, learn_appearance
from tracking.trackers.linking.motion import walk_likelihood
from tracking.trackers.linking.occlusion import hidden_shares
from tracking.trackers.linking.seen_rows import find_seen_rows, is_track_start
from tracking.trackers.linking.tracklets import State, Tracklets, cut_tracklets
from tracking.tracks import EMBEDDING_COLUMNS, Run

LANES = [straight((-2, 5 + lane), (2, 5 + lane), 100) for lane in range(4)]


def pieces_of(
    clothes: Sequence[Sequence[float]], half_hidden: int = 0
) -> tuple[Tracklets, TrackletAppearance]:
    """A tracklet of each of those who walk in lanes, one after the other.

    Args:
        half_hidden: track of somebody of whom less shows.
    """
    run = run_of(
        *(Stretch(n + 1, 100 * n, LANES[n], worn) for n, worn in enumerate(clothes)), frames=400
    )
    run.tracks["visibility"][run.tracks["track"] == half_hidden] = 0.4
    seen, _ = find_seen_rows(run, VIEW)
    pieces = cut_tracklets(seen, is_track_start(seen).astype(np.uint8), FPS)
    return pieces, learn_appearance(seen, pieces, FPS)


def ratio(appearance: TrackletAppearance, one: int, other: int) -> float:
    rows = [(appearance.weight[[n]], appearance.value[[n]]) for n in (one, other)]
    return float(appearance.log_likelihood_ratio(*rows)[0])


def test_the_same_clothes_speak_for_one_person_and_others_against() -> None:
    _, appearance = pieces_of([RED, BLUE, RED, BLUE])
    assert ratio(appearance, 0, 2) > 1.0
    assert ratio(appearance, 0, 1) < -3.0


def test_clothes_of_somebody_half_hidden_tell_something_but_less() -> None:
    _, appearance = pieces_of([RED, BLUE, RED, BLUE], half_hidden=1)
    assert ratio(appearance, 0, 2) > 1.0
    assert ratio(appearance, 0, 1) < -1.0
    assert 0.0 < appearance.weight[0, 0] < 0.5 * appearance.weight[2, 0]


def test_where_all_wear_the_same_clothes_say_little() -> None:
    _, appearance = pieces_of([RED, RED, RED, RED])
    assert ratio(appearance, 0, 1) == pytest.approx(0.0, abs=1.5)


def test_footage_without_colours_is_weighed_by_lightness() -> None:
    dark, light = (20.0, 0.0, 0.0, 25.0, 0.0, 0.0), (70.0, 0.0, 0.0, 60.0, 0.0, 0.0)
    _, appearance = pieces_of([dark, light, dark, light])
    assert ratio(appearance, 0, 2) > ratio(appearance, 0, 1) + 3.0


def test_a_tracklet_ends_where_and_as_fast_as_its_rows_do() -> None:
    pieces, _ = pieces_of([RED])
    np.testing.assert_allclose(pieces.last.place[0], (2, 5), atol=0.08)
    np.testing.assert_allclose(pieces.last.velocity[0], (4 * FPS / 99, 0), atol=0.15)


def looks_known(run: Run, track: int) -> np.ndarray:
    seen, _ = find_seen_rows(run, VIEW)
    return np.asarray(np.isfinite(seen.appearance[seen.track == track]).all(axis=1))


def test_clothes_of_whom_only_the_legs_show_are_not_known() -> None:
    run = run_of(Stretch(1, 0, LANES[0], RED))
    assert looks_known(run, 1).all()
    half = run.tracks["height"] / 2
    for table in (run.tracks, run.detections):
        table["top"][:50] += half[:50]
        table["height"][:50] -= half[:50]
    assert looks_known(run, 1).tolist() == [False] * 50 + [True] * 50


def test_clothes_of_who_walks_in_front_of_somebody_are_known_and_those_behind_are_not() -> None:
    run = run_of(Stretch(1, 0, LANES[0], RED), Stretch(2, 0, LANES[0] + (0.0, 0.5), BLUE))
    run.tracks["visibility"][run.tracks["track"] == 2] = 0.3
    assert looks_known(run, 1).all()
    assert not looks_known(run, 2).any()


def state(place: Sequence[float], velocity: Sequence[float]) -> State:
    spread = np.diag((0.01, 0.02))[None]
    return State(np.zeros(1, np.int64), np.array([place]), np.array([velocity]), spread)


def walked(to: Sequence[float], velocity: Sequence[float], gap_s: float) -> float:
    """How likely somebody is found there who was at the origin and walked at 1 m/s."""
    rows = np.zeros(1, np.intp)
    ends, starts = state((0, 0), (1, 0)), state(to, velocity)
    return float(walk_likelihood(ends, starts, rows, rows, np.array([gap_s]))[0])


def test_who_walks_on_straight_is_likelier_than_who_turned_and_the_less_so_the_later() -> None:
    soon = walked((0.5, 0), (1, 0), 0.5) - walked((0, 0), (-1, 0), 0.5)
    late = walked((3, 0), (1, 0), 3.0) - walked((0, 0), (-1, 0), 3.0)
    assert soon > late > 0.0


def test_somebody_far_away_at_once_is_nobody_who_was_here() -> None:
    assert walked((3, 0), (1, 0), 0.2) < walked((0.2, 0), (1, 0), 0.2) - 20.0


def hidden(range_m: float, track: int = 9) -> float:
    """The share of a way along y = 8 m that somebody hides who walks beside at that range."""
    run = run_of(Stretch(track, 0, straight((-1, range_m), (1, range_m), 100)), frames=100)
    ways = (np.array([[-8 / range_m, 8.0]]), np.array([[8 / range_m, 8.0]]))
    ends = (np.array([0]), np.array([99]))
    return float(hidden_shares(run.tracks, ways, ends, (np.array([1]), np.array([2])), VIEW)[0])


def test_who_walks_in_front_hides_and_who_walks_behind_does_not() -> None:
    assert hidden(7.0) > 0.9
    assert hidden(9.0) == 0.0


def test_nobody_hides_himself() -> None:
    assert hidden(7.0, track=2) == 0.0


def embedded(run: Run, vectors: dict[int, np.ndarray]) -> Run:
    """The run with what an appearance network said of each track, now and then."""
    rng = np.random.default_rng(0)
    parts = []
    for track, vector in vectors.items():
        for frame in run.tracks["frame"][run.tracks["track"] == track][::10].tolist():
            seen = vector + rng.normal(scale=0.05, size=len(vector))
            seen = (seen / np.linalg.norm(seen)).astype(np.float32)
            parts.append(embedding_columns(frame, np.array([track]), seen[None]))
    rows = {name: np.concatenate([part[name] for part in parts]) for name in EMBEDDING_COLUMNS}
    return replace(run, embeddings=rows)


def test_an_appearance_network_tells_people_in_the_same_clothes_apart() -> None:
    run = run_of(*(Stretch(n + 1, 100 * n, LANES[n], RED) for n in range(4)), frames=400)
    one, other = np.eye(40)[3], np.eye(40)[20]
    run = embedded(run, {1: one, 2: other, 3: one, 4: other})
    seen, _ = find_seen_rows(run, VIEW)
    pieces = cut_tracklets(seen, is_track_start(seen).astype(np.uint8), FPS)
    appearance = learn_appearance(seen, pieces, FPS)
    assert ratio(appearance, 0, 2) > 1.0
    assert ratio(appearance, 0, 1) < -3.0


def test_rows_of_people_in_front_of_others_have_no_embedding_of_theirs() -> None:
    run = run_of(*(Stretch(n + 1, 0, LANES[n], RED) for n in range(2)), frames=100)
    run.tracks["visibility"][run.tracks["track"] == 2] = 0.4
    run = embedded(run, {1: np.eye(20)[0], 2: np.eye(20)[1]})
    seen, _ = find_seen_rows(run, VIEW)
    assert not np.isfinite(seen.embedding[seen.track == 2]).any()


def test_embeddings_of_tracks_without_a_row_that_was_seen_are_left_out() -> None:
    run = embedded(run_of(Stretch(1, 0, LANES[0], RED), frames=100), {1: np.eye(20)[0]})
    run.tracks["predicted"][:] = True
    seen, _ = find_seen_rows(run, VIEW)
    assert seen.embedding.shape == (0, 0)
