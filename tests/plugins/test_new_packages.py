"""`plugins new` makes packages that keep the rules."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from app.__main__ import run as run_command
from app.cli.plugin_package import PluginPackage, make_package
from tests.installed_plugins import install_package
from tracking.plugins import PluginKind

_MOST_LINES = 40


@pytest.mark.slow
@pytest.mark.parametrize("kind", PluginKind)
def test_the_tests_of_a_new_package_pass(kind: PluginKind, site: Path, tmp_path: Path) -> None:
    place = make_package(PluginPackage(kind, "my-own"), tmp_path)
    install_package(place, site)
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(place)],
        capture_output=True,
        text=True,
        check=False,
        cwd=place,
    )
    assert done.returncode == 0, done.stdout
    assert "2 passed" in done.stdout


def test_a_new_tracker_is_of_forty_lines_at_most(tmp_path: Path) -> None:
    place = make_package(PluginPackage(PluginKind.TRACKER, "mine"), tmp_path)
    code = (place / "src" / "trackwright_mine" / "__init__.py").read_text(encoding="utf-8")
    assert len(code.splitlines()) <= _MOST_LINES
    assert max(map(len, code.splitlines())) <= 100


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["old", "tracker", "mine"], "'old' is unknown"),
        (["new"], "name what to make: tracker, format, recording, detector"),
        (["new", "window", "mine"], "name what to make"),
        (["new", "tracker"], "give a name of small letters"),
        (["new", "tracker", "../mine"], "give a name of small letters"),
        (["new", "tracker", "Mine"], "give a name of small letters"),
        (["new", "tracker", "flow"], "there is a tracker flow already"),
    ],
)
def test_what_cannot_be_made_is_told_in_one_line(
    words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_command(["plugins", *words, "--out", str(tmp_path)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line
    assert list(tmp_path.iterdir()) == []


def test_a_package_that_is_there_stays_as_it_is(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "trackwright-mine").mkdir()
    assert run_command(["plugins", "new", "tracker", "mine", "--out", str(tmp_path)]) == 1
    assert "is there already" in capsys.readouterr().err
    assert list((tmp_path / "trackwright-mine").iterdir()) == []
    assert len(list(tmp_path.iterdir())) == 1
