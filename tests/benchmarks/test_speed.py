"""The benchmarks of speed: each group has its function, and each tracker its peers."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest

from tests.benchmarks import pipeline, two_processes
from tests.benchmarks.__main__ import GROUPS
from tests.benchmarks.pipeline import FLOW, PIPELINE, Speed
from tests.benchmarks.tables import table
from tracking.synthesis import Disturbances, render_recording


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A second in which people are there from the start."""
    late = Disturbances(begin_s=8.0)
    folder = tmp_path_factory.mktemp("clips") / "lobby"
    return render_recording(folder, "lobby", 0.7, 3, 1, size=(320, 240), disturbances=late)


@pytest.mark.parametrize("group", GROUPS)
def test_each_group_is_measured_by_a_function_that_says_what_its_figures_are(group: str) -> None:
    module, _, name = GROUPS[group].partition(".")
    assert getattr(import_module(f"tests.benchmarks.{module}"), name).__doc__


@pytest.mark.parametrize("speed", [FLOW, PIPELINE], ids=["flow", "pipeline"])
def test_a_tracker_is_timed_beside_what_others_would_do(
    speed: Speed, rendered: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pipeline, "folder_of", lambda _: rendered)
    figures = pipeline.measure(replace(speed, people=range(10)))
    assert figures["cpu_ms"] == pytest.approx(
        sum(figures[f"{stage}_ms"] or 0 for stage in ("decode", "perception", "tracker"))
    )
    for peer in speed.peers:
        parts = [value for name, value in figures.items() if name.startswith(f"{peer}_")]
        ratio = figures[f"vs_{peer}"]
        assert ratio
        assert ratio * figures[f"{peer}_frame_ms"] == pytest.approx(figures["cpu_ms"])
        assert len(parts) > 2
    assert table("speed", "How fast.", figures)


def test_two_commands_are_timed_against_one(
    rendered: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(two_processes, "recording", lambda: rendered)
    monkeypatch.setattr(two_processes, "_ROUNDS", 1)
    figures = two_processes.measure()
    expected = 2 * figures["one_ms"] / figures["both_ms"]
    assert 0.0 < figures["speed_up"] == pytest.approx(expected)
    assert "times one process" in table("two", "How much sooner.", figures)


def test_a_command_that_fails_is_not_timed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(two_processes, "recording", lambda: tmp_path)
    with pytest.raises(RuntimeError, match="track failed:\\ntrackwright: "):
        two_processes.measure()


def test_the_larger_recording_is_the_same_scene_in_720_rows() -> None:
    larger = pipeline.PIPELINE_720P.clip
    assert (larger.size, larger.name) == ((1280, 720), f"{PIPELINE.clip.name}-rows720")
