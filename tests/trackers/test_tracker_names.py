"""Only the catalogue and a tracker's own folder know its name: all others ask what it can do."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from tracking.trackers import TRACKERS, TrackerSpec, body_part_tracker, tracker_with

ROOT = Path(__file__).parents[2]
TRACKER_FOLDERS = ROOT / "tracking" / "trackers"
CATALOGUE = {
    TRACKER_FOLDERS / "catalogue.py",
    *(TRACKER_FOLDERS / "built_in").glob("*.py"),
}
TEXTS = {".py", ".html", ".j2", ".toml", ".json"}
_OTHER_WORDS = re.compile(r"docs/[\w/-]+|[Ff]low map|https?://\S+")
"""Pages of the documents, and other things that are called like a tracker."""


def _folder(spec: TrackerSpec) -> Path:
    module = spec.build.__module__.split(".")
    assert module[:2] == ["tracking", "trackers"]
    return TRACKER_FOLDERS / module[2]


@cache
def _sources() -> dict[Path, tuple[str, ...]]:
    """What is looked through of each file: plain strings of code, all of other files."""
    files = [
        path
        for room in ("app", "tracking")
        for path in sorted((ROOT / room).rglob("*"))
        if path.suffix in TEXTS and path not in CATALOGUE
    ]
    assert len(files) > 500
    return {path: tuple(_texts(path)) for path in files}


def _texts(path: Path) -> Iterator[str]:
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".py":
        yield text
        return
    tree = ast.parse(text)
    documents = {
        id(node.value)
        for node in ast.walk(tree)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value if id(node) not in documents else ""


def _naming(name: str, texts: tuple[str, ...]) -> bool:
    whole = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return any(whole.search(_OTHER_WORDS.sub("", text)) for text in texts)


@pytest.mark.parametrize("name", TRACKERS)
def test_a_trackers_name_stands_in_its_folder_and_the_catalogue_alone(name: str) -> None:
    own = _folder(TRACKERS[name])
    naming = [
        str(path.relative_to(ROOT))
        for path, texts in _sources().items()
        if own not in path.parents and _naming(name, texts)
    ]
    assert naming == []


def test_names_in_texts_and_in_code_are_found() -> None:
    assert _naming("flow", ("track with flow (Ctrl+T)",))
    assert _naming("three-part", ("three-part",))
    assert not _naming("three-part", ("three-part-joint",))
    assert not _naming("flow", ("Flow map over the floor", "flow_map", "docs/results/flow"))


def test_nobody_outside_imports_from_a_trackers_folder() -> None:
    folders = {_folder(spec).name for spec in TRACKERS.values()}
    outside = [
        path for path in _sources() if path.suffix == ".py" and TRACKER_FOLDERS not in path.parents
    ]
    inside = re.compile(rf"\btracking\.trackers\.({'|'.join(sorted(folders))})\b")
    found = [
        str(path.relative_to(ROOT))
        for path in outside
        if inside.search(path.read_text(encoding="utf-8"))
    ]
    assert found == []


def test_overlays_and_parts_are_found_by_what_trackers_can_do() -> None:
    for able in (
        lambda spec: spec.overlays.subtraction,
        lambda spec: spec.overlays.tracklets,
        lambda spec: spec.overlays.kernel,
        lambda spec: spec.overlays.outlines,
        lambda spec: spec.overlays.evaluation,
        lambda spec: spec.overlays.ramp,
    ):
        assert able(tracker_with(able))
    assert TRACKERS[body_part_tracker()].body_parts


def test_the_preferred_tracker_is_taken_where_it_is_able() -> None:
    last = list(TRACKERS)[-1]
    assert tracker_with(lambda _: True, last).name == last
    assert tracker_with(lambda spec: spec.name != last, last).name == next(iter(TRACKERS))
    assert tracker_with(lambda _: True, "of another version").name == next(iter(TRACKERS))
    with pytest.raises(LookupError):
        tracker_with(lambda _: False)


@pytest.mark.parametrize("name", TRACKERS)
def test_a_tracker_has_the_settings_that_its_overlays_name(name: str) -> None:
    settings, overlays = TRACKERS[name].settings_type(), TRACKERS[name].overlays
    if overlays.evaluation is not None:
        assert isinstance(getattr(settings, overlays.evaluation.setting), bool)
    assert overlays.subtraction == hasattr(settings, "stereo")
