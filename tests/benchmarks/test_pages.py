"""Pages of results: written section by section, and each as its kept figures have it."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest

from tests.benchmarks import command, pages
from tests.benchmarks.pages import Page
from tests.benchmarks.tables import met, table, unit_of

SUBJECTS = ("spheroid", "flow", "parts", "stereo")


@pytest.mark.parametrize("subject", SUBJECTS)
def test_a_page_is_what_is_made_of_the_kept_figures(subject: str) -> None:
    page = import_module(f"tests.benchmarks.{subject}.__main__").PAGE
    figures, again = page.figures(), f"run python -m tests.benchmarks.{subject} --rewrite"
    assert page.text(figures) == (page.folder / f"{subject}.md").read_text("utf-8"), again
    for section, (_, draw) in page.diagrams.items():
        assert draw(figures[section]).startswith("<svg")


@pytest.fixture
def page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Page:
    """A page of two sections in a folder of its own."""
    templates = tmp_path / "templates"
    (templates / "speed").mkdir(parents=True)
    blocks = ("introduction", "# Speed"), ("fast", "Fast: {{ fast }}"), ("slow", "Slow: {{ slow }}")
    text = "\n".join(f"{{% block {name} %}}{said}{{% endblock %}}" for name, said in blocks)
    (templates / "speed" / "page.md.j2").write_text(text)
    monkeypatch.setattr(pages, "_HERE", templates)
    monkeypatch.setattr(pages, "one_core", lambda: None)
    return Page(
        "speed",
        "How fast",
        {"slow": lambda _: 9, "fast": lambda _: 3},
        diagrams={"fast": ("bars", lambda n: f"<svg>{n}</svg>")},
        folder=tmp_path / "results",
    )


def _run(
    page: Page, monkeypatch: pytest.MonkeyPatch, *words: str, fast: int = 3, state: str = "one"
) -> str:
    monkeypatch.setattr("sys.argv", ["benchmark", *words])
    monkeypatch.setattr(pages, "sources", lambda: state)
    replace(page, measures={**page.measures, "fast": lambda _: fast}).main()
    written = page.folder / "speed.md"
    return written.read_text() if written.is_file() else ""


def test_sections_are_kept_and_stand_in_the_pages_order(
    page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert _run(page, monkeypatch, "--report") == "# Speed\n\nFast: 3\n\nSlow: 9\n"
    again = _run(page, monkeypatch, "--report", "--only", "fast", fast=4)
    assert again == "# Speed\n\nFast: 4\n\nSlow: 9\n"
    assert (page.folder / "speed-bars.svg").read_text() == "<svg>4</svg>"


def test_a_page_is_written_anew_from_what_was_measured(
    page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    _run(page, monkeypatch, "--report", "--only", "slow")
    (page.folder / "speed.md").unlink()
    assert _run(page, monkeypatch, "--rewrite") == "# Speed\n\nSlow: 9\n"


def test_a_page_says_which_sections_are_of_an_older_state_than_the_newest(
    page: Page, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "Measured with" not in _run(page, monkeypatch, "--report")
    text = _run(page, monkeypatch, "--report", "--only", "fast", state="two")
    assert "# Speed\n\nMeasured with other sources than the rest: slow.\n\n" in text
    assert "than the rest: slow." in _run(page, monkeypatch, "--rewrite", state="three")
    last = _run(page, monkeypatch, "--report", "--only", "slow", state="two")
    assert "Measured with" not in last


def test_without_a_report_figures_are_printed_and_nothing_is_written(
    page: Page, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    _run(page, monkeypatch, "--only", "fast")
    said = capsys.readouterr()
    assert said.out == "Fast: 3\n"
    assert said.err.startswith("speed, fast: measuring ...\n")
    assert not page.folder.exists()


def test_measuring_begins_anew_on_one_core(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list[list[str]] = []
    monkeypatch.setattr("os.execv", lambda _, words: begun.append(words))
    monkeypatch.setenv("OMP_NUM_THREADS", "4")
    monkeypatch.setenv("OPENBLAS_NUM_THREADS", "1")
    command.one_core()
    assert os.environ["OMP_NUM_THREADS"] == "1"
    command.one_core()
    assert begun == [[sys.executable, *sys.orig_argv[1:]]]


def test_a_goal_is_met_or_missed_by_so_much() -> None:
    assert met(4.2, 5.0, at_most=True) == "met"
    assert met(0.8, 0.85, digits=3) == "missed by 0.050"
    assert met(0.96, 0.96001, digits=3) == "missed by less than 0.001"
    assert met(float("nan"), 1.0) == "not measured"


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("frame_ms", "ms"),
        ("ms_20_people", "ms"),
        ("us_per_person", "\u00b5s a person"),
        ("10m_edits_peak_mb", "MB"),
        ("open_vs_raw", "times theirs"),
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
    text = table("memory", "Room that particles take.", {"kept_mb": 8.5, "vs_peer": None})
    assert text.splitlines() == [
        "memory",
        "  Room that particles take.",
        "",
        "  kept_mb         8.50 MB",
        "  vs_peer not measured",
    ]
