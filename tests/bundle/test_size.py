"""What takes the room: counted by package."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.bundle.size import parts_of_environment, parts_of_folder, print_table


def _file(path: Path, size: int) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"x" * size)


def test_a_package_counts_what_it_installed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {
        "one/__init__.py": 100,
        "one/fast.cpython-313-x86_64-linux-gnu.so": 2_000_000,
        "one/__pycache__/__init__.cpython-313.pyc": 50,
        "one/tests/test_one.py": 30,
    }
    for name, size in files.items():
        _file(tmp_path / name, size)
    info = tmp_path / "one-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: one\nVersion: 1.0\n")
    (info / "RECORD").write_text("".join(f"{name},,\n" for name in (*files, "one/gone.py")))
    (part,) = parts_of_environment(tmp_path)
    assert (part.name, part.whole, part.libraries) == ("one", 2_000_180, 2_000_000)
    assert (part.compiled, part.tests) == (50, 30)
    print_table([part])
    lines = capsys.readouterr().out.splitlines()
    assert lines[1].split() == ["2.0", "2.0", "0.0", "0.0", "one"]
    assert lines[-1].split()[0] == "2.0"


def test_a_folder_is_counted_by_what_stands_right_in_it(tmp_path: Path) -> None:
    inner = tmp_path / "_internal"
    _file(inner / "Qt" / "lib" / "libQt6Core.so.6", 1000)
    _file(inner / "libz.so.1", 10)
    (inner / "libQt6Core.so.6").symlink_to("Qt/lib/libQt6Core.so.6")
    found = {part.name: (part.whole, part.libraries) for part in parts_of_folder(tmp_path)}
    assert found == {"Qt": (1000, 1000), "files right in it": (10, 10)}
