"""`doctor` names the cure of faults that are planted in an installation."""

from __future__ import annotations

import importlib.metadata
import sys
from collections import namedtuple
from importlib.machinery import ModuleSpec
from pathlib import Path

import pytest

from app.cli import installation_faults
from app.cli.installation import check_installation
from app.cli.installation_faults import find_faults
from tests.installed_plugins import install_module, write_metadata
from tracking.plugins import offers

_Usage = namedtuple("_Usage", "total used free")


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    folder = tmp_path / "site"
    folder.mkdir()
    monkeypatch.syspath_prepend(str(folder))
    yield folder
    monkeypatch.undo()
    offers.look_again()


def _faults() -> dict[str, tuple[str, bool]]:
    return {name: (str(said), needed) for name, said, needed in find_faults({})}


def test_an_installation_without_faults_has_none(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("QT_PLUGIN_PATH", raising=False)
    monkeypatch.delenv("QT_QPA_PLATFORM_PLUGIN_PATH", raising=False)
    assert _faults() == {}


def test_a_second_opencv_is_told(site: Path) -> None:
    write_metadata(site, "opencv-python", "5.0", {})
    said, needed = _faults()["opencv"]
    assert "pip uninstall opencv-python" in said
    assert needed


def test_plugins_of_another_qt_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("QT_PLUGIN_PATH", "/opt/other")
    assert "unset QT_PLUGIN_PATH" in _faults()["second qt"][0]


def test_another_qt_among_the_libraries_is_told_and_ones_own_is_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("ours", "theirs"):
        (tmp_path / name / "PySide6").mkdir(parents=True)
        (tmp_path / name / "libQt6Core.so.6").touch()
    package = tmp_path / "ours" / "PySide6" / "__init__.py"
    found = ModuleSpec("PySide6", None, origin=str(package))
    monkeypatch.setattr(installation_faults.importlib.util, "find_spec", lambda _: found)
    monkeypatch.setenv("LD_LIBRARY_PATH", str(tmp_path / "ours"))  # as in a bundle
    assert "second qt" not in _faults()
    monkeypatch.setenv("LD_LIBRARY_PATH", str(tmp_path / "theirs"))
    assert f"holds another Qt in {tmp_path / 'theirs'}" in _faults()["second qt"][0]


def test_a_full_disk_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    full = lambda _: _Usage(10, 10, 5_000_000)  # noqa: E731
    monkeypatch.setattr(installation_faults.shutil, "disk_usage", full)
    assert "5 MB are free" in _faults()["room for temporary folder"][0]


def test_a_damaged_file_is_told(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (site / "resources_of_it.txt").write_text("changed")
    write_metadata(site, "whole", "1.0", {})
    record = site / "whole-1.0.dist-info" / "RECORD"
    record.write_text("resources_of_it.txt,sha256=47DEQpj8HBSa-_TImW-5JCeuQeRkm5NMpJWZG3hSuFU,0\n")
    monkeypatch.setattr(installation_faults, "_NAME", "whole")
    said, needed = _faults()["resources"]
    assert "resources_of_it.txt" in said
    assert "--force-reinstall" in said
    assert needed
    assert importlib.metadata.version("whole") == "1.0"


def test_lost_resources_are_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation_faults.resources, "__file__", str(tmp_path / "__init__.py"))
    assert "files are missing" in _faults()["resources"][0]


def test_a_plugin_that_does_not_work_is_told_and_is_not_needed(site: Path) -> None:
    install_module(site, "broken", "1 / 0", {("trackwright.trackers", "broken"): "TRACKER"})
    offers.look_again()
    said, needed = _faults()["plug-in broken"]
    assert "pip uninstall broken" in said
    assert not needed
    (check,) = [one for one in check_installation() if one.name == "plug-in broken"]
    assert not check.is_well
    sys.modules.pop("broken", None)
