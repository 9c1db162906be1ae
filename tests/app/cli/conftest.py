"""What the tests of the command line share."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from command_line import Trackwright

from app.__main__ import run
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import Run


@pytest.fixture(scope="session")
def footage(tiny_recording: Path) -> Path:
    """Ten seconds of a small stereo recording with four people; not to be changed."""
    return tiny_recording


@pytest.fixture
def recording(footage: Path, tmp_path: Path) -> Path:
    """A copy of it, to be damaged."""
    return Path(shutil.copytree(footage, tmp_path / "square"))


@pytest.fixture(scope="session")
def made(footage: Path, tiny_run: Run, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A session of the small recording; not to be changed."""
    place = tmp_path_factory.mktemp("made") / "square.h5"
    with open_recording(footage) as recording:
        Session.create(recording, [tiny_run], place).close()
    return place


@pytest.fixture
def session(made: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copy(made, tmp_path / "square.h5"))


@pytest.fixture
def trackwright(capsys: pytest.CaptureFixture[str]) -> Trackwright:
    """Runs a command; gives exit status, stdout and stderr."""

    def typed(*words: str | Path) -> tuple[int, str, str]:
        status = run([str(word) for word in words])
        return (status, *capsys.readouterr())

    return typed
