"""Small recordings for the command line's tests, rendered once."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from command_line import Trackwright

from app.__main__ import run
from tracking.synthesis import render_recording


@pytest.fixture(scope="session")
def footage(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four seconds of a small stereo recording with two people; not to be changed."""
    folder = tmp_path_factory.mktemp("footage") / "lobby"
    return render_recording(folder, "lobby", 4.0, 2, 3, size=(320, 240))


@pytest.fixture
def recording(footage: Path, tmp_path: Path) -> Path:
    """A copy of it, to be damaged."""
    return Path(shutil.copytree(footage, tmp_path / "lobby"))


@pytest.fixture
def trackwright(capsys: pytest.CaptureFixture[str]) -> Trackwright:
    """Runs a command; gives exit status, stdout and stderr."""

    def typed(*words: str | Path) -> tuple[int, str, str]:
        status = run([str(word) for word in words])
        return (status, *capsys.readouterr())

    return typed
