"""Runs over footage whose frames did not come evenly, looked over as time went."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import pytest
from linked_runs import FPS, VIEW, Stretch, corrected, run_of, straight
from numpy.typing import NDArray

from tracking.pipeline.ticks import Ticks, finished
from tracking.trackers import tracker_named
from tracking.tracks import Columns, Particles, Run

FINISH = tracker_named("stereo-joint").finish
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


def test_ticks_are_the_nearest_and_each_frame_has_its_own():
    assert Ticks.of(Timed(None)) is None
    times = np.array([0.0, 0.05, 0.101, 0.3, 0.34, 20.0, 20.05, 20.1])
    ticks = Ticks.of(Timed(times))
    assert ticks.of_frame.tolist() == [0, 1, 2, 7, 8, 435, 436, 437]
    assert 20.0 <= ticks.rate_hz < 25.0


def test_nonsense_of_times_is_not_counted():
    far = np.arange(50) * 15.0
    far[1::2] = far[0::2] + 0.001
    assert Ticks.of(Timed(far)) is None
    assert Ticks.of(Timed(np.zeros(1))) is None


@pytest.mark.parametrize("paces", [(30, 10), (10, 30)], ids=["slower", "faster"])
def test_a_pace_that_changes_is_followed(paces: tuple[int, int]):
    between = np.concatenate([np.full(90, 1 / pace) for pace in paces])
    times = np.concatenate(((0.0,), np.cumsum(between)))
    ticks = Ticks.of(Timed(times, fps=180 / times[-1]))
    np.testing.assert_allclose(ticks.of_frame / ticks.rate_hz, times, atol=0.02)
    way = np.stack((-3 + 0.5 * times, np.full(len(times), 6.0)), axis=1)
    run = run_of(Stretch(1, 0, way), frames=len(times))
    found = finished(FINISH, run, VIEW, 180 / times[-1], None, ticks)
    assert set(found.tracks["track"].tolist()) == {1}
    assert found.tracks["vx"] == pytest.approx(np.full(len(times), 0.5), abs=0.12)


def test_a_rate_told_a_little_too_low_leaves_gaps_as_long_as_they_were():
    times = np.arange(20_000) / 30.0
    times[10_000:] += 1.0
    ticks = Ticks.of(Timed(times, fps=29.97))
    assert np.diff(ticks.of_frame)[9_999] == pytest.approx(31, abs=1)


def test_particles_bear_the_ids_of_the_finished_run():
    tick = without(slice(60, 80))
    stretches = Stretch(1, 0, LINE[tick][:75]), Stretch(2, 78, LINE[tick][78:])
    run = run_of(*stretches, frames=len(tick))
    found = finished(FINISH, run, VIEW, FPS, None, Ticks(tick, FPS))
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
    found = finished(FINISH, run, VIEW, FPS, None, Ticks(tick, FPS))
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
    found = finished(FINISH, run, VIEW, FPS, corrected(whole, 0, 5), Ticks(tick, FPS))
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
    finished(finish, run, VIEW, FPS, None, None)
    finished(finish, followed, VIEW, FPS, None, Ticks(np.arange(50) * 2, FPS))
    assert given == [run, followed]
