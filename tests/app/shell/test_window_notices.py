"""What the line below the pictures tells, and when it goes again."""

import pytest
from correcting_window import Hands, open_for_correcting
from PySide6.QtCore import QPoint, QRect, Qt

from app.core.jobs.job_list import JobState
from tracking.errors import SessionError

Key = Qt.Key


@pytest.fixture
def hands(window, qtbot, tiny_session) -> Hands:
    hands = Hands(window, open_for_correcting(window, qtbot, tiny_session), qtbot)
    hands.press(Key.Key_Tab)
    return hands


@pytest.fixture
def full_disk(hands, monkeypatch):
    """No edit can be written until it is called."""

    def refuse(*_):
        raise SessionError("the edit could not be written: the disk is full")

    monkeypatch.setattr(hands.controller.document.session, "apply", refuse)
    return monkeypatch.undo


def test_an_edit_the_disk_refused_waits_on_and_enter_tries_again(window, hands, full_disk, qtbot):
    hands.press(Key.Key_Delete)
    assert hands.controller.document.planned.change is not None
    hands.press(Key.Key_Return)
    assert "the disk is full" in window.notice.text
    assert hands.controller.document.flow is not None
    assert window.workspace.preview.isVisible()
    full_disk()
    hands.press(Key.Key_Return)
    assert hands.controller.document.flow is None
    assert len(hands.controller.document.session.history) == 1
    qtbot.waitUntil(lambda: window.notice.text == "")


def test_a_save_that_works_ends_what_was_told_of_one_that_did_not(window, hands, qtbot):
    window.tell_error(SessionError("the disk is full"))
    hands.press(Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: window.notice.text == "")


def test_the_word_about_what_was_recovered_goes_with_the_first_edit(window, hands, qtbot):
    window.notice.say("recovered", passing=True)
    hands.controller.draw()
    qtbot.wait(5)
    assert window.notice.text == "recovered"
    hands.controller.editing.rename(hands.controller.document.selection.track, "anna")
    qtbot.waitUntil(lambda: window.notice.text == "")


def test_it_goes_by_itself_after_a_while(window, hands, qtbot):
    window.notice._passing.setInterval(1)
    window.notice.say("recovered", passing=True)
    qtbot.waitUntil(lambda: window.notice.text == "")


def test_what_offers_a_button_waits_for_its_answer(window, hands):
    window.notice.say("not kept", "Try again", lambda: None, is_error=True)
    window.notice.settle()
    assert window.notice.text == "not kept"


def test_another_session_that_is_damaged_does_not_offer_to_leave_the_open_one(
    window, hands, qtbot, tmp_path
):
    hands.press(Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    damaged = tmp_path / "damaged.h5"
    damaged.write_bytes(b"nothing of use")
    qtbot.waitUntil(lambda: not window.work.busy)
    window.files.beside.compare_with(damaged)
    qtbot.waitUntil(lambda: window.notice.text != "")
    assert window.notice.action_text == ""


def test_the_page_does_not_move_when_something_is_told(window, hands, qtbot):
    before = window.workspace.mapToGlobal(QPoint(0, 0)), window.workspace.size()
    for text in ("not kept", "not kept, for a reason that takes many words " * 20):
        window.notice.say(text, "Try again", lambda: None, is_error=True)
        qtbot.wait(5)
        after = window.workspace.mapToGlobal(QPoint(0, 0)), window.workspace.size()
        assert after == before
        assert window.notice.x() == 0
        assert window.notice.width() > 0.9 * window.centralWidget().width()
        shown = window.childAt(window.notice.geometry().center() - QPoint(0, 3))
        assert shown is window.notice or window.notice.isAncestorOf(shown)


def test_what_is_told_hides_nobody(window, hands):
    told = "People stand in the way of the camera: look after it.\nThe right camera is late."
    for size in ((1280, 688), (1920, 1040)):
        window.resize(*size)
        window.notice.say(told, "Try again", lambda: None)
        over = window.notice.rect().translated(window.notice.mapTo(window, QPoint(0, 0)))
        for view in (window.workspace.left, window.workspace.right, window.workspace.overhead):
            assert not view.rect().translated(view.mapTo(window, QPoint(0, 0))).intersects(over)


@pytest.mark.parametrize("size", [(1280, 688), (1920, 1040)])
def test_a_line_that_is_told_hides_neither_lanes_nor_the_overview(window, hands, size):
    window.resize(*size)
    window.notice.say("Tracked 600 frames with stereo-joint. Kept as run 1.")
    over = window.notice.geometry()
    timeline = window.workspace.timeline
    assert not timeline.rect().translated(timeline.mapTo(window, QPoint(0, 0))).intersects(over)
    assert window.rect().contains(over)


def test_what_is_told_hides_neither_a_passing_word_nor_the_progress(window, hands, qtbot):
    window.notice.say("Tracked 600 frames with stereo-joint.")
    line = window.statusBar().geometry()
    assert window.notice.geometry().intersects(line)
    window.say("saved")
    assert not window.notice.geometry().intersects(line)
    window.statusBar().clearMessage()
    assert window.notice.geometry().intersects(line)
    window.progress.show_scene("Scoring", 0.5)
    assert not window.notice.geometry().intersects(line)


def test_what_is_told_leaves_the_button_of_the_list_of_jobs_in_sight(window, hands, qtbot):
    jobs = window.work.jobs
    jobs.end(jobs.begin("Exporting"), JobState.FAILED)
    qtbot.waitUntil(window.jobs_button.isVisible)
    window.notice.say("Exported", "Open", lambda: None)
    button = window.jobs_button
    place = QRect(button.mapTo(window, QPoint(0, 0)), button.size())
    qtbot.waitUntil(lambda: not window.notice.geometry().intersects(place))
    assert window.notice.geometry().bottom() > place.top()


@pytest.mark.parametrize("size", [(1280, 688), (1920, 1040)])
def test_a_long_text_hides_neither_lanes_nor_the_overview_until_more_is_asked_for(
    window, hands, size
):
    window.resize(*size)
    told = "not kept, for a reason that takes many words " * 20
    window.notice.say(told, "Try again", lambda: None, is_error=True)
    assert window.notice.text == told
    assert window.notice._text.text().endswith("\u2026")
    assert all_of_it_is_seen(window.notice)
    timeline = window.workspace.timeline
    place = timeline.rect().translated(timeline.mapTo(window, QPoint(0, 0)))
    assert not place.intersects(window.notice.geometry())
    window.notice._more.click()
    assert window.notice._text.text() == told
    assert all_of_it_is_seen(window.notice)
    window.notice._more.click()
    assert not place.intersects(window.notice.geometry())


def test_a_short_text_offers_no_more_of_it_also_after_a_long_one(window, hands):
    window.notice.say("not kept, for a reason that takes many words " * 20)
    window.notice._more.click()
    window.notice.say("saved")
    assert window.notice._text.text() == "saved"
    assert window.notice._more.isHidden()


def all_of_it_is_seen(notice) -> bool:
    notice.grab()
    label = notice._text
    return label.height() >= label.heightForWidth(label.width())


def test_all_of_a_long_text_is_seen_in_a_window_that_becomes_narrow(window, hands, qtbot):
    window.notice.say("not kept, for a reason that takes many words " * 20, is_error=True)
    window.notice._more.click()
    wide = window.notice.height()
    window.resize(window.minimumSizeHint())
    qtbot.waitUntil(lambda: window.notice.width() == window.centralWidget().width())
    assert window.notice.height() > wide
    assert all_of_it_is_seen(window.notice)


def test_the_buttons_that_end_long_work_are_seen_whole(window, hands, qtbot):
    window.progress.show_scene("Tracking", 0.4, 12, stoppable=True)
    qtbot.wait(5)
    for button in (window.progress._stop, window.progress._cancel):
        assert button.height() >= button.sizeHint().height()
        seen = button.visibleRegion().boundingRect()
        assert seen == button.rect()


def test_a_passing_word_that_was_read_gives_way_to_the_next_command(window, hands, monkeypatch):
    window.notice.say("tracked", passing=True)
    window.run_command("play.next")
    assert window.notice.text == "tracked"
    monkeypatch.setattr("app.core.widgets.notice._READ_S", 0.0)
    window.run_command("play.next")
    assert window.notice.text == ""
    window.notice.say("look after the camera")
    window.run_command("play.next")
    assert window.notice.text == "look after the camera"
