"""Tracklets are kept with the run that followed them, frame by frame."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up_sessions import FRAMES, make_recording, make_run

from app.core.tracks.session_tracks import SessionTracks
from tracking.editing import plan_delete
from tracking.errors import SessionError
from tracking.session import Session
from tracking.tracks import TRACKLET_COLUMNS, Particles, Run

_PER_FRAME = 7


def run_with_tracklets() -> Run:
    run, random = make_run(), np.random.default_rng(5101)
    start = np.arange(FRAMES + 1, dtype=np.int64) * _PER_FRAME
    rows = int(start[-1])
    columns = {
        name: (400 * random.random(rows)).astype(kind) for name, kind in TRACKLET_COLUMNS.items()
    }
    columns["track"] = random.integers(0, 2, rows).astype(np.int32)
    return replace(run, tracklets=Particles(start, columns))


@pytest.fixture
def made(tmp_path: Path) -> tuple[Path, Run]:
    path, run = tmp_path / "s.h5", run_with_tracklets()
    Session.create(make_recording(tmp_path / "footage"), [run], path).close()
    return path, run


def test_tracklets_are_read_frame_by_frame_as_they_were_saved(made: tuple[Path, Run]) -> None:
    path, run = made
    with closing(Session.open(path)) as session:
        for frame in (0, 17, FRAMES - 1, FRAMES):
            wanted = run.tracklets.of_frame(frame)
            found = session.runs[0].tracklets.of_frame(frame)
            assert list(found) == list(TRACKLET_COLUMNS)
            assert all(found[name].tobytes() == wanted[name].tobytes() for name in wanted)


def test_runs_from_before_there_were_tracklets_have_none_and_are_saved(
    made: tuple[Path, Run],
) -> None:
    path, _ = made
    with h5py.File(path, "r+") as file:
        file.attrs["format_version"] = "1.2"
        del file["runs/0/tracklets"]
    with closing(Session.open(path)) as session:
        assert len(session.runs[0].tracklets.of_frame(3)["track"]) == 0
        session.save()
    with closing(Session.open(path)) as session:
        assert list(session.runs[0].tracklets.of_frame(3)) == list(TRACKLET_COLUMNS)


def test_runs_from_before_feet_were_noticed_have_none(made: tuple[Path, Run]) -> None:
    path, run = made
    with h5py.File(path, "r+") as file:
        file.attrs["format_version"] = "1.3"
        del file["runs/0/tracklets/foot_v"]
    with closing(Session.open(path)) as session:
        session.save()
        found = session.runs[0].tracklets.of_frame(3)
        assert list(found) == list(TRACKLET_COLUMNS)
        assert np.isnan(found["foot_v"]).all()
        assert np.array_equal(found["v2"], run.tracklets.of_frame(3)["v2"])


@pytest.mark.parametrize("missing", ["start", "v2"])
def test_tracklets_that_lack_a_column_are_refused(made: tuple[Path, Run], missing: str) -> None:
    path, _ = made
    with h5py.File(path, "r+") as file:
        del file[f"runs/0/tracklets/{missing}"]
    with pytest.raises(SessionError, match="tracklets"):
        Session.open(path)


def test_tracklets_of_frames_that_go_backwards_are_refused(made: tuple[Path, Run]) -> None:
    path, _ = made
    with h5py.File(path, "r+") as file:
        start = file["runs/0/tracklets/start"][()]
        start[5], start[6] = start[6], start[5]
        file["runs/0/tracklets/start"][...] = start
    with closing(Session.open(path)) as session, pytest.raises(SessionError, match="tracklets"):
        session.runs[0].tracklets.of_frame(0)


def test_tracklets_of_somebody_who_was_deleted_are_shown_as_nobodys(
    made: tuple[Path, Run],
) -> None:
    path, run = made
    own = run.tracklets.of_frame(4)["track"]
    with closing(Session.open(path)) as session:
        shown = SessionTracks(session.tracks, session.runs[0]).tracklets(4)
        np.testing.assert_array_equal(shown["track"], own)
        session.apply(plan_delete(session.tracks, 1))
        shown = SessionTracks(session.tracks, session.runs[0]).tracklets(4)
    assert own.any()
    assert not shown["track"].any()
