"""The installed command beside other programs' packages of the same names."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from app.launcher import OWN, OwnPackages, install_folders

SCRIPT = Path(sys.executable).with_name("trackwright")
INSTALLED = [str(SCRIPT)]
AS_A_MODULE = [sys.executable, "-P", "-m", "trackwright"]
CHECKOUT = str(Path(__file__).parents[3])


@pytest.fixture
def others(tmp_path: Path) -> Path:
    """A folder with packages of other programs, which end whatever imports them."""
    for name in OWN:
        package = tmp_path / "others" / name
        package.mkdir(parents=True)
        (package / "__init__.py").write_text(f"raise SystemExit('the wrong {name}')\n")
    return tmp_path / "others"


def obeyed(
    words: list[str | Path], path: list[str | Path], command: list[str] = INSTALLED
) -> subprocess.CompletedProcess[str]:
    """What the command does in a process of its own, with folders in PYTHONPATH."""
    return subprocess.run(
        [*command, *map(str, words)],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, path))},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.skipif(not SCRIPT.exists(), reason="the command is not installed beside Python")
def test_the_installed_command_finds_its_own_packages(others: Path) -> None:
    done = obeyed(["trackers", "--json"], [others])
    assert (done.returncode, done.stderr) == (0, "")
    assert json.loads(done.stdout)["trackers"]


@pytest.mark.skipif(not SCRIPT.exists(), reason="the command is not installed beside Python")
def test_so_does_python_with_the_name_of_the_module(others: Path) -> None:
    done = obeyed(["trackers", "--json"], [others, CHECKOUT], AS_A_MODULE)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_wheel_has_the_packages_beside_the_module(tmp_path: Path) -> None:
    (tmp_path / "app").mkdir()
    (tmp_path / "app" / "__init__.py").touch()
    finder = OwnPackages(install_folders(tmp_path / "trackwright.py"))
    found = finder.find_spec("app")
    assert found is not None
    assert found.origin == str(tmp_path / "app" / "__init__.py")
    assert finder.find_spec("json") is None


def test_an_editable_install_names_the_checkout(tmp_path: Path) -> None:
    (tmp_path / "_editable_impl_trackwright.pth").write_text("/somewhere/else\n")
    folders = list(install_folders(tmp_path / "trackwright.py"))
    assert folders == [str(tmp_path), "/somewhere/else"]


@pytest.mark.skipif(not SCRIPT.exists(), reason="the command is not installed beside Python")
def test_the_programs_that_look_files_over_do_too(others: Path, session: Path) -> None:
    done = obeyed(["info", session, "--json"], [others])
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["kind"] == "session"


def test_the_tracker_s_process_does_too(others: Path, footage: Path) -> None:
    code = (
        f"import sys; sys.path.insert(0, {CHECKOUT!r})\n"
        "import pathlib\n"
        "from app.core.tracking_process import TrackerProcess, TrackingRequest\n"
        "from tracking.recording import open_recording\n"
        "with open_recording(pathlib.Path(sys.argv[1])) as recording:\n"
        "    request = TrackingRequest.of(recording, 'flow', None, 0, (0, 2))\n"
        "print(sum(len(batch) for batch in TrackerProcess(request).batches()))\n"
    )
    done = obeyed([footage], [others, CHECKOUT], [sys.executable, "-P", "-c", code])
    assert (done.stdout, done.returncode) == ("2\n", 0), done.stderr
