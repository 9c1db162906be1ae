"""Texts on stdout, and files that an export would replace."""

from __future__ import annotations

import io
import json
import sys
from pathlib import Path

import pytest
from command_line import Trackwright

TEXTS = ("mot", "mot16", "kitti", "csv", "cvat", "coco", "pedpy-txt")
LINE = ("--line", "gate:0,0:1,9")


@pytest.mark.parametrize("name", TEXTS)
def test_an_export_to_stdout_is_what_the_file_would_hold(
    trackwright: Trackwright, session: Path, tmp_path: Path, name: str
) -> None:
    out = tmp_path / "tracks.txt"
    assert trackwright("export", session, "-o", out, "--format", name)[0] == 0
    status, printed, _ = trackwright("export", session, "-o", "-", "--format", name)
    assert status == 0
    if name in ("cvat", "coco"):  # tell when they were made
        assert len(printed) == len(out.read_text())
    else:
        assert printed == out.read_text()


def test_tables_of_counts_and_of_the_log_go_to_stdout_alone(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    out = tmp_path / "table.csv"
    assert trackwright("count", session, *LINE, "--csv", out)[0] == 0
    assert trackwright("count", session, *LINE, "--csv", "-")[:2] == (0, out.read_text())
    out.unlink()
    assert trackwright("log", session, "--csv", out)[0] == 0
    assert trackwright("log", session, "--csv", "-")[:2] == (0, out.read_text())


def test_an_export_replaces_what_it_wrote_itself_and_nothing_else_without_a_question(
    trackwright: Trackwright, session: Path, tmp_path: Path
) -> None:
    out = tmp_path / "tracks.txt"
    words = ("export", session, "-o", out, "--format", "mot")
    out.write_text("somebody's own notes\n")
    status, printed, err = trackwright(*words, "--json")
    assert (status, printed) == (1, "")
    assert err.endswith("changed since; choose another name with -o, or add --force\n")
    assert out.read_text() == "somebody's own notes\n"
    assert trackwright(*words, "--force")[0] == 0
    assert trackwright(*words)[0] == 0
    with out.open("a") as stream:
        stream.write("1,1,0,0,5,5,1,-1,-1,-1\n")  # put right by hand
    corrected = out.read_text()
    assert trackwright(*words)[0] == 1
    assert out.read_text() == corrected


@pytest.mark.parametrize(("answer", "status"), [("y", 0), ("n", 1), ("", 1)])
def test_on_a_terminal_an_export_asks(
    trackwright: Trackwright,
    session: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    answer: str,
    status: int,
) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    out = tmp_path / "tracks.txt"
    out.write_text("mine\n")
    monkeypatch.setattr(sys, "stdin", Terminal(f"{answer}\n"))
    found, _, err = trackwright("export", session, "-o", out, "--format", "csv")
    assert found == status
    assert "Replace it? [y/N]" in err
    assert (out.read_text() == "mine\n") == (status == 1)


def test_a_failed_command_prints_no_document(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    tracks, out = tmp_path / "tracks.txt", tmp_path / "s.h5"
    tracks.write_text("1,1,1,1,5,5,1,-1,-1,-1\n2,1,1,1,-5,5,1,-1,-1,-1\n3,1,1,1,-5,5,1,-1,-1,-1\n")
    words = ("import", tracks, "-r", footage, "-o", out)
    status, printed, err = trackwright(*words, "--json")
    assert (status, printed, err.count("\n")) == (1, "", 1)
    assert err.endswith("--take-good to import the others, --report to list all\n")
    status, printed, err = trackwright(*words, "--report")
    assert (status, printed) == (1, "")
    assert err.count("negative size") == 3
    status, printed, err = trackwright(*words, "--take-good", "--json")
    assert (status, json.loads(printed)["bad_count"]) == (0, 2)
