"""Parts labelled by keys where the detector is least sure, and over a range."""

import pytest
from correcting_window import CROWDED, CTRL, LEFT, NO_KEY, Hands, open_for_correcting
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtTest import QTest

from app.core.document.detector_choice import DetectorChoice
from tracking.failure import built_in_detector, suggest

Key = Qt.Key
ALT = Qt.KeyboardModifier.AltModifier


@pytest.fixture
def hands(window, qtbot, parted_session):
    return Hands(window, open_for_correcting(window, qtbot, parted_session), qtbot)


@pytest.fixture
def labels(hands):
    return lambda: hands.controller.document.session.labels.parts


@pytest.fixture
def suggested(hands, qtbot):
    """Alt+6 was pressed and the first suggestion is looked at."""
    hands.press(Key.Key_6, ALT)
    queue = lambda: hands.controller.labelling._keys.suggesting.queue  # noqa: E731
    qtbot.waitUntil(lambda: queue().current is not None)
    wait_there(hands, qtbot)
    return queue


def wait_there(hands, qtbot):
    playback = hands.controller.playback
    qtbot.waitUntil(lambda: playback.number == playback.clock.frame)


def test_suggestions_are_those_of_the_detector_in_use_the_least_sure_first(hands, suggested):
    document = hands.controller.document
    parts = document.session.runs[0].parts
    wanted = suggest(parts, document.recording.fps, built_in_detector(), {})
    assert [one.key for one in suggested().open] == [one.key for one in wanted]
    frame, track, part = suggested().open[0].key
    assert hands.controller.playback.number == frame
    assert document.selection.track == track
    assert hands.controller.labelling.part == part


def test_the_list_says_whose_scores_it_goes_by(suggested):
    assert all(one.reason.endswith(" of the built-in detector") for one in suggested().open)


def test_while_labelling_the_verdict_and_whose_score_it_is_stand_on_the_picture(
    hands, window, suggested
):
    (card,) = window.workspace.left._parts.cards
    frame, track, part = suggested().current.key
    rows = hands.controller.document.session.runs[0].parts
    here = (rows["frame"] == frame) & (rows["track"] == track) & (rows["part"] == part)
    said = next(line.text for line in card.lines if line.part == part)
    assert f"{rows['score'][here][0]:+.2f}" in said
    assert "of the run" in card.foot[0]
    assert card.foot[1].endswith("of the built-in detector")
    hands.press(Key.Key_Q)  # parts are hidden, the verdict of what is labelled is not
    assert said in [line.text for line in window.workspace.left._parts.cards[0].lines]


def test_an_answer_goes_on_to_the_next_suggestion_and_keeps_who_said_it_and_why(
    hands, suggested, labels, qtbot
):
    first, second = suggested().open[:2]
    hands.press(Key.Key_5)
    wait_there(hands, qtbot)
    label = labels()[first.key]
    assert label.on_part is False
    assert label.source == "tracker"
    assert label.author == hands.controller.document.session.author != ""
    assert label.reason == first.reason
    assert "unsure" in label.reason
    assert suggested().current == second
    assert hands.controller.playback.number == second.key[0]
    hands.press(Key.Key_4)
    assert labels()[second.key].on_part is True
    assert suggested().current.key not in labels()


def test_n_and_p_walk_the_suggestions_without_labelling(hands, suggested, labels, qtbot):
    first, second, third = suggested().open[:3]
    hands.press(Key.Key_N)
    hands.press(Key.Key_N)
    wait_there(hands, qtbot)
    assert suggested().current == third
    hands.press(Key.Key_P)
    assert suggested().current == second
    hands.press(Key.Key_P)
    assert suggested().current == first
    assert len(labels()) == 0


def test_what_is_suggested_is_seen_from_near_and_all_again_afterwards(hands, window, suggested):
    picture = window.workspace.left
    part = suggested().current.key[2]
    mark = next(one for one in hands.controller.labelling._parts._marks if one.part == part)
    near = picture.viewport.scale
    rect = picture.viewport.rect(QRectF(*mark.box))
    assert QRectF(picture.rect()).contains(rect)
    hands.press(Key.Key_Escape)
    assert picture.viewport.scale < near


def test_undo_brings_a_suggestion_back(hands, suggested, labels, window):
    first = suggested().open[0]
    count = len(suggested().open)
    hands.press(Key.Key_6)
    assert len(suggested().open) == count - 1
    hands.press(Key.Key_Z, CTRL)
    assert len(labels()) == 0
    hands.controller.draw()
    assert suggested().open[0] == first
    shown = window.workspace.labelling.parts._suggestions
    assert shown._model.rowCount() == len(suggested().open)


def test_undo_looks_at_the_person_part_and_row_of_the_label_that_was_taken_back(
    hands, suggested, labels, qtbot
):
    number = next(
        number
        for number, (one, after) in enumerate(
            zip(suggested().open, suggested().open[1:], strict=False)
        )
        if one.key[1] != after.key[1]
    )
    one = suggested().open[number]
    for _ in range(number):
        hands.press(Key.Key_N)
    wait_there(hands, qtbot)
    hands.press(Key.Key_5)
    wait_there(hands, qtbot)
    assert hands.controller.document.selection.track != one.key[1]
    hands.press(Key.Key_Z, CTRL)
    wait_there(hands, qtbot)
    frame, track, part = one.key
    assert hands.controller.playback.number == frame
    assert hands.controller.document.selection.track == track
    assert hands.controller.labelling.part == part
    assert suggested().current == one
    hands.press(Key.Key_4)
    assert labels()[one.key].on_part is True
    assert len(labels()) == 1


def test_a_key_labels_nobody_where_the_person_is_not_in_the_frame(hands, labels, window):
    track = hands.people()[0]
    hands.controller.editing.pick(track)
    hands.press(Key.Key_1, ALT)
    there = set(hands.frames(track))
    count = hands.controller.document.recording.frame_count
    away = [frame for frame in range(count) if frame not in there]
    hands.controller.playback.go(away[-1])
    hands.qtbot.waitUntil(lambda: hands.controller.playback.number == away[-1])
    hands.press(Key.Key_4)
    assert len(labels()) == 0
    panel = window.workspace.labelling
    assert "has no box in frame" in panel._refused.text()
    assert not window.notice.isVisible()
    hands.go(sorted(there)[0])
    hands.controller.draw()
    assert panel._refused.text() == ""  # it is not true any more


def test_an_answer_elsewhere_goes_on_from_there(hands, suggested, labels, qtbot):
    first = suggested().open[0]
    track = first.key[1]
    frame = next(f for f in hands.frames(track) if abs(f - first.key[0]) > 10)
    hands.go(frame)
    hands.press(Key.Key_7)
    hands.press(Key.Key_4)
    assert labels()[frame, track, 0].reason == ""
    assert hands.controller.labelling.part == 1
    assert hands.controller.playback.clock.frame == frame


def test_moving_a_suggested_rectangle_labels_it_where_it_was_put(hands, suggested, labels, qtbot):
    frame, track, part = suggested().open[0].key
    layer = hands.controller.labelling._parts
    mark = next(one for one in layer._marks if one.part == part)
    rect = layer.canvas.viewport.rect(QRectF(*mark.box))
    scale = layer.canvas.viewport.scale  # the next suggestion is shown at its own
    hands.drag(layer, rect.center(), rect.center() + QPointF(25, 4))
    label = labels()[frame, track, part]
    assert label.box[0] == pytest.approx(mark.box[0] + 25 / scale, abs=1.5 / scale)
    assert (label.source, label.on_part) == ("person", True)
    assert "unsure" in label.reason
    assert suggested().current.key != (frame, track, part)


def test_a_range_is_labelled_with_one_key_and_taken_back_with_one(hands, labels, window):
    track = hands.people()[0]
    hands.controller.editing.pick(track)
    hands.press(Key.Key_1, ALT)
    hands.press(Key.Key_BracketLeft)
    hands.go(CROWDED + 6)
    hands.press(Key.Key_BracketRight)
    hands.press(Key.Key_R)
    row = window.workspace.labelling.parts._scope
    assert row._group.checkedButton().text() == f"frames {CROWDED} to {CROWDED + 6}"
    hands.press(Key.Key_8)
    hands.press(Key.Key_5)
    said = {key: label.on_part for key, label in labels().items()}
    frames = [f for f in hands.frames(track) if CROWDED <= f <= CROWDED + 6]
    assert said == {(frame, track, 1): False for frame in frames}
    assert {label.source for label in labels().values()} == {"tracker"}
    assert len(frames) == 7
    hands.press(Key.Key_Z, CTRL)
    assert len(labels()) == 0


def test_a_range_that_is_not_set_is_asked_for(hands, labels, window):
    hands.controller.editing.pick(hands.people()[0])
    hands.press(Key.Key_1, ALT)
    hands.press(Key.Key_R)
    hands.press(Key.Key_4)
    assert len(labels()) == 0
    panel = window.workspace.labelling
    assert "No range is set" in panel._refused.text()
    assert panel._refused.isVisible()
    hands.controller.document.correcting.marked = (CROWDED, CROWDED + 2)
    hands.controller.draw()
    assert not panel._refused.isVisible()


def test_the_balance_of_a_part_is_told(hands, window):
    hands.controller.editing.pick(hands.people()[0])
    hands.press(Key.Key_1, ALT)
    for key in (Key.Key_4, Key.Key_5, Key.Key_5, Key.Key_4, Key.Key_4, Key.Key_4):
        hands.press(key)
        hands.qtbot.waitUntil(
            lambda: hands.controller.playback.number == hands.controller.playback.clock.frame
        )
    told = [bar.accessibleName() for bar in window.workspace.labelling.parts._balances]
    assert told[0] == "head: 100 % of 2 labels say on its part, 0 % off"
    assert told[1] == "torso: 50 % of 2 labels say on its part, 50 % off"


def test_a_detector_that_is_gone_is_told_in_the_list(hands, window, qtbot, tmp_path):
    hands.controller.document.detector = DetectorChoice(str(tmp_path / "gone.h5"))
    hands.press(Key.Key_6, ALT)
    shown = window.workspace.labelling.parts._suggestions
    qtbot.waitUntil(lambda: "gone.h5" in shown._told.text())
    assert not shown._list.isVisible()


def test_a_suggestion_is_clicked(hands, suggested, window, qtbot):
    third = suggested().open[2]
    shown = window.workspace.labelling.parts._suggestions
    rect = shown._list.visualRect(shown._model.index(2))
    hands.click(shown._list.viewport(), QPointF(rect.center() + QPoint(1, 1)))
    assert suggested().current == third
    assert hands.controller.playback.clock.frame == third.key[0]


def _grip(hands, suggested):
    """The suggested rectangle, held in its middle and dragged along by (10, 4)."""
    layer = hands.controller.labelling._parts
    mark = next(one for one in layer._marks if one.part == suggested().current.key[2])
    middle = layer.canvas.viewport.rect(QRectF(*mark.box)).center()
    QTest.mousePress(layer, LEFT, NO_KEY, middle.toPoint())
    QTest.mouseMove(layer, middle.toPoint() + QPoint(10, 4))
    return layer, mark, middle.toPoint() + QPoint(10, 4)


def test_a_rectangle_that_is_held_does_not_jump_when_the_view_shifts(hands, suggested):
    layer, _, at = _grip(hands, suggested)
    before = QRectF(layer._box)
    layer.canvas.fit()
    QTest.mouseMove(layer, at + QPoint(1, 0))
    assert layer._box == before
    QTest.mouseMove(layer, at + QPoint(3, 0))
    assert layer._box.x() == pytest.approx(before.x() + 2 / layer.canvas.viewport.scale)
    QTest.mouseRelease(layer, LEFT, NO_KEY, at + QPoint(3, 0))


def test_a_rectangle_that_is_held_is_not_put_into_another_frame(hands, suggested, labels):
    layer, mark, at = _grip(hands, suggested)
    frame = hands.controller.playback.number
    there = hands.controller.labelling._presenter.parts.parts
    other = next(n for n in (frame + 3, frame - 3) if mark.part in there(n))
    hands.go(other)
    QTest.mouseRelease(layer, LEFT, NO_KEY, at)
    assert len(labels()) == 0


def test_a_key_goes_on_from_a_part_that_is_labelled_so_already(hands, labels, window):
    track = hands.people()[0]
    hands.controller.editing.pick(track)
    hands.press(Key.Key_1, ALT)
    frame, keys = hands.controller.playback.number, hands.controller.labelling._keys
    keys.put_box(0, keys._presenter.parts(frame)[0][0].box)
    for _ in range(3):
        hands.press(Key.Key_4)
    assert sorted(labels()) == [(frame, track, part) for part in range(3)]
    assert {one.on_part for one in labels().values()} == {True}
