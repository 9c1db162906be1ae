"""The desktop's menu, icon and type of sessions."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from app.__main__ import run
from app.cli import desktop

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="of Linux desktops")


@pytest.fixture
def data(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path / "data"


def test_the_entry_calls_the_program_where_it_is_installed(
    data: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["desktop", "--json"]) == 0
    written = json.loads(capsys.readouterr().out)["written"]
    assert [Path(one).is_file() for one in written] == [True, True, True]
    entry = (data / "applications" / "trackwright.desktop").read_text(encoding="utf-8")
    (called,) = [line for line in entry.splitlines() if line.startswith("Exec=")]
    assert called == f"Exec={desktop.command()} open %f"
    ET.parse(data / "mime" / "packages" / "trackwright.xml")


def test_what_was_entered_is_removed(data: Path) -> None:
    assert run(["desktop"]) == 0
    assert run(["desktop", "--remove"]) == 0
    assert not list(data.rglob("trackwright.*"))
    assert run(["desktop", "--remove"]) == 0


def test_a_folder_that_cannot_be_made_is_told_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "file"))
    assert run(["desktop"]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert "cannot make" in line


@pytest.mark.parametrize(
    ("path", "written"),
    [
        ("/usr/bin/trackwright", "/usr/bin/trackwright"),
        ("/home/A B/trackwright", '"/home/A B/trackwright"'),
        ("/home/50%/t$", '"/home/50%%/t\\\\$"'),
    ],
)
def test_a_path_with_special_signs_is_quoted(path: str, written: str) -> None:
    assert desktop._quoted(path) == written


@pytest.mark.skipif(
    shutil.which("update-mime-database") is None or shutil.which("gio") is None,
    reason="no programs that tell types",
)
def test_a_session_is_told_by_its_content(
    data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert run(["desktop"]) == 0
    file = tmp_path / "renamed.bin"
    file.write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(900) + b"trackwright-session" + bytes(900))
    monkeypatch.setenv("XDG_DATA_DIRS", "/usr/share")
    told = subprocess.run(
        ["gio", "info", "-a", "standard::content-type", str(file)],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "application/x-trackwright-session" in told.stdout
