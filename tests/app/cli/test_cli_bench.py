"""`bench` hands over to the checkout's benchmarks."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import Trackwright

import resources
from app.__main__ import run


@pytest.fixture
def checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A checkout that stands elsewhere."""
    monkeypatch.setattr(resources, "__file__", str(tmp_path / "resources" / "__init__.py"))
    return tmp_path


def test_the_benchmarks_are_given_what_was_asked(
    checkout: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    folder = checkout / "tests" / "benchmarks"
    folder.mkdir(parents=True)
    (folder / "__main__.py").write_text("import sys; print(sys.argv[1:]); sys.exit(1)")
    assert run(["bench", "--only", "scoring", "--json"]) == 1
    assert capfd.readouterr().out == "['--only', 'scoring', '--json']\n"


def test_a_group_is_one_document(capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["bench", "--only", "scoring", "--json"]) == 0
    figures = json.loads(capfd.readouterr().out)
    assert figures["scoring"]["ms"] > 0
    assert {"vs_trackeval", "vs_motrics"} <= set(figures["scoring"])


def test_without_a_checkout_there_are_none(trackwright: Trackwright, checkout: Path) -> None:
    status, _, err = trackwright("bench")
    assert status == 1
    assert "checkout" in err


def test_a_group_there_is_not_is_told_in_a_line(capfd: pytest.CaptureFixture[str]) -> None:
    assert run(["bench", "--only", "nope"]) == 1
    err = capfd.readouterr().err
    assert err.startswith("trackwright: no benchmark 'nope'; choose one of pipeline, pipeline_720p")
    assert err.count("\n") == 1
