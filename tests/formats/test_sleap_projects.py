"""SLEAP's projects, its CSV, and analysis files without tracks."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from made_tracks import BOX, looked_over_here

from tracking.errors import FormatError
from tracking.formats import format_of
from tracking.formats.read_result import Filmed
from tracking.formats.sleap import SLEAP, import_sleap
from tracking.tracks import TrackLabel

NAN = np.nan
USER, MODEL = 0, 1
FRAME = [(name, "u8") for name in ("frame_id", "instance_id_start", "instance_id_end", "frame_idx")]
FRAME += [("video", "u4")]
INSTANCE = [("instance_id", "i8"), ("instance_type", "u1"), ("track", "i4")]
INSTANCE += [("from_predicted", "i8"), ("score", "f4"), ("point_id_start", "u8")]
INSTANCE += [("point_id_end", "u8"), ("frame_id", "u8")]
POINT = [("x", "f8"), ("y", "f8"), ("visible", "?"), ("complete", "?")]
Row = tuple[int, int, int, int, float, list[tuple[float, float]]]
"""Frame, kind, track, the instance it was made from, score and points."""

# A model's person, one a person drew in its stead, one with no track, and one seen in part.
ROWS: list[Row] = [
    (2, MODEL, 0, -1, 0.5, [(10, 20), (14, 50)]),
    (2, MODEL, 1, -1, 0.75, [(30, 40), (NAN, NAN)]),
    (5, MODEL, 0, -1, 0.25, [(11, 21), (15, 51)]),
    (5, USER, 0, 2, 0.0, [(12, 22), (16, 52)]),
    (5, MODEL, -1, -1, 0.9, [(1, 2), (3, 4)]),
]
EXPECTED = [(2, 1, 10, 20, 4, 30), (2, 2, 30, 40, 0, 0), (5, 1, 12, 22, 4, 30)]


@pytest.fixture(autouse=True)
def quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tracking.formats.hdf5_tracks.verdicts_of", looked_over_here)


def project(path: Path, rows: list[Row] = ROWS, version: float = 1.3, videos: int = 1) -> Path:
    points: tuple[list[Any], list[Any]] = ([], [])
    instances, frames = [], []
    for number, (_, kind, track, made_from, score, nodes) in enumerate(rows):
        held = points[kind]
        span = (len(held), len(held) + len(nodes))
        instances.append((number, kind, track, made_from, score, *span, 0))
        held += [(x, y, np.isfinite(x), True) for x, y in nodes]
    shown = [row[0] for row in rows]
    for number, frame in enumerate(dict.fromkeys(shown)):
        first = shown.index(frame)
        span = (first, first + shown.count(frame))
        frames.append((number, *span, frame, number % videos))
    with h5py.File(path, "w") as file:
        file["frames"] = np.array(frames, FRAME)
        file["instances"] = np.array(instances, INSTANCE)
        file["points"] = np.array(points[USER], POINT)
        file["pred_points"] = np.array(points[MODEL], POINT)
        names = [json.dumps([0, name]) for name in ("track_0", "Zoë")]
        file["tracks_json"] = np.array(names, "S")
        file.create_group("metadata").attrs["format_id"] = version
        file["metadata"].attrs["json"] = "{}"
    return path


def rows_of(path: Path) -> list[tuple[float, ...]]:
    columns = import_sleap(path, Filmed()).columns
    lists = (columns[name].tolist() for name in ("frame", "track", *BOX))
    return list(zip(*lists, strict=True))


def test_what_a_person_drew_takes_the_place_of_what_the_model_found(tmp_path: Path) -> None:
    path = project(tmp_path / "p.slp")
    assert format_of(path) is SLEAP
    found = import_sleap(path, Filmed())
    assert rows_of(path) == EXPECTED
    assert found.columns["source"].tolist() == [0, 0, 1]
    np.testing.assert_array_equal(found.columns["confidence"], [0.5, 0.75, NAN])
    assert found.labels == {2: TrackLabel("Zoë")}
    assert "1 instance without a track is left out" in found.notes


def test_a_drawn_track_hides_the_found_one_it_was_not_made_from(tmp_path: Path) -> None:
    loose = [(*row[:3], -1, *row[4:]) for row in ROWS]
    assert rows_of(project(tmp_path / "p.slp", loose)) == EXPECTED


def test_pixels_of_old_projects_are_told_by_their_corners(tmp_path: Path) -> None:
    assert rows_of(project(tmp_path / "p.slp", version=1.0))[0] == (2, 1, 9.5, 19.5, 4, 30)


def test_instances_without_any_track_are_told_by_their_place_in_the_frame(tmp_path: Path) -> None:
    untracked = [(row[0], MODEL, -1, -1, *row[4:]) for row in ROWS[:3]]
    path = project(tmp_path / "p.slp", untracked)
    assert [row[:2] for row in rows_of(path)] == [(2, 1), (2, 2), (5, 1)]
    assert any("look for swaps" in note for note in import_sleap(path, Filmed()).notes)


def column(table: str, name: str, value: Any) -> Callable[[h5py.File], None]:
    def spoil(file: h5py.File) -> None:
        rows = file[table][()]
        rows[name] = value
        file[table][...] = rows

    return spoil


def instead(name: str, data: Any) -> Callable[[h5py.File], None]:
    def spoil(file: h5py.File) -> None:
        del file[name]
        file[name] = data

    return spoil


def newer(file: h5py.File) -> None:
    file["metadata"].attrs["format_id"] = 3.0


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (column("frames", "instance_id_end", 9), "instances that are not there"),
        (column("frames", "instance_id_start", 0), "share instances"),
        (column("instances", "point_id_end", 2**62), "points that are not there"),
        (column("instances", "point_id_end", 8), "points that are not there"),
        (instead("instances", np.zeros(3)), "no tracks of SLEAP|without instance_id"),
        (instead("frames", np.zeros(1, [("frame_id", "S3")])), "without video"),
        (instead("tracks_json", [b"a" * 9999]), "longer than any"),
        (instead("points", h5py.ExternalLink("other.h5", "points")), "link to somewhere else"),
        (newer, "newer than is known"),
    ],
)
def test_hostile_projects_are_refused_in_one_line(
    tmp_path: Path, spoil: Callable[[h5py.File], None], reason: str
) -> None:
    path = project(tmp_path / "p.slp")
    with h5py.File(path, "a") as file:
        spoil(file)
    with pytest.raises(FormatError, match=reason) as told:
        import_sleap(path, Filmed())
    assert str(told.value).startswith(str(path))
    assert "\n" not in str(told.value)


def test_a_project_that_unpacks_to_far_more_than_it_holds_is_refused(tmp_path: Path) -> None:
    path = project(tmp_path / "p.slp")
    with h5py.File(path, "a") as file:
        del file["points"]
        file.create_dataset("points", data=np.zeros(2_000_000, POINT), compression="gzip")
    assert path.stat().st_size < 1 << 20
    with pytest.raises(FormatError, match="packs 2000000 rows"):
        import_sleap(path, Filmed())


def test_a_project_of_several_videos_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="2 videos"):
        import_sleap(project(tmp_path / "p.slp", videos=2), Filmed())


@pytest.mark.parametrize("people", [1, 2])
def test_an_analysis_without_tracks_is_read(tmp_path: Path, people: int) -> None:
    path = tmp_path / "a.h5"
    points = np.arange(2.0 * 2 * 3 * people).reshape(people, 2, 2, 3)
    with h5py.File(path, "w") as file:
        file["tracks"] = points
        file["track_names"] = np.array([])  # as NumPy makes of an empty list: numbers
        file["node_names"] = [b"head", b"foot"]
    assert format_of(path) is SLEAP
    found = import_sleap(path, Filmed())
    assert sorted(set(found.columns["track"].tolist())) == list(range(1, people + 1))
    assert len(found.columns["frame"]) == 3 * people
    assert found.labels == {}
    assert any("look for swaps" in note for note in found.notes) == (people > 1)


HEADER = "track,frame_idx,instance.score,a.score,a.x,a.y,b.x,b.y"


def csv_file(path: Path, *lines: str) -> Path:
    path.write_text("".join(f"{line}\n" for line in (HEADER, *lines)), encoding="utf-8")
    return path


def test_names_of_the_csv_are_kept_and_give_ids_in_their_order(tmp_path: Path) -> None:
    path = csv_file(
        tmp_path / "a.csv", '"Zoë, 2",0,0.5,,1,2,3,4', "track_0,0.0,,,5,6,,", ",1,,,1,1,1,1"
    )
    found = import_sleap(path, Filmed())
    assert rows_of(path) == [(0, 1, 1, 2, 2, 2), (0, 2, 5, 6, 0, 0)]
    assert found.labels == {1: TrackLabel("Zoë, 2"), 2: TrackLabel("track_0")}
    assert "1 instance without a track is left out" in found.notes


def test_instances_of_the_csv_without_any_track_are_told_by_their_place(tmp_path: Path) -> None:
    path = csv_file(tmp_path / "a.csv", ",4,,,1,2,,", ",4,,,3,4,,", ",5,,,3,4,,", ",6,,,,,,")
    assert [row[:3] for row in rows_of(path)] == [(4, 1, 1), (4, 2, 3), (5, 1, 3)]


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("t,0,1,1,1,1", "6 values"),
        ("t,-1,1,1,1,1,1,1", "frame_idx"),
        ("t,0.5,1,1,1,1,1,1", "frame_idx"),
        ("t,99999999,1,1,1,1,1,1", "frame_idx"),
        ("t,0,1,1,x,1,1,1", "not a number"),
        ("t,0,1,1,1e999,1,1,1", "not a number"),
        ("t,0,high,1,1,1,1,1", "not a number"),
        ('"t,0,1,1,1,1,1,1', "0 values"),
    ],
)
def test_an_invalid_line_of_the_csv_is_told(tmp_path: Path, line: str, reason: str) -> None:
    found = import_sleap(csv_file(tmp_path / "a.csv", "t,7,1,1,1,1,1,1", line), Filmed())
    assert found.columns["frame"].tolist() == [7]
    (bad,) = found.bad_rows
    assert (bad.place, reason in bad.reason) == ("line 3", True)
