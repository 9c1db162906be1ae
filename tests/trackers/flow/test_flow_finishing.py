"""Finished runs of the flow tracker: pieces joined, ways led back and on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.trackers.flow.flow_scenes import FPS, view_of
from tracking.trackers import smooth_run, tracker_named
from tracking.trackers.flow.pieces import join_pieces
from tracking.tracks.columns import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    empty,
)
from tracking.tracks.run import Particles, Run

finish_run = tracker_named("flow").finisher.finish
VIEW = view_of(2.2, 20.0)
FRAMES = 100

Piece = tuple[int, range, tuple[float, float], tuple[float, float]]
"""Track, frames, place in frame 0 and pace, as if it had been walking all the time."""


def tracks_of(pieces: Sequence[Piece]) -> Columns:
    """Rows of straight walks."""
    rows = sorted(
        (frame, track, *_at(frame, start, pace), *pace)
        for track, frames, start, pace in pieces
        for frame in frames
    )
    table = np.array(rows)
    values = dict(zip(("frame", "track", "x", "y", "vx", "vy"), table.T, strict=True))
    box = VIEW.box_of_person(table[:, 2:4], 1.7, 0.55)
    values |= dict(zip(("left", "top", "width", "height"), box.T, strict=True))
    values |= {"confidence": np.ones(len(rows)), "visibility": np.ones(len(rows))}
    values["predicted"] = np.zeros(len(rows), bool)
    return {name: values[name].astype(dtype) for name, dtype in TRACK_COLUMNS.items()}


def _at(frame: int, start: tuple[float, float], pace: tuple[float, float]) -> tuple[float, float]:
    return start[0] + frame / FPS * pace[0], start[1] + frame / FPS * pace[1]


def run_of(*pieces: Piece, hold: bool = True) -> Run:
    """A run of straight walks, a tracklet a row."""
    tracks = tracks_of(pieces)
    tracklets = {
        name: tracks["track"] if name == "track" else np.zeros(len(tracks["track"]), dtype)
        for name, dtype in TRACKLET_COLUMNS.items()
    }
    start = np.searchsorted(tracks["frame"], np.arange(FRAMES + 1))
    return Run(
        tracker="flow",
        settings={"persistent_points": hold, "smooth": True},
        seed=0,
        frames=(0, FRAMES),
        tracks=tracks,
        detections={name: tracks.get(name, tracks["x"]) for name in DETECTION_COLUMNS},
        particles=Particles.none(PARTICLE_COLUMNS),
        associations=empty(ASSOCIATION_COLUMNS),
        tracklets=Particles(start, tracklets),
        software="test",
    )


ONE = (0.2, 12.0), (0.0, -1.2)


def with_points(run: Run, frames: range, feet_m: float = 0.0) -> Run:
    """The run with points, of nobody, on the chest of `ONE` in these frames and no others.

    Args:
        feet_m: how much farther away than `ONE` the foreground below them ends.
    """
    place = np.array([_at(frame, *ONE) for frame in frames])
    chest = VIEW.pixel_from_world(np.column_stack((place, np.full(len(place), 1.2))))
    away = place * (1 + feet_m / np.hypot(*place.T))[:, None]
    foot = VIEW.pixel_from_world(np.column_stack((away, np.zeros(len(place)))))
    columns = {name: np.zeros(len(frames), dtype) for name, dtype in TRACKLET_COLUMNS.items()}
    for step in range(3):
        columns[f"u{step}"][:], columns[f"v{step}"][:] = chest.T
    columns["foot_v"][:] = foot[:, 1]
    start = np.searchsorted(np.array(frames), np.arange(FRAMES + 1))
    return replace(run, tracklets=Particles(start, columns))


def test_pieces_of_one_way_are_one_track() -> None:
    found = finish_run(run_of((1, range(20, 40), *ONE), (2, range(52, 70), *ONE)), VIEW, FPS)
    assert set(found.tracks["track"]) == {1}
    assert set(found.detections["track"]) == {1}
    assert set(np.asarray(found.tracklets.columns["track"])) == {1}


def test_between_two_pieces_people_walk_straight_and_count_as_predicted() -> None:
    found = finish_run(run_of((1, range(20, 40), *ONE), (2, range(52, 70), *ONE)), VIEW, FPS).tracks
    gap = (found["frame"] >= 40) & (found["frame"] < 52)
    assert gap.sum() == 12
    assert found["predicted"][gap].all()
    straight = 12.0 - 0.12 * found["frame"][gap]
    assert found["y"][gap] == pytest.approx(straight, abs=0.02)


def test_who_walks_the_other_way_is_somebody_else() -> None:
    back = (0.2, 0.0), (0.0, 1.2)
    found = join_pieces(run_of((1, range(20, 50), *ONE), (2, range(52, 80), *back)), FPS)
    assert set(found.tracks["track"]) == {1, 2}


def test_of_two_who_walk_abreast_each_goes_on_as_who_they_are() -> None:
    beside = (-0.6, 12.0), (0.0, -1.2)
    run = run_of(
        (1, range(20, 40), *ONE),
        (2, range(20, 40), *beside),
        (3, range(46, 70), *beside),
        (4, range(47, 70), *ONE),
    )
    found = join_pieces(run, FPS).tracks
    assert set(found["track"][found["x"] > 0]) == {1}
    assert set(found["track"][found["x"] < 0]) == {2}


def test_ways_are_led_back_and_on() -> None:
    run = with_points(run_of((1, range(30, 50), *ONE)), range(FRAMES))
    found = finish_run(run, VIEW, FPS).tracks
    assert (found["frame"].min(), found["frame"].max()) == (15, 64)
    assert found["y"] == pytest.approx(12.0 - 0.12 * found["frame"], abs=0.02)
    seen = (found["frame"] >= 30) & (found["frame"] < 50)
    assert found["predicted"].tolist() == (~seen).tolist()


def test_ways_are_led_no_farther_than_points_are_followed_there() -> None:
    run = with_points(run_of((1, range(30, 50), *ONE)), range(25, 56))
    found = finish_run(run, VIEW, FPS).tracks
    assert (found["frame"].min(), found["frame"].max()) == (25, 55)


@pytest.mark.parametrize(("feet_m", "led"), [(-3.0, True), (0.0, True), (3.0, False)])
def test_who_would_stand_before_the_feet_seen_is_not_there(feet_m: float, led: bool) -> None:
    run = with_points(run_of((1, range(30, 50), *ONE)), range(FRAMES), feet_m)
    assert finish_run(run, VIEW, FPS).tracks["predicted"].any() == led


def test_runs_of_which_no_points_are_known_are_led_all_the_same() -> None:
    run = run_of((1, range(30, 50), *ONE))
    found = finish_run(replace(run, tracklets=Particles.none(TRACKLET_COLUMNS)), VIEW, FPS).tracks
    assert (found["frame"].min(), found["frame"].max()) == (15, 64)


def test_who_stands_is_led_nowhere() -> None:
    standing = (0.2, 7.0), (0.0, 0.0)
    found = finish_run(run_of((1, range(30, 60), *standing)), VIEW, FPS).tracks
    assert found["frame"].tolist() == list(range(30, 60))


def test_nobody_is_led_out_of_the_picture_nor_of_the_frames_tracked() -> None:
    aside = (-4.2, 7.0), (1.2, 0.0)
    run = run_of((1, range(45, 60), *aside), (2, range(80, 100), (0.2, 14.0), (0.0, -1.2)))
    run = replace(run, tracklets=Particles.none(TRACKLET_COLUMNS))
    found = finish_run(run, VIEW, FPS).tracks
    assert found["frame"].max() < FRAMES
    place = np.stack((found["x"], found["y"], np.full(len(found["x"]), 1.2)), axis=1)
    chest = VIEW.pixel_from_world(place)[found["predicted"]]
    assert ((chest > 0) & (chest < np.array(VIEW.camera.size))).all()


def test_without_hold_a_run_is_smoothed_as_any() -> None:
    run = run_of((1, range(20, 40), *ONE), (2, range(52, 70), *ONE), hold=False)
    usual = smooth_run(run, VIEW, FPS)
    found = finish_run(run, VIEW, FPS)
    assert all((found.tracks[name] == usual.tracks[name]).all() for name in TRACK_COLUMNS)


def test_a_run_of_nobody_stays_one() -> None:
    nobody = replace(run_of((1, range(20, 40), *ONE)), tracks=empty(TRACK_COLUMNS))
    assert len(finish_run(nobody, VIEW, FPS).tracks["track"]) == 0


@given(cut=st.integers(8, 40), gap=st.integers(0, 15), x=st.floats(-1.0, 1.0))
def test_wherever_a_way_is_cut_no_row_stands_twice(cut: int, gap: int, x: float) -> None:
    way = (x, 12.0), (0.0, -1.2)
    found = finish_run(
        run_of((1, range(10, 10 + cut), *way), (2, range(10 + cut + gap, 80), *way)), VIEW, FPS
    ).tracks
    keys = list(zip(found["frame"], found["track"], strict=True))
    assert keys == sorted(set(keys))
