"""Whatever a command prints for people is in their language, typer's own words included."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from command_line import Trackwright
from typer.main import get_command

from app.cli.commands.program import program
from tests.catalogue import ROOT, called
from tests.page_reader import english
from tests.pseudo import Wide
from tracking.trackers import TRACKERS
from tracking.translation import use_catalogue

_PRINTS = frozenset({"say", "print_line", "BadParameter"})
_TYPED = re.compile(r"--?[\w-]+|<\w+>(?:\.\.\.)?|\{\w+\}|\[[A-Za-z:]+\]")
"""What is typed as it stands: options, kinds of values, arguments."""


@pytest.fixture
def wide() -> Iterator[None]:
    use_catalogue(Wide())
    yield
    use_catalogue(None)


@pytest.mark.parametrize("words", [
    ["info"], ["score"], ["trackk"], ["track", "--nix"], ["track", "--untill"], ["synth"],
    ["synth", "x", "--scene"], ["synth", "x", "--scene", "square", "--seconds", "abc"],
    ["synth", "x", "--scene", "square", "--people", "abc"], ["trackers", "a", "b"],
    ["track", "--force=3"], ["track", "a"], ["export", "a"], ["review", "a", "--most", "0"],
])  # fmt: skip
@pytest.mark.usefixtures("wide")
def test_what_is_wrongly_asked_for_is_told_in_no_english_word(
    trackwright: Trackwright, words: list[str]
) -> None:
    status, _, err = trackwright(*words)
    assert status == 2
    told = re.sub(r"'[^']*'", "", _TYPED.sub("", err.partition("--help")[0]))
    known = {"trackwright", *get_command(program).commands, "RESULT", "NAME", "nix", "untill"}
    assert english([told], known) == set()


@pytest.mark.usefixtures("wide")
def test_help_has_no_english_word(trackwright: Trackwright) -> None:
    commands = get_command(program).commands
    page = trackwright("--help")[1]
    assert english([_TYPED.sub("", page)], {"trackwright", *commands, "labels", "import"}) == set()
    page = trackwright("trackers", "--help")[1]
    assert english([_TYPED.sub("", page)], {"trackwright", "trackers", "str", "name"}) == set()


@pytest.mark.usefixtures("wide")
def test_no_word_of_the_list_of_trackers_stays_english(trackwright: Trackwright) -> None:
    said = [
        line.partition("=")[2].partition(" ")[2] if "=" in line[:40] else _TYPED.sub("", line)
        for line in trackwright("trackers", "--expert")[1].splitlines()
    ]
    papers = {spec.paper.rstrip("0123456789") for spec in TRACKERS.values() if spec.paper}
    names = {word for name in TRACKERS for word in name.split("-")}
    assert english(said, names | papers) == set()


@pytest.mark.usefixtures("wide")
def test_no_word_of_info_stays_english(
    trackwright: Trackwright, footage: Path, session: Path
) -> None:
    for path in (footage, session):
        facts = json.loads(trackwright("info", path, "--json")[1])
        (run,) = facts.get("runs", [{"settings": {}, "tracker": ""}])
        names = f"{facts['name']} {run['tracker']} {' '.join(run['settings'])} trackwright"
        data = set(re.findall("[A-Za-z]+", f"{names} {facts.get('recording', '')}"))
        said = trackwright("info", path)[1].replace(str(path), "")
        assert english([said], data) == set()


def test_nothing_is_printed_that_cannot_be_translated() -> None:
    bare = [
        f"{path.name}:{call.lineno}"
        for path in sorted((ROOT / "app" / "cli").rglob("*.py"))
        for call in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(call, ast.Call) and called(call) in _PRINTS and call.args
        for text in [call.args[0]]
        for piece in (text.values if isinstance(text, ast.JoinedStr) else [text])
        if isinstance(piece, ast.Constant)
        and re.search(r"[A-Za-z]{3}", str(piece.value))
        and "trackwright" not in str(piece.value)
    ]
    assert bare == []
