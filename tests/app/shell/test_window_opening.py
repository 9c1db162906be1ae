import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog

from app.core.document import document_loader
from app.core.widgets.user_settings import Place
from app.features.files import demonstration, left_behind
from app.features.files.demonstration import Demonstration
from app.features.timeline.tracks_area import TracksArea
from app.shell.layout_shares import screen_key
from tracking.errors import CancelledError
from tracking.recording import open_recording


def _is_open(window) -> bool:
    return window.controller is not None and window.controller.playback.frame is not None


def test_the_first_page_is_shown_where_nothing_is_open(window):
    assert window.welcome.isVisible()
    assert window.windowTitle() == "trackwright"
    assert not window.menus.actions["play.toggle"].isEnabled()


def test_a_recording_opens_on_its_first_frame(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.workspace.isVisible()
    assert window.controller.playback.number == 0
    assert "plaza" in window.windowTitle()
    assert tiny_recording.resolve() in window.remembered.recent


def test_a_session_opens_with_its_tracks(window, qtbot, tiny_session):
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: _is_open(window))
    assert len(window.controller.document.tracks.ids) >= 4
    assert not window.files.saving.unsaved


def test_what_was_told_as_a_session_was_tracked_is_said_once_and_goes_by_itself(
    window, qtbot, tiny_recording, tiny_run, tmp_path
):
    path = tmp_path / "noted.h5"
    run = replace(tiny_run, notes=("tiny: the right camera was dark for 4 s.",))
    with open_recording(tiny_recording) as recording:
        document_loader.keep_run(recording, run, path).close()
    window.files.open_path(path)
    qtbot.waitUntil(lambda: window.controller is not None)
    assert "During tracking: tiny: the right camera was dark" in window.notice.text
    assert window.notice._passing.isActive()
    window.notice.hide()
    window.controller.draw()
    assert window.notice.text == ""


def test_what_cannot_be_opened_is_told_in_one_line_and_the_window_stays(window, qtbot, tmp_path):
    (tmp_path / "empty").mkdir()
    window.files.open_path(tmp_path / "empty")
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert "empty" in window.notice.text
    assert window.notice.text.count("\n") == 0
    assert window.controller is None


def test_a_session_whose_recording_moved_offers_to_find_it(
    window, qtbot, tiny_session, tiny_recording, own_folder
):
    (own_folder / "recordings.json").unlink()
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert window.notice.action_text == "Find it..."
    assert "outside the session's folder" in window.notice.text
    assert "--" not in window.notice.text
    window.files.open_path(tiny_session, tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.controller.document.session is not None


def test_a_recording_closes_back_to_the_first_page_which_lists_it(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    window.run_command("file.close")
    assert window.welcome.isVisible()
    assert window.controller is None
    assert [item.path for item in window.files.welcome_scene().recent] == [str(tiny_recording)]


def test_the_layout_and_the_look_are_remembered(window, qtbot, remembered):
    window.run_command("view.look_dark")
    assert remembered.text("look") == "dark"
    window.close()
    assert remembered.state("window/geometry") is not None
    assert remembered.text(f"shares/{screen_key(window.screen())}/top")


def test_unsaved_sessions_stand_on_the_first_page_after_a_crash(window, own_folder, tiny_session):
    left: Path = document_loader.unsaved_folder() / "lost-1.h5"
    left.parent.mkdir(parents=True)
    left.write_bytes(tiny_session.read_bytes())
    recent = window.files.welcome_scene().recent
    assert recent[0].path == str(left)
    assert "never saved" in recent[0].detail


def test_work_that_was_never_saved_is_offered_with_its_recording(
    window, qtbot, tiny_recording, tiny_session
):
    left = document_loader.unsaved_folder() / f"{tiny_recording.stem}-7.h5"
    left.parent.mkdir(parents=True)
    tiny_session.rename(left)
    (left.parent / f"{tiny_recording.stem}-8.h5").write_bytes(b"no session")
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert "never saved" in window.notice.text
    window.notice._action.click()
    qtbot.waitUntil(lambda: window.files.session is not None)
    assert window.files.session.path == left
    assert not window.files.session.read_only
    assert "never saved" not in window.notice.text


def test_work_on_another_recording_of_the_same_name_is_not_offered(
    window, qtbot, tiny_recording, tiny_session, tmp_path
):
    left = document_loader.unsaved_folder() / f"{tiny_recording.stem}-1.h5"
    left.parent.mkdir(parents=True)
    tiny_session.rename(left)
    other = tmp_path / "elsewhere" / tiny_recording.name
    shutil.copytree(tiny_recording, other)
    video = next(other.glob("left*"))
    next(other.glob("right*")).replace(video)
    shutil.copyfile(video, other / next(tiny_recording.glob("right*")).name)
    window.files.open_path(other)
    qtbot.waitUntil(lambda: _is_open(window))
    assert "never saved" not in window.notice.text


def test_after_a_crash_the_window_opens_where_it_was_and_says_so(
    window, qtbot, tiny_session, remembered
):
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: _is_open(window))
    person = window.controller.document.tracks.ids[1]
    window.controller.editing.pick(person)
    window.controller.playback.go(42)
    qtbot.waitUntil(lambda: remembered.place(tiny_session.resolve()).frame == 42)
    assert remembered.left_open == (tiny_session.resolve(),)
    window.files.close()
    assert remembered.left_open == ()
    window.files.greet_after_crash()
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.controller.playback.clock.frame == 42
    assert window.controller.document.selection.track == person
    assert "Here is where you were" in window.notice.text


def test_a_recording_opens_again_where_it_was_left(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    window.controller.playback.go(30)
    window.files.close_recording()
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.controller.playback.clock.frame == 30
    assert not window.notice.text


def test_only_so_many_places_are_remembered(remembered):
    for number in range(80):
        remembered.note_open([Path(f"/there/{number}")], Place(number))
    assert remembered.place(Path("/there/79")) == Place(79)
    assert remembered.place(Path("/there/0")) == Place()


@pytest.mark.parametrize("text", ["", "[", "[1]", '{"/there": 3}', '{"/there": ["a", null]}'])
def test_places_that_cannot_be_read_are_forgotten(remembered, text):
    remembered.set_text("places", text)
    assert remembered.place(Path("/there")) == Place()


def test_the_demo_is_made_played_and_tracked_and_saved_beside(
    window, qtbot, tiny_recording, monkeypatch, own_folder
):
    demo = Demonstration.of_user()
    assert demo.folder == own_folder / "demonstration"
    copy = lambda folder, *_, **__: Path(shutil.copytree(tiny_recording, folder))  # noqa: E731
    monkeypatch.setattr(demonstration, "render_recording", copy)
    window.run_command("file.demo")
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.controller.document.recording.path == demo.recording
    assert window.controller.playback.clock.playing
    assert window.controller.live.running
    qtbot.waitUntil(lambda: window.files.session is not None)
    window.run_command("file.save")
    dialog = window.findChild(QFileDialog)
    assert dialog.selectedFiles() == [str(demo.session)]
    dialog.reject()


def test_a_demo_that_is_cancelled_leaves_nothing_behind(window, qtbot):
    demo = Demonstration.of_user()
    said = []
    window.work.said.connect(said.append)
    window.run_command("file.demo")
    qtbot.waitUntil(lambda: window.progress._bar.maximum() > 0)
    assert not window.progress._cancel.isHidden()
    window.progress._cancel.click()
    qtbot.waitUntil(lambda: not window.work.busy)
    assert said == ["Stopped: Making the demo recording"]
    assert not demo.folder.exists() or list(demo.folder.iterdir()) == []
    assert window.controller is None
    assert window.menus.actions["file.open"].isEnabled()


def test_opening_that_was_cancelled_leaves_nothing_open(tiny_session, own_folder):
    def cancel(*_):
        raise CancelledError("stopped by the user")

    with pytest.raises(CancelledError):
        left_behind.open_with_unsaved(tiny_session, None, None, cancel)
    opened = document_loader.open_path(tiny_session)
    assert not opened.document.session.read_only  # nobody holds the lock
    opened.close()


def _damaged(path: Path) -> Path:
    whole = path.read_bytes()
    path.write_bytes(whole[: len(whole) // 2])
    return path


def _text(path: Path) -> Path:
    path.write_text("hello")
    return path


def _no_video(path: Path) -> Path:
    path.mkdir()
    (path / "readme.txt").write_text("hello")
    return path


@pytest.mark.parametrize(
    ("name", "make", "what", "advice"),
    [
        ("notes.txt", _text, "not a video", "give a video"),
        ("cut.h5", _damaged, "damaged or cut short", ""),
        ("text.h5", _text, "not an HDF5 file", "choose a session"),
        ("folder", _no_video, "no recording in this folder", "it needs a recording.toml"),
        ("gone.h5", lambda path: path, "no such session", "check the path"),
    ],
)
def test_a_wrong_file_is_told_in_one_line_with_what_to_do_and_the_window_goes_on(
    window, qtbot, tiny_session, tiny_recording, tmp_path, name, make, what, advice
):
    path = tmp_path / name
    if name == "cut.h5":
        path.write_bytes(tiny_session.read_bytes())
    window.files.open_path(make(path))
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert name in window.notice.text
    assert what in window.notice.text
    assert advice in window.notice.text
    assert "\n" not in window.notice.text
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))


def test_a_damaged_session_offers_the_copy_that_was_saved_before(window, qtbot, tiny_session):
    session = document_loader.open_path(tiny_session)
    session.document.session.save(tiny_session)
    session.close()
    _damaged(tiny_session)
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert window.notice.action_text == "Open the copy saved before"
    window.notice._action.click()
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.files.session.path == tiny_session.with_name("tiny-as-saved-before.h5")
    assert len(window.controller.document.tracks.ids) >= 4


def test_a_file_that_is_dropped_is_opened(window, qtbot, tiny_recording):
    for part, page in ((window, window.welcome), (window, window.workspace)):
        mime = QMimeData()
        mime.setUrls([QUrl.fromLocalFile(str(tiny_recording))])
        none, left = Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton
        entering = QDragEnterEvent(QPoint(5, 5), Qt.DropAction.CopyAction, mime, left, none)
        QApplication.sendEvent(part, entering)
        assert page.isVisible()
        assert entering.isAccepted()
        dropped = QDropEvent(QPointF(5, 5), Qt.DropAction.CopyAction, mime, left, none)
        before = window.controller
        QApplication.sendEvent(part, dropped)
        qtbot.waitUntil(lambda: window.controller is not before and _is_open(window))  # noqa: B023


def test_one_uncalibrated_camera_plays_and_is_tracked_in_parts(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording / "left.mp4")
    qtbot.waitUntil(lambda: _is_open(window))
    controller = window.controller
    said = window.workspace.timeline.findChild(TracksArea)._scene.message
    assert "Press Space" in said
    assert "The position of the floor is unknown" in window.workspace.overhead._scene.message
    assert not window.workspace.camera_switch.isVisible()
    window.run_command("play.toggle")
    assert controller.live.tracker == "three-part"
    qtbot.waitUntil(lambda: controller.live.done > 3)
    qtbot.waitUntil(lambda: controller.playback.number > 3)
    window.run_command("tracks.stop")
    qtbot.waitUntil(lambda: controller.document.session is not None)
    assert controller.document.session.runs[0].tracker == "three-part"


def test_one_camera_is_not_taken_for_the_users_choice_of_a_camera(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording / "left.mp4")
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.controller.cameras == "left"
    window.files.close()
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: _is_open(window))
    assert window.controller.cameras == "both"


def test_the_key_of_a_command_that_cannot_be_done_says_why(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording / "left.mp4")
    qtbot.waitUntil(lambda: _is_open(window))
    with qtbot.waitActive(window):
        window.activateWindow()
    QTest.keyClick(window.workspace.left, Qt.Key.Key_2)
    assert "has one camera" in window.statusBar().currentMessage()
    QTest.keyClick(window.workspace.left, Qt.Key.Key_X)
    assert "track the recording first, or draw a person" in window.statusBar().currentMessage()
