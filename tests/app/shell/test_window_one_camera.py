"""What trackers of one camera think of, over the picture of the real window."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from correcting_window import open_for_correcting
from PySide6.QtCore import Qt

from app.core.tracks.frame_state import Kinds
from app.core.tracks.made_by import AtWork
from app.features.pictures.ramp_overlay import RampPainter
from tracking.errors import CalibrationError
from tracking.recording import open_recording
from tracking.trackers import settings_from
from tracking.trackers.spheroid import SpheroidSettings
from tracking.tracks import TRACKLET_COLUMNS, Particles

Key, SHIFT = Qt.Key, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def controller(window, qtbot, tiny_session):
    return open_for_correcting(window, qtbot, tiny_session)


def overlay(window) -> np.ndarray | None:
    return window.workspace.left._scene.overlay


@pytest.mark.parametrize("key", [Key.Key_E, Key.Key_R])
def test_a_key_lays_them_over_the_left_camera_and_takes_them_off(window, controller, press, key):
    run = controller.document.session.corrected_run
    object.__setattr__(run, "tracker", "spheroid")
    object.__setattr__(run, "settings", {"paper": True})
    controller.editing.pick(
        int(controller.document.tracks.of_frame(controller.playback.number)["track"][0])
    )
    press(key, SHIFT)
    assert np.count_nonzero(overlay(window)[..., 3]) > 50
    assert window.workspace.right._scene.overlay is None
    press(key, SHIFT)
    assert overlay(window) is None


@pytest.mark.parametrize(
    ("command", "said"),
    [("tracklets", "track with flow"), ("evaluation", "No region of evaluation here")],
)
def test_what_is_not_there_is_told_with_what_to_do(window, controller, command, said):
    window.run_command(f"view.{command}")
    assert said in window.statusBar().currentMessage()
    window.run_command(f"view.{command}")


def test_tracklets_follow_the_frame(window, controller, press, qtbot):
    run = controller.document.session.corrected_run
    frames = controller.document.recording.frame_count
    point = {name: np.full(frames, 40, dtype) for name, dtype in TRACKLET_COLUMNS.items()}
    point["track"][:] = 1
    point["u0"][:] = np.arange(frames) + 50
    object.__setattr__(run, "tracklets", Particles(np.arange(frames + 1), point))
    press(Key.Key_T, SHIFT)
    before = np.argwhere(overlay(window)[..., 3] > 200)[:, 1].max()
    controller.playback.step(10)
    qtbot.waitUntil(lambda: controller.playback.number == controller.playback.clock.frame)
    after = np.argwhere(overlay(window)[..., 3] > 200)[:, 1].max()
    assert after == before + 10


def test_the_ramp_image_covers_the_picture_with_its_legend(window, controller, press, qtbot):
    press(Key.Key_B, SHIFT)
    qtbot.waitUntil(lambda: overlay(window) is not None)
    assert (overlay(window)[..., 3] > 0).all()
    texts = [entry.text for entry in window.workspace.left._scene.legend]
    assert texts == ["foreground", "doubtful", "background"]


def test_the_ramp_image_is_made_anew_with_the_settings_of_a_tracker_at_work(
    window, controller, press, qtbot
):
    press(Key.Key_B, SHIFT)
    qtbot.waitUntil(lambda: overlay(window) is not None)
    dark = int(overlay(window)[..., :3].astype(int).sum())
    settings = settings_from(SpheroidSettings, {"ramp.low": 0.1, "ramp.high": 0.5})
    controller.document.begin_live(0, AtWork.of("spheroid", settings))
    controller.draw_frame()
    qtbot.waitUntil(lambda: overlay(window) is not None)
    assert int(overlay(window)[..., :3].astype(int).sum()) > 1.2 * dark
    controller.document.end_live()


def test_before_the_frame_a_tracker_goes_on_from_the_run_made_what_is_shown(controller):
    controller.document.begin_live(40, AtWork.of("flow"))
    assert controller.document.made_by(39) is controller.document.session.corrected_run
    assert controller.document.made_by(40).tracker == "flow"
    controller.document.end_live()


def test_people_are_brighter_in_the_ramp_image_than_what_lies_around(
    tiny_recording: Path, tiny_run
) -> None:
    with open_recording(tiny_recording) as recording:
        painter = RampPainter(recording)
        frame = recording.read(60)
        painted = painter.paint(frame, Kinds(ramp=True))
    people = tiny_run.tracks["frame"] == 60
    bright = painted[..., :3].astype(int).sum(axis=-1)
    u = tiny_run.tracks["left"][people] + tiny_run.tracks["width"][people] / 2
    v = tiny_run.tracks["top"][people] + tiny_run.tracks["height"][people] / 2
    assert np.median(bright[v.astype(int), u.astype(int)]) > 3 * np.median(bright) + 30


def test_without_a_calibration_the_ramp_image_is_refused(tiny_recording: Path) -> None:
    with open_recording(tiny_recording) as recording:
        recording.view = None
        with pytest.raises(CalibrationError, match="needs a calibrated camera"):
            RampPainter(recording)
