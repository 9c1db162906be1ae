"""What is left out of the folder with the program, and what must not be."""

from __future__ import annotations

import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from tests.bundle.trimming import (
    MODULES,
    is_left_out,
    is_loadable,
    libraries_needed,
    strip_libraries,
    with_one_ffmpeg,
    without_orphans,
)

_CV, _AV = "opencv_python_headless.libs", "av.libs"
_NEEDS_BINUTILS = pytest.mark.skipif(
    any(shutil.which(name) is None for name in ("strip", "readelf", "objdump")),
    reason="no binutils (apt-get install binutils)",
)


@pytest.mark.parametrize(
    ("name", "left_out"),
    [
        ("PySide6/Qt/translations/qtbase_ja.qm", False),
        ("PySide6/Qt/translations/qt_ja.qm", False),
        ("PySide6/Qt/translations/qtbase_de.qm", False),
        ("PySide6/Qt/translations/qt_help_de.qm", True),
        ("resources/translations/trackwright.pot", False),
        ("PySide6/Qt/plugins/platforms/libqxcb.so", False),
        ("PySide6/Qt/plugins/platforms/libqwayland.so", False),
        ("PySide6/Qt/plugins/platforms/libqoffscreen.so", False),
        ("PySide6/Qt/plugins/imageformats/libqjpeg.so", False),
        ("PySide6/Qt/plugins/platformthemes/libqgtk3.so", True),
        ("PySide6/Qt/plugins/tls/libqopensslbackend.so", True),
        ("PySide6/QtNetwork.abi3.so", True),
        ("libQt6Network.so.6", True),
    ],
)
def test_files_of_qt_that_the_program_never_loads_are_left_out(name: str, left_out: bool) -> None:
    assert is_left_out(name) is left_out


def test_no_module_of_ours_imports_what_is_left_out() -> None:
    root = Path(__file__).parents[2]
    ours = [file for name in ("app", "tracking") for file in (root / name).rglob("*.py")]
    code = "\n".join(file.read_text() for file in ours)
    assert not [
        name
        for name in MODULES
        if name != "pandas"  # an extra
        for line in (f"import {name}", f"from {name}")
        if f"\n{line} " in code or f"\n    {line} " in code
    ]


def _entry(folder: str, name: str) -> tuple[str, str, str]:
    return f"{folder}/{name}", f"/env/{folder}/{name}", "BINARY"


def test_opencv_borrows_the_libraries_of_ffmpeg_that_can_stand_for_its_own() -> None:
    entries = [
        _entry(_CV, "libavcodec-c42.so.62.28.101"),
        _entry(_CV, "libavutil-bef.so.60.26.101"),
        _entry(_CV, "libswscale-fe2.so.8.5.101"),
        _entry(_CV, "libpng16-529.so.16.58.0"),
        _entry(_AV, "libavcodec-5e6.so.62.28.102"),
        _entry(_AV, "libavutil-580.so.60.25.102"),  # older
        _entry(_AV, "libswscale-88e.so.9.5.102"),  # of another major version
    ]
    made = with_one_ffmpeg(entries)
    assert made[0] == (
        f"{_CV}/libavcodec-c42.so.62.28.101",
        f"../{_AV}/libavcodec-5e6.so.62.28.102",
        "SYMLINK",
    )
    assert made[1:] == entries[1:]


def test_libraries_that_nothing_needs_any_more_go_with_what_needed_them() -> None:
    needs = {
        "/s/qt_network": ["libgssapi.so", "libc.so"],
        "/s/libgssapi.so": ["libkrb5.so"],
        "/s/libkrb5.so": [],
        "/s/qt_gui": ["libz.so"],
        "/s/libz.so": [],
        "/s/libdlopened.so": [],
    }
    before = [(Path(source).name, source, "BINARY") for source in needs]
    before.append(("link.so", "libkrb5.so", "SYMLINK"))
    kept = without_orphans(before, before[1:], lambda source: needs[source])
    assert [name for name, _, _ in kept] == ["qt_gui", "libz.so", "libdlopened.so"]


@_NEEDS_BINUTILS
def test_stripped_libraries_are_smaller_and_can_be_loaded(tmp_path: Path) -> None:
    held = Path(sysconfig.get_path("platlib")) / "yaml"
    source = next(held.glob("_yaml*.so"))
    inner = tmp_path / "yaml"
    shutil.copytree(held, inner)
    (tmp_path / "no_library.so").write_text("text")
    saved = strip_libraries(tmp_path)
    stripped = inner / source.name
    assert saved == source.stat().st_size - stripped.stat().st_size
    assert saved > 0
    assert is_loadable(stripped)
    assert libraries_needed(str(stripped)) == libraries_needed(str(source))
    assert (tmp_path / "no_library.so").read_text() == "text"
    code = "import yaml; print(yaml.__file__, yaml.load('a: 1', yaml.CSafeLoader))"
    said = subprocess.run(
        [sys.executable, "-c", code],
        env={"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert said.stdout.startswith(str(tmp_path))
