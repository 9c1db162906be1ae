"""What a run noticed of its rows is kept with it."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
from made_up_sessions import make_recording, make_run

from tracking.review import find_review_items
from tracking.session import Session
from tracking.tracks import SIGNAL_COLUMNS, Run


def run_with_signals() -> Run:
    run, random = make_run(), np.random.default_rng(3101)
    rows = len(run.tracks["frame"])
    signals = {name: random.random(rows).astype(dtype) for name, dtype in SIGNAL_COLUMNS.items()}
    signals |= {name: run.tracks[name] for name in ("frame", "track")}
    signals["height_m"][::3] = np.nan
    return replace(run, signals=signals)


def made(folder: Path) -> tuple[Path, Run]:
    path, run = folder / "s.h5", run_with_signals()
    Session.create(make_recording(folder / "footage"), [run], path).close()
    return path, run


def test_signals_are_read_as_they_were_saved(tmp_path: Path) -> None:
    path, run = made(tmp_path)
    with closing(Session.open(path)) as session:
        kept = session.runs[0].signals
    assert list(kept) == list(SIGNAL_COLUMNS)
    for name, column in run.signals.items():
        np.testing.assert_array_equal(kept[name], column)


def test_sessions_from_before_there_were_signals_are_read_and_reviewed(tmp_path: Path) -> None:
    path, _ = made(tmp_path)
    with h5py.File(path, "r+") as file:
        del file["runs/0/signals"]
    with closing(Session.open(path)) as session:
        run = session.runs[0]
        assert {name: len(column) for name, column in run.signals.items()} == dict.fromkeys(
            SIGNAL_COLUMNS, 0
        )
        kinds = {one.kind for one in find_review_items(session.tracks, run, 20.0)}
    assert kinds
    assert not kinds & {"exchange", "colour", "height", "spread", "split"}
