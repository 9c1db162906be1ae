"""Points of animals, or people, from SLEAP and idtracker.ai."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from made_tracks import BOX, looked_over_here
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.idtracker import IDTRACKER, import_idtracker
from tracking.formats.read_result import Filmed
from tracking.formats.sleap import SLEAP, import_sleap
from tracking.tracks import TrackLabel

NAN = np.nan
# frame, track, node, xy: a person of two nodes, one who is seen in part, and one who comes later.
POINTS = np.array(
    [
        [[[10, 20], [14, 50]], [[30, 40], [NAN, NAN]]],
        [[[NAN, NAN], [NAN, NAN]], [[31, 41], [35, 39]]],
        [[[12, 22], [16, 52]], [[NAN, NAN], [NAN, NAN]]],
    ],
    float,
)
SCORES = np.array([[0.5, 0.25], [NAN, 0.75], [1.0, NAN]])


@pytest.fixture(autouse=True)
def quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tracking.formats.hdf5_tracks.verdicts_of", looked_over_here)


def analysis(path: Path, order: tuple[int, ...], scores: NDArray[Any], **attributes: Any) -> Path:
    with h5py.File(path, "w") as file:
        file.create_dataset("tracks", data=POINTS.transpose(order), compression="gzip")
        file["track_names"] = np.array([b"track_0", "Zoë".encode()])
        file["node_names"] = np.array([b"head", b"foot"])
        file["track_occupancy"] = np.isfinite(SCORES).astype(np.uint8)
        file["instance_scores"] = scores
        dims = attributes.pop("dims", None)
        if dims is not None:
            file["tracks"].attrs["dims"] = json.dumps(dims)
        file.attrs.update(attributes)
    return path


@pytest.mark.parametrize(
    ("order", "scores", "attributes"),
    [
        ((1, 3, 2, 0), SCORES.T, {}),
        ((0, 2, 3, 1), SCORES, {"transpose": False}),
        ((0, 1, 2, 3), SCORES, {"dims": ["frame", "track", "node", "xy"]}),
        ((1, 3, 2, 0), SCORES.T, {"dims": ["track", "xy", "node", "frame"]}),
    ],
)
def test_boxes_are_around_the_nodes_sleap_found(
    tmp_path: Path, order: tuple[int, ...], scores: NDArray[Any], attributes: dict[str, Any]
) -> None:
    path = analysis(tmp_path / "a.h5", order, scores, **attributes)
    assert SLEAP.recognises(path, path.read_bytes()[:64])
    found = import_sleap(path, Filmed())
    assert found.columns["frame"].tolist() == [0, 0, 1, 2]
    assert found.columns["track"].tolist() == [1, 2, 2, 1]
    boxes = np.column_stack([found.columns[name] for name in BOX])
    assert boxes.tolist() == [[10, 20, 4, 30], [30, 40, 0, 0], [31, 39, 4, 2], [12, 22, 4, 30]]
    assert found.columns["confidence"].tolist() == [0.5, 0.25, 0.75, 1.0]
    assert np.isnan(found.columns["x"]).all()
    assert found.labels == {2: TrackLabel("Zoë")}
    assert found.frames is None  # what lies behind the last one found is not told
    assert "points SLEAP found" in found.notes[0]


CENTRES = np.array([[[1.5, 2], [NAN, NAN]], [[1.75, 2], [30, 40]], [[NAN, NAN], [31, 41]]])


def trajectories(path: Path, **attributes: Any) -> Path:
    with h5py.File(path, "w") as file:
        file["trajectories"] = CENTRES
        file["id_probabilities"] = np.full((3, 2, 1), 0.5)
        file.create_group("areas")["mean"] = np.ones(2)
        file.attrs["frames_per_second"] = 25
        file.attrs["identities_labels"] = ["1", "Zoë"]
        file.attrs["length_unit"] = -1
        file.attrs.update(attributes)
    return path


def test_centres_of_idtracker_are_boxes_without_size(tmp_path: Path) -> None:
    path = trajectories(tmp_path / "trajectories.h5")
    assert IDTRACKER.recognises(path, path.read_bytes()[:64])
    assert not SLEAP.recognises(path, path.read_bytes()[:64])
    found = import_idtracker(path, Filmed())
    assert found.columns["frame"].tolist() == [0, 1, 1, 2]
    assert found.columns["track"].tolist() == [1, 1, 2, 2]
    boxes = np.column_stack([found.columns[name] for name in BOX])
    assert boxes.tolist() == [[1.5, 2, 0, 0], [1.75, 2, 0, 0], [30, 40, 0, 0], [31, 41, 0, 0]]
    assert found.columns["confidence"].tolist() == [0.5] * 4
    assert found.labels == {2: TrackLabel("Zoë")}
    assert (found.fps, found.frames) == (25, 3)


def table(path: Path, rows: str, header: str = "seconds,x1,y1,x2,y2") -> Path:
    path.write_text(f"{header}\n{rows}", encoding="utf-8")
    return path


def test_the_table_of_idtracker_says_the_same(tmp_path: Path) -> None:
    rows = "0.000,1.500,2.000,nan,nan\n0.033,1.750,2.000,30.000,40.000\n0.067,nan,nan,31.000,41\n"
    path = table(tmp_path / "trajectories.csv", rows)
    assert IDTRACKER.recognises(path, path.read_bytes())
    found = import_idtracker(path, Filmed())
    assert found.columns["frame"].tolist() == [0, 1, 1, 2]
    assert found.columns["left"].tolist() == [1.5, 1.75, 30, 31]
    assert (found.fps, found.frames) == (30, 3)


@pytest.mark.parametrize(
    ("fps", "expected"), [(25, 25), (29.97, 29.97), (30, 30), (12.5, 12.5), (120, 120)]
)
def test_frames_a_second_are_told_by_the_time_of_the_last_frame(
    tmp_path: Path, fps: float, expected: float
) -> None:
    rows = "".join(f"{at / fps:.3f},1,2\n" for at in range(2000))
    found = import_idtracker(table(tmp_path / "t.csv", rows, "seconds,x1,y1"), Filmed())
    assert found.fps == expected


@pytest.mark.parametrize(
    ("rows", "reason"),
    [
        ("0,1,2,3,4\n0.1,1,2\n", "line 3"),
        ("0,1,2,3,4\n\n0.1,1,2,3,4\n", "empty lines"),
        ("0,a,2,3,4\n", "not a number"),
    ],
)
def test_a_table_that_misses_a_frame_is_refused(tmp_path: Path, rows: str, reason: str) -> None:
    with pytest.raises(FormatError, match=reason):
        import_idtracker(table(tmp_path / "t.csv", rows), Filmed())


def spoilt(name: str, data: Any) -> Callable[[h5py.File], None]:
    def spoil(file: h5py.File) -> None:
        del file[name]
        file[name] = data

    return spoil


@pytest.mark.parametrize(
    ("make", "read", "spoil", "reason"),
    [
        (analysis, import_sleap, spoilt("tracks", np.zeros((2, 2))), "2 dimensions at tracks"),
        (analysis, import_sleap, spoilt("tracks", np.zeros((2, 3, 2, 4))), "x and y of nodes"),
        (analysis, import_sleap, spoilt("track_names", [b"a" * 9999]), "longer than any"),
        (trajectories, import_idtracker, spoilt("trajectories", np.zeros((3, 2, 3))), "3 numbers"),
        (trajectories, import_idtracker, spoilt("trajectories", [b"x"]), "1 dimensions"),
        (trajectories, import_sleap, spoilt("areas", [1.0]), "a file of idtracker"),
    ],
)
def test_hostile_files_are_refused_in_one_line(
    tmp_path: Path, make: Any, read: Any, spoil: Callable[[h5py.File], None], reason: str
) -> None:
    path = tmp_path / "t.h5"
    make(path) if make is trajectories else make(path, (1, 3, 2, 0), SCORES.T)
    with h5py.File(path, "a") as file:
        spoil(file)
    with pytest.raises(FormatError, match=reason) as told:
        read(path, Filmed())
    assert str(told.value).startswith(str(path))
    assert "\n" not in str(told.value)


def test_points_no_picture_has_are_bad_rows(tmp_path: Path) -> None:
    path = trajectories(tmp_path / "t.h5")
    with h5py.File(path, "a") as file:
        file["trajectories"][1, 0] = (1e9, 2)
    found = import_idtracker(path, Filmed())
    assert [bad.place for bad in found.bad_rows] == ["identity 1, frame 1"]


def test_pickles_are_not_of_any_format(tmp_path: Path) -> None:
    assert not IDTRACKER.recognises(tmp_path / "trajectories.npy", b"\x93NUMPY\x01\x00v\x00{'descr")
