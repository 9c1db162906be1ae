"""The conformance kit: what is built in keeps its rules, and it finds who breaks them."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import pytest
from bad_trackers import tracker_code

from tracking.formats import FORMATS, TrackFormat
from tracking.testing import BrokenRule, check_format, check_installed, check_tracker
from tracking.trackers import TRACKERS, TrackerSpec


@pytest.mark.parametrize("name", [name for name, one in FORMATS.items() if one.write])
def test_every_format_of_ours_that_is_written_keeps_the_rules(name: str, tmp_path: Path) -> None:
    check_format(FORMATS[name], tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("name", TRACKERS.built_in)
def test_every_tracker_of_ours_keeps_the_rules(name: str, tmp_path: Path) -> None:
    check_tracker(TRACKERS[name], tmp_path)


BROKEN = {
    "tracks['left'] = tracks['left'] + np.random.rand()": "two runs with the same seed differ",
    "HELD.append(open(__import__('os').devnull))": "leaves files open",
    "tracks['width'] = -tracks['width']": "a negative width or height",
}


def _tracker(code: str, monkeypatch: pytest.MonkeyPatch) -> TrackerSpec:
    module = ModuleType("broken")
    monkeypatch.setitem(sys.modules, "broken", module)  # where dataclasses look
    exec(code, module.__dict__)
    spec: TrackerSpec = module.TRACKER
    return spec


@pytest.mark.parametrize("step", BROKEN)
def test_a_tracker_that_breaks_a_rule_is_told_which(
    step: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(BrokenRule, match=BROKEN[step]):
        check_tracker(_tracker(tracker_code(step), monkeypatch), tmp_path)


def test_a_setting_that_is_described_badly_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    people = "people: PeopleSettings = stage(PeopleSettings)"
    code = tracker_code().replace(people, f"{people}\n    odd: int = setting(1, '', None, 'low')")
    with pytest.raises(BrokenRule, match="setting odd: its help must begin with a capital"):
        check_tracker(_tracker(code, monkeypatch), tmp_path)


def _csv(**changed: object) -> TrackFormat:
    return replace(FORMATS["csv"], name="other", **changed)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        (lambda: _csv(recognises=lambda *_: True), "takes an empty file for its own"),
        (lambda: _csv(recognises=lambda *_: 1 / 0), "recognises raised"),
        (lambda: _csv(recognises=lambda *_: False), "does not recognise its own file"),
        (lambda: _csv(read=None, write=None), "neither reads nor writes"),
        (lambda: _csv(extensions=("csv",)), "must begin with a dot"),
    ],
)
def test_a_format_that_breaks_a_rule_is_told_which(kind, said: str, tmp_path: Path) -> None:
    with pytest.raises(BrokenRule, match=said):
        check_format(kind(), tmp_path)


def test_what_is_not_installed_is_told_with_what_to_write() -> None:
    with pytest.raises(BrokenRule, match=r'project.entry-points."trackwright.trackers"'):
        check_installed("tracker", "nowhere")


def test_a_name_that_is_taken_is_told(tmp_path: Path) -> None:
    with pytest.raises(BrokenRule, match="the name csv is that of one that is built in"):
        check_format(replace(FORMATS["csv"], recognises=lambda *_: True), tmp_path)
