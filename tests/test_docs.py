"""The documents: links lead somewhere, nothing is left out, and the guides work as written."""

from __future__ import annotations

import re
import sys
import textwrap
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any, cast
from urllib.parse import unquote

import numpy as np
import pytest
from PySide6.QtCore import QSettings
from pytestqt.qtbot import QtBot
from typer.main import get_command

from app.__main__ import run
from app.cli.commands.program import program
from app.core.tracking_process.request import TrackingRequest
from app.core.widgets.user_settings import UserSettings
from app.features.runs.track_dialog import TrackDialog
from tests.editing.tables_of_people import bytes_of, table_of
from tests.trackers.people_of_three_blocks import RED_BLUE, Blocks, observations, walking
from tracking.editing import apply_change
from tracking.formats import FORMATS, Exported, Filmed, no_progress
from tracking.pipeline import track
from tracking.plugins import PluginKind, offered_for_a_while
from tracking.recording import open_recording
from tracking.synthesis import render_recording
from tracking.trackers import TRACKERS, TrackerSpec, settings_fields
from tracking.tracks import Labels, TrackTable

ROOT = Path(__file__).parents[1]
DOCUMENTS = sorted(
    path
    for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md"))
    if path.is_file()
)
_LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
_FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
_LONGEST_README = 150
"""Lines: one sitting. What does not fit belongs into docs/."""


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_relative_link_of_a_document_leads_to_a_file_and_heading(document: Path) -> None:
    assert [link for link in _links(document) if not _leads_somewhere(document, link)] == []


def test_readme_is_short() -> None:
    assert len((ROOT / "README.md").read_text(encoding="utf-8").splitlines()) <= _LONGEST_README


def test_readme_leads_to_every_page_of_docs() -> None:
    seen, waiting = set[Path](), [ROOT / "README.md"]
    while waiting:
        document = waiting.pop()
        seen.add(document)
        targets = {
            (document.parent / link.partition("#")[0]).resolve() for link in _links(document)
        }
        waiting += [page for page in DOCUMENTS if page in targets - seen]
    assert [page for page in DOCUMENTS if page not in seen] == []


def _links(document: Path) -> list[str]:
    """The relative links and images of a document, without those in code."""
    text = _FENCE.sub("", document.read_text(encoding="utf-8"))
    return [unquote(link) for link in _LINK.findall(text) if "://" not in link]


def _leads_somewhere(document: Path, link: str) -> bool:
    name, _, anchor = link.partition("#")
    target = document.parent / name if name else document
    if not target.exists():
        return False
    return not anchor or anchor in _anchors(target)


def _anchors(document: Path) -> set[str]:
    """The headings as links name them, by GitHub's rule."""
    text = _FENCE.sub("", document.read_text(encoding="utf-8"))
    headings = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", one.lower()).replace(" ", "-") for one in headings}


def test_every_format_has_a_row_in_the_page_of_formats() -> None:
    page = (ROOT / "docs" / "formats.md").read_text(encoding="utf-8")
    assert [name for name in FORMATS if f"\n| `{name}` |" not in page] == []


def test_every_tracker_and_command_has_a_row_in_its_page() -> None:
    trackers = (ROOT / "docs" / "trackers.md").read_text(encoding="utf-8")
    assert [name for name in TRACKERS if f"`{name}`" not in trackers] == []
    commands = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    names = get_command(program).commands  # type: ignore[attr-defined] # a group
    assert [name for name in names if not re.search(rf"\n\| `{name}\b", commands)] == []


def test_the_page_of_trackers_names_the_settings_that_are_offered() -> None:
    page = (ROOT / "docs" / "trackers.md").read_text(encoding="utf-8")
    rows = page.partition("| settings offered |")[2].partition("\n\n")[0].splitlines()[2:]
    written, stages = {}, set[str]()
    for row in rows:
        names, own, earlier = (
            set(re.findall(r"`([\w.-]+)`", cell)) for cell in row.split("|")[1:4]
        )
        stages = earlier or stages  # "the same" as in the row above
        written |= dict.fromkeys(names, own | stages)
    offered = {
        name: {one.name for one in settings_fields(spec.settings_type) if not one.expert}
        for name, spec in TRACKERS.items()
    }
    assert written == offered


@pytest.mark.parametrize("name", ["CONTRIBUTING.md", "docs/architecture.md"])
def test_every_module_that_is_named_exists(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    named = set(re.findall(r"`((?:app|tracking|tests)/[\w/]+\.py)`", text))
    assert named
    assert [path for path in sorted(named) if not (ROOT / path).is_file()] == []


def test_the_tracker_of_the_guide_keeps_ids() -> None:
    guide = _module("tracking/trackers/overlap.py")
    people = (Blocks(walking((20, 40), (1, 0)), RED_BLUE),)
    tracker = guide["OverlapTracker"](guide["OverlapSettings"]())
    found = [tracker.step(one).tracks["track"].tolist() for one in observations(people, 5)]
    assert found == [[1]] * 5


@pytest.fixture
def overlap() -> Iterator[TrackerSpec]:
    """The tracker of the guide, entered into the catalogue as the guide says."""
    module = _module("tracking/trackers/overlap.py")
    guide = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    entry = (
        guide.partition("`overlap.py` in `tracking/trackers/built_in/`")[2]
        .partition("```python\n")[2]
        .partition("   ```")[0]
    )
    names = {"TrackerSpec": TrackerSpec, **module}
    exec(textwrap.dedent(entry), names)
    spec = cast("TrackerSpec", names["OVERLAP"])
    with offered_for_a_while(PluginKind.TRACKER, spec.name, spec, "overlap"):
        yield spec


@pytest.fixture(scope="module")
def clip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A few frames of three people, with a file of detections beside them."""
    folder = tmp_path_factory.mktemp("clips") / "clip"
    render_recording(folder, "plaza", 4.0, 3, 5, size=(320, 240), fps=8.0)
    (folder / "det.txt").write_text("1,-1,20,40,24,60,0.9\n")
    return folder


def test_the_tracker_of_the_guide_tracks_a_recording(overlap: TrackerSpec, clip: Path) -> None:
    with open_recording(clip) as recording, track(recording, overlap.name) as tracking:
        for _ in tracking:
            pass
        made = tracking.run()
    assert made.tracker == "overlap"
    assert len(made.tracks["track"]) > 0


def test_the_tracker_of_the_guide_can_be_asked_of_another_process(
    overlap: TrackerSpec, clip: Path
) -> None:
    with open_recording(clip) as recording:
        asked = TrackingRequest.of(recording, overlap.name, None, 0, None)
    assert not [name for name in asked.settings if name.startswith("detections")]


@pytest.mark.parametrize("option", ["--detections", "--detections-right"])
def test_detections_for_the_tracker_of_the_guide_are_refused_in_one_line(
    overlap: TrackerSpec, clip: Path, tmp_path: Path, option: str, capsys
) -> None:
    words = ["track", str(clip), "-o", str(tmp_path / "s.h5"), "--tracker", overlap.name]
    assert run([*words, option, str(clip / "det.txt")]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert f"tracker overlap knows no {option[2:]}: leave {option} out or choose" in line
    assert not (tmp_path / "s.h5").exists()


def test_the_dialog_asks_for_no_detections_for_the_tracker_of_the_guide(
    overlap: TrackerSpec, clip: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    kept = QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat)
    with open_recording(clip) as recording:
        dialog = TrackDialog(recording, "three-part", UserSettings(kept))
        qtbot.addWidget(dialog)
        files = dialog._detections._left
        dialog.put_settings("three-part", {"detections.file": "det.txt"}, 0)
        assert files.isVisibleTo(dialog)
        dialog.put_settings(overlap.name, {}, 0)
        assert not files.isVisibleTo(dialog)
        assert dialog.answer()[:2] == (overlap.name, overlap.settings_type())


def test_the_format_of_the_guide_reads_what_it_writes(tmp_path: Path) -> None:
    kind = _module("tracking/formats/eth_ucy.py")["ETH_UCY"]
    table = table_of({7: [(3, 5)]})
    kind.write(tmp_path / "out.txt", Exported.of_table(table), no_progress)
    back = kind.read(tmp_path / "out.txt", Filmed()).columns
    standing = np.isfinite(table.columns()["x"])
    np.testing.assert_array_equal(back["frame"], table.columns()["frame"][standing])
    np.testing.assert_array_equal(back["x"], table.columns()["x"][standing])


def test_the_edit_of_the_guide_can_be_undone() -> None:
    plan = _module("tracking/editing/boxes/confirmation.py")["plan_confirm"]
    rows = table_of({1: [(0, 4)]}).columns()
    table = TrackTable({**rows, "predicted": np.ones(4, bool)})
    before = bytes_of(table)
    change = plan(table, [1], 1, 3)
    apply_change(table, Labels(), change)
    assert table.of_track(1)["predicted"].tolist() == [True, False, False, True]
    apply_change(table, Labels(), change.inverse)
    assert bytes_of(table) == before


def _module(path: str) -> dict[str, Any]:
    """What a module that CONTRIBUTING.md shows complete defines."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    _, _, shown = text.partition(f"<code>{path}</code>, complete")
    code = shown.partition("```python\n")[2].partition("\n```")[0]
    module = ModuleType(path)
    sys.modules[path] = module  # where dataclasses look for the module of a class
    exec(compile(code, path, "exec"), module.__dict__)
    return module.__dict__
