"""Folders that reports are written into."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from tracking.errors import OutputError
from tracking.pages import render, write_report_folder

KIND = "a test's report"


def _page(title: str, kind: str) -> str:
    return render("pages/page.html", title=title, kind=kind)


def _files(title: str) -> dict[str, str]:
    return {"report.html": _page(title, KIND), "report.json": f'"{title}"'}


def test_a_report_is_written_and_written_again(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "report"
    for title in ("first", "second"):
        write_report_folder(folder, _files(title), KIND)
        assert title in (folder / "report.html").read_text(encoding="utf-8")
    (folder / ".report.json.0abc.part").write_text("left by a crash")
    write_report_folder(folder, _files("third"), KIND)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("thesis.txt", "years of work"),
        ("report.json", "of another program"),
        ("report.html", "<title>somebody's own</title>"),
        ("report.html", _page("of another kind", "another kind")),
    ],
)
def test_nothing_else_is_lost_to_a_report(tmp_path: Path, name: str, content: str) -> None:
    (tmp_path / name).write_text(content)
    with pytest.raises(OutputError, match=f"holds {name}, which is no earlier report"):
        write_report_folder(tmp_path, _files("x"), KIND)
    assert [each.name for each in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_text() == content


def test_a_report_that_fails_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_report_folder(tmp_path / "old", _files("first"), KIND)

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    for folder in ("old", "new"):
        with pytest.raises(OutputError, match="No space left on device"):
            write_report_folder(tmp_path / folder, _files("second"), KIND)
    assert [each.name for each in tmp_path.iterdir()] == ["old"]
    assert "first" in (tmp_path / "old" / "report.html").read_text(encoding="utf-8")
    assert sorted(each.name for each in (tmp_path / "old").iterdir()) == [
        "report.html",
        "report.json",
    ]


def test_a_file_is_no_folder_for_a_report(tmp_path: Path) -> None:
    (tmp_path / "notes").write_text("x")
    with pytest.raises(OutputError, match="notes: Not a directory; choose another"):
        write_report_folder(tmp_path / "notes", _files("x"), KIND)


@pytest.mark.skipif(sys.platform == "win32", reason="links and pipes of POSIX")
def test_a_pipe_or_a_link_in_the_place_of_a_page_is_no_earlier_report(tmp_path: Path) -> None:
    write_report_folder(tmp_path / "real", _files("first"), KIND)
    for name in ("pipe", "link"):
        (tmp_path / name).mkdir()
    os.mkfifo(tmp_path / "pipe" / "report.html")
    (tmp_path / "link" / "report.html").symlink_to(tmp_path / "real" / "report.html")
    for name in ("pipe", "link"):
        with pytest.raises(OutputError, match=r"report\.html, which is no earlier report"):
            write_report_folder(tmp_path / name, _files("second"), KIND)
