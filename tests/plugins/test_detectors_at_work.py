"""A detector of a plug-in finds the people that a tracker follows."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QSettings, Qt
from pytestqt.qtbot import QtBot

from app.__main__ import run as run_command
from app.core.widgets.user_settings import UserSettings
from app.features.runs.track_dialog import TrackDialog
from tests.installed_plugins import install_module
from tracking.pipeline import track
from tracking.plugins import PluginKind, offers
from tracking.recording import open_recording
from tracking.session import Session
from tracking.trackers import parse_settings, tracker_named

_CODE = """
import numpy as np
from tracking.detections.detector import DetectorSpec
from tracking.people.detection_source import FrameDetections
class Middle:
    def find(self, picture):
        height, width = picture.shape[:2]
        box = np.array([[width / 2, height / 3, width / 10, height / 3], [0, 0, 20, 60]])
        return FrameDetections(box, np.array([0.9, 0.1]))
    def close(self):
        pass
DETECTOR = DetectorSpec("middle", "Somebody in the middle", Middle, min_score=0.5, licence="MIT")
"""


@pytest.fixture
def detector(site: Path) -> str:
    """One that sees somebody in the middle of every picture."""
    points = {(PluginKind.DETECTOR.group, "middle"): "DETECTOR"}
    install_module(site, "middle", _CODE, points)
    offers.look_again()
    return "middle"


def test_its_boxes_are_what_a_tracker_sees_people_by(detector: str, clip: Path) -> None:
    texts = {"detections.model": detector, "detections.use": "only"}
    settings = parse_settings(tracker_named("spheroid"), texts)
    with open_recording(clip) as recording, track(recording, "spheroid", settings) as work:
        for _ in work:
            pass
        run = work.run()
        notes = work.notes
    (given,) = run.detections_input
    assert (given.file, given.format, given.network) == (
        detector, "detector", "Somebody in the middle",
    )  # fmt: skip
    assert given.licence == "MIT"
    assert given.count == len(run.network_boxes.columns["left"]) == 32
    assert any(note.startswith("detector middle: ") for note in notes)


def test_the_dialog_offers_it_by_its_title(
    detector: str, site: Path, clip: Path, tmp_path: Path, qtbot: QtBot
) -> None:
    install_module(site, "broken", "1 / 0", {(PluginKind.DETECTOR.group, "broken"): "DETECTOR"})
    offers.look_again()
    kept = UserSettings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))
    with open_recording(clip) as recording:
        dialog = TrackDialog(recording, "spheroid", kept)
        qtbot.addWidget(dialog)
        line = dialog._detections
        files = line._left.files
        offered = [files.itemText(row) for row in range(1, files.count())]
        assert offered == ["Somebody in the middle (plug-in)", "broken (does not work)"]
        assert "ZeroDivisionError" in files.itemData(2, Qt.ItemDataRole.ToolTipRole)
        files.setCurrentIndex(1)
        line._use.setCurrentIndex(1)
        with qtbot.waitSignal(line.usable, check_params_cb=bool):
            pass
        assert line._told.text() == "Detector Somebody in the middle (MIT)"
        chosen = dialog.answer()[1].detections
        assert (chosen.model, chosen.file, chosen.use) == (detector, "", "only")
        dialog.put_settings("spheroid", {"detections.model": detector}, 0)  # as a run had it
        assert files.currentText() == "Somebody in the middle (plug-in)"


def test_the_command_takes_its_name_as_a_model(detector: str, clip: Path, tmp_path: Path) -> None:
    out = tmp_path / "s.h5"
    words = ["track", str(clip), "-o", str(out), "--tracker", "spheroid", "--frames", "0:4"]
    assert run_command([*words, "--model", detector]) == 0
    session = Session.look_into(out)
    assert session.runs[0].settings["detections.model"] == detector
    session.close()


def test_a_model_that_is_neither_a_file_nor_installed_is_told(
    detector: str, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["track", str(clip), "-o", str(tmp_path / "s.h5"), "--model", "nobody"]
    assert run_command(words) in (1, 2)
    assert "nobody" in capsys.readouterr().err.splitlines()[-1]
