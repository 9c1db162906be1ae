"""Clips and runs are kept for as long as nothing they were made with has changed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.benchmarks import clips, runner
from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.runner import Case, run_of, runs_over
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.synthesis import Disturbances, render_recording

FEWER = Case("stereo-direction", (("particles", 50),))
CASES = (FEWER, Case("stereo-joint"), Case("spheroid"))


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A second in which people are there from the start."""
    folder = tmp_path_factory.mktemp("clips") / "lobby-1"
    late = Disturbances(begin_s=8.0)
    return render_recording(folder, "lobby", 1.0, 3, 6001, size=(320, 240), disturbances=late)


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's cache."""
    for module in (clips, runner):
        monkeypatch.setattr(module, "clips_cache", lambda: tmp_path / "cache")
    return tmp_path / "cache"


@pytest.fixture
def tracked(monkeypatch: pytest.MonkeyPatch) -> list[Case]:
    """The cases that were tracked anew."""
    cases: list[Case] = []
    fresh = runner._tracked

    def counting(recording: Any, together: list[Case]) -> Any:
        cases.extend(together)
        return fresh(recording, together)

    monkeypatch.setattr(runner, "_tracked", counting)
    return cases


def test_a_run_over_shared_perception_is_the_run_alone(rendered: Path) -> None:
    seen = runs_over(rendered, CASES)
    with open_recording(rendered) as recording:
        for case in CASES:
            with track(recording, case.tracker, case.chosen(), runner.SEED) as alone:
                for _ in alone:
                    pass
                run, notes = alone.run(), alone.notes
            assert len(run.tracks["track"]) > 0
            for table in ("tracks", "detections", "associations", "signals", "parts"):
                for name, column in getattr(run, table).items():
                    kept = getattr(seen[case].run, table)[name]
                    np.testing.assert_array_equal(kept, column)
            assert (seen[case].run.notes, seen[case].run.frames) == (notes, run.frames)


def test_a_run_is_tracked_once_and_comes_back_as_it_was(
    rendered: Path, tracked: list[Case]
) -> None:
    first, again = (run_of(rendered, FEWER) for _ in range(2))
    assert tracked == [FEWER]
    for name, column in first.tracks.items():
        np.testing.assert_array_equal(again.tracks[name], column)
        assert again.tracks[name].dtype == column.dtype
    assert again.times["frames"].tolist() == [20]
    assert 0 < again.times["following_s"][0] < again.times["seeing_s"][0] < 60


@pytest.mark.parametrize("changed", ["sources", "libraries", "settings", "recording"])
def test_a_run_is_tracked_anew_where_something_it_was_made_with_has_changed(
    changed: str, rendered: Path, tracked: list[Case], monkeypatch: pytest.MonkeyPatch
) -> None:
    run_of(rendered, FEWER)
    case, more = FEWER, rendered / "more.txt"
    if changed == "sources":
        monkeypatch.setattr(runner, "sources", lambda: "edited")
    elif changed == "libraries":
        monkeypatch.setattr(runner, "LIBRARIES", "numpy of tomorrow")
    elif changed == "settings":
        case = Case("stereo-direction", (("particles", 60),))
    else:
        more.touch()
    run_of(rendered, case)
    more.unlink(missing_ok=True)
    assert tracked == [FEWER, case]


def test_another_detector_counts_for_those_who_act_on_it(monkeypatch: pytest.MonkeyPatch) -> None:
    cases = (Case("three-part"), Case("three-part", (("adjust", False),)))
    before = [runner._file_name(Path("clip"), "", case) for case in cases]
    other = runner.built_in_detector().with_operating_point(0.5)
    monkeypatch.setattr(runner, "built_in_detector", lambda: other)
    after = [runner._file_name(Path("clip"), "", case) for case in cases]
    assert after[0] != before[0]
    assert after[1] == before[1]


def test_tables_beside_the_sources_count_and_compiled_files_do_not() -> None:
    files = {path.name: path for path in clips.files_of(clips.PACKAGES)}
    assert "scenes.toml" in files
    assert "raster.py" in files
    assert {path.suffix for path in files.values()} & {".pyc", ".so"} == set()


def test_a_clip_is_rendered_once_until_rendering_changes(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[Path] = []

    def render(folder: Path, *_: object, **__: object) -> None:
        made.append(folder)
        folder.mkdir(parents=True)

    monkeypatch.setattr(clips, "render_recording", render)
    clip, longer = Clip("square", 1, 12.0, 16), Clip("square", 1, 30.0, 16)
    first, again, other = folder_of(clip), folder_of(clip), folder_of(longer)
    assert first == again != other
    monkeypatch.setattr(clips, "rendering", lambda: "edited")
    anew = folder_of(clip)
    assert (first.name, other.name) == ("square-1-s12-p16", "square-1-s30-p16")
    assert first.name == anew.name
    assert made == [first, other, anew]
    assert cache in first.parents
    assert folder_of(clip, tmp_path / "mine") == tmp_path / "mine" / clip.name
