"""Places on the floor as HDF5: the Pedestrian Dynamics Data Archive's layout and JuPedSim's."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pedpy
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import (
    FLOOR,
    assert_same,
    known_rows,
    looked_over_here,
    table,
    through,
    tracks,
)
from numpy.testing import assert_array_equal

from tracking.errors import CancelledError, FormatError
from tracking.formats.floor_hdf5 import JUPEDSIM_HDF5, PEDPY_HDF5
from tracking.formats.floor_hdf5 import import_trajectory as read
from tracking.formats.read_result import Filmed
from tracking.formats.track_format import TrackFormat
from tracking.formats.track_writer import Exported
from tracking.tracks import TrackTable
from tracking.untrusted import verdicts_of

BOTH = pytest.mark.parametrize("format_", [PEDPY_HDF5, JUPEDSIM_HDF5], ids=lambda each: each.name)
WALK = table([(0, 3), (2, 3), (2, 5)], floor=[(1.5, 4.25), (1.75, 4), (-2, 7)])


@pytest.fixture(autouse=True)
def quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tracking.formats.hdf5_tracks.verdicts_of", looked_over_here)


def exported(made: TrackTable = WALK, **known: Any) -> Exported:
    return Exported.of_table(made, **{"fps": 12.5, "name": "yard", **known})


@BOTH
@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=15
)
@given(made=tracks())
def test_who_has_a_place_comes_back(tmp_path: Path, format_: TrackFormat, made: TrackTable) -> None:
    placed = known_rows(made.columns(), "x")
    if not len(placed["frame"]):
        with pytest.raises(FormatError, match="nobody has a place"):
            through(format_, tmp_path / "t.h5", exported(made))
        return
    back = through(format_, tmp_path / "t.h5", exported(made))
    assert_same(back.columns, placed, FLOOR)
    assert np.isnan(back.columns["left"]).all()
    assert (back.fps, back.bad_count) == (12.5, 0)


@BOTH
def test_pedpy_loads_the_places_and_an_area_that_holds_them(
    tmp_path: Path, format_: TrackFormat
) -> None:
    through(format_, tmp_path / "t.h5", exported())
    loaded = pedpy.load_trajectory_from_ped_data_archive_hdf5(trajectory_file=tmp_path / "t.h5")
    assert loaded.frame_rate == 12.5
    assert loaded.data[["id", "frame", "x", "y"]].to_numpy().tolist() == [
        [3, 0, 1.5, 4.25],
        [3, 2, 1.75, 4],
        [5, 2, -2, 7],
    ]
    area = pedpy.load_walkable_area_from_ped_data_archive_hdf5(trajectory_file=tmp_path / "t.h5")
    assert area.bounds == (-3, 3, 2.75, 8)
    assert pedpy.is_trajectory_valid(traj_data=loaded, walkable_area=area)


def test_more_rows_than_a_chunk_come_back(tmp_path: Path) -> None:
    frames, people = np.divmod(np.arange(150_000), 50)
    floor = np.random.default_rng(1).uniform(-5, 5, (150_000, 2))
    floor[::7] = np.nan
    made = table(list(zip(frames, people + 1, strict=True)), floor=list(floor))
    back = through(PEDPY_HDF5, tmp_path / "t.h5", exported(made))
    assert_array_equal(back.columns["x"], floor[np.isfinite(floor[:, 0]), 0])


def test_without_frames_a_second_nothing_is_written(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="frames per second"):
        through(PEDPY_HDF5, tmp_path / "t.h5", exported(fps=None))
    assert not list(tmp_path.iterdir())


def test_cancelling_leaves_no_file(tmp_path: Path) -> None:
    def cancel(_done: int, _total: int) -> None:
        raise CancelledError("stopped")

    assert PEDPY_HDF5.write is not None
    with pytest.raises(CancelledError):
        PEDPY_HDF5.write(tmp_path / "t.h5", exported(), cancel)
    assert not list(tmp_path.iterdir())


ROW = [("id", "i8"), ("frame", "f8"), ("x", "f4"), ("y", "f4"), ("z", "f4")]


def made_elsewhere(path: Path, rows: list[tuple[Any, ...]], dtype: Any = ROW) -> Path:
    with h5py.File(path, "w") as file:
        file.attrs["petrack_metadata"] = "{}"
        file["personal_details"] = np.array([(1, 1.8)], [("id", "i4"), ("height", "f4")])
        data = file.create_dataset("trajectory", data=np.array(rows, dtype))
        data.attrs["fps"] = np.float32(25)
    return path


def test_files_of_petrack_are_read_with_ids_from_zero(tmp_path: Path) -> None:
    rows = [(0, 4, 1, 2, 1.8), (6, 4, 3, 2, 1.7)]
    found = read(made_elsewhere(tmp_path / "t.h5", rows), Filmed())
    assert found.columns["track"].tolist() == [6, 7]
    assert found.columns["x"].tolist() == [3, 1]
    assert found.fps == 25
    assert found.track_of_zero


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ((1, -1, 0, 0, 0), "the frame number"),
        ((1, 1e12, 0, 0, 0), "the frame number"),
        ((1, np.nan, 0, 0, 0), "finite"),
        ((1, 0.5, 0, 0, 0), "whole numbers"),
        ((-1, 1, 0, 0, 0), "the id is not"),
        ((2**62, 1, 0, 0, 0), "the id is too large"),
        ((1, 1, np.nan, 0, 0), "finite"),
        ((1, 1, np.inf, 0, 0), "finite"),
        ((1, 1, 1e9, 0, 0), "farther than"),
        ((1, 0, 1, 1, 1), "stands twice"),
    ],
)
def test_a_bad_row_is_told_by_its_place(tmp_path: Path, row: tuple[Any, ...], reason: str) -> None:
    found = read(made_elsewhere(tmp_path / "t.h5", [(1, 0, 1, 1, 1), row]), Filmed())
    assert [bad.place for bad in found.bad_rows] == ["row 1 of /trajectory"]
    assert reason in found.bad_rows[0].reason
    assert len(found.columns["frame"]) == 1


def linked(file: h5py.File) -> None:
    del file["trajectory"]
    file["trajectory"] = h5py.ExternalLink("other.h5", "/trajectory")


def virtual(file: h5py.File) -> None:
    del file["trajectory"]
    layout = h5py.VirtualLayout((1,), np.dtype(ROW))
    layout[:] = h5py.VirtualSource("other.h5", "trajectory", (1,))
    file.create_virtual_dataset("trajectory", layout)


def replaced(data: Any, **how: Any) -> Callable[[h5py.File], None]:
    def spoil(file: h5py.File) -> None:
        del file["trajectory"]
        file.create_dataset("trajectory", data=data, **how)

    return spoil


def bomb(file: h5py.File) -> None:
    del file["trajectory"]
    file.create_dataset("trajectory", (10**12,), np.dtype(ROW), chunks=(1000,), compression="gzip")


def zeros(file: h5py.File) -> None:
    del file["trajectory"]
    rows = np.zeros(3_000_000, ROW)
    file.create_dataset("trajectory", data=rows, chunks=(100_000,), compression="gzip")


def of_a_session(file: h5py.File) -> None:
    file.attrs["format"] = "trackwright-session"


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (lambda file: file.__delitem__("trajectory"), "holds no /trajectory"),
        (linked, "holds no /trajectory|link to somewhere else"),
        (virtual, "in other files"),
        (bomb, "which 0 bytes cannot hold"),
        (zeros, "packs 3000000 rows into"),
        (replaced(np.zeros(4)), "without id, frame"),
        (replaced(np.zeros(4, [("id", "i4"), ("frame", "i4"), ("x", "f4")])), "without y"),
        (
            replaced(np.zeros(4, [(name, "S8") for name in ("id", "frame", "x", "y")])),
            "numbers are needed",
        ),
        (
            replaced(np.zeros(4, [(n, "f4", (3,)) for n in ("id", "frame", "x", "y")])),
            "numbers are needed",
        ),
        (of_a_session, "is a trackwright session"),
    ],
)
def test_hostile_files_are_refused_in_one_line(
    tmp_path: Path, spoil: Callable[[h5py.File], None], reason: str
) -> None:
    path = made_elsewhere(tmp_path / "t.h5", [(1, 0, 1, 1, 1)])
    with h5py.File(path, "a") as file:
        spoil(file)
    with pytest.raises(FormatError, match=reason) as told:
        read(path, Filmed())
    assert str(told.value).startswith(str(path))
    assert "\n" not in str(told.value)
    assert not PEDPY_HDF5.recognises(path, path.read_bytes()[:100])


def test_what_is_cut_short_or_no_hdf5_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracking.formats.hdf5_tracks.verdicts_of", verdicts_of)
    path = made_elsewhere(tmp_path / "t.h5", [(1, 0, 1, 1, 1)])
    path.write_bytes(path.read_bytes()[:700])
    with pytest.raises(FormatError, match="damaged or cut short"):
        read(path, Filmed())
    path.write_text("no")
    with pytest.raises(FormatError, match="not an HDF5 file"):
        read(path, Filmed())
    with pytest.raises(FormatError, match="cannot read"):
        read(tmp_path / "nowhere.h5", Filmed())
