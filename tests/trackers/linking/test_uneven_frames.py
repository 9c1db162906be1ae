"""Runs over footage whose frames did not come evenly, looked over as time went."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest
from linked_runs import FPS, VIEW, Stretch, corrected, run_of, straight
from numpy.typing import NDArray

from tracking.pipeline.ticks import Ticks, finish_with_ticks
from tracking.trackers import tracker_named
from tracking.tracks import Columns, Particles, Run

FINISH = tracker_named("stereo-joint").finisher.finish
LINE = straight((-3, 6), (4, 6.5), 140)
"""1 m/s, by the clock."""
TABLES = ("tracks", "detections", "associations", "signals")


@dataclass
class Timed:
    """A recording as far as its times go."""

    uneven_times_s: NDArray[np.float64] | None
    fps: float = FPS


def without(gap: slice) -> NDArray[np.int64]:
    """When the frames that were recorded came, in frames, some of 140 not being recorded."""
    return np.delete(np.arange(140), gap)


def since(table: Columns, frame: int) -> Columns:
    """The rows from a frame on."""
    return {name: column[table["frame"] >= frame] for name, column in table.items()}


def walked(run: Run, tick: NDArray[np.int64]) -> float:
    """How far the run is off the line at most, m."""
    place = np.stack((run.tracks["x"], run.tracks["y"]), axis=1)
    return float(np.hypot(*(place - LINE[tick[run.tracks["frame"]]]).T).max())


def test_ticks_make_up_for_missing_frames_and_each_frame_has_its_own():
    assert Ticks.of(Timed(None)) is None
    times = np.array([0.0, 0.05, 0.051, 0.101, 0.3, 0.34, 90.0, 90.05])
    assert Ticks.of(Timed(times)).of_frame.tolist() == [0, 1, 2, 3, 7, 8, 408, 409]
    assert Ticks.of(Timed(np.zeros(1))).of_frame.tolist() == [0]
    assert Ticks.of(Timed(np.arange(1_000) * 15.0, fps=10_000.0)) is None


def test_a_burst_of_frames_takes_nothing_off_a_later_gap():
    between = np.full(200, 0.05)
    between[20:45], between[150] = 0.001, 1.2
    times = np.concatenate(((0.0,), np.cumsum(between)))
    steps = np.diff(Ticks.of(Timed(times)).of_frame)
    assert steps[150] == 24
    assert set(np.delete(steps, 150).tolist()) == {1}


def test_frames_in_pairs_lose_nobody_who_is_seen_for_a_moment():
    times = np.cumsum(np.tile((0.0125, 0.0875), 60))
    run = run_of(
        Stretch(1, 0, LINE[:120]), Stretch(2, 50, LINE[50:65] + np.array([0.0, 3.0])), frames=120
    )
    found = finish_with_ticks(FINISH, run, VIEW, FPS, None, Ticks.of(Timed(times)))
    assert np.count_nonzero(found.tracks["frame"] >= 0) >= 120 + 15


def test_a_rate_told_a_little_too_low_leaves_gaps_as_long_as_they_were():
    times = np.arange(20_000) / 30.0
    times[10_000:] += 1.0
    ticks = Ticks.of(Timed(times, fps=29.97)).of_frame
    assert ticks[9_999] == 9_999
    assert ticks[10_000] - ticks[9_999] == 31
    minutes = np.array([0.0, 60.0, 180.0, 240.0])
    assert Ticks.of(Timed(minutes, fps=1 / 60)).of_frame.tolist() == [0, 1, 2, 3]


def test_a_run_of_no_frames_is_finished_as_it_is():
    run = replace(run_of(Stretch(1, 0, LINE[:9]), frames=9), frames=(5, 5))
    assert (
        finish_with_ticks(lambda run, *_: run, run, VIEW, FPS, None, Ticks(np.arange(9) * 2)) is run
    )


def test_particles_bear_the_ids_of_the_finished_run():
    tick = without(slice(60, 80))
    stretches = Stretch(1, 0, LINE[tick][:75]), Stretch(2, 78, LINE[tick][78:])
    run = run_of(*stretches, frames=len(tick))
    found = finish_with_ticks(FINISH, run, VIEW, FPS, None, Ticks(tick))
    assert set(found.tracks["track"].tolist()) == {1}
    assert np.array_equal(found.particles.start, run.particles.start)
    for frame in (10, 58, 62, 74, 79, 100):
        own = run.particles.of_frame(frame)
        theirs = found.particles.of_frame(frame)
        assert set(theirs["track"].tolist()) == {1}
        assert np.array_equal(theirs["x"], own["x"])


@pytest.mark.parametrize("missing", [10, 20, 30])
def test_frames_that_were_not_recorded_neither_part_nor_move_anybody(missing: int):
    tick = without(slice(60, 60 + missing))
    run = run_of(Stretch(1, 0, LINE[tick]), frames=len(tick))
    found = finish_with_ticks(FINISH, run, VIEW, FPS, None, Ticks(tick))
    assert set(found.tracks["track"].tolist()) == {1}
    assert found.frames == run.frames
    assert found.tracks["frame"].tolist() == list(range(len(tick)))
    assert walked(found, tick) < 0.06
    assert found.tracks["vx"] == pytest.approx(np.full(len(tick), 1.0), abs=0.15)
    # Frames taken for even time pull the path across the gap, or tear it.
    blind = FINISH(run, VIEW, FPS, None)
    assert walked(blind, tick) > 0.1 or len(set(blind.tracks["track"].tolist())) > 1


def test_rows_stand_in_recorded_frames_only_and_all_tables_fit():
    tick = without(slice(60, 80))
    lost = Stretch(1, 0, LINE[tick], lost=range(55, 65))
    whole = run_of(lost, Stretch(2, 30, LINE[tick][30:] + np.array([0.0, 2.0])), frames=len(tick))
    run = replace(whole, **{name: since(getattr(whole, name), 5) for name in TABLES})
    run = replace(run, frames=(5, len(tick)), known_tracks=1)
    found = finish_with_ticks(FINISH, run, VIEW, FPS, corrected(whole, 0, 5), Ticks(tick))
    assert found.frames == run.frames
    rows = np.stack([found.tracks[name] for name in ("frame", "track")], axis=1)
    assert len(np.unique(rows, axis=0)) == len(rows)
    assert found.tracks["frame"].max() < len(tick)
    assert np.array_equal(found.signals["frame"], found.tracks["frame"])
    assert {n: c.dtype for n, c in found.tracks.items()} == {
        n: c.dtype for n, c in run.tracks.items()
    }
    assert found.detections["frame"].tolist() == run.detections["frame"].tolist()


def test_even_footage_and_tracklets_are_finished_as_they_are():
    given: list[Run] = []

    def finish(run: Run, *_: object) -> Run:
        given.append(run)
        return run

    run = run_of(Stretch(1, 0, LINE[:50]), frames=50)
    points: Columns = {"track": np.zeros(3, np.int32)}
    followed = replace(run, tracklets=Particles(np.array([0, 3]), points))
    finish_with_ticks(finish, run, VIEW, FPS, None, None)
    finish_with_ticks(finish, followed, VIEW, FPS, None, Ticks(np.arange(50) * 2))
    assert given == [run, followed]
