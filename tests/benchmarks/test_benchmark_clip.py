"""The clip that speed is measured on is never one of another rendering."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.benchmarks import pipeline, rendered_clips
from tests.benchmarks.rendered_clips import Clip


@pytest.fixture
def made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[Path]:
    """The folders that were rendered."""
    folders: list[Path] = []

    def render(folder: Path, *_: object, **__: object) -> None:
        folders.append(folder)
        folder.mkdir(parents=True)
        (folder / "truth.txt").touch()

    monkeypatch.setattr(rendered_clips, "render_recording", render)
    monkeypatch.setattr(pipeline, "_KEPT", tmp_path)
    return folders


def test_it_is_rendered_once(made: list[Path]) -> None:
    assert pipeline.recording() == pipeline.recording()
    assert made == [pipeline.recording()]


def test_it_is_rendered_anew_where_rendering_has_changed(
    made: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    pipeline.recording()
    monkeypatch.setattr(pipeline, "rendering", lambda: "edited")
    assert pipeline.recording() == made[1] != made[0]


def test_a_longer_one_is_another_one(made: list[Path], monkeypatch: pytest.MonkeyPatch) -> None:
    pipeline.recording()
    was = pipeline.CLIP
    monkeypatch.setattr(pipeline, "CLIP", Clip(was.scene, was.seed, 30.0, was.people))
    assert pipeline.recording() == made[1] != made[0]
