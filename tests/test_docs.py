"""The documents: links lead somewhere, nothing is left out, and the guides work as written."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from types import ModuleType
from typing import Any
from urllib.parse import unquote

import numpy as np
import pytest
from typer.main import get_command

from app.cli.commands.program import program
from tests.editing.tables_of_people import bytes_of, table_of
from tests.trackers.people_of_three_blocks import RED_BLUE, Blocks, observations, walking
from tracking.editing import apply_change
from tracking.formats import FORMATS, Exported, Filmed, no_progress
from tracking.trackers import TRACKERS, settings_fields
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
