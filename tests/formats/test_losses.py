"""What formats do not hold is told, and what they hold comes back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from made_tracks import BOX, through

from tracking.formats import FORMATS, Exported, Filmed, TrackFormat, losses, no_progress
from tracking.formats.read_result import with_all_columns
from tracking.formats.track_format import Content
from tracking.geometry import Camera, Ground, View
from tracking.tracks import Attribute, AttributeType, Source, TrackLabel, TrackTable

VIEW = View(
    Camera(np.array([[700.0, 0, 600], [0, 700, 180], [0, 0, 1]]), np.zeros(0), 1242, 375),
    Ground(1.65, 0.0),
)
COUNT = 6
COLUMN = {
    Content.BOXES: "left",
    Content.PLACES: "x",
    Content.VELOCITIES: "vx",
    Content.CONFIDENCE: "confidence",
    Content.SOURCES: "source",
    Content.PREDICTED: "predicted",
}
WRITTEN = [each for each in FORMATS.values() if each.write is not None]


def whole(**changed: np.ndarray) -> Exported:
    """One track of which everything is known, and of which something is said of everything."""
    columns = {
        "frame": np.arange(COUNT),
        "track": np.full(COUNT, 3),
        **dict(zip(BOX, (np.arange(COUNT) * 3.0, *np.ones((3, COUNT)) * 40), strict=True)),
        "x": np.linspace(1, 2, COUNT),
        "y": np.linspace(5, 6, COUNT),
        "vx": np.ones(COUNT),
        "vy": np.zeros(COUNT),
        "confidence": np.full(COUNT, 0.59),
        "visibility": np.full(COUNT, 0.1),
        "predicted": np.arange(COUNT) == 2,
        "source": np.full(COUNT, Source.PERSON),
        **changed,
    }
    labels = {3: TrackLabel("Zoë", {"class": "car", "bag": "yes"}, "limps")}
    known = {"frames": COUNT, "fps": 25.0, "size_px": (1242, 375), "labels": labels, "view": VIEW}
    known["schema"] = (Attribute("bag", AttributeType.YES_NO),)
    return Exported.of_table(TrackTable(with_all_columns(columns)), **known)


def lost_in(kind: TrackFormat, path: Path, exported: Exported) -> set[Content]:
    notes = [note for note in losses(kind, exported, path) if note.startswith("left out")]
    told = notes[0].split(" has none: ")[1] if notes else ""
    return {each for each in Content if each.value in told}


@pytest.mark.parametrize("kind", WRITTEN, ids=lambda kind: kind.name)
def test_what_does_not_come_back_was_told_and_nothing_else(
    tmp_path: Path, kind: TrackFormat
) -> None:
    path, exported = tmp_path / "tracks", whole()
    assert kind.write is not None
    assert kind.read is not None
    kind.write(path, exported, no_progress)
    back = kind.read(path, Filmed(view=VIEW))
    expected = exported.rows
    kept = {
        content
        for content, name in COLUMN.items()
        if np.allclose(back.columns[name], expected[name][0:COUNT], atol=1e-6)
    }
    kept |= {Content.VISIBILITY} if (back.columns["visibility"] < 0.5).all() else set()
    label = back.labels.get(3, TrackLabel())
    kept |= {Content.CLASSES} if "class" in label.attributes else set()
    kept |= {Content.NAMES} if label.name and "bag" in label.attributes else set()
    kept |= {Content.NOTES} if label.notes else set()
    kept |= {Content.SCHEMA} if back.schema == exported.schema else set()
    assert lost_in(kind, path, exported) == set(Content) - kept


@pytest.mark.parametrize("kind", WRITTEN, ids=lambda kind: kind.name)
def test_nothing_is_told_of_what_the_tracks_do_not_have(tmp_path: Path, kind: TrackFormat) -> None:
    content = {**dict.fromkeys(("vx", "vy"), np.full(COUNT, np.nan))}
    content |= {"confidence": np.ones(COUNT), "visibility": np.ones(COUNT)}
    content |= {"predicted": np.zeros(COUNT), "source": np.zeros(COUNT)}
    if Content.PLACES not in kind.holds:
        content |= dict.fromkeys(("x", "y"), np.full(COUNT, np.nan))
    if Content.BOXES not in kind.holds:
        content |= dict.fromkeys(BOX, np.full(COUNT, np.nan))
    assert losses(kind, replace(whole(**content), labels={}, schema=()), tmp_path / "t") == ()


@pytest.mark.parametrize(("name", "lacking"), [("coco", "box"), ("pedpy-txt", "place")])
def test_rows_that_are_not_written_are_counted(tmp_path: Path, name: str, lacking: str) -> None:
    unknown = np.where(np.arange(COUNT) < 2, np.nan, 7.0)
    exported = whole(**dict.fromkeys((*BOX, "x", "y"), unknown))
    first = losses(FORMATS[name], exported, tmp_path / "t")[0]
    assert first.startswith(f"2 of {COUNT} rows have no {lacking}")
    back = through(FORMATS[name], tmp_path / "t", exported)
    assert len(back.columns["frame"]) == COUNT - 2


def test_places_that_need_the_camera_are_told_where_it_is_not_known(tmp_path: Path) -> None:
    exported = replace(whole(), view=None)
    (note,) = losses(FORMATS["kitti"], exported, tmp_path / "0000.txt")
    assert Content.PLACES.value in note
    assert "camera and floor" in note


@pytest.mark.parametrize("name", ["mot", "mot16", "kitti"])
@pytest.mark.parametrize("place", ["gt/gt.txt", "label_02/0000.txt", "truth.txt"])
def test_ground_truth_lacks_confidence_which_is_told(tmp_path: Path, name: str, place: str) -> None:
    kind, exported = FORMATS[name], replace(whole(), corrected=True)
    assert Content.CONFIDENCE in lost_in(kind, tmp_path / place, exported)
    assert Content.CONFIDENCE not in lost_in(kind, tmp_path / "out.txt", exported)
    assert "written as a result" in losses(kind, exported, tmp_path / "out.txt")[-1]
    assert "written as a result" not in losses(kind, exported, tmp_path / place)[-1]
