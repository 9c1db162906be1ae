"""Sessions whose runs name their settings as earlier versions did."""

from __future__ import annotations

from contextlib import closing
from dataclasses import replace
from pathlib import Path

import h5py
import pytest
from made_up_sessions import make_recording, make_run

from tracking.errors import SessionError
from tracking.session import Session, describe

OLD = {"agility": 3.0, "looks_weight": 0.5, "smooth": False}
PRESENT = {"process_noise": 3.0, "appearance_weight": 0.5, "smooth": False}


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A session as an earlier version saved it: `looks_weight` has its default."""
    run = replace(make_run(), tracker="stereo-joint", settings=OLD)
    recording = make_recording(tmp_path / "yard")
    with closing(Session.create(recording, [run], tmp_path / "s.h5")) as session:
        return session.save()


def test_a_run_is_opened_with_the_present_names(path: Path) -> None:
    with closing(Session.open(path)) as session:
        assert session.runs[0].settings == PRESENT


def test_a_session_is_described_with_the_present_names(path: Path) -> None:
    (run,) = describe(path)["runs"]
    assert run["settings"] == {"process_noise": 3.0, "smooth": False}


def test_a_run_has_the_present_names_after_saving_too(path: Path, tmp_path: Path) -> None:
    with closing(Session.open(path)) as session:
        session.save(tmp_path / "copy.h5")
    with closing(Session.open(tmp_path / "copy.h5")) as session:
        assert session.runs[0].settings == PRESENT


def test_a_run_whose_settings_are_no_names_with_values_is_damage(path: Path) -> None:
    with h5py.File(path, "a") as file:
        file["runs/0"].attrs["settings"] = "[1, 2]"
    with pytest.raises(SessionError, match="does not name settings"):
        describe(path)
