"""Body parts and their particles are kept with the run that found them."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_sessions import FRAMES, make_recording, make_run

from tracking.errors import SessionError
from tracking.session import Session
from tracking.tracks import PART_COLUMNS, PART_PARTICLE_COLUMNS, Particles, Run

_LATER = ("entropy", "particles", "occluded")


def run_with_parts() -> Run:
    run, random = make_run(), np.random.default_rng(4101)
    rows = 3 * len(run.tracks["frame"])
    parts = {name: (100 * random.random(rows)).astype(t) for name, t in PART_COLUMNS.items()}
    parts |= {name: np.repeat(run.tracks[name], 3) for name in ("frame", "track")}
    parts["part"] = np.tile(np.arange(3, dtype=np.uint8), rows // 3)
    parts["entropy"][::4] = np.nan
    start = np.arange(FRAMES + 1, dtype=np.int64) * 60
    cloud = {
        name: (100 * random.random(int(start[-1]))).astype(t)
        for name, t in PART_PARTICLE_COLUMNS.items()
    }
    return replace(run, parts=parts, part_particles=Particles(start, cloud))


@pytest.fixture
def made(tmp_path: Path) -> tuple[Path, Run]:
    path, run = tmp_path / "s.h5", run_with_parts()
    Session.create(make_recording(tmp_path / "footage"), [run], path).close()
    return path, run


def test_parts_are_read_as_they_were_saved(made: tuple[Path, Run]) -> None:
    path, run = made
    with closing(Session.open(path)) as session:
        kept = session.runs[0].parts
    assert list(kept) == list(PART_COLUMNS)
    for name, column in run.parts.items():
        np.testing.assert_array_equal(kept[name], column)


def test_particles_of_parts_are_read_frame_by_frame(made: tuple[Path, Run]) -> None:
    path, run = made
    with closing(Session.open(path)) as session:
        for frame in (0, 17, FRAMES - 1, FRAMES):
            wanted = run.part_particles.of_frame(frame)
            found = session.runs[0].part_particles.of_frame(frame)
            assert all(found[name].tobytes() == wanted[name].tobytes() for name in wanted)


def test_parts_from_before_there_was_entropy_are_read_with_none(made: tuple[Path, Run]) -> None:
    path, run = made
    with h5py.File(path, "r+") as file:
        file.attrs["format_version"] = "1.1"
        del file["runs/0/part_particles"]
        for name in _LATER:
            del file[f"runs/0/parts/{name}"]
    with closing(Session.open(path)) as session:
        read = session.runs[0]
        np.testing.assert_array_equal(read.parts["cx"], run.parts["cx"])
        assert np.isnan(read.parts["entropy"]).all()
        assert not read.parts["particles"].any()
        assert not read.parts["occluded"].any()
        assert len(read.part_particles.of_frame(3)["track"]) == 0
        session.save()
    with closing(Session.open(path)) as session:
        assert len(session.runs[0].parts["cx"]) == len(run.parts["cx"])


def test_a_file_with_some_of_the_later_columns_is_refused(made: tuple[Path, Run]) -> None:
    path, _ = made
    with h5py.File(path, "r+") as file:
        del file["runs/0/parts/entropy"]
    with pytest.raises(SessionError, match="no column entropy"):
        Session.open(path)


def test_particles_without_their_frames_are_refused(made: tuple[Path, Run]) -> None:
    path, _ = made
    with h5py.File(path, "r+") as file:
        del file["runs/0/part_particles/start"]
    with pytest.raises(SessionError, match="part_particles of run 0"):
        Session.open(path)
