"""Long tables are written a piece at a time: in flat memory, with progress, and all or nothing."""

from __future__ import annotations

import tracemalloc
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from made_tracks import table
from numpy.typing import NDArray

from tracking.errors import CancelledError
from tracking.formats import FORMATS, Exported, no_progress
from tracking.tracks import CORRECTED_COLUMNS

PEOPLE = 20


@dataclass(frozen=True)
class MadeAsAsked:
    """A column that stands nowhere: its values are made as they are read."""

    name: str
    rows: int

    def __len__(self) -> int:
        return self.rows

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        number = np.arange(rows.start, rows.stop)
        values = {"frame": number // PEOPLE, "track": number % PEOPLE + 1}
        made = values.get(self.name, np.sqrt(number + 2) % 1)
        return made.astype(CORRECTED_COLUMNS[self.name])


def long(rows: int) -> Exported:
    columns = {name: MadeAsAsked(name, rows) for name in CORRECTED_COLUMNS}
    return Exported(columns, frames=rows // PEOPLE, size_px=(640, 480))


def peak_bytes(name: str, path: Path, rows: int) -> int:
    write = FORMATS[name].write
    assert write is not None
    tracemalloc.start()
    try:
        write(path, long(rows), no_progress)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("name", ["mot", "mot16", "kitti", "csv"])
def test_ten_times_the_rows_take_no_more_memory(tmp_path: Path, name: str) -> None:
    short = peak_bytes(name, tmp_path / "t", 20_000)
    assert peak_bytes(name, tmp_path / "t", 60_000) < 1.2 * short < 60e6


@pytest.mark.parametrize("name", [name for name, each in FORMATS.items() if each.write])
def test_progress_is_told_to_the_end(tmp_path: Path, name: str) -> None:
    told: list[tuple[int, int]] = []
    made = table([(f, t) for f in range(9) for t in (1, 2)], [(0, 0, 5, 5)] * 18, [(1, 2)] * 18)
    write = FORMATS[name].write
    assert write is not None
    exported = Exported.of_table(made, frames=9, fps=10.0, size_px=(64, 48))
    files = write(tmp_path / "t", exported, lambda *step: told.append(step))
    assert told[-1][0] == told[-1][1]
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert set(files) == set(tmp_path.iterdir())


@pytest.mark.parametrize("name", [name for name, each in FORMATS.items() if each.write])
@pytest.mark.parametrize("stop", [CancelledError("stopped"), KeyboardInterrupt()])
def test_who_cancels_keeps_the_old_file_and_no_part_of_the_new_one(
    tmp_path: Path, name: str, stop: BaseException
) -> None:
    path = tmp_path / "t"
    if FORMATS[name].is_folder:
        path.mkdir()
    else:
        path.write_bytes(b"old")

    def report(_done: int, _total: int) -> None:
        raise stop

    made = table([(0, 1), (1, 1)], [(0, 0, 5, 5)] * 2, [(1, 2)] * 2)
    write = FORMATS[name].write
    assert write is not None
    exported = Exported.of_table(made, frames=2, fps=10.0, size_px=(64, 48))
    with pytest.raises(type(stop)):
        write(path, exported, report)
    assert [*tmp_path.iterdir()] == [path]
    if FORMATS[name].is_folder:
        assert not any(path.iterdir())
    else:
        assert path.read_bytes() == b"old"


def test_frames_are_whole_however_the_pieces_fall() -> None:
    rows = long(50_000)
    frames = list(rows.frame_by_frame())
    assert [frame for frame, _ in frames] == list(range(2500))
    assert all(found["track"].tolist() == list(range(1, 21)) for _, found in frames)


def test_tracks_come_one_after_the_other_with_their_rows_by_frame() -> None:
    tracks = list(long(400).track_by_track())
    assert [track for track, _ in tracks] == list(range(1, 21))
    assert all(found["frame"].tolist() == list(range(20)) for _, found in tracks)


def test_only_what_does_not_count_has_confidence_0() -> None:
    made = table([(0, 1), (0, 2)])
    rows = {**made.columns(), "confidence": np.array([0.0, 0.4], np.float32)}
    for dont_cares, counted, least in ((False, [True, True], 1e-6), (True, [False, True], 0)):
        exported = Exported(rows, dont_cares=dont_cares)
        piece = next(exported.pieces())
        assert exported.counted(piece).tolist() == counted
        assert exported.confidence(piece).tolist() == pytest.approx([least, 0.4])
