"""Steps of a made-up tracker, kept in memory and in a spool."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from tracking.errors import OutputError
from tracking.pipeline import KeptSteps
from tracking.pipeline.spool import Spool
from tracking.trackers import StepResult
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Run,
    empty,
)

FIRST, FRAMES, EACH = 5, 80, 20
RECORDING = SimpleNamespace(frame_count=100, view=None, fps=20.0)


def step(frame: int) -> StepResult:
    """Two people but every tenth frame, with particles in whole steps."""
    rng = np.random.default_rng(frame)
    people = np.array([] if frame % 10 == 0 else [3, 8])
    tracks = {name: np.zeros(len(people), dtype) for name, dtype in TRACK_COLUMNS.items()}
    tracks["frame"][:], tracks["track"][:] = frame, people
    tracks["x"][:] = rng.normal(size=len(people))
    rows = len(people) * EACH
    cloud = {
        "track": np.repeat(people, EACH),
        "x": rng.integers(-4000, 4000, rows) / 1024,
        "y": rng.integers(2000, 9000, rows) / 1024,
        "weight": np.full(rows, 1 / 32),
    }
    seen = {name: rng.random(3).astype(dtype) for name, dtype in DETECTION_COLUMNS.items()}
    return StepResult(
        frame,
        tracks,
        seen,
        {name: cloud[name].astype(dtype) for name, dtype in PARTICLE_COLUMNS.items()},
        empty(ASSOCIATION_COLUMNS),
        tracklets={
            name: rng.normal(300, 50, 4).astype(dtype) for name, dtype in TRACKLET_COLUMNS.items()
        },
    )


STEPS = [step(frame) for frame in range(FIRST, FIRST + FRAMES)]


@pytest.fixture(params=["memory", "disk"])
def steps(request: pytest.FixtureRequest, tmp_path: Path) -> KeptSteps:
    return KeptSteps(tmp_path, in_memory=0 if request.param == "disk" else 1 << 20)


def made(steps: KeptSteps) -> Run:
    return steps.run("made up", {}, 7, RECORDING)


def assert_same(found: dict, wanted: dict) -> None:
    for name, column in wanted.items():
        assert np.asarray(found[name]).dtype == column.dtype, name
        assert np.asarray(found[name]).tobytes() == column.tobytes(), name


def test_every_frame_is_there_as_it_came(steps: KeptSteps):
    for one in STEPS:
        steps.add((one,))
        assert steps.frames == (FIRST, one.frame + 1)
        assert_same(steps.rows("tracks", one.frame, one.frame + 1), one.tracks)
    for one in STEPS:
        for table in ("tracks", "particles", "tracklets", "detections"):
            assert_same(steps.rows(table, one.frame, one.frame + 1), getattr(one, table))


def test_frames_that_were_not_tracked_have_no_rows(steps: KeptSteps):
    assert len(steps.rows("tracks", 0, 100)["track"]) == 0
    steps.add(STEPS)
    for start, stop in ((0, FIRST), (FIRST + FRAMES, 100), (40, 40), (50, 30)):
        assert len(steps.rows("particles", start, stop)["x"]) == 0


def test_rows_of_many_frames_stand_one_behind_the_other(steps: KeptSteps):
    steps.add(STEPS)
    whole = {n: np.concatenate([one.tracks[n] for one in STEPS]) for n in TRACK_COLUMNS}
    assert_same(steps.rows("tracks", 0, 1000), whole)


def test_a_run_has_all_of_it_frame_by_frame(steps: KeptSteps):
    steps.add(STEPS)
    run = made(steps)
    assert run.frames == (FIRST, FIRST + FRAMES)
    assert len(run.particles.start) == RECORDING.frame_count + 1
    for one in STEPS:
        assert_same(run.particles.of_frame(one.frame), one.particles)
        assert_same(run.tracklets.of_frame(one.frame), one.tracklets)
    assert len(run.particles.of_frame(FIRST - 1)["x"]) == 0
    assert len(run.particles.of_frame(FIRST + FRAMES)["x"]) == 0


def test_a_run_stays_as_it_is_when_more_comes(steps: KeptSteps):
    steps.add(STEPS[:40])
    run = made(steps)
    rows = run.tracks["x"].tobytes(), np.asarray(run.particles.columns["x"]).tobytes()
    steps.add(STEPS[40:])
    later = made(steps)
    assert (run.tracks["x"].tobytes(), np.asarray(run.particles.columns["x"]).tobytes()) == rows
    assert run.particles.start[-1] < later.particles.start[-1] == FRAMES * 0.9 * 2 * EACH


def test_runs_in_memory_and_on_the_disk_are_the_same_to_the_byte(tmp_path: Path):
    rough = [
        replace(one, particles={**one.particles, "x": one.particles["x"] * np.float32(np.pi)})
        for one in STEPS
    ]
    here, there = KeptSteps(), KeptSteps(tmp_path, in_memory=0)
    here.add(rough)
    for one in rough:
        there.add((one,))
    assert_same(
        made(there).particles.columns,
        {name: np.asarray(column) for name, column in made(here).particles.columns.items()},
    )


def test_nothing_kept_is_an_empty_run_where_it_was_to_begin():
    run = KeptSteps(first=30).run("made up", {}, 7, RECORDING)
    assert run.frames == (30, 30)
    assert all(len(column) == 0 for column in (*run.tracks.values(), *run.parts.values()))


def test_tables_of_a_long_run_stay_on_the_disk_and_read_as_arrays(tmp_path: Path):
    steps = KeptSteps(tmp_path, in_memory=0)
    steps.add(STEPS)
    seen = made(steps).detections
    assert not isinstance(seen, dict)
    assert list(seen) == list(DETECTION_COLUMNS)
    whole = {n: np.concatenate([one.detections[n] for one in STEPS]) for n in DETECTION_COLUMNS}
    assert_same(seen, whole)
    del steps
    assert_same({**seen}, whole)
    assert not seen["x"].flags.writeable
    assert len(made(KeptSteps(tmp_path, in_memory=0)).detections["x"]) == 0


def test_the_starts_of_nothing_kept_are_all_the_first():
    run = KeptSteps(first=30).run("made up", {}, 7, RECORDING)
    assert run.particles.start.tolist() == [0] * (RECORDING.frame_count + 1)


def test_what_finds_no_room_is_lost_as_a_whole_and_what_was_settled_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    steps = KeptSteps(tmp_path, in_memory=0)
    steps.add(STEPS[:64])
    written, usual = [], Spool._write

    def full_after_ten(spool: Spool, *asked: object) -> None:
        written.append(asked)
        if len(written) > 10:
            raise OutputError("the disk is full")
        usual(spool, *asked)

    monkeypatch.setattr(Spool, "_write", full_after_ten)
    steps.add(STEPS[64:])
    with pytest.raises(OutputError, match="full"):
        made(steps)
    assert steps.frames == (FIRST, FIRST + 64)
    run = steps.run_so_far("made up", {}, 7, RECORDING)
    kept = KeptSteps()
    kept.add(STEPS[:64])
    wanted = made(kept)
    assert run.frames == (FIRST, FIRST + 64)
    assert_same(run.tracks, wanted.tracks)
    assert_same(run.detections, wanted.detections)
    assert run.particles.start.tolist() == wanted.particles.start.tolist()
    assert len(run.particles.columns["x"]) == len(wanted.particles.columns["x"])


def test_of_a_tracker_that_found_nothing_nothing_is_kept():
    assert KeptSteps(first=30).run_so_far("made up", {}, 7, RECORDING) is None


def test_where_finishing_fails_the_tracks_stay_as_they_were_given():
    steps = KeptSteps()
    steps.add(STEPS)
    filmed = SimpleNamespace(frame_count=100, view="no view at all", fps=20.0)
    with pytest.raises(AttributeError):
        steps.run("flow", {"smooth": True}, 7, filmed)
    run = steps.run_so_far("flow", {"smooth": True}, 7, filmed)
    assert run.frames == (FIRST, FIRST + FRAMES)
    assert_same(run.tracks, made(steps).tracks)
