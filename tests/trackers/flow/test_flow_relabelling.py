"""Finished runs relabelled by their tracklets: who walked where."""

from __future__ import annotations

import numpy as np
import pytest

from tests.trackers.flow.flow_scenes import FPS
from tests.trackers.flow.tracklet_runs import FRAMES, VIEW, Walker, run_with
from tracking.trackers import tracker_named
from tracking.trackers.flow import trajectory_selection
from tracking.trackers.flow.bundles import Trajectory, gather_bundle
from tracking.trackers.flow.chains import link_chains
from tracking.trackers.flow.explained_rows import cover_rows, explained_rows
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.relabel_run import find_pieces, relabel_run
from tracking.trackers.flow.trajectory_selection import WalkerTrajectory, remove_twins
from tracking.tracks.columns import Columns

COMING = Walker((-0.7, 12.0), (0.0, -1.1))
GOING = Walker((0.7, 3.5), (0.0, 1.2))
FLOOR = Floor(VIEW)


def at_side(tracks: Columns, side: int) -> Columns:
    """The rows of who walks left (-1) or right (1) of the middle."""
    return {name: column[np.sign(tracks["x"]) == side] for name, column in tracks.items()}


def off(tracks: Columns, walker: Walker) -> float:
    """How far from the walker the rows lie, in m, at most."""
    away = np.stack((tracks["x"], tracks["y"]), axis=1) - walker.at(tracks["frame"])
    return float(np.hypot(*away.T).max())


def test_a_track_that_went_over_to_somebody_else_is_two_people() -> None:
    run = run_with((COMING, GOING), ((1, 0, range(5, 35)), (1, 1, range(35, 75))))
    found = relabel_run(run, VIEW, FPS).tracks
    assert len(np.unique(found["track"])) == 2
    for side, walker in ((-1, COMING), (1, GOING)):
        own = at_side(found, side)
        assert len(np.unique(own["track"])) == 1
        assert off(own, walker) < 0.8


def test_ways_reach_as_far_as_their_tracklets() -> None:
    run = run_with((COMING,), ((1, 0, range(30, 50)),))
    found = relabel_run(run, VIEW, FPS).tracks
    assert found["frame"].min() <= 4
    assert found["frame"].max() >= FRAMES - 3
    assert set(found["track"]) == {1}


def test_who_was_followed_twice_at_once_is_one() -> None:
    run = run_with((COMING,), ((1, 0, range(5, 40)), (2, 0, range(20, 75))))
    assert len(np.unique(relabel_run(run, VIEW, FPS).tracks["track"])) == 1


@pytest.mark.parametrize(("aside_m", "hidden"), [(0.0, True), (0.8, False)])
def test_points_seen_on_somebody_are_of_nobody_behind(aside_m: float, hidden: bool) -> None:
    front = Walker((0.0, 9.0), (0.0, -0.7))
    behind = Walker((aside_m, 10.98), (0.0, -0.854))
    run = run_with((front, behind), ((1, 0, range(5, 75)), (2, 1, range(5, 75))))
    chains = link_chains(run, FLOOR, FPS)
    front_m, left = np.full(len(chains.row), np.inf), np.ones(len(chains), bool)
    ways = [Trajectory(5, one.at(np.arange(5, 75))) for one in (front, behind)]
    seen, farther = (explained_rows(way, chains, FLOOR, FPS) for way in ways)
    before = farther.count(left, front_m)
    assert before > 100
    cover_rows(front_m, ways[0], chains, FLOOR)
    seen_behind = farther.count(left, front_m) / before
    assert seen_behind < 0.1 if hidden else seen_behind == 1.0  # led on, nobody hides it
    assert seen.count(left, front_m) > 100  # who stands in front is seen


def test_tracklets_and_detections_go_with_the_people_told_of() -> None:
    run = run_with((COMING, GOING), ((1, 0, range(5, 35)), (1, 1, range(35, 75))))
    found = relabel_run(run, VIEW, FPS)
    rows = {(f, t) for f, t in zip(found.tracks["frame"], found.tracks["track"], strict=True)}
    seen = set(zip(found.detections["frame"], found.detections["track"], strict=True))
    assert seen == rows
    for frame in range(10, 70):
        held = found.tracklets.of_frame(frame)
        assert (np.diff(held["track"]) >= 0).all()
        left = held["track"][held["u0"] < VIEW.camera.matrix[0, 2]]
        own = at_side(found.tracks, -1)["track"][0]
        assert np.mean(left == own) > 0.9


def test_new_people_get_tracks_above_all_that_were_known() -> None:
    run = run_with((COMING, GOING), ((1, 0, range(5, 75)),), known_tracks=40)
    found = relabel_run(run, VIEW, FPS).tracks
    assert set(at_side(found, -1)["track"]) == {1}
    assert (at_side(found, 1)["track"] > 40).all()


def test_who_stands_stays_as_followed() -> None:
    standing = Walker((0.9, 6.0), (0.0, 0.0))
    run = run_with((COMING, standing), ((1, 0, range(5, 75)), (2, 1, range(5, 75))))
    found = relabel_run(run, VIEW, FPS).tracks
    own = found["frame"][found["track"] == 2]
    assert own.tolist() == list(range(5, 75))


def test_tracklets_of_who_stays_as_followed_stay_theirs_under_the_new_name_too() -> None:
    standing = Walker((0.9, 6.0), (0.0, 0.0))
    followed = ((2, 1, range(5, 20)), (2, 0, range(20, 60)), (2, 1, range(60, 75)))
    run = run_with((COMING, standing), ((1, 0, range(5, 75)), *followed))
    found = relabel_run(run, VIEW, FPS)
    stood = np.hypot(found.tracks["x"] - 0.9, found.tracks["y"] - 6.0) < 0.1
    for frame, track in zip(
        found.tracks["frame"][stood], found.tracks["track"][stood], strict=True
    ):
        before = (run.tracklets.of_frame(int(frame))["track"] == 2).sum()
        assert (found.tracklets.of_frame(int(frame))["track"] == track).sum() == before > 0


def test_a_track_off_all_ways_before_and_after_a_while_is_told_without_a_hole() -> None:
    standing = Walker((0.9, 6.0), (0.0, 0.0))
    followed = ((2, 1, range(5, 20)), (2, 0, range(20, 60)), (2, 1, range(60, 75)))
    run = run_with((COMING, standing), ((1, 0, range(5, 75)), *followed))
    found = relabel_run(run, VIEW, FPS).tracks
    for track in np.unique(found["track"]):
        frame = found["frame"][found["track"] == track]
        assert (np.diff(frame) == 1).all()
    stood = found["frame"][np.hypot(found["x"] - 0.9, found["y"] - 6.0) < 0.1]
    assert stood.tolist() == [*range(5, 20), *range(60, 75)]


def test_a_finished_run_has_every_row_once_and_is_the_same_each_time() -> None:
    run = run_with((COMING, GOING), ((1, 0, range(5, 35)), (1, 1, range(35, 75))))
    finish = tracker_named("flow").finisher.finish
    found, again = (finish(run, VIEW, FPS).tracks for _ in range(2))
    keys = list(zip(found["frame"], found["track"], strict=True))
    assert keys == sorted(set(keys))
    assert all(np.array_equal(found[name], again[name], equal_nan=True) for name in found)


def test_tracklets_are_linked_over_all_their_frames() -> None:
    run = run_with((COMING,), ((1, 0, range(10, 20)),))
    chains = link_chains(run, FLOOR, FPS)
    assert len(chains) == 10
    assert chains.length.tolist() == [FRAMES - 2] * 10
    assert (chains.first == 2).all()
    held = np.isfinite(chains.held_at[:, 0])
    assert set(chains.frame[held]) == set(range(10, 20))


def test_a_bundle_is_of_those_who_walk_the_way_and_of_nobody_beside_or_against() -> None:
    beside = Walker((-0.1, 12.0), (0.0, -1.1))
    against = Walker((-0.7, 3.5), (0.0, 1.2))
    run = run_with((COMING, beside, against), ((1, 0, range(10, 70)),))
    chains = link_chains(run, FLOOR, FPS)
    way = Trajectory(10, COMING.at(np.arange(10, 70)))
    bundle = gather_bundle(way, chains, FLOOR, FPS, 0.3)
    own = np.isfinite(chains.held_at[:, 0])
    assert set(bundle.chain[bundle.alike]) == set(chains.chain[own])


@pytest.mark.parametrize(("apart_m", "people"), [(0.1, 1), (0.6, 2)])
def test_two_ways_too_near_to_each_other_are_one_persons(apart_m: float, people: int) -> None:
    place = COMING.at(np.arange(40))
    walks = [
        WalkerTrajectory(Trajectory(10, place), np.arange(5)),
        WalkerTrajectory(Trajectory(12, place[2:30] + np.array((apart_m, 0.0))), np.arange(5, 8)),
    ]
    kept = remove_twins(walks)
    assert len(kept) == people
    assert sum(len(walk.chain) for walk in kept) == 8


def test_without_room_for_one_body_alone_they_are_two_people(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(trajectory_selection, "_are_twins", lambda *_: False)
    place = COMING.at(np.arange(40))
    ways = (Trajectory(10, place), Trajectory(12, place[2:30] + np.array((0.1, 0.0))))
    assert len(remove_twins([WalkerTrajectory(way, np.arange(5)) for way in ways])) == 2


def test_pieces_end_where_nobody_is_seen_for_a_while() -> None:
    run = run_with((COMING,), ((1, 0, range(5, 30)), (1, 0, range(40, 60)), (2, 0, range(60, 70))))
    pieces = find_pieces(run.tracks, FPS)
    assert [len(rows) for rows in pieces] == [25, 20, 10]


def body(*heights: float, aside_m: float = 0.1) -> np.ndarray:
    """(n, 2) points of a body at these heights to either side of its middle."""
    return np.array([(side * aside_m, height) for height in heights for side in (-1.0, 1.0)])


def test_points_as_far_aside_as_shoulders_and_elbows_are_their_bodys() -> None:
    broad = Walker((-0.7, 12.0), (0.0, -1.1), points=body(0.8, 1.0, 1.2, 1.4, aside_m=0.22))
    run = run_with((COMING, broad), ((1, 0, range(10, 70)),))
    chains = link_chains(run, FLOOR, FPS)
    way = Trajectory(10, COMING.at(np.arange(10, 70)))
    bundle = gather_bundle(way, chains, FLOOR, FPS, 0.3)
    assert bundle.alike.sum() == len(COMING.points) + len(broad.points)


@pytest.mark.parametrize(("highest_m", "people"), [(1.6, 2), (1.1, 1)])
def test_what_has_no_head_in_the_picture_is_nobody(highest_m: float, people: int) -> None:
    heights = np.linspace(0.2, highest_m, 6)
    other = Walker((0.7, 12.0), (0.0, -1.1), points=body(*heights))
    followed = ((1, 0, range(5, 75)), (2, 1, range(5, 75)))
    found = relabel_run(run_with((COMING, other), followed), VIEW, FPS).tracks
    assert len(np.unique(found["track"])) == people


@pytest.mark.parametrize("stride_m", [0.1, 0.5])
def test_how_far_before_people_their_feet_are_seen_is_learnt_of_the_run(stride_m: float) -> None:
    walkers = [
        Walker((-0.7, 12.0), (0.0, -1.1), stride_m=stride_m),
        Walker((0.7, 3.5), (0.0, 1.2), stride_m=stride_m),
    ]
    run = run_with(walkers, ((1, 0, range(5, 75)), (2, 1, range(5, 75))), feet=True)
    chains = link_chains(run, FLOOR, FPS)
    away = np.hypot(*chains.held_at.T) - chains.feet_m
    assert abs(np.nanmedian(away)) < 0.02
