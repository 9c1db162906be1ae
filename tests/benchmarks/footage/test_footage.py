"""The bench of all footage: figures of known tracks, what changed, what is left out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.benchmarks.footage import recordings
from tests.benchmarks.footage.__main__ import middle_of
from tests.benchmarks.footage.failures import save_worst_frame
from tests.benchmarks.footage.measures import box_figures, figures_of
from tests.benchmarks.footage.others import with_detections
from tests.benchmarks.footage.overhead import passages_found
from tests.benchmarks.footage.recordings import BY_EYE, OTHER_RENDERER, REAL, Footage
from tests.benchmarks.footage.table import cell, changes, table
from tests.benchmarks.runner import Case, KeptRun, fresh_runs
from tracking.formats import read_mot
from tracking.synthesis import Disturbances, render_recording
from tracking.tracks.run import Run


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Footage:
    """Two seconds in which people are there from the start."""
    folder = tmp_path_factory.mktemp("clips") / "lobby-1"
    late = Disturbances(begin_s=8.0)
    render_recording(folder, "lobby", 2.0, 3, 6001, size=(320, 240), disturbances=late)
    return Footage("lobby-1", OTHER_RENDERER, folder)


def kept_run(tracks: dict[str, np.ndarray], frames: int) -> KeptRun:
    """A run that consists of these tracks."""
    times = {"frames": [frames], "seeing_s": [1.0], "following_s": [1.0]}
    run = Run.__new__(Run)
    object.__setattr__(run, "tracks", tracks)
    return KeptRun(run, {name: np.array(value, float) for name, value in times.items()})


def true_tracks(footage: Footage) -> dict[str, np.ndarray]:
    """The rows of the truth that count, as a run's."""
    columns = read_mot(footage.folder / "truth.txt")
    return {name: column[columns["confidence"] > 0] for name, column in columns.items()}


def test_the_truth_is_right_by_box_and_on_the_floor(rendered: Footage) -> None:
    figures = figures_of(rendered, kept_run(true_tracks(rendered), 40))
    assert figures["boxes"]["MOTA"] == figures["floor"]["IDF1"] == 1.0
    assert figures["floor"]["error_m"] == pytest.approx(0.0, abs=1e-6)
    assert (figures["nobody"], figures["ms"]) == (0, 50.0)
    assert figures["tracks"] == figures["people"]


def test_of_several_runs_the_one_in_the_middle_is_told(rendered: Footage) -> None:
    several = [{"boxes": {"MOTA": worth}} for worth in (0.3, 0.0, 0.2, 0.9, -1.0)]
    assert middle_of(several) is several[2]
    assert middle_of([{"tracks": 3}]) == {"tracks": 3}
    assert rendered.is_short


def test_a_track_far_from_everybody_is_of_nobody(rendered: Footage) -> None:
    tracks = true_tracks(rendered)
    one = tracks["track"] == np.bincount(tracks["track"]).argmax()
    ghost = {name: column[one].copy() for name, column in tracks.items()}
    ghost["track"][:] = 99
    ghost["x"] += 20.0
    ghost["left"] += 2000.0
    both = {name: np.concatenate([column, ghost[name]]) for name, column in tracks.items()}
    figures = figures_of(rendered, kept_run(both, 40))
    assert figures["nobody"] == 1
    assert figures["floor"]["false_positives"] > 0


def test_boxes_alone_say_nothing_of_the_floor(rendered: Footage) -> None:
    names = ("frame", "track", "left", "top", "width", "height")
    tracks = true_tracks(rendered)
    figures = box_figures(rendered, {name: tracks[name] for name in names})
    assert figures["boxes"]["MOTA"] == 1.0
    assert cell(figures, "floor MOTA") == ""
    assert cell(figures, "misses") == "0.00"


def test_people_marked_by_eye_are_found_by_their_boxes(tmp_path: Path) -> None:
    name, marked = next(iter(BY_EYE.items()))
    frame, boxes = next(iter(marked.items()))
    left, top, right, bottom = np.array(boxes[0], float)
    values = (frame, 7, left + 3, top, right - left, bottom - top)
    names = ("frame", "track", "left", "top", "width", "height")
    tracks = {n: np.array([value]) for n, value in zip(names, values, strict=True)}
    figures = figures_of(Footage(name, REAL, tmp_path), kept_run(tracks, 10))
    assert figures["walkers"] == {"of": sum(map(len, marked.values())), "found": 1}


def test_the_worst_frame_is_shown(rendered: Footage, tmp_path: Path) -> None:
    tracks = true_tracks(rendered)
    assert save_worst_frame(rendered, "best", tracks, tmp_path) is None
    fewer = {name: column[tracks["frame"] != 11] for name, column in tracks.items()}
    path = save_worst_frame(rendered, "worse", fewer, tmp_path)
    assert path is not None
    assert path.name == "lobby-1-worse-11.jpg"
    assert path.stat().st_size > 1000


def test_a_passage_told_by_eye_is_found_where_one_track_covers_half_of_it() -> None:
    spans = ((1, 60, 111), (2, 180, 321), (3, 380, 400), (4, 400, 420), (5, 480, 571))
    frames = np.concatenate([np.arange(start, end) for _, start, end in spans])
    tracks = np.concatenate([np.full(end - start, track) for track, start, end in spans])
    assert passages_found({"frame": frames, "track": tracks}) == 3


def test_changes_name_what_fell_first() -> None:
    kept = {"people_kept": 1, "people_detected": 2}
    old = {"people": 2, "boxes": {**kept, "MOTA": 0.5, "IDF1": 0.5, "HOTA": 0.5}}
    new = {"people": 2, "boxes": {**kept, "MOTA": 0.7, "IDF1": 0.4, "HOTA": 0.51}}
    before, now = {"lobby": {"flow": old}}, {"lobby": {"flow": new}}
    said = changes(now, before).splitlines()
    assert [line.split()[0] for line in said[1:]] == ["-0.100", "+0.200"]
    assert "0.70 (0.50)" in table("lobby", now["lobby"], before["lobby"])
    assert "Nothing" in changes(before, before)


def test_footage_that_is_missing_is_left_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert recordings.all_footage(tmp_path, ["pets-s2l1-real"]) == []
    assert "it is left out" in capsys.readouterr().err


def test_a_case_of_some_frames_ends_there(rendered: Footage) -> None:
    ((_, kept),) = fresh_runs(rendered.folder, [Case("spheroid", frames=8)])
    assert kept.times["frames"][0] == 8
    assert kept.run.frames == (0, 8)


def test_public_detections_are_given_to_each_tracker_as_a_case_of_its_own() -> None:
    (case,) = with_detections([Case("spheroid", (("coast_s", 1.0),))])
    assert str(case) == "spheroid with detections"
    assert case.settings == (("coast_s", 1.0), ("detections.file", "detections.txt"))
    assert case.chosen().detections.file == "detections.txt"
