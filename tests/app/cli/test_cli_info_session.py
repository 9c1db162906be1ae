"""`info` of a session, as people read it."""

from __future__ import annotations

import json
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
from command_line import Trackwright

from tracking.editing import plan_label_part
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import PartLabel, Run


def test_runs_and_labels_have_lines_of_their_own(
    trackwright: Trackwright, footage: Path, tiny_run: Run, tmp_path: Path
) -> None:
    outlines = json.dumps([[[n, n] for n in range(100)]])
    settings = {"adjust": False, "occluders": outlines, "detector": "mine.h5"}
    other = replace(tiny_run, tracker="three-part", settings=settings, detector="ab12", seed=7)
    place = tmp_path / "s.h5"
    with open_recording(footage) as recording:
        made = Session.create(recording, [replace(tiny_run, settings={}), other], place)
    with closing(made) as session:
        label = PartLabel(10, session.tracks.track_ids[0], 2, (1.0, 2.0, 3.0, 4.0), None)
        session.apply(plan_label_part(session.labels, label))
        session.save()
    lines = dict(line.split("  ", 1) for line in trackwright("info", place)[1].splitlines())
    lines = {name: text.strip() for name, text in lines.items()}
    start, end = tiny_run.frames
    assert lines["run 0"] == f"{tiny_run.tracker}, frames {start} to {end - 1}, seed 0"
    assert lines["run 1"].startswith(f"three-part, frames {start} to {end - 1}, seed 7, file ")
    assert "detector ab12, adjust off, " in lines["run 1"]
    assert "…" in lines["run 1"]
    assert lines["hip-leg labels"] == "on 0, off 0, unsure 1"
    assert lines["reviewed ranges"] == "0"
    assert lines["size"] == "320 x 240 px"


def test_a_long_name_in_a_session_is_cut(
    trackwright: Trackwright, footage: Path, tiny_run: Run, tmp_path: Path
) -> None:
    place = tmp_path / "s.h5"
    with open_recording(footage) as recording:
        Session.create(recording, [tiny_run], place).close()
    with h5py.File(place, "a") as file:
        file["recording"].attrs["name"] = "n" * 60_000
        file["runs/0"].attrs["tracker"] = "t" * 60_000
    status, said, _ = trackwright("info", place)
    assert status == 0
    assert max(map(len, said.splitlines())) < 5000
    assert said.count("…") == 2
