"""How far away people are, told by one camera whose view of their feet comes and goes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from linked_runs import FPS, RED, VIEW, Stretch, ids_at, run_of, straight
from numpy.typing import NDArray

from tracking.trackers.linking import link_tracks
from tracking.trackers.three_part.places import link_refined, refine_places
from tracking.tracks import PART_COLUMNS, Run
from tracking.tracks.columns import typed

USUAL_M, TALL_M = 1.7, 1.9
WAY = straight((-2, 6), (2, 6.5), 160)


def hidden_feet(frames: NDArray[np.integer]) -> NDArray[np.bool_]:
    """For a third of a second in each second."""
    return np.asarray(frames % 20 >= 13)


def seen_by_one_camera(run: Run) -> Run:
    """The run of a tall person whose range is told by the feet, where hidden by the head.

    Whose feet are hidden is taken for of usual height, so that a tall person seems nearer.
    """
    seen = run.detections
    hidden = hidden_feet(seen["frame"])
    head = np.column_stack((seen["left"] + seen["width"] / 2, seen["top"]))
    by_head = VIEW.floor_from_pixel(head, USUAL_M)
    x = np.where(hidden, by_head[:, 0], seen["x"])
    y = np.where(hidden, by_head[:, 1], seen["y"])
    z = np.where(hidden, USUAL_M, TALL_M) / 2
    return replace(
        run,
        settings={**run.settings, "people.body_height_m": USUAL_M},
        detections={**seen, "x": x, "y": y, "z": z},
    )


def run_of_somebody_tall() -> Run:
    return seen_by_one_camera(run_of(Stretch(1, 0, WAY, height_m=TALL_M), frames=len(WAY)))


def off_m(run: Run) -> NDArray[np.float64]:
    """How far the detections are from the way."""
    seen = run.detections
    return np.hypot(*(np.column_stack((seen["x"], seen["y"])) - WAY[seen["frame"]]).T)


def test_ranges_hold_while_feet_are_hidden() -> None:
    run = run_of_somebody_tall()
    assert off_m(run).max() > 0.5
    assert off_m(refine_places(run, VIEW, FPS)).max() < 0.25


def test_a_range_that_feet_of_somebody_else_tell_is_not_believed() -> None:
    run = run_of(Stretch(1, 0, WAY), frames=len(WAY))
    run = replace(run, settings={"people.body_height_m": USUAL_M})
    nearer = {name: column.copy() for name, column in run.detections.items()}
    odd = slice(60, 66)
    nearer["y"][odd] -= 2.0
    nearer["z"][odd] = 0.6
    run = replace(run, detections=nearer)
    assert off_m(run)[odd].min() > 1.5
    assert off_m(refine_places(run, VIEW, FPS)).max() < 0.5


def test_somebody_whose_range_jumps_keeps_the_id() -> None:
    run = run_of_somebody_tall()
    jumps = {name: column.copy() for name, column in run.detections.items()}
    jumps["y"][hidden_feet(jumps["frame"])] -= 2.0
    run = replace(run, detections=jumps)
    assert len(np.unique(link_tracks(run, VIEW, FPS).tracks["track"])) > 1
    assert np.unique(link_refined(run, VIEW, FPS).tracks["track"]).tolist() == [1]


def test_parts_of_somebody_missed_for_a_moment_are_filled_in_with_the_rows() -> None:
    gone = range(50, 55)
    stretch = Stretch(1, 0, WAY, RED, lost=gone)
    run = run_of(stretch, frames=len(WAY))
    kept = ~np.isin(run.tracks["frame"], gone)
    tracks = {name: column[kept] for name, column in run.tracks.items()}
    signals = {name: column[kept] for name, column in run.signals.items()}
    frame = np.repeat(tracks["frame"], 3)
    values = {name: np.zeros(len(frame)) for name in PART_COLUMNS}
    values |= {
        "frame": frame,
        "track": np.ones(len(frame)),
        "part": np.tile((0, 1, 2), len(tracks["frame"])),
    }
    values["cx"] = frame * 2.0 + values["part"]
    run = replace(run, tracks=tracks, signals=signals, parts=typed(values, PART_COLUMNS))
    parts = link_refined(run, VIEW, FPS).parts
    assert 1 in ids_at(link_refined(run, VIEW, FPS), 52)
    there = np.isin(parts["frame"], gone)
    assert there.sum() == 3 * len(gone)
    assert parts["occluded"][there].all()
    assert not parts["occluded"][~there].any()
    np.testing.assert_allclose(parts["cx"], parts["frame"] * 2.0 + parts["part"])
    assert np.isnan(parts["score"][there]).all()
