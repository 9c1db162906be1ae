"""What is built for installing is whole, and the same every time."""

from __future__ import annotations

import subprocess
import sys
import tarfile
import tomllib
import zipfile
from email import message_from_string
from pathlib import Path

import pytest

from tests.bill_of_materials import components, document

ROOT = Path(__file__).parents[1]
PACKAGES = ("app", "tracking", "resources")
_NOT_SHIPPED = {"__pycache__", ".mypy_cache", ".ruff_cache"}


def _build(source: Path, kind: str, folder: Path) -> Path:
    """A wheel or an sdist of a source tree, built as pip builds it."""
    folder.mkdir(parents=True)
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", kind, "-d", str(folder)],
        cwd=source,
        check=True,
        capture_output=True,
    )
    (built,) = folder.iterdir()
    return built


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Built from the checkout."""
    return _build(ROOT, "wheel", tmp_path_factory.mktemp("wheel") / "dist")


@pytest.fixture(scope="module")
def sdist(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The source as it is handed on."""
    return _build(ROOT, "sdist", tmp_path_factory.mktemp("sdist") / "dist")


def test_two_wheels_are_the_same_to_the_byte(wheel: Path, tmp_path: Path) -> None:
    assert _build(ROOT, "wheel", tmp_path / "again").read_bytes() == wheel.read_bytes()


def test_a_wheel_of_the_handed_on_source_is_the_same_to_the_byte(
    wheel: Path, sdist: Path, tmp_path: Path
) -> None:
    with tarfile.open(sdist) as archive:
        archive.extractall(tmp_path / "source", filter="data")
    (source,) = (tmp_path / "source").iterdir()
    assert _build(source, "wheel", tmp_path / "dist").read_bytes() == wheel.read_bytes()


def test_two_sources_are_the_same_to_the_byte(sdist: Path, tmp_path: Path) -> None:
    assert _build(ROOT, "sdist", tmp_path / "again").read_bytes() == sdist.read_bytes()


def test_a_wheel_has_every_file_of_the_packages(wheel: Path) -> None:
    ours = {
        path.relative_to(ROOT).as_posix()
        for package in PACKAGES
        for path in (ROOT / package).rglob("*")
        if path.is_file() and not _NOT_SHIPPED & set(path.parts) and path.suffix != ".pyc"
    }
    with zipfile.ZipFile(wheel) as archive:
        held = set(archive.namelist())
    assert sorted(ours - held) == ["app/launcher.py"]  # it is trackwright.py there
    for needed in (
        "trackwright.py",
        "tracking/py.typed",
        "resources/part_failures_paper.h5",
        "resources/plugin_package/pyproject.toml.jinja",
        "trackwright-0.1.0.data/data/share/applications/trackwright.desktop",
        "trackwright-0.1.0.dist-info/licenses/LICENSE",
    ):
        assert needed in held
    strays = [one for one in held if one.startswith(("tests/", "docs/"))]
    assert strays == []


def test_the_metadata_of_a_wheel_is_whole(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        told = message_from_string(archive.read("trackwright-0.1.0.dist-info/METADATA").decode())
        points = archive.read("trackwright-0.1.0.dist-info/entry_points.txt").decode()
    assert told["Summary"]
    assert told["Keywords"]
    assert told["License-Expression"] == "MIT"
    assert told["Requires-Python"] == ">=3.11"
    assert "Typing :: Typed" in (told.get_all("Classifier") or [])
    assert told["Description-Content-Type"] == "text/markdown"
    for group in ("trackers", "formats", "recordings", "detectors"):
        assert f"[trackwright.{group}]" in points


def test_the_bill_of_materials_names_everything_that_is_needed_with_a_licence() -> None:
    found = {one.name: one for one in components()}
    told = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    names = {one.split(">")[0].split("[")[0].lower() for one in told["dependencies"]}
    assert sorted(names - found.keys()) == []
    assert [name for name, one in found.items() if not one.licence] == []
    assert "pytest" not in found
    listed = document(list(found.values()))
    assert len(listed["components"]) == len(found) - 1
    assert listed["metadata"]["component"]["name"] == "trackwright"
