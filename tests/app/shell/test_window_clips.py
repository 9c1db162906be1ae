"""Clips and pictures of the floor, exported from the real window while work goes on."""

from __future__ import annotations

import threading
from dataclasses import replace

import av
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton, QWidget

from app.core.widgets.jobs_dialog import JobsDialog
from app.features.pictures.clip import ClipChoice, ClipKind
from app.features.pictures.clip_dialog import ClipDialog, ClipOffer, ClipStretch

CHOICE = ClipChoice(ClipKind.MP4, 32, 48, 160, 8.0, floor=True)


def dialog_of(window, kind):
    return next((one for one in window.findChildren(kind) if one.isVisible()), None)


def button(dialog, text):
    return next(
        one for one in dialog.findChildren(QPushButton) if one.text() == text and one.isVisible()
    )


def test_the_dialog_proposes_the_range_then_the_selected_person(window, controller, press, qtbot):
    controller.playback.go(40)
    track = int(controller.document.tracks.of_frame(40)["track"][0])
    controller.editing.pick(track)
    controller.document.correcting.marked = (10, 20)
    press(Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier)
    dialog = dialog_of(window, ClipDialog)
    assert (dialog.choice.start, dialog.choice.stop) == (10, 20)
    asked = []
    dialog.asked.connect(asked.append)
    dialog._stretch.setCurrentIndex(1)
    dialog._follow.setChecked(True)
    dialog._kind.setCurrentIndex(1)
    assert "pictures" in dialog._told.text()
    dialog.accept()
    frames = controller.document.tracks.of_track(track)["frame"]
    (choice,) = asked
    assert (choice.start, choice.stop) == (int(frames[0]), int(frames[-1]) + 1)
    assert (choice.kind, choice.follow) == (ClipKind.GIF, track)


def test_the_dialog_offers_the_current_review_item(window, controller, qtbot):
    qtbot.waitUntil(lambda: bool(controller.reviewing.queue.items))
    controller.reviewing.walk(1)
    window.files.clips.ask()
    dialog = dialog_of(window, ClipDialog)
    item = controller.reviewing.current
    assert (dialog.choice.start, dialog.choice.stop) == (max(0, item.start), item.end)
    dialog.close()


def test_the_dialog_remembers_what_was_chosen_and_not_whom_to_follow(qtbot):
    offer = ClipOffer([ClipStretch("all", 0, 80)], 8.0, 720, "4", 4, stereo=True, floor=True)
    parent = QWidget()
    qtbot.addWidget(parent)
    first = ClipDialog(offer, parent)
    first._kind.setCurrentIndex(1)
    for box in (first._floor, first._follow, first._trails):
        box.toggle()
    first._height.setValue(200)
    second = ClipDialog(offer, parent, first.remembered)
    assert second.choice == replace(first.choice, follow=0)
    assert (second.choice.floor, second.choice.trails) == (True, False)
    without = ClipDialog(replace(offer, floor=False), parent, first.remembered)
    assert not without.choice.floor
    assert ClipDialog(offer, parent, without.remembered).choice.floor
    assert ClipDialog(offer, parent, "kind=99 height=x rate").choice.height_px == 720


def test_a_clip_is_written_behind_all_else_and_can_be_opened(
    window, controller, qtbot, tmp_path, monkeypatch
):
    opened = []
    monkeypatch.setattr(
        "app.shell.main_window.open_place", lambda path: opened.append(path) or True
    )
    path = tmp_path / "clip.mp4"
    window.files.clips.clip_to(path, CHOICE)
    assert not window.work.busy  # people are corrected meanwhile
    qtbot.waitUntil(lambda: str(path) in window.notice.text)
    with av.open(str(path)) as container:
        assert sum(1 for _ in container.decode(video=0)) == 16
    window.notice._act()
    assert opened == [path]


def test_edits_that_come_later_are_not_in_it(window, controller, qtbot, tmp_path):
    window.files.clips.clip_to(tmp_path / "one.gif", CHOICE)
    for track in list(controller.document.tracks.ids):
        assert track in controller.document.tracks.ids
    qtbot.waitUntil(lambda: (tmp_path / "one.gif").exists())


def test_work_behind_is_listed_and_cancelled_there(window, controller, qtbot):
    let_go = threading.Event()

    def work(report):
        while not let_go.is_set():
            report(1, 4)
            let_go.wait(0.01)

    window.work.run_behind("Exporting a film", work, "done")
    QTest.keyClick(window, Qt.Key.Key_J, Qt.KeyboardModifier.ControlModifier)
    dialog = dialog_of(window, JobsDialog)
    qtbot.waitUntil(lambda: window.jobs_button.isVisible() and "25 %" in window.jobs_button.text())
    assert window.jobs_button.text() == "1 job running, 25 %"
    assert "(Ctrl+J)" in window.jobs_button.toolTip()
    qtbot.waitUntil(lambda: any(row.isVisible() for row in dialog._rows.values()))
    button(dialog, "Cancel").click()
    qtbot.waitUntil(lambda: not window.work.jobs.running)
    assert "Exporting a film" in window.statusBar().currentMessage()
    qtbot.waitUntil(lambda: window.jobs_button.text() == "Jobs")
    dialog.close()


def test_the_button_opens_the_list_of_jobs_once(window, controller, qtbot, tmp_path):
    window.work.run_behind("Exporting a film", lambda report: report(1, 1), "done", tmp_path)
    qtbot.waitUntil(window.jobs_button.isVisible)
    window.jobs_button.click()
    window.jobs_button.click()
    (dialog,) = window.findChildren(JobsDialog)
    assert dialog.isVisible()
    assert dialog.windowTitle() == window.jobs_button.accessibleName() == "List of jobs"
    dialog.close()


def test_what_ran_is_opened_from_the_list(window, controller, qtbot, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(
        "app.shell.main_window.open_place", lambda path: opened.append(path) or True
    )
    window.work.run_behind("Exporting a film", lambda report: report(1, 1), "done", tmp_path)
    qtbot.waitUntil(lambda: bool(window.work.jobs.lines) and not window.work.jobs.running)
    window.show_jobs()
    button(dialog_of(window, JobsDialog), "Open").click()
    assert opened == [tmp_path]


def test_a_recording_that_is_closed_takes_its_clips_along(window, controller, qtbot, tmp_path):
    path = tmp_path / "clip.mp4"
    window.files.clips.clip_to(path, ClipChoice(ClipKind.MP4, 0, 80, 480, 60.0, 0.25))
    window.files.close()
    assert not window.work.jobs.running
    assert list(tmp_path.glob("*clip*")) == []


def test_work_that_fails_behind_is_told_and_listed(window, controller, qtbot, tmp_path):
    window.files.clips.clip_to(tmp_path / "missing" / "clip.mp4", CHOICE)
    qtbot.waitUntil(lambda: bool(window.notice.text))
    assert "missing" in window.notice.text
    assert "missing" in window.work.jobs.lines[0].word


@pytest.mark.parametrize("ending", ["png", "svg"])
def test_the_floor_is_written_as_it_is_shown(window, controller, qtbot, tmp_path, ending):
    path = tmp_path / f"floor.{ending}"
    window.files.clips.floor_to(path)
    qtbot.waitUntil(lambda: str(path) in window.notice.text)
    assert path.stat().st_size > 2000


def test_a_session_is_never_written_over(window, controller, qtbot, tiny_session):
    before = tiny_session.read_bytes()
    window.files.clips.clip_to(tiny_session, CHOICE)
    qtbot.waitUntil(lambda: "would be lost" in window.notice.text)
    assert tiny_session.read_bytes() == before
