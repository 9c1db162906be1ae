"""The folder with its own Python: what begins in it, and how it is packed."""

from __future__ import annotations

import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

from app import bundle
from tests.bundle.archives import debian_package, packed_folder
from tests.bundle.environment import versions_of

_ROOT = Path(__file__).parents[2]


def _said(*words: str) -> str:
    """What the program in the folder prints; here it is run by this Python."""
    command = [sys.executable, str(Path(bundle.__file__)), *words]
    done = subprocess.run(
        command,
        cwd=_ROOT,
        env={"PYTHONPATH": str(_ROOT)},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.strip()


def test_it_is_the_program() -> None:
    assert _said("--version").startswith("trackwright ")


def test_it_does_what_python_does_for_the_programs_begun_from_it(tmp_path: Path) -> None:
    file = tmp_path / "say.py"
    file.write_text("import sys\nprint(__name__, *sys.argv[1:])\n")
    assert _said("-P", str(file), "a", "-m") == "__main__ a -m"
    assert _said("-P", "-c", "import sys; print(sys.argv)", "b") == "['-c', 'b']"
    assert _said("-P", "-m", "json.tool", "--help").startswith("usage: ")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "trackwright"
    made.mkdir()
    (made / "trackwright").write_text("#!/bin/sh\n")
    (made / "trackwright").chmod(0o755)
    return made


def test_the_archive_is_one_folder_that_belongs_to_nobody_in_particular(folder: Path) -> None:
    with tarfile.open(packed_folder(folder, folder.parent)) as archive:
        held = {entry.name: (entry.uname, entry.mode & 0o111) for entry in archive}
    assert held == {"trackwright": ("root", 0o111), "trackwright/trackwright": ("root", 0o111)}


@pytest.mark.skipif(shutil.which("dpkg-deb") is None, reason="no dpkg-deb (apt-get install dpkg)")
def test_the_package_has_the_program_its_entry_and_the_type_of_sessions(folder: Path) -> None:
    file = debian_package(folder, folder.parent, "1.2.3")
    told = subprocess.run(
        ["dpkg-deb", "-f", file, "Version", "Depends"], capture_output=True, text=True
    )
    assert "1.2.3" in told.stdout
    assert "libegl1" in told.stdout
    listed = subprocess.run(["dpkg-deb", "-c", file], capture_output=True, text=True).stdout
    for part in (
        "./opt/trackwright/trackwright",
        "./usr/bin/trackwright -> /opt/trackwright/trackwright",
        "./usr/share/applications/trackwright.desktop",
        "./usr/share/mime/packages/trackwright.xml",
        "./usr/share/doc/trackwright/copyright",
    ):
        assert part in listed


def test_the_folder_is_made_of_the_versions_of_the_lock_file() -> None:
    lock = "a-b==1.0 \\\n    --hash=x:00\nc==2 ; python_version < '3.12' \\\n    --hash=x:11\n"
    assert versions_of(lock) == "a-b==1.0\nc==2 ; python_version < '3.12'"
