import threading

import numpy as np
import pytest
from patient import PATIENCE_S

from app.core.document import document_loader
from app.features.runs.run_summary import RunSummary
from app.features.runs.track_dialog import TrackDialog
from tracking.session import Session


@pytest.fixture
def opened(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    return window


def _tracked(window) -> bool:
    return window.files.session is not None and not window.work.busy


def test_the_first_play_tracks_live_and_ends_in_a_session_kept_on_disk(opened, qtbot):
    controller = opened.controller
    opened.run_command("play.faster")
    opened.run_command("play.toggle")
    assert controller.live.running
    qtbot.waitUntil(lambda: _tracked(opened))
    session = opened.files.session
    assert session.path.parent == document_loader.unsaved_folder()
    assert len(session.tracks.track_ids) >= 4
    assert opened.files.saving.unsaved  # nobody gave it a place yet


def test_playing_never_outruns_the_tracker(opened, qtbot):
    controller = opened.controller
    ahead = []
    controller.playback.shown.connect(
        lambda: ahead.append(
            controller.live.running
            and controller.playback.number - max(controller.document.tracked_until - 1, 0)
        )
    )
    controller.playback.set_speed(8.0)
    opened.run_command("play.toggle")
    qtbot.waitUntil(lambda: _tracked(opened))
    assert max(ahead) <= 0


def test_the_floor_shows_particles_of_the_same_frame_as_the_pictures(opened, qtbot):
    controller = opened.controller
    opened.run_command("play.toggle")
    qtbot.waitUntil(lambda: _tracked(opened))
    controller.playback.pause()
    controller.playback.go(60)
    qtbot.waitUntil(lambda: controller.playback.number == 60)
    state = controller.document.frame_state(controller.playback.number)
    floor = controller.scenes.overhead.scene(state)
    assert floor.frame == controller.playback.frame.number == 60
    assert set(np.unique(controller.document.tracks.particles(60)["track"])) == {
        person.track for person in floor.people
    }
    assert len(floor.particles) >= 500


def test_stopping_keeps_what_was_tracked(opened, qtbot):
    controller = opened.controller
    controller.toggle()
    qtbot.waitUntil(lambda: controller.live.done > 3)
    opened.run_command("tracks.stop")
    qtbot.waitUntil(lambda: _tracked(opened))
    run = opened.files.session.runs[0]
    assert run.frames[0] == 0
    assert 3 < run.frames[1] <= 80


def test_cancel_keeps_nothing_of_a_tracking_and_the_button_beside_it_keeps_it(opened, qtbot):
    strip, controller = opened.progress, opened.controller
    controller.tracking.track("stereo-colour")
    qtbot.waitUntil(lambda: controller.live.done > 3 and not strip._stop.isHidden())
    strip._cancel.click()
    assert not controller.live.running
    assert not controller.document.tracks.ids
    qtbot.waitUntil(strip.isHidden)
    assert "its result is not kept" in opened.statusBar().currentMessage()
    assert opened.files.session is None
    controller.tracking.track("stereo-colour")
    qtbot.waitUntil(lambda: controller.live.done > 3 and not strip._stop.isHidden())
    assert strip._stop.text() == "Stop, keep the result"
    strip._stop.click()
    qtbot.waitUntil(lambda: _tracked(opened))
    assert "Stopped early" in opened.notice.text


def test_closing_while_a_tracker_works_waits_for_its_thread(opened, qtbot):
    opened.controller.toggle()
    qtbot.wait(50)
    assert opened.controller.live.running
    opened.files.close()
    assert opened.controller is None


def test_tracking_again_never_touches_corrected_tracks(opened, qtbot):
    controller = opened.controller
    controller.toggle()
    qtbot.waitUntil(lambda: _tracked(opened))
    session = opened.files.session
    track = session.tracks.track_ids[0]
    controller.editing.rename(track, "first")
    corrected = session.tracks.columns()["x"].copy()
    controller.tracking.track("stereo-colour", None, 1)
    qtbot.waitUntil(lambda: not controller.live.running and _tracked(opened))
    assert len(session.runs) == 2
    assert np.array_equal(session.tracks.columns()["x"], corrected, equal_nan=True)
    assert controller.document.label(track).name == "first"
    assert opened.notice.isVisible()
    assert "run 1" in opened.notice._text.text()
    assert "Ctrl+R" in opened.notice._text.text()


def test_a_part_of_the_recording_can_be_tracked(opened, qtbot):
    opened.run_command("tracks.track")
    dialog = opened.findChild(TrackDialog)
    dialog.put_frames(20, 39)
    dialog.accept()
    assert opened.controller.playback.clock.frame == 20
    qtbot.waitUntil(lambda: _tracked(opened))
    assert opened.files.session.runs[0].frames == (20, 40)
    assert opened.files.session.runs[0].seed == 0


def test_the_first_and_the_last_frame_never_cross(opened):
    opened.run_command("tracks.track")
    dialog = opened.findChild(TrackDialog)
    assert dialog.answer()[3] is None
    dialog.put_frames(20, 39)
    dialog._first.setValue(60)
    assert dialog.answer()[3] == (39, 40)
    dialog.put_frames(*dialog._whole)
    assert dialog.answer()[3] is None
    dialog.reject()


def test_a_word_is_seen_beside_the_progress(window, qtbot):
    over = threading.Event()
    window.work.run("Counting", lambda _: over.wait(PATIENCE_S), lambda _: None)
    qtbot.waitUntil(lambda: window.progress.isVisible() and window.jobs_button.isVisible())
    wide = window.progress.maximumWidth()
    window.statusBar().showMessage("stop tracking first")
    room = window.fontMetrics().horizontalAdvance("stop tracking first")
    qtbot.waitUntil(lambda: window.progress.x() > room)
    window.statusBar().clearMessage()
    assert window.progress.maximumWidth() == wide
    over.set()
    qtbot.waitUntil(lambda: not window.work.busy)


def test_a_command_that_must_wait_for_the_tracker_says_so(opened, qtbot):
    opened.controller.toggle()
    assert opened.controller.live.running
    opened.run_command("tracks.swap")
    assert "stop tracking first" in opened.statusBar().currentMessage()


def test_what_there_is_to_tell_of_a_tracking_is_shown_when_it_ends(opened, tiny_run):
    opened.controller.live.notes = ("Lobby: are the cameras swapped?",)
    opened.controller.live.finished.emit(tiny_run)
    assert "are the cameras swapped?" in opened.notice.text
    assert not opened.notice._passing.isActive()


def test_a_result_for_a_session_without_any_says_that_it_is_to_be_saved(opened, tiny_run):
    controller = opened.controller
    controller.document.take_session(Session.create(controller.document.recording))
    controller.live.run_summary = RunSummary.of(tiny_run, [tiny_run.tracks], tiny_run.frames)
    controller.tracking.add_run(tiny_run)
    assert "Kept as run 0; you now correct its tracks" in opened.notice.text
    assert "on disk" not in opened.notice.text
    assert opened.notice._passing.isActive()


def test_which_run_is_corrected_is_told_until_another_one_is(opened, tiny_run, qtbot):
    controller = opened.controller
    controller.document.take_session(Session.create(controller.document.recording, [tiny_run]))
    controller.document.begin_live()
    controller.live.run_summary = RunSummary.of(tiny_run, [tiny_run.tracks], tiny_run.frames)
    controller.live.notes = ("Lobby: are the cameras swapped?",)
    controller.tracking.add_run(tiny_run)
    opened.bring_up_to_date()
    assert "Kept as run 1; you now correct its tracks" in opened.notice.text
    controller.comparing.correct(0)
    qtbot.waitUntil(lambda: opened.notice.text == "")


def test_the_views_follow_the_tracker_until_the_playhead_is_moved(opened, qtbot):
    controller = opened.controller
    controller.tracking.track("stereo-direction", frames=(20, 60))
    assert controller.tracking.following.on
    qtbot.waitUntil(lambda: controller.playback.number > 24)
    controller.playback.go(21)
    assert not controller.tracking.following.on
    done, controller.tracking.following._shown_s = controller.live.done, 0.0  # a picture is due
    qtbot.waitUntil(lambda: controller.live.done > done)
    assert controller.playback.clock.frame == 21
    opened.run_command("play.follow")
    assert controller.tracking.following.on
    qtbot.waitUntil(lambda: _tracked(opened))
    assert controller.playback.clock.frame == 59
    assert not controller.playback.following
    assert opened.notice.text.startswith("Tracked 40 frames with stereo-direction. ")


def test_whoever_plays_is_not_taken_along_by_the_tracker(opened):
    opened.run_command("play.toggle")
    assert opened.controller.live.running
    assert not opened.controller.tracking.following.on
    assert opened.controller.playback.clock.playing


def test_the_first_run_is_seen_and_corrected_while_a_second_one_is_made(opened, qtbot):
    controller = opened.controller
    controller.toggle()
    qtbot.waitUntil(lambda: _tracked(opened))
    document = controller.document
    people = document.tracks.of_frame(40)["track"].tolist()
    controller.tracking.track("stereo-colour", None, 1)
    assert document.is_live
    assert document.in_the_way
    controller.playback.go(40)  # no longer at the tracker's side
    assert controller.live.running
    assert not document.is_live
    assert (document.in_the_way, document.tracks.of_frame(40)["track"].tolist()) == ("", people)
    controller.editing.rename(people[0], "first")
    assert document.label(people[0]).name == "first"
    controller.tracking.following.toggle()
    assert document.is_live
    qtbot.waitUntil(lambda: not controller.live.running and _tracked(opened))
    assert not document.is_live
    assert document.session.adopted_run == 0  # what somebody worked on is not replaced
