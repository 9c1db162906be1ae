"""Pages of results are written section by section; figures are told with their units."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.benchmarks import pages, results
from tests.benchmarks.page_texts import table, unit_of
from tests.benchmarks.results import Contents


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where the page and its figures are put."""
    monkeypatch.setattr(results, "one_core", lambda: None)
    monkeypatch.setattr(pages, "Page", lambda subject, page=pages.Page: page(subject, tmp_path))
    return tmp_path


def _run(monkeypatch: pytest.MonkeyPatch, *words: str, fast: int = 3, state: str = "") -> None:
    monkeypatch.setattr("sys.argv", ["benchmark", *words])
    contents = Contents(
        "# Speed",
        {"fast": lambda n: f"Fast: {n}", "slow": lambda n: f"Slow: {n}"},
        {"fast": lambda: fast, "slow": lambda: 9},
        state=lambda: state,
        diagrams={"fast": ("bars", lambda n: f"<svg>{n}</svg>")},
    )
    results.run("speed", "How fast", ("slow", "fast"), lambda _: contents)


def test_sections_are_kept_and_stand_in_the_pages_order(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _run(monkeypatch, "--report")
    assert (folder / "speed.md").read_text() == "# Speed\n\nFast: 3\n\nSlow: 9\n"
    _run(monkeypatch, "--report", "--only", "fast", fast=4)
    assert (folder / "speed.md").read_text() == "# Speed\n\nFast: 4\n\nSlow: 9\n"
    assert (folder / "speed-bars.svg").read_text() == "<svg>4</svg>"


def test_a_page_is_written_anew_from_what_was_measured(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _run(monkeypatch, "--report", "--only", "slow")
    (folder / "speed.md").unlink()
    _run(monkeypatch, "--rewrite")
    assert (folder / "speed.md").read_text() == "# Speed\n\nSlow: 9\n"


def test_a_page_says_which_sections_are_of_an_older_state_than_the_newest(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = folder / "speed.md"
    _run(monkeypatch, "--report", state="one")
    assert "Measured with other sources" not in page.read_text()
    _run(monkeypatch, "--report", "--only", "fast", state="two")
    assert "# Speed\n\nMeasured with other sources than the rest: slow.\n\n" in page.read_text()
    _run(monkeypatch, "--rewrite", state="three")
    assert "than the rest: slow." in page.read_text()
    _run(monkeypatch, "--report", "--only", "slow", state="two")
    assert "Measured with other sources" not in page.read_text()


def test_without_a_report_figures_are_printed_and_nothing_is_written(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    _run(monkeypatch, "--only", "fast")
    said = capsys.readouterr()
    assert said.out == "Fast: 3\n"
    assert said.err.startswith("speed, fast: measuring ...\n")
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("frame_ms", "ms"),
        ("ms_20_people", "ms"),
        ("us_per_person", "\u00b5s a person"),
        ("gzip_bytes", "bytes"),
        ("10m_edits_peak_mb", "MB"),
        ("mot_read_rows_s", "rows/s"),
        ("kept_size_vs_gzip", "times theirs"),
        ("vs_primitives", "times theirs"),
        ("shown_fps", "frames/s"),
        ("people", "people"),
    ],
)
def test_the_name_of_a_figure_tells_its_unit(name: str, unit: str) -> None:
    assert unit_of(name) == unit


def test_a_figure_whose_name_tells_no_unit_is_refused() -> None:
    with pytest.raises(ValueError, match="tells no unit"):
        table("gaps", "How long they are.", {"gap_ms": 2.0, "gap_max": 3.0})


def test_a_table_tells_what_is_measured_and_in_which_units() -> None:
    text = table("memory", "Room that particles take.", {"gzip_bytes": 8.5, "vs_peer": None})
    assert text.splitlines() == [
        "memory",
        "  Room that particles take.",
        "",
        "  gzip_bytes         8.50 bytes",
        "  vs_peer    not measured",
    ]
