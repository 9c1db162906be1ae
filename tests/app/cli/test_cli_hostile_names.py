"""Names that command terminals and spreadsheets, through every command that prints them."""

from __future__ import annotations

import ast
import csv
import json
import re
import sys
import unicodedata
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest
from command_line import Trackwright

import app.cli
from app.cli.output import escape_controls
from tracking.editing import plan_label_part
from tracking.failure import SAMPLE_COLUMNS
from tracking.formats import read_part_labels, read_samples
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import HEAD, PartLabel, Run

COMMANDS = "\x1b[31mred\x1b]0;title\x07\u202egnp.\nforged: line\r\x9b2J\u2066"
FORMULA = '=HYPERLINK("http://example.org")'
PRINTING = Path(app.cli.__file__).parent
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="no such names of files there")


@pytest.fixture
def hostile(recording: Path, tmp_path: Path) -> Path:
    """A recording whose name, and whose folder's name, command the terminal."""
    folder = recording.rename(tmp_path / COMMANDS.replace("/", ""))
    manifest = folder / "recording.toml"
    quoted = json.dumps(COMMANDS)
    manifest.write_text(
        re.sub("(?m)^name = .*$", lambda _: f"name = {quoted}", manifest.read_text())
    )
    return folder


@pytest.fixture
def corrected(hostile: Path, tiny_run: Run, tmp_path: Path) -> Path:
    """A session of it in which somebody of a hostile name gave labels for hostile reasons."""
    place = tmp_path / f"{COMMANDS}.h5"
    parted = with_head(tiny_run)
    with (
        open_recording(hostile) as footage,
        closing(Session.create(footage, [parted], place)) as session,
    ):
        frame, track = (int(parted.tracks[name][0]) for name in ("frame", "track"))
        label = PartLabel(frame, track, HEAD, (1.0, 2.0, 9.0, 9.0), True, "person", FORMULA, "-1+2")
        session.author = FORMULA
        session.apply(plan_label_part(session.labels, [label]))
        session.save()
    return place


def with_head(run: Run) -> Run:
    from run_with_parts import with_parts

    return replace(with_parts(run), tracker="three-part")


def assert_harmless(printed: str) -> None:
    signs = {sign for sign in printed if unicodedata.category(sign) in ("Cc", "Cf", "Zl", "Zp")}
    assert signs <= {"\n"}, printed
    assert not [line for line in printed.splitlines() if line.startswith("forged")]


def commands(recording: Path, session: Path, out: Path) -> list[tuple[object, ...]]:
    """Every command that prints names, and some that fail over them."""
    line = f"{FORMULA}:0,0:1,9"
    return [
        ("info", recording),
        ("info", session),
        ("track", recording, "-o", out / "t.h5", "--tracker", "stereo-colour", "--frames", "0:2"),
        ("track", recording, "-o", out / "t.h5", "--tracker", COMMANDS),
        ("track", "--again", session, "--from", "70", "--until", "72"),
        ("score", session, "--truth", recording),
        ("score", session, session, "--truth", recording, "--report", out / COMMANDS),
        ("compare", session, session),
        ("review", session),
        ("count", session, "--line", line, "--csv", out / f"{COMMANDS}.csv"),
        ("count", session, "--line", COMMANDS),
        ("export", session, "-o", out / f"{COMMANDS}.txt", "--format", "mot"),
        ("export", session, "-o", out / "x", "--format", COMMANDS),
        ("export", out / COMMANDS, "-o", out / "x", "--format", "mot"),
        ("import", out / f"{COMMANDS}.txt", "-r", recording, "-o", out / f"{COMMANDS}-2.h5"),
        ("import", recording / "recording.toml", "-r", recording, "-o", out / "i.h5"),
        ("import-labels", recording / "truth.txt", session),
        ("log", session),
        ("log", session, "--csv", out / f"{COMMANDS}-log.csv"),
        ("restore", session, "--list"),
        ("train", session, "-o", out / f"{COMMANDS}-d.h5"),
        ("trackers", COMMANDS),
        ("synth", out / COMMANDS, "--scene", COMMANDS),
        (COMMANDS,),
        ("info", f"--{COMMANDS}"),
    ]


def test_no_command_passes_a_name_on_to_the_terminal(
    trackwright: Trackwright, hostile: Path, corrected: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    done = {}
    for words in commands(hostile, corrected, out):
        status, printed, err = trackwright(*words)
        assert_harmless(printed)
        assert_harmless(err)
        done[" ".join(map(str, words[:1]))] = status
        assert status in (0, 1, 2), words
    assert done["review"] == done["compare"] == done["log"] == 0


def test_words_in_exported_tables_are_no_formulas_and_come_back(
    trackwright: Trackwright, corrected: Path, tmp_path: Path
) -> None:
    line = f"{FORMULA}:0,0:1,9"
    tables = {name: tmp_path / f"{name}.csv" for name in ("count", "log", "labels", "samples")}
    assert trackwright("count", corrected, "--line", line, "--csv", tables["count"])[0] == 0
    assert trackwright("log", corrected, "--csv", tables["log"])[0] == 0
    for name in ("labels", "samples"):
        words = ("export", corrected, "-o", tables[name], "--format", name)
        assert trackwright(*words)[0] == 0
    for table in tables.values():
        with table.open(newline="") as stream:
            cells = [cell for row in csv.reader(stream) for cell in row]
        assert f"'{FORMULA}" in cells
        assert not [cell for cell in cells if cell.startswith("=") or cell[:2] == "-1+"]
    (label,) = read_part_labels(tables["labels"])
    assert (label.label.author, label.label.reason) == (FORMULA, "-1+2")
    samples = read_samples(tables["samples"])
    assert "author" in SAMPLE_COLUMNS
    assert set(samples.columns["author"]) == {FORMULA}


def test_names_are_shown_as_they_are_written() -> None:
    assert escape_controls("\x1b[31m\n\u202e") == "\\x1b[31m\\n\\u202e"
    assert escape_controls(b"\xff".decode("utf-8", "surrogateescape")) == "\\udcff"
    plain = "Grüße, 入口 — \u00a0👩\u200d🔬"
    assert escape_controls(plain) == plain


def test_commands_print_through_one_place() -> None:
    """What prints by itself would print names by itself."""
    for module in [*PRINTING.rglob("*.py"), PRINTING.with_name("__main__.py")]:
        if module.name in ("output.py", "system_libraries.py"):  # which runs before anything else
            continue
        for node in ast.walk(ast.parse(module.read_text())):
            called = node.func if isinstance(node, ast.Call) else None
            assert not (isinstance(called, ast.Name) and called.id == "print"), module
            if isinstance(called, ast.Attribute):
                assert (
                    called.attr not in ("write", "writelines")
                    or called.value is None
                    or (not ast.unparse(called.value).startswith("sys.std"))
                ), module
