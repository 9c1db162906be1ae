"""The door: what is built in and what is plugged in comes through it alike."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from bad_trackers import tracker_code

from tests.installed_plugins import install_module
from tracking.detections.catalogue import DETECTORS
from tracking.errors import PluginError, SettingsError
from tracking.formats import FORMATS, format_of
from tracking.plugins import WITHOUT, PluginKind, offers
from tracking.recording.kinds.catalogue import KINDS
from tracking.trackers import TRACKERS, tracker_named

ROOT = Path(__file__).parents[2]
CATALOGUES = {PluginKind(each.kind): each for each in (TRACKERS, FORMATS, KINDS, DETECTORS)}
GROUP = PluginKind.TRACKER.group


@pytest.mark.parametrize("kind", PluginKind)
def test_what_is_built_in_stands_among_the_entry_points_in_the_same_order(kind: PluginKind) -> None:
    told = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    points = told["project"]["entry-points"][kind.group]
    assert list(points.items()) == list(CATALOGUES[kind].built_in.items())


@pytest.mark.parametrize("kind", PluginKind)
def test_everything_that_is_built_in_loads_under_its_name(kind: PluginKind) -> None:
    catalogue = CATALOGUES[kind]
    assert [catalogue[name].name for name in catalogue.built_in] == list(catalogue.built_in)


def test_names_are_known_before_anything_is_imported() -> None:
    code = (
        "import sys, tracking.plugins as p\n"
        "from tracking.trackers.catalogue import TRACKERS\n"
        "assert 'flow' in TRACKERS.names\n"
        "print([m for m in sys.modules if m.startswith('tracking.trackers.built_in.')])\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_plugin_is_not_imported_for_its_name(site: Path) -> None:
    install_module(site, "loud", "raise SystemExit('imported')", {(GROUP, "loud"): "TRACKER"})
    offers.look_again()
    assert TRACKERS.names[-1] == "loud"
    assert tracker_named("flow").name == "flow"
    assert "loud" not in sys.modules


def test_a_plugin_stands_among_the_trackers_behind_those_built_in(site: Path) -> None:
    install_module(site, "bad", tracker_code(), {(GROUP, "bad"): "TRACKER"})
    offers.look_again()
    assert list(TRACKERS) == [*TRACKERS.built_in, "bad"]
    assert tracker_named("bad").title == "Bad"


def test_plugins_can_be_left_out(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    install_module(site, "bad", tracker_code(), {(GROUP, "bad"): "TRACKER"})
    offers.look_again()
    monkeypatch.setenv(WITHOUT, "off")
    assert list(TRACKERS) == list(TRACKERS.built_in)
    with pytest.raises(SettingsError, match="tracker bad is unknown"):
        tracker_named("bad")


WRONG_MODULES = {
    "raises": ("1 / 0", "raised ZeroDivisionError: division by zero at wrong.py:1"),
    "exits": ("raise SystemExit(2)", "raised SystemExit: 2"),
    "interrupts": ("raise KeyboardInterrupt", "raised KeyboardInterrupt"),
    "has no such module": ("import nowhere_at_all", "raised ModuleNotFoundError"),
    "is no code": ("def", "raised SyntaxError"),
    "lacks the name": ("OTHER = 1", "raised AttributeError"),
    "is of another kind": ("TRACKER = 7", "wrong:TRACKER is int, and should be TrackerSpec"),
    "bears another name": (tracker_code(), "its entry point says wrong, it calls itself bad"),
}


@pytest.mark.parametrize("case", WRONG_MODULES)
def test_a_plugin_that_does_not_load_is_named_and_left_out(site: Path, case: str) -> None:
    code, said = WRONG_MODULES[case]
    install_module(site, "wrong", code, {(GROUP, "wrong"): "TRACKER"}, "2.5")
    offers.look_again()
    assert list(TRACKERS) == list(TRACKERS.built_in)
    with pytest.raises(PluginError) as caught:
        tracker_named("wrong")
    assert str(caught.value).startswith("tracker wrong (plug-in wrong 2.5)")
    assert said in str(caught.value)
    assert "pip uninstall wrong" in str(caught.value)


def test_a_plugin_that_hangs_as_it_is_imported_is_given_up_on(
    site: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    code = "import time\nfor _ in range(80): time.sleep(0.05)"
    install_module(site, "slow", code, {(GROUP, "slow"): "TRACKER"})
    offers.look_again()
    monkeypatch.setattr("tracking.plugins.loader.LOAD_S", 0.1)
    with pytest.raises(PluginError, match=r"slow 1.0\): it did not answer within 0.1 s"):
        tracker_named("slow")


def test_a_plugin_cannot_take_the_name_of_what_is_built_in(site: Path) -> None:
    install_module(site, "thief", tracker_code(), {(GROUP, "flow"): "TRACKER"})
    offers.look_again()
    assert TRACKERS["flow"].paper == "Yoneji2013"
    TRACKERS.load_all()
    (fault,) = [one for one in TRACKERS.faults if one.offer.package == "thief"]
    assert "its name is that of tracker flow already" in str(fault.error)


def test_of_two_plugins_of_one_name_the_second_is_told(site: Path) -> None:
    for package in ("one", "two"):
        install_module(site, package, tracker_code(), {(GROUP, "bad"): "TRACKER"})
    offers.look_again()
    TRACKERS.load_all()
    (fault,) = [one for one in TRACKERS.faults if one.offer.package == "two"]
    assert "its name is that of tracker bad (plug-in one 1.0) already" in str(fault.error)


FORMAT = """
from tracking.formats import TrackFormat
def recognises(path, head):
    {recognises}
FORMAT = TrackFormat("odd", "Odd", (".odd",), recognises, read=lambda *_: {read})
"""


def _install_format(site: Path, recognises: str, read: str = "None") -> None:
    code = FORMAT.format(recognises=recognises, read=read)
    install_module(site, "odd", code, {("trackwright.formats", "odd"): "FORMAT"})
    offers.look_again()


def test_a_format_of_a_plugin_is_asked_where_none_of_ours_knows_a_file(
    site: Path, tmp_path: Path
) -> None:
    _install_format(site, "return head.startswith(b'odd')")
    (tmp_path / "tracks").write_bytes(b"odd tracks")
    assert format_of(tmp_path / "tracks").name == "odd"


def test_a_format_of_a_plugin_takes_no_file_from_ours(site: Path, tmp_path: Path) -> None:
    _install_format(site, "return True")
    (tmp_path / "t.txt").write_text("1,1,2,3,4,5,1,-1,-1,-1\n")
    assert format_of(tmp_path / "t.txt").name == "mot"


def test_a_format_that_raises_is_named_where_nobody_knows_the_file(
    site: Path, tmp_path: Path
) -> None:
    _install_format(site, "raise RuntimeError('what is this')")
    (tmp_path / "tracks").write_bytes(b"odd tracks")
    with pytest.raises(PluginError, match=r"format odd \(plug-in odd 1.0\) raised RuntimeError"):
        format_of(tmp_path / "tracks")
    (tmp_path / "t.txt").write_text("1,1,2,3,4,5,1,-1,-1,-1\n")
    assert format_of(tmp_path / "t.txt").name == "mot"


def test_a_format_that_reads_no_tracks_is_named(site: Path, tmp_path: Path) -> None:
    _install_format(site, "return head.startswith(b'odd')", "[1, 2]")
    read = FORMATS["odd"].read
    assert read is not None
    with pytest.raises(PluginError, match="read gave list, and should give Imported"):
        read(tmp_path, None)  # type: ignore[arg-type]
