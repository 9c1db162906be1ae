"""The window and plug-ins that fail: no edit is lost, and they are named."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from bad_trackers import tracker_code
from PySide6.QtCore import QObject, QSettings, Qt
from pytestqt.qtbot import QtBot

from app.core.widgets.user_settings import UserSettings
from app.features.runs.live_tracker import LiveTracker
from app.features.runs.track_dialog import TrackDialog
from tests.installed_plugins import install_module
from tracking.editing import plan_rename
from tracking.pipeline import track
from tracking.plugins import PluginKind, offers
from tracking.recording import Recording, open_recording
from tracking.session import Session

GROUP = PluginKind.TRACKER.group
_PATIENCE_MS = 180_000


def _install(site: Path, code: str, package: str = "bad") -> None:
    install_module(site, package, code, {(GROUP, package): "TRACKER"})
    offers.look_again()


@pytest.fixture
def recording(clip: Path) -> Iterator[Recording]:
    with open_recording(clip) as opened:
        yield opened


@pytest.fixture
def session(recording: Recording, tmp_path: Path) -> Iterator[Session]:
    """On disk, with an edit that is in its journal alone."""
    with track(recording, "spheroid") as work:
        for _ in work:
            pass
        made = Session.create(recording, [work.run()], tmp_path / "s.h5")
    first = made.tracks.track_ids[0]
    made.apply(plan_rename(made.tracks, made.labels, first, "Ann"))
    yield made
    made.close()


@pytest.mark.parametrize(
    ("step", "limit_s", "said"),
    [
        ("raise ValueError('stop')", 60.0, "raised ValueError: stop at bad.py:"),
        ("tracks['left'] = np.full(n, np.nan)", 60.0, "column left holds nan"),
        ("import os; os._exit(9)", 60.0, "ended by itself (status 9)"),
        ("time.sleep(600)", 3.0, "did not answer within 3 s"),
    ],
)
def test_a_plugin_that_fails_is_named_and_the_edits_are_on_disk(
    site: Path,
    recording: Recording,
    session: Session,
    qtbot: QtBot,
    step: str,
    limit_s: float,
    said: str,
) -> None:
    _install(site, tracker_code(step, limit_s=limit_s))
    frames = (0, recording.frame_count)
    owner = QObject()
    live = LiveTracker(recording, "bad", None, 0, owner, frames)
    told: list[object] = []
    live.failed.connect(told.append)
    live.finished.connect(lambda _: told.append(live.run_summary and live.run_summary.why))
    live.start()
    qtbot.waitUntil(lambda: bool(told), timeout=_PATIENCE_MS)
    assert "tracker bad (plug-in bad 1.0)" in str(told[0])
    assert said in str(told[0])
    assert session.path is not None
    looked = Session.look_into(session.path)
    assert [label.name for label in looked.labels.tracks.values()] == ["Ann"]
    looked.close()


def test_the_dialog_lists_plugins_and_greys_those_that_do_not_work(
    site: Path, recording: Recording, tmp_path: Path, qtbot: QtBot
) -> None:
    _install(site, tracker_code())
    _install(site, "1 / 0", "broken")
    kept = UserSettings(QSettings(str(tmp_path / "settings.ini"), QSettings.Format.IniFormat))
    dialog = TrackDialog(recording, "bad", kept)
    qtbot.addWidget(dialog)
    choice = dialog._choice
    assert choice.currentText() == "bad"
    assert dialog.answer()[0] == "bad"
    last = choice.count() - 1
    assert choice.itemText(last) == "broken (does not work)"
    assert "raised ZeroDivisionError" in choice.itemData(last, Qt.ItemDataRole.ToolTipRole)
    assert not choice.model().flags(choice.model().index(last, 0)) & Qt.ItemFlag.ItemIsEnabled


def test_a_session_of_a_plugin_that_is_gone_opens_with_its_tracks(
    site: Path, recording: Recording, tmp_path: Path
) -> None:
    _install(site, tracker_code())
    with track(recording, "bad") as work:
        for _ in work:
            pass
        run = work.run()
    Session.create(recording, [run], tmp_path / "s.h5").close()
    (site / "bad-1.0.dist-info" / "entry_points.txt").unlink()
    offers.look_again()
    again = Session.open(tmp_path / "s.h5")
    assert again.runs[0].tracker == "bad"
    assert len(again.tracks.columns()["frame"]) == len(run.tracks["frame"])
    again.close()
