"""Body parts that a tracker followed, seen and walked in the real window."""

import numpy as np
import pytest
import run_with_parts
from correcting_window import CROWDED, Hands, open_for_correcting
from PySide6.QtCore import QPointF, QRectF, Qt

from app.features.parts.controller import PartsController
from app.features.parts.panel import CurvesPanel
from tracking.editing import plan_reassign

Key = Qt.Key
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def hands(window, qtbot, parted_session):
    return Hands(window, open_for_correcting(window, qtbot, parted_session), qtbot)


@pytest.fixture
def picture(window):
    return window.workspace.left


def _pick(hands, frame=CROWDED):
    track = hands.people(frame)[0]
    hands.controller.editing.pick(track)
    return track


def test_every_part_of_everybody_stands_where_the_tracker_saw_it(hands, picture):
    boxes = picture._parts.boxes
    rows = run_with_parts.parts_of(hands.controller.document.session.tracks.of_frame(CROWDED))
    assert len(boxes) == len(rows["frame"])
    wanted = {
        (t, p): f for t, p, f in zip(rows["track"], rows["part"], rows["failed"], strict=True)
    }
    assert {(box.track, box.part): box.failed for box in boxes} == wanted
    assert any(box.failed for box in boxes)
    assert not all(box.failed for box in boxes)


def test_q_takes_the_parts_off_the_picture_and_off_the_timeline_and_brings_them_back(
    hands, window, picture
):
    track = _pick(hands)
    assert _lane(window, track).score is not None
    hands.press(Key.Key_Q)
    assert picture._parts.boxes == ()
    assert _lane(window, track).score is None
    hands.press(Key.Key_Q)
    assert picture._parts.boxes


def test_the_particles_of_the_part_that_is_looked_at_are_laid_over_the_picture(hands, picture):
    track = _pick(hands)
    hands.press(Key.Key_O, SHIFT)
    hands.press(Key.Key_8)
    torso = picture._parts.particles
    assert len(torso) == run_with_parts.PARTICLES
    box = next(one for one in picture._parts.boxes if (one.track, one.part) == (track, 1))
    middle = (box.box[0] + box.box[2] / 2, box.box[1] + box.box[3] / 2)
    assert np.allclose(torso.mean(axis=0), middle, atol=3.0)
    hands.press(Key.Key_7)
    assert not np.array_equal(picture._parts.particles, torso)


def test_particles_of_nobody_ask_for_somebody(hands, window):
    hands.press(Key.Key_O, SHIFT)
    assert "Click a person" in window.statusBar().currentMessage()


def test_f3_goes_from_failure_to_failure_of_the_selected_person_and_back(hands, window):
    track = _pick(hands)
    starts = _failures(hands, track)
    seen = []
    for _ in range(3):
        hands.press(Key.Key_F3)
        seen.append((hands.controller.playback.clock.frame, hands.controller.labelling.part))
    later = [one for one in starts if one[0] > CROWDED]
    assert seen == later[:3]
    hands.press(Key.Key_F3, SHIFT)
    assert (hands.controller.playback.clock.frame, hands.controller.labelling.part) == later[1]
    assert hands.controller.document.selection.track == track
    assert "begins to fail" in window.statusBar().currentMessage()


def test_after_the_last_failure_of_anybody_f3_says_so_and_stays(hands, window):
    track = _pick(hands)
    last = max(_failures(hands, one)[-1][0] for one in _failing(hands))
    hands.go(last)
    hands.press(Key.Key_F3)
    assert hands.controller.playback.clock.frame == last
    assert hands.controller.document.selection.track == track
    assert "No part of anybody fails after" in window.statusBar().currentMessage()


def test_f3_goes_on_to_others_once_the_selected_person_has_no_further_failure(hands, window):
    early = min(_failing(hands), key=lambda one: _failures(hands, one)[-1])
    last = _failures(hands, early)[-1][0]
    hands.go(last)
    hands.controller.editing.pick(early)
    hands.press(Key.Key_F3)
    now = hands.controller.document.selection.track
    assert now not in (0, early)
    at = (hands.controller.playback.clock.frame, hands.controller.labelling.part)
    assert at in _failures(hands, now)
    assert at[0] > last
    said = window.statusBar().currentMessage()
    assert f"No further failure of {early}" in said
    assert f"of {now} begins to fail" in said


def test_f3_brings_parts_back_that_were_switched_off(hands, picture):
    hands.press(Key.Key_Q)
    assert picture._parts.boxes == ()
    hands.press(Key.Key_F3)
    hands.qtbot.waitUntil(
        lambda: hands.controller.playback.number == hands.controller.playback.clock.frame
    )
    track = hands.controller.document.selection.track
    assert any(box.track == track and box.failed for box in picture._parts.boxes)
    assert hands.controller.view_options.parts


def test_f3_comes_near_to_somebody_who_is_small_or_out_of_view(hands, picture):
    picture.show_close(QRectF(0.0, 0.0, 8.0, 8.0))
    hands.press(Key.Key_F3)
    frame, track = hands.controller.playback.clock.frame, hands.controller.document.selection.track
    place = picture.viewport.rect(
        QRectF(*hands.controller.of(PartsController).presenter.person_box(frame, track))
    )
    assert QRectF(picture.rect()).contains(place)
    assert place.height() > picture.height() / 4


def test_the_lane_of_the_selected_person_shows_the_score_of_the_part(hands, window):
    track = _pick(hands)
    hands.press(Key.Key_9)
    score = _lane(window, track).score
    rows = run_with_parts.parts_of(hands.controller.document.session.tracks.of_track(track))
    assert score.part == 2
    assert np.array_equal(score.curve.score, rows["score"][rows["part"] == 2])
    others = [lane for lane in window.workspace.timeline.area._scene.lanes if lane.track != track]
    assert all(lane.score is None for lane in others)


def test_parts_follow_their_person_to_another_id(hands):
    track = _pick(hands)
    document = hands.controller.document
    before = document.tracks.parts_of_track(track)
    new = max(document.tracks.ids) + 1
    document.apply(plan_reassign(document.session.tracks, track, new))
    after = document.tracks.parts_of_track(new)
    assert np.array_equal(after["score"], before["score"])
    assert set(after["track"].tolist()) == {new}
    assert len(document.tracks.parts_of_track(track)["frame"]) == 0
    assert new in document.tracks.parts(CROWDED)["track"]


def test_the_plots_say_the_figures_at_the_playhead_and_a_click_goes_to_its_frame(hands, window):
    track = _pick(hands)
    hands.press(Key.Key_Q, SHIFT)
    panel = window.workspace.of(CurvesPanel)
    assert panel.isVisible()
    rows = run_with_parts.parts_of(hands.controller.document.session.tracks.of_track(track))
    head = (rows["part"] == 0) & (rows["frame"] == CROWDED)
    said = panel._said[0].text()
    assert f"{rows['score'][head][0]:+.2f}" in said
    assert f"{rows['particles'][head][0]} particles" in said
    axis = panel.plot.axis
    place = QPointF(axis.x_of(CROWDED + 4.5), panel.plot.height() / 3)
    hands.click(panel.plot, place)
    assert hands.controller.playback.clock.frame == CROWDED + 4
    hands.press(Key.Key_Q, SHIFT)
    assert not panel.isVisible()


def test_a_click_on_a_part_of_the_selected_person_looks_at_that_part(hands, picture):
    track = _pick(hands)
    for part in (2, 0, 1):
        box = next(one for one in picture._parts.boxes if (one.track, one.part) == (track, part))
        rect = picture.viewport.rect(QRectF(*box.box))
        hands.click(picture, rect.center())
        assert hands.controller.document.selection.track == track
        assert hands.controller.labelling.part == part


def test_resting_on_a_part_tells_what_the_detector_says_of_it(hands, picture):
    box = picture._parts.boxes[0]
    told = picture.name_at(picture.viewport.rect(QRectF(*box.box)).center())
    assert any(one.text in told for one in picture._parts.boxes if one.track == box.track)


def test_where_no_parts_were_tracked_the_plots_and_f3_say_how_to_get_them(
    window, qtbot, tiny_session
):
    hands = Hands(window, open_for_correcting(window, qtbot, tiny_session), qtbot)
    _pick(hands)
    hands.press(Key.Key_Q, SHIFT)
    assert "three-part" in window.workspace.of(CurvesPanel).plot._scene.message
    hands.press(Key.Key_F3)
    assert "three-part" in window.statusBar().currentMessage()
    window.statusBar().clearMessage()
    hands.press(Key.Key_Q)
    hands.press(Key.Key_Q)
    assert "three-part" in window.statusBar().currentMessage()


def _lane(window, track):
    lanes = window.workspace.timeline.area._scene.lanes
    return next(lane for lane in lanes if lane.track == track)


def _failing(hands):
    """Everybody of whom a part fails somewhere."""
    return [one for one in hands.controller.document.tracks.ids if _failures(hands, one)]


def _failures(hands, track):
    """(frame, part) at which a part of the track begins to fail, in the order of time."""
    rows = run_with_parts.parts_of(hands.controller.document.session.tracks.of_track(track))
    failed = {
        (frame, part)
        for frame, part, bad in zip(
            rows["frame"].tolist(), rows["part"].tolist(), rows["failed"].tolist(), strict=True
        )
        if bad
    }
    return sorted(one for one in failed if (one[0] - 1, one[1]) not in failed)


def test_part_failures_stand_in_the_review_queue_and_n_goes_to_them(hands, window, qtbot):
    reviewing = hands.controller.reviewing
    qtbot.waitUntil(lambda: any(item.title == "Part failed" for item in reviewing.queue.items))
    reviewing.narrow("part")
    hands.press(Key.Key_N)
    current = reviewing.queue.current
    assert current.kind == "part"
    assert hands.controller.document.selection.track == current.tracks[0]
    there = hands.controller.document.session.tracks.frames_of_track(current.tracks[0])
    first = int(there[there >= current.start][0])
    assert first <= current.frame
    hands.qtbot.waitUntil(lambda: hands.controller.playback.number == first)
    rows = run_with_parts.parts_of(hands.controller.document.session.tracks.of_frame(current.frame))
    failed = {int(p) for t, p, bad in _rows(rows) if bad and t == current.tracks[0]}
    names = [name for part, name in enumerate(("head", "torso", "hip-leg")) if part in failed]
    assert names
    why = reviewing.queue.items[reviewing.queue.place].why
    assert all(name in why for name in names)


def _rows(rows):
    return zip(rows["track"].tolist(), rows["part"].tolist(), rows["failed"].tolist(), strict=True)
