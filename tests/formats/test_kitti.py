"""KITTI's tracking labels in and out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import BOX, FLOOR, assert_same, table, through, tracks
from numpy.testing import assert_allclose

from tracking.errors import FormatError
from tracking.formats import format_of
from tracking.formats.kitti import KITTI
from tracking.formats.read_result import Filmed, Imported
from tracking.formats.track_writer import Exported, no_progress
from tracking.geometry import Camera, Ground, View
from tracking.tracks import TrackLabel, TrackTable

VIEW = View(
    Camera(np.array([[700.0, 0, 600], [0, 700, 180], [0, 0, 1]]), np.zeros(0), 1242, 375),
    Ground(1.65, 0.0),
)
TRUTH = """0 0 Pedestrian 0 1 -1.8 100.5 50 140.5 150 1.7 0.6 0.8 2 1.65 10 -1.6
0 -1 DontCare -1 -1 -10 0 0 30 30 -1000 -1000 -1000 -10 -1 -1 -1
1 2 Car 0 0 -1.8 1 1 2 3 1.5 1.6 4 -1000 -1000 -1000 -10
"""


def imported(folder: Path, text: str, view: View | None = None) -> Imported:
    path = folder / "0000.txt"
    path.write_text(text)
    assert KITTI.read is not None
    return KITTI.read(path, Filmed(view=view))


def test_labels_of_the_benchmark_are_read(tmp_path: Path) -> None:
    found = imported(tmp_path, TRUTH, VIEW)
    assert format_of(tmp_path / "0000.txt").name == "kitti"
    rows = found.columns
    assert rows["frame"].tolist() == [0, 1]
    assert rows["track"].tolist() == [3, 2]
    assert [rows[name][0] for name in BOX] == [100.5, 50, 40, 100]
    assert_allclose([rows["x"], rows["y"]], [[2, np.nan], [10, np.nan]], atol=1e-9)
    assert rows["visibility"].tolist() == [0.5, 1]
    assert found.labels == {2: TrackLabel(attributes={"class": "Car"})}
    assert found.notes == ("1 regions nobody cares about (DontCare) are left out",)
    assert found.track_of_zero == 3


def test_without_a_camera_places_are_left_out_and_that_is_told(tmp_path: Path) -> None:
    found = imported(tmp_path, TRUTH)
    assert np.isnan(found.columns["x"]).all()
    assert "camera and floor" in found.notes[-1]


def test_places_are_told_along_the_camera_s_axes(tmp_path: Path) -> None:
    tilted = View(VIEW.camera, Ground(2.0, 30.0, 5.0))
    made = table([(0, 1)], [(5, 6, 7, 8)], [(1.0, 6.0)])
    path = tmp_path / "t.txt"
    KITTI.write(path, Exported.of_table(made, view=tilted), no_progress)  # type: ignore[misc] # it writes
    x, y, z = (float(field) for field in path.read_text().split()[13:16])
    pixel = tilted.pixel_from_world(np.array([[1.0, 6.0, 0.0]]))[0]
    assert_allclose(pixel, [700 * x / z + 600, 700 * y / z + 180])


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=20
)
@given(tracks())
def test_boxes_and_places_come_back(tmp_path: Path, made: TrackTable) -> None:
    if not len(made):
        return
    path = tmp_path / "t.txt"
    KITTI.write(path, Exported.of_table(made, view=VIEW), no_progress)  # type: ignore[misc] # it writes
    back = KITTI.read(path, Filmed(view=VIEW))  # type: ignore[misc] # it reads
    assert_same(back.columns, made.columns(), (*BOX, *FLOOR))
    assert back.bad_count == 0


def test_what_is_written_byte_for_byte(tmp_path: Path) -> None:
    made = table(
        [(0, 3), (0, 9), (7, 3)],
        [(0, 1.5, 10, 20), (-5, 0, 20, 20), (0, 0, 1, 1)],
        visibility=[1.0, 0.4, np.nan],
    )
    labels = {9: TrackLabel(attributes={"class": "bicycle"})}
    exported = Exported.of_table(made, labels=labels, size_px=(640, 480), ground_truth=True)
    back = through(KITTI, tmp_path / "t.txt", exported)
    assert (tmp_path / "t.txt").read_bytes() == (
        b"0 3 Pedestrian 0 0 -10 0 1.5 10 21.5 -1 -1 -1 -1000 -1000 -1000 -10\n"
        b"0 9 Misc 0 1 -10 -5 0 15 20 -1 -1 -1 -1000 -1000 -1000 -10\n"
        b"7 3 Pedestrian 0 0 -10 0 0 1 1 -1 -1 -1 -1000 -1000 -1000 -10\n"
    )
    assert back.labels == {9: TrackLabel(attributes={"class": "Misc"})}


def test_results_end_in_their_score(tmp_path: Path) -> None:
    back = through(KITTI, tmp_path / "t.txt", Exported.of_table(table([(0, 3)], [(0, 1, 2, 3)])))
    assert (tmp_path / "t.txt").read_text().split()[-1] == "-1"
    assert np.isnan(back.columns["confidence"]).all()
    scored = imported(tmp_path, "0 1 Cyclist 0 0 -10 0 0 1 1 -1 -1 -1 -1000 -1000 -1000 -10 0.75\n")
    assert scored.columns["confidence"].tolist() == [0.75]


GOOD = "4 1 Pedestrian 0 0 -10 0 0 1 1 -1 -1 -1 0 0 0 -10"


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("4 -1 Pedestrian 0 0 -10 0 0 1 1 -1 -1 -1 0 0 0 -10", "id is not a positive"),
        ("5 1 Pedestrian 0 0 -10 5 0 1 1 -1 -1 -1 0 0 0 -10", "negative size"),
        ("5 1 Pedestrian 0 0 -10 nan 0 1 1 -1 -1 -1 0 0 0 -10", "finite"),
        ("5 1 <script> 0 0 -10 0 0 1 1 -1 -1 -1 0 0 0 -10", "'<script>' is no word"),
        *(
            (f"5 1 {number} 0 0 -10 0 0 1 1 -1 -1 -1 0 0 0 -10", f"{number!r} is no word")
            for number in ("0", "1", "7", "-1", "1.5")
        ),
        ("5 1 Pedestrian 0 0", "5 values"),
        ("-5 1 Pedestrian 0 0 -10 0 0 1 1 -1 -1 -1 0 0 0 -10", "frame number"),
        ("5 1 Pedestrian 0 0 -10 0 0 1 1 -1 -1 -1 9e300 0 0 -10", "farther"),
        (GOOD, "twice"),
    ],
)
def test_a_bad_row_is_told_by_its_line(tmp_path: Path, row: str, reason: str) -> None:
    found = imported(tmp_path, f"{GOOD}\n{row}\n", VIEW)
    assert len(found.columns["frame"]) == 1
    assert [bad.place for bad in found.bad_rows] == ["line 2"]
    assert reason in found.bad_rows[0].reason


def test_a_file_of_a_thousand_types_is_refused(tmp_path: Path) -> None:
    rows = [GOOD.replace("Pedestrian", f"Type{n}") for n in range(1000)]
    with pytest.raises(FormatError, match="more than 100 types"):
        imported(tmp_path, "\n".join(rows))
