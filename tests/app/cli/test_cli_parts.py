"""`track` with the trackers of body parts and the options of their own."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from command_line import Trackwright

from tracking.editing import plan_occluders
from tracking.session import Session
from tracking.tracks import Occluder

PARTS = ("--tracker", "three-part", "--frames", "0:8")


@pytest.fixture
def drawn(session: Path) -> Path:
    """A session in which a pillar is drawn."""
    pillar = Occluder("pillar", ((10.0, 0.0), (40.0, 0.0), (40.0, 90.0)))
    with closing(Session.open(session)) as opened:
        opened.apply(plan_occluders(opened.labels, [pillar]))
        opened.save()
    return session


def test_a_session_holds_the_settings_the_detector_and_particles_of_parts(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    words = ["--set", "stored_particles=20", "--set", "confirm_s=0"]
    assert trackwright("track", footage, "-o", out, *PARTS, *words)[0] == 0
    with closing(Session.open(out)) as session:
        run = session.runs[0]
        assert (run.tracker, run.settings["adjust"]) == ("three-part", True)
        assert len(run.detector) == 16
        assert len(run.parts["frame"]) == 3 * len(run.tracks["frame"])
        per_frame = np.diff(run.part_particles.start)
        assert per_frame.max() <= 3 * 20 * len(np.unique(run.tracks["track"]))


def test_occluders_are_taken_from_a_session_and_kept_with_the_run(
    trackwright: Trackwright, footage: Path, drawn: Path, tmp_path: Path
) -> None:
    out = tmp_path / "s.h5"
    assert trackwright("track", footage, "-o", out, *PARTS, "--occluders", drawn)[0] == 0
    with closing(Session.open(out)) as session:
        said = json.loads(session.runs[0].settings["occluders"])
    assert said == [[[10.0, 0.0], [40.0, 0.0], [40.0, 90.0]]]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--detector", "gone.h5"], "there is no such detector"),
        (["--set", "occluders=here"], "must be outlines"),
        (["--tracker", "whole-body", "--detector", "d.h5"], "whole-body knows no detector"),
    ],
)
def test_what_cannot_be_used_is_told_in_a_line(
    trackwright: Trackwright, footage: Path, tmp_path: Path, words: list[str], reason: str
) -> None:
    status, _, err = trackwright("track", footage, "-o", tmp_path / "s.h5", *PARTS, *words)
    assert status == 2
    assert err.count("\n") == 1
    assert reason in err


def test_a_session_without_occluders_gives_none(
    trackwright: Trackwright, footage: Path, made: Path, tmp_path: Path
) -> None:
    words = ["-o", tmp_path / "s.h5", *PARTS, "--occluders", made]
    status, _, err = trackwright("track", footage, *words)
    assert status == 1
    assert "no occluders are drawn in it" in err
