"""Help > Check this recording, in the real window: findings, Mend, Undo, Cancel, nothing wrong."""

from __future__ import annotations

import math
import shutil
from dataclasses import replace
from pathlib import Path
from threading import Event, Timer
from threading import enumerate as threads

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.features.doctor import presenter
from app.features.doctor.dialog import DoctorDialog
from app.shell.main_window import MainWindow
from tracking.doctor import Examination, Finding, Mend, Mended
from tracking.errors import RecordingError
from tracking.geometry import read_calibration, write_calibration
from tracking.recording import OpenOptions, read_manifest
from tracking.synthesis import SCENES, render_recording
from tracking.translation import msg

LONG_MS = 120_000
NOTHING = Examination((), (), {})


@pytest.fixture(scope="module")
def lobby(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording that is sound."""
    folder = tmp_path_factory.mktemp("doctor") / "lobby"
    render_recording(folder, SCENES["lobby"], 3.0, 3, 11)
    return folder


@pytest.fixture
def sound(lobby: Path, tmp_path: Path) -> Path:
    """A copy of it, with a comment in recording.toml."""
    folder = Path(shutil.copytree(lobby, tmp_path / "lobby"))
    path = folder / "recording.toml"
    path.write_text("# Lobby, from the east\n" + path.read_text())
    return folder


@pytest.fixture
def turned(sound: Path) -> Path:
    """One whose calibration has the right camera turned by half a degree."""
    path = sound / read_manifest(sound).calibration[0]
    rig, vector = read_calibration((path,)), np.array([0.0, 0.0, math.radians(0.5)])
    turn = cv2.Rodrigues(vector)[0]
    write_calibration(
        path, replace(rig, rotation=turn @ rig.rotation, translation=turn @ rig.translation)
    )
    return sound


def page_of(window: MainWindow, qtbot: QtBot, folder: Path) -> DoctorDialog:
    """The page over the recording, opened by its command."""
    window.files.open_path(folder)
    qtbot.waitUntil(lambda: window.controller is not None, timeout=20_000)
    window.run_command("help.doctor")
    assert window.files.doctor.page is not None
    return window.files.doctor.page.dialog


def press(button: object) -> None:
    """As a person does."""
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def rests(page: DoctorDialog) -> bool:
    """Whether nothing runs."""
    return page.again.isEnabled() and page.progress.isHidden()


def nothing_works() -> bool:
    """Whether every job of the page has ended."""
    return not any(each.name.startswith("job ") for each in threads())


def test_a_finding_is_shown_mended_and_the_mend_taken_back(
    window: MainWindow, qtbot: QtBot, turned: Path
) -> None:
    calibration = turned / read_manifest(turned).calibration[0]
    wrong, manifest = calibration.read_bytes(), (turned / "recording.toml").read_text()
    page = page_of(window, qtbot, turned)
    assert page.progress.isVisible()
    qtbot.waitUntil(lambda: rests(page), timeout=LONG_MS)
    assert page.list.count() == 1
    assert "m on the floor" in page.list.item(0).text()
    assert "misplaced" in page.detail.meaning.text()
    assert page.detail.fix.text()
    assert not page.detail.picture.is_empty
    assert page.undo.isHidden()
    press(page.detail.mend)
    qtbot.waitUntil(lambda: rests(page) and page.undo.isVisible(), timeout=LONG_MS)
    assert page.list.count() == 0
    assert page.list.isHidden()
    assert page.text.text().startswith("Nothing is wrong")
    assert calibration.read_bytes() != wrong
    assert (turned / "recording.toml").read_text() == manifest
    press(page.undo)
    qtbot.waitUntil(lambda: rests(page) and page.list.count() == 1, timeout=LONG_MS)
    assert calibration.read_bytes() == wrong
    assert page.undo.isHidden()
    press(page.close_button)
    qtbot.waitUntil(lambda: window.files.doctor.page is None, timeout=20_000)


def test_a_mended_recording_is_opened_anew_where_nothing_was_tracked(
    window: MainWindow, qtbot: QtBot, turned: Path
) -> None:
    page = page_of(window, qtbot, turned)
    before = window.controller
    qtbot.waitUntil(lambda: rests(page), timeout=LONG_MS)
    press(page.detail.mend)
    qtbot.waitUntil(lambda: rests(page) and page.undo.isVisible(), timeout=LONG_MS)
    press(page.close_button)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller is not before, timeout=20_000
    )


def test_the_check_is_cancelled_and_begun_again(
    window: MainWindow, qtbot: QtBot, sound: Path
) -> None:
    page = page_of(window, qtbot, sound)
    press(page.progress._cancel)
    qtbot.waitUntil(lambda: rests(page), timeout=LONG_MS)
    assert "cancelled" in page.text.text()
    press(page.again)
    qtbot.waitUntil(lambda: rests(page) and "Nothing" in page.text.text(), timeout=LONG_MS)
    assert "Checked: " in page.text.text()
    assert page.list.isHidden()
    assert page.detail.isHidden()


def test_the_page_is_closed_while_it_works(window: MainWindow, qtbot: QtBot, sound: Path) -> None:
    page = page_of(window, qtbot, sound)
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert window.files.doctor.page is None
    qtbot.waitUntil(nothing_works, timeout=LONG_MS)


def test_a_recording_without_a_manifest_is_checked_as_it_was_opened(
    window: MainWindow, qtbot: QtBot, turned: Path
) -> None:
    manifest = read_manifest(turned)
    ground = manifest.ground
    options = OpenOptions(
        left=turned / manifest.left,
        right=turned / str(manifest.right),
        calibration=(turned / manifest.calibration[0],),
        height_m=ground.height_m,
        tilt_deg=ground.tilt_deg,
    )
    (turned / "recording.toml").unlink()
    window.files.open_path(turned / manifest.left, options=options)
    qtbot.waitUntil(lambda: window.controller is not None, timeout=20_000)
    window.run_command("help.doctor")
    page = window.files.doctor.page.dialog
    qtbot.waitUntil(lambda: rests(page), timeout=LONG_MS)
    assert page.list.count() == 1
    assert "m on the floor" in page.list.item(0).text()
    assert page.detail.mend.isHidden()
    page.reject()


def test_close_waits_for_no_check_that_tells_no_progress(
    window: MainWindow, qtbot: QtBot, sound: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, may_end = Event(), Event()

    def examined(*_: object) -> Examination:
        begun.set()
        may_end.wait(LONG_MS / 1000)
        return NOTHING

    monkeypatch.setattr(presenter, "examined", examined)
    page = page_of(window, qtbot, sound)
    qtbot.waitUntil(begun.is_set)
    timer = Timer(20.0, may_end.set)  # a window that stood still goes on by then
    timer.start()
    press(page.close_button)
    assert window.files.doctor.page is None
    assert not may_end.is_set()
    timer.cancel()
    may_end.set()
    qtbot.waitUntil(nothing_works, timeout=LONG_MS)


@pytest.mark.parametrize("fails", [False, True])
def test_a_mend_that_goes_on_after_close_ends_and_counts(
    window: MainWindow,
    qtbot: QtBot,
    sound: Path,
    monkeypatch: pytest.MonkeyPatch,
    fails: bool,
) -> None:
    begun, may_end = Event(), Event()

    def mended(*_: object) -> Mended:
        begun.set()
        may_end.wait(LONG_MS / 1000)
        if fails:
            raise RecordingError("the disk is full")
        return Mended((), {}, {})

    found = Finding("lag", msg("late"), msg("mend it"), {}, 0.1, mend=Mend(lag=1))
    monkeypatch.setattr(presenter, "examined", lambda *_: Examination((found,), (), {}))
    monkeypatch.setattr(presenter, "mended", mended)
    page = page_of(window, qtbot, sound)
    before = window.controller
    qtbot.waitUntil(lambda: rests(page), timeout=LONG_MS)
    press(page.detail.mend)
    qtbot.waitUntil(begun.is_set)
    timer = Timer(20.0, may_end.set)
    timer.start()
    press(page.close_button)
    assert not may_end.is_set()
    assert window.controller is before
    timer.cancel()
    may_end.set()
    qtbot.waitUntil(lambda: window.files.doctor.page is None, timeout=20_000)
    if fails:
        assert "the disk is full" in window.notice.text
        assert window.controller is before
    else:
        qtbot.waitUntil(lambda: window.controller not in (None, before), timeout=20_000)


def test_a_recording_that_has_gone_is_told(window: MainWindow, qtbot: QtBot, sound: Path) -> None:
    window.files.open_path(sound)
    qtbot.waitUntil(lambda: window.controller is not None, timeout=20_000)
    (sound / "recording.toml").rename(sound / "elsewhere.toml")
    window.run_command("help.doctor")
    page = window.files.doctor.page.dialog
    qtbot.waitUntil(lambda: rests(page), timeout=LONG_MS)
    assert page.text.text()
    assert page.list.isHidden()
    page.reject()
