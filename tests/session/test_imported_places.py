"""Where imported people stand on the floor, in a recording with one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from tracking.formats import Filmed, format_of
from tracking.geometry import Camera, Ground, View
from tracking.session.track_import import Importable, ImportWish, fit_to_recording

HEADS = np.array([[0.5, 4.0, 1.8], [-0.5, 5.0, 1.5]])
"""World metres of two heads."""
IDTRACKER = "seconds,x1,y1\n0.0,100,90\n0.04,101,91\n"
SLEAP = "track,frame_idx,instance.score,head.x,head.y,neck.x,neck.y\ntrack_0,0,0.9,100,90,104,99\n"
POINTS_AS_MOT = "1,1,100,90,0,0,1,-1,-1,-1\n2,1,101,91,0,0,1,-1,-1,-1\n"
BOXES_AS_MOT = "1,1,100,90,10,30,1,-1,-1,-1\n2,1,101,91,0,0,1,-1,-1,-1\n"


@pytest.fixture
def filmed() -> Filmed:
    matrix = np.array([[300.0, 0.0, 160.0], [0.0, 300.0, 120.0], [0.0, 0.0, 1.0]])
    camera = Camera(matrix, np.zeros(5), 320, 240)
    return Filmed(view=View(camera, Ground(height_m=2.6, tilt_deg=25.0)))


def view_of(filmed: Filmed) -> View:
    assert filmed.view is not None
    return filmed.view


def trc(pixels: NDArray[np.float64], heights_cm: tuple[float, ...]) -> str:
    people = "".join(
        f"0 {height} 0 0 1 -1 -1 -1 -1 1\n\n{x!r} {y!r} -1 -1 -1 100 0 0 -1 -1 -1 -1\n"
        for height, (x, y) in zip(heights_cm, pixels.tolist(), strict=True)
    )
    return f"version 4\n{len(heights_cm)}\n{people}"


def taken(folder: Path, text: str, name: str, filmed: Filmed) -> Importable:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    read = format_of(path).read
    assert read is not None
    return fit_to_recording(read(path, filmed), filmed, ImportWish())


def test_heads_of_a_trc_stand_below_where_they_are_at_the_height_it_has(
    tmp_path: Path, filmed: Filmed
) -> None:
    pixels = view_of(filmed).pixel_from_world(HEADS)
    found = taken(tmp_path, trc(pixels, (180, 150)), "t.trc", filmed)
    places = np.stack([found.rows["x"], found.rows["y"]], axis=1)
    np.testing.assert_allclose(places, HEADS[:, :2], atol=1e-5)
    assert "from heads at the heights that the file has" in found.notes[-1]


@pytest.mark.parametrize("height_cm", [-100000, 0, 5000])
def test_a_head_without_a_height_of_a_person_has_no_place(
    tmp_path: Path, filmed: Filmed, height_cm: float
) -> None:
    pixels = view_of(filmed).pixel_from_world(HEADS)
    some = taken(tmp_path, trc(pixels, (180, height_cm)), "t.trc", filmed)
    assert np.isnan(some.rows["x"]).tolist() == [False, True]
    assert some.notes[-1].endswith("1 of 2 rows have no place")
    none = taken(tmp_path, trc(pixels, (height_cm, height_cm)), "t.trc", filmed)
    assert np.isnan(none.rows["x"]).all()
    assert "there are no places on the floor" in none.notes[-1]


@pytest.mark.parametrize(
    ("text", "name"),
    [(IDTRACKER, "t.csv"), (SLEAP, "t.csv"), (POINTS_AS_MOT, "t.txt")],
    ids=["idtracker", "sleap", "points"],
)
def test_boxes_that_do_not_reach_to_the_feet_give_no_places(
    tmp_path: Path, filmed: Filmed, text: str, name: str
) -> None:
    found = taken(tmp_path, text, name, filmed)
    assert len(found.rows["x"])
    assert np.isnan(found.rows["x"]).all()
    assert "there are no places on the floor" in found.notes[-1]


def test_boxes_beside_points_alone_give_places(tmp_path: Path, filmed: Filmed) -> None:
    found = taken(tmp_path, BOXES_AS_MOT, "t.txt", filmed)
    assert np.isnan(found.rows["x"]).tolist() == [False, True]
    assert "boxes' feet" in found.notes[-1]
