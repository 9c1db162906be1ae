"""What `make` does about missing system libraries."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence

import pytest

from app.cli.system_libraries import INSTALL, Machine, ensure

MISSING = "Qt cannot start: libEGL.so.1: cannot open shared object file"


class FakeMachine:
    """Answers the check with one answer after the other and notes what was run."""

    def __init__(self, *answers: str, status: int = 0) -> None:
        self.answers = list(answers)
        self.status = status
        self.commands: list[Sequence[str]] = []

    def run(self, command: Sequence[str]) -> int:
        self.commands.append(command)
        return self.status

    def with_rights(self, *, has_apt: bool = True, is_root: bool = True) -> Machine:
        return Machine(lambda: self.answers.pop(0), has_apt, is_root, self.run)


def test_nothing_is_said_or_done_when_nothing_is_missing(
    capfd: pytest.CaptureFixture[str],
) -> None:
    machine = FakeMachine("")
    assert ensure(machine.with_rights()) == 0
    assert machine.commands == []
    assert capfd.readouterr() == ("", "")


def test_root_installs_what_is_missing() -> None:
    machine = FakeMachine(MISSING, "")
    assert ensure(machine.with_rights()) == 0
    assert machine.commands == [("apt-get", "update", "-q"), INSTALL]


def test_others_are_given_the_one_command(capsys: pytest.CaptureFixture[str]) -> None:
    machine = FakeMachine(MISSING)
    assert ensure(machine.with_rights(is_root=False)) == 1
    assert machine.commands == []
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    assert "libEGL.so.1" in told
    assert "apt-get update && apt-get install -y --no-install-recommends libgl1 " in told


def test_other_systems_are_told_the_library(capsys: pytest.CaptureFixture[str]) -> None:
    assert ensure(FakeMachine(MISSING).with_rights(has_apt=False)) == 1
    told = capsys.readouterr().err
    assert "libEGL.so.1" in told
    assert "apt-get" not in told


def test_an_installation_that_fails_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert ensure(FakeMachine(MISSING, status=100).with_rights()) == 1
    assert "could not be installed; run: apt-get update" in capsys.readouterr().err


def test_an_installation_that_did_not_help_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert ensure(FakeMachine(MISSING, MISSING).with_rights()) == 1
    assert "although its packages are installed" in capsys.readouterr().err


def test_this_machine_can_show_the_window() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "app.cli.system_libraries"], capture_output=True, text=True
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
