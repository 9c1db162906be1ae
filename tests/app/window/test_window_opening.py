import shutil
from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog

from app.presenters import demonstration, opening
from app.presenters.demonstration import Demonstration
from tracking.errors import CancelledError


def _is_open(window) -> bool:
    return window.desk is not None and window.desk.playback.frame is not None


def test_the_first_page_is_shown_where_nothing_is_open(window):
    assert window.welcome.isVisible()
    assert window.windowTitle() == "trackwright"
    assert not window.menus.actions["play.toggle"].isEnabled()


def test_a_recording_opens_on_its_first_frame(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.workspace.isVisible()
    assert window.desk.playback.number == 0
    assert "plaza" in window.windowTitle()
    assert tiny_recording.resolve() in window.remembered.recent


def test_a_session_opens_with_its_tracks(window, qtbot, tiny_session):
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: _is_open(window))
    assert len(window.desk.document.tracks.ids) >= 4
    assert not window.files.unsaved


def test_what_cannot_be_opened_is_told_in_one_line_and_the_window_stays(window, qtbot, tmp_path):
    (tmp_path / "empty").mkdir()
    window.files.open_path(tmp_path / "empty")
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert "empty" in window.notice.text
    assert window.notice.text.count("\n") == 0
    assert window.desk is None


def test_a_session_whose_recording_moved_offers_to_find_it(
    window, qtbot, tiny_session, tiny_recording, own_folder
):
    (own_folder / "recordings.json").unlink()
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert window.notice.action_text == "Find it..."
    window.files.open_path(tiny_session, tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.desk.document.session is not None


def test_a_recording_closes_back_to_the_first_page_which_lists_it(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    window.run_command("file.close")
    assert window.welcome.isVisible()
    assert window.desk is None
    assert [item.path for item in window.files.welcome_scene().recent] == [str(tiny_recording)]


def test_the_layout_and_the_look_are_remembered(window, qtbot, remembered):
    window.run_command("view.look_dark")
    assert remembered.text("look") == "dark"
    window.close()
    assert remembered.state("window/geometry") is not None
    assert remembered.state("workspace/top") is not None


def test_unsaved_sessions_stand_on_the_first_page_after_a_crash(window, own_folder, tiny_session):
    left: Path = opening.unsaved_folder() / "lost-1.h5"
    left.parent.mkdir(parents=True)
    left.write_bytes(tiny_session.read_bytes())
    recent = window.files.welcome_scene().recent
    assert recent[0].path == str(left)
    assert "never saved" in recent[0].detail


def test_after_a_crash_the_window_opens_where_it_was_and_says_so(
    window, qtbot, tiny_session, remembered
):
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: _is_open(window))
    window.desk.playback.go(42)
    window.desk.draw()
    assert remembered.left_open == (tiny_session.resolve(), 42)
    left_open = remembered.left_open
    window.files.close()
    assert remembered.left_open is None
    window.files.reopen(*left_open)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.desk.playback.clock.frame == 42
    assert "here is where you were" in window.notice.text


def test_the_demo_is_made_played_and_tracked_and_saved_beside(
    window, qtbot, tiny_recording, monkeypatch, own_folder
):
    demo = Demonstration.of_user()
    assert demo.folder == own_folder / "demonstration"
    copy = lambda folder, *_, **__: Path(shutil.copytree(tiny_recording, folder))  # noqa: E731
    monkeypatch.setattr(demonstration, "render_recording", copy)
    window.run_command("file.demo")
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.desk.document.recording.path == demo.recording
    assert window.desk.playback.clock.playing
    assert window.desk.live.running
    qtbot.waitUntil(lambda: window.files.session is not None, timeout=20_000)
    window.run_command("file.save")
    dialog = window.findChild(QFileDialog)
    assert dialog.selectedFiles() == [str(demo.session)]
    dialog.reject()


def test_a_demo_that_is_cancelled_leaves_nothing_behind(window, qtbot):
    demo = Demonstration.of_user()
    said = []
    window.work.said.connect(said.append)
    window.run_command("file.demo")
    qtbot.waitUntil(lambda: window.progress._bar.maximum() > 0, timeout=20_000)
    assert not window.progress._cancel.isHidden()
    window.progress._cancel.click()
    qtbot.waitUntil(lambda: not window.work.busy, timeout=20_000)
    assert said == ["Stopped: Making the demo recording"]
    assert not demo.folder.exists() or list(demo.folder.iterdir()) == []
    assert window.desk is None
    assert window.menus.actions["file.open"].isEnabled()


def test_opening_that_was_cancelled_leaves_nothing_open(tiny_session, own_folder):
    def cancel(*_):
        raise CancelledError("stopped by the user")

    with pytest.raises(CancelledError):
        opening.open_cancellable(tiny_session, None, None, cancel)
    opened = opening.open_path(tiny_session)
    assert not opened.document.session.read_only  # nobody holds the lock
    opened.close()
