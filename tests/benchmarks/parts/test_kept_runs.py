"""Runs are kept for as long as nothing they were made with has changed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.parts import clips, kept_people
from tests.benchmarks.parts.kept_people import Seen, kept_run
from tests.benchmarks.parts.real import RECORDINGS, folders_in


class Tracker:
    """Counts how often it tracked."""

    def __init__(self) -> None:
        self.runs = 0

    def __call__(self) -> Seen:
        self.runs += 1
        return Seen({"frame": np.arange(3)}, {"part": np.array([self.runs], np.uint8)})


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "walkway-1"
    made.mkdir()
    return made


def test_a_run_is_tracked_once_and_comes_back_as_it_was(folder: Path) -> None:
    tracker = Tracker()
    first, again = (kept_run(folder, ("three-part",), True, tracker) for _ in range(2))
    assert tracker.runs == 1
    assert again.tracks["frame"].tolist() == first.tracks["frame"].tolist() == [0, 1, 2]
    assert again.parts["part"].dtype == np.uint8


def test_other_settings_and_other_sources_are_tracked_anew(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tracker = Tracker()
    kept_run(folder, ("three-part",), False, tracker)
    kept_run(folder, ("three-part", ("adjust", False)), False, tracker)
    assert tracker.runs == 2
    monkeypatch.setattr(kept_people, "sources", lambda: "edited")
    assert kept_run(folder, ("three-part",), False, tracker).parts["part"].tolist() == [3]


def test_another_clip_under_the_same_name_and_other_libraries_are_tracked_anew(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tracker = Tracker()
    for picture in (b"one", b"other", b"one"):
        (folder / "left.mkv").write_bytes(picture)
        kept_run(folder, ("three-part",), False, tracker)
    assert tracker.runs == 2
    monkeypatch.setattr(kept_people, "LIBRARIES", "numpy of tomorrow")
    assert kept_run(folder, ("three-part",), False, tracker).parts["part"].tolist() == [3]


def test_a_clip_is_rendered_anew_where_rendering_has_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rendered = []

    def render(folder: Path, *_: object, **__: object) -> None:
        rendered.append(folder)
        folder.mkdir(parents=True)
        (folder / "truth_parts.csv").touch()

    monkeypatch.setattr(clips, "render_recording", render)
    first, again = (clips.folder_of(clips.TUNED[0], tmp_path) for _ in range(2))
    monkeypatch.setattr(clips, "rendering", lambda: "edited")
    other = clips.folder_of(clips.TUNED[0], tmp_path)
    assert first == again != other
    assert first.name == other.name
    assert rendered == [first, other]


def test_another_detector_counts_for_those_who_act_on_it(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tracker = Tracker()
    for judged in (True, False):
        kept_run(folder, ("three-part", judged), judged, tracker)
    other = kept_people.built_in_detector().with_operating_point(0.5)
    monkeypatch.setattr(kept_people, "built_in_detector", lambda: other)
    for judged in (True, False):
        kept_run(folder, ("three-part", judged), judged, tracker)
    assert tracker.runs == 3


def test_real_footage_that_is_not_there_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert folders_in(None) == []
    assert "--data or TRACKWRIGHT_DATA" in capsys.readouterr().err
    (tmp_path / RECORDINGS[0]).mkdir()
    (tmp_path / RECORDINGS[0] / "truth.txt").touch()
    assert [folder.name for folder in folders_in(tmp_path)] == [RECORDINGS[0]]
    assert f"no real footage {RECORDINGS[1]}" in capsys.readouterr().err
