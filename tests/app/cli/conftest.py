"""What the tests of the command line share."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from command_line import Trackwright

from app.__main__ import run


@pytest.fixture(scope="session")
def footage(tiny_recording: Path) -> Path:
    """Ten seconds of a small stereo recording with four people; not to be changed."""
    return tiny_recording


@pytest.fixture
def recording(footage: Path, tmp_path: Path) -> Path:
    """A copy of it, to be damaged."""
    return Path(shutil.copytree(footage, tmp_path / "square"))


@pytest.fixture
def trackwright(capsys: pytest.CaptureFixture[str]) -> Trackwright:
    """Runs a command; gives exit status, stdout and stderr."""

    def typed(*words: str | Path) -> tuple[int, str, str]:
        status = run([str(word) for word in words])
        return (status, *capsys.readouterr())

    return typed
