"""Another language while the program runs: the window is built anew, and nothing is lost."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QLocale, QPointF, QRect
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog, QLabel

from app.core.jobs.job_list import JobState
from app.core.widgets.user_settings import UserSettings
from app.features.review.scene import Order
from app.shell import language_choice
from app.shell.application import start_application
from app.shell.language_choice import chosen_language, name_of_language, why_unreadable
from app.shell.main_window import MainWindow
from app.shell.panel_docks import Dock
from app.shell.shutdown_signals import take_down
from app.shell.window_host import WindowHost
from tracking.translation import language_in_use, use_catalogue

SECOND = 5


@pytest.fixture
def host(qtbot, no_threads_left, remembered: UserSettings, lag_known) -> Iterator[WindowHost]:
    """The program as it runs, its window on the welcome page."""
    application = start_application(remembered)
    host = WindowHost(application, remembered)
    host.window.resize(1280, 800)
    host.window.show()
    yield host
    take_down(host.window)
    host.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    remembered.set_text("language", "en")
    start_application(remembered)
    use_catalogue(None)


@pytest.fixture
def opened(host: WindowHost, qtbot, tiny_session) -> WindowHost:
    """The tiny session open in it."""
    host.window.files.open_path(tiny_session)
    qtbot.waitUntil(
        lambda: (
            host.window.controller is not None and host.window.controller.playback.frame is not None
        )
    )
    return host


def change(host: WindowHost, qtbot, language: str = "ja") -> None:
    """Choose a language in the menu, and wait for the new window."""
    before = host.window
    before.run_command(f"view.language_{language}")
    qtbot.waitUntil(lambda: host.window is not before)


def at_rest(window: MainWindow, qtbot) -> None:
    """Wait until nothing is looked for any more and all is laid out."""
    qtbot.waitUntil(lambda: not window.controller.reviewing.busy)
    qtbot.wait(100)


def shares_of(window: MainWindow) -> list[float]:
    """How large the parts of each splitter are, of all of it; the panels are as high as words."""
    named = window.workspace._shares.splitters.items()
    splitters = [one.sizes() for name, one in named if name != "side"]
    return [size / max(sum(sizes), 1) for sizes in splitters for size in sizes]


def test_the_first_page_is_shown_in_the_language_that_is_chosen(host, qtbot) -> None:
    assert host.window.menus.actions["file.open"].text() == "Open..."
    change(host, qtbot)
    assert language_in_use() == "ja"
    assert host.window.isVisible()
    assert host.window.menus.actions["file.open"].text() == "開く..."
    assert host.window.menus.actions["view.language_ja"].isChecked()
    change(host, qtbot, "en")
    assert host.window.menus.actions["file.open"].text() == "Open..."


def test_qts_own_texts_and_numbers_follow(host, qtbot) -> None:
    change(host, qtbot)
    box = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
    qtbot.addWidget(box)
    assert box.button(QDialogButtonBox.StandardButton.Cancel).text() == "キャンセル"
    assert QLocale().language() is QLocale.Language.Japanese
    assert QLocale().toString(1.5) == "1.5"


def test_file_dialogs_of_qt_are_japanese(host, qtbot) -> None:
    change(host, qtbot)
    dialog = QFileDialog()
    qtbot.addWidget(dialog)
    dialog.setOption(QFileDialog.Option.DontUseNativeDialog)
    dialog.show()
    said = [label.text() for label in dialog.findChildren(QLabel)]
    assert said == ["アドレス(&L):", "ファイル名(&N):", "ファイルの種類(&T):"]


def test_recording_frame_selection_and_history_stay(opened, qtbot) -> None:
    controller = opened.window.controller
    session, recording = controller.document.session, controller.document.recording
    first, second = controller.document.tracks.ids[:2]
    controller.editing.pick(first)
    controller.editing.rename(first, "Anna")
    controller.editing.rename(first, "Anne")
    opened.window.run_command("edit.undo")
    controller.editing.add(second)
    selected = controller.document.selection.all
    controller.playback.set_speed(2.0)
    controller.playback.go(SECOND)
    opened.window.run_command("view.left")
    change(opened, qtbot)
    after = opened.window.controller
    assert after is not controller
    assert after.document.session is session
    assert after.document.recording is recording
    assert after.document.label(first).name == "Anna"
    assert after.playback.clock.frame == SECOND
    qtbot.waitUntil(lambda: after.playback.frame is not None and after.playback.number == SECOND)
    assert after.playback.clock.speed == 2.0
    assert after.document.selection.all == selected
    assert after.cameras == "left"
    assert opened.window.files.saving.unsaved
    opened.window.run_command("edit.redo")
    assert after.document.label(first).name == "Anne"
    opened.window.run_command("edit.undo")
    opened.window.run_command("edit.undo")
    assert after.document.label(first).name == ""


def test_panels_layout_and_zooms_stay(opened, qtbot) -> None:
    window = opened.window
    window.run_command("view.score")
    window.run_command("view.left")
    window.workspace.left.zoom(3.0, QPointF(40, 40))
    window.workspace.timeline.area.stretch.zoom(2.0)
    at_rest(window, qtbot)
    seen, axis = window.workspace.left.zoomed_to, window.workspace.timeline.area.stretch.axis
    shares = shares_of(window)
    options, geometry = window.controller.view_options, window.geometry()
    change(opened, qtbot)
    new = opened.window
    at_rest(new, qtbot)
    assert new.geometry() == geometry
    assert new.controller.view_options == options
    assert shares_of(new) == pytest.approx(shares, abs=0.03)  # of letters of another height
    assert new.workspace.left.zoomed_to.scale == pytest.approx(seen.scale, rel=0.05)
    now = new.workspace.timeline.area.stretch.axis
    assert (now.start, now.frames) == pytest.approx((axis.start, axis.frames))


def test_a_panel_in_a_window_of_its_own_stays_where_it_stood_above_its_window(opened, qtbot):
    window = opened.window
    window.workspace.docks.move("history", Dock.WINDOW)
    own = window.workspace.docks.panels["history"].window()
    room = window.screen().availableGeometry()
    place = QRect(room.right() - own.width(), 90, own.width(), own.height())  # at the very edge
    own.setGeometry(place)
    change(opened, qtbot)
    own = opened.window.workspace.docks.panels["history"].window()
    assert own.isVisible()
    assert (own.geometry().topLeft() - place.topLeft()).manhattanLength() < 40
    assert own.windowHandle().transientParent() is opened.window.windowHandle()


def test_what_ended_stands_in_the_list_of_jobs_still(opened, qtbot, tmp_path):
    jobs = opened.window.work.jobs
    jobs.end(jobs.begin("Batch of recordings"), JobState.DONE, place=tmp_path)
    change(opened, qtbot)
    assert "Batch of recordings" in [one.title for one in opened.window.work.jobs.lines]


def test_the_place_in_the_review_queue_stays(opened, qtbot) -> None:
    before = opened.window.controller.reviewing
    at_rest(opened.window, qtbot)
    before.sort(Order.TIME)
    before.walk(1)
    before.walk(1)
    before.narrow(before.current.kind)
    standing, place = before.standing, before.queue.place
    assert standing.queue.key is not None
    assert standing.queue.kind
    opened.window.run_command("review.plays")
    change(opened, qtbot)
    after = opened.window.controller.reviewing
    at_rest(opened.window, qtbot)
    assert after.standing == replace(standing, plays=True)
    assert after.queue.place == place
    assert after.current.key == standing.queue.key


def test_it_waits_for_an_edit_and_says_so_in_a_line(opened, qtbot) -> None:
    controller, window = opened.window.controller, opened.window
    controller.editing.pick(controller.document.tracks.ids[0])
    window.run_command("tracks.swap")
    window.run_command("view.language_ja")
    assert opened.window is window
    assert "an edit waits" in window.notice.text
    assert "\n" not in window.notice.text
    controller.editing.leave()
    qtbot.waitUntil(lambda: opened.window is not window)
    assert language_in_use() == "ja"


def test_it_waits_for_the_tracker_whose_result_is_kept(host, qtbot, tiny_recording) -> None:
    window = host.window
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller is not None)
    window.controller.toggle()
    qtbot.waitUntil(lambda: window.controller.live.running)
    window.run_command("view.language_ja")
    assert host.window is window
    assert "the tracker is at work" in window.notice.text
    qtbot.waitUntil(lambda: host.window is not window)
    session = host.window.controller.document.session
    assert session is not None
    assert len(session.tracks)


def test_the_choice_is_had_again_at_the_next_start(host, qtbot, remembered) -> None:
    change(host, qtbot)
    use_catalogue(None)
    start_application(UserSettings(remembered._settings))
    assert language_in_use() == "ja"


def test_as_the_system_follows_the_environment(host, qtbot, monkeypatch, remembered) -> None:
    monkeypatch.setenv("LANGUAGE", "ja")
    remembered.set_text("language", "en")
    change(host, qtbot, "system")
    assert language_in_use() == "ja"


@pytest.mark.parametrize("word", ["", "xx", "../ja"])
def test_a_word_that_is_no_language_is_that_of_the_system(remembered, word) -> None:
    remembered.set_text("language", word)
    assert chosen_language(remembered) == ""


def test_where_no_font_has_the_letters_it_says_which_package_gives_one(qapp, monkeypatch) -> None:
    monkeypatch.setattr(language_choice.QFontDatabase, "families", lambda *_: [])
    assert "fonts-noto-cjk" in why_unreadable("ja")
    assert why_unreadable("") == why_unreadable("en") == ""


def test_languages_are_named_as_they_call_themselves() -> None:
    assert [name_of_language(one) for one in ("en", "ja")] == ["English", "日本語"]
