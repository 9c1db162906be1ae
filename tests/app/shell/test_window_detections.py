"""Detections of another program in the window: chosen, tracked with, drawn, kept."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot
from tracked_frames import track_ten_frames

from app.core.scenes import Side
from app.core.tracks.made_by import AtWork
from app.features.detections.controller import DetectionsController
from app.features.detections.presenter import UsedDetections, boxes_of, picture
from app.shell.main_window import MainWindow
from tracking.detections import DetectionSettings, Footage, RecordingDetections, read_detections
from tracking.errors import FormatError

ROWS = "".join(f"{n},-1,{20 + n},40,24,60,0.9\n" for n in range(1, 81))


@pytest.fixture
def tracked(window: MainWindow, qtbot: QtBot, tiny_recording: Path, tmp_path: Path) -> MainWindow:
    """A window in which ten frames were tracked with det.txt."""
    folder = Path(shutil.copytree(tiny_recording, tmp_path / "tiny"))
    (folder / "det.txt").write_text(ROWS)
    track_ten_frames(window, qtbot, folder, {"detections.file": "det.txt"})
    return window


def test_boxes_are_drawn_over_the_picture_until_they_are_switched_off(tracked, qtbot) -> None:
    view = tracked.workspace.left
    qtbot.waitUntil(lambda: view._detections.boxes == ((24.0, 39.0, 24.0, 60.0),), timeout=20_000)
    assert [entry.text for entry in view._detections.legend] == ["boxes of det.txt"]
    with_boxes = view.grab().toImage()
    tracked.run_command("view.detections")
    assert view._detections.boxes == ()
    assert view.grab().toImage() != with_boxes
    tracked.run_command("view.detections")
    assert len(view._detections.boxes) == 1


def test_the_run_says_which_detections_the_process_read(tracked) -> None:
    run = tracked.files.session.runs[0]
    (given,) = run.detections_input
    assert (given.file, given.format, given.count) == ("det.txt", "mot", 80)
    assert run.settings["detections.file"] == "det.txt"


def test_boxes_of_a_file_that_has_changed_since_are_not_drawn_and_that_is_told(
    tracked, qtbot
) -> None:
    path = Path(tracked.controller.document.recording.folder) / "det.txt"
    path.write_text(ROWS.replace("24,60", "30,60"))
    told = []
    tracked.controller.failed.connect(told.append)
    tracked.controller.of(DetectionsController)._found = None
    tracked.controller.of(DetectionsController)._search.stop()
    tracked.controller.draw_frame()
    qtbot.waitUntil(lambda: bool(told), timeout=20_000)
    assert "det.txt has changed since the tracks were made with it" in str(told[0])
    assert tracked.workspace.left._detections.boxes == ()


def test_boxes_of_a_file_outside_that_a_session_names_are_not_drawn_and_that_is_told(
    tracked, tmp_path
) -> None:
    outside = tmp_path / "elsewhere.txt"
    outside.write_text(ROWS)
    run = tracked.files.session.runs[0]
    session_run = replace(run, settings={**run.settings, "detections.file": str(outside)})
    recording = tracked.controller.document.recording
    with pytest.raises(FormatError, match="not in the folder of the recording"):
        boxes_of(recording, UsedDetections.of(session_run))
    at_work = AtWork(session_run.tracker, session_run.settings)  # as the user asked for it
    assert boxes_of(recording, UsedDetections.of(at_work)) is not None


def test_boxes_of_the_cameras_swapped_are_not_drawn(tracked) -> None:
    run = tracked.files.session.runs[0]
    (left,) = run.detections_input
    given = UsedDetections.of(replace(run, detections_input=(replace(left, camera="right"),)))
    with pytest.raises(FormatError, match="has changed since"):
        boxes_of(tracked.controller.document.recording, given)


def test_the_legend_of_each_camera_names_its_own_file(tmp_path: Path) -> None:
    files = []
    for name in ("det.txt", "right.txt"):
        (tmp_path / name).write_text(ROWS)
        files.append(read_detections(tmp_path / name, Footage(80, (320, 240))))
    boxes = RecordingDetections(*files, settings=DetectionSettings())
    told = [picture(boxes, side, 3).legend[0].text for side in (Side.LEFT, Side.RIGHT)]
    assert told == ["boxes of det.txt", "boxes of right.txt"]
