"""A box that is pressed while the recording plays: the drag is of what is seen as it begins."""

from dataclasses import replace

import pytest
from correcting_window import CROWDED, LEFT, NO_KEY, Hands, open_for_correcting
from PySide6.QtCore import QPointF
from PySide6.QtTest import QTest


@pytest.fixture
def hands(window, qtbot, tiny_session) -> Hands:
    return Hands(window, open_for_correcting(window, qtbot, tiny_session), qtbot)


def _drag_over_a_change_of_frame(hands, start, frame) -> None:
    view = hands.window.workspace.left
    QTest.mousePress(view, LEFT, NO_KEY, start.toPoint())
    hands.go(frame)
    hands.qtbot.waitUntil(lambda: view._scene.frame == frame)
    for x in (20, 40):
        QTest.mouseMove(view, (start + QPointF(x, 0)).toPoint())
    QTest.mouseRelease(view, LEFT, NO_KEY, (start + QPointF(40, 0)).toPoint())


def test_the_box_that_is_seen_as_the_drag_begins_is_moved(hands):
    someone, later = hands.apart(), CROWDED + 3
    start, before = hands.box_on(someone).center(), hands.row(someone, later)
    assert before["width"] != hands.row(someone, CROWDED)["width"]
    _drag_over_a_change_of_frame(hands, start, later)
    after = hands.row(someone, later)
    assert after["left"] > before["left"]
    assert [after[one] for one in ("top", "width", "height")] == pytest.approx(
        [before[one] for one in ("top", "width", "height")]
    )


def test_who_has_left_the_picture_meanwhile_is_not_dragged(hands):
    document = hands.controller.document
    someone, gone = hands.apart(), CROWDED + 3
    start = hands.box_on(someone).center()
    hands.window.workspace.left.grabs(start)
    scene = hands.window.workspace.left._scene
    others = tuple(one for one in scene.people if one.track != someone)
    hands.window.workspace.left.show_scene(replace(scene, frame=gone, people=others))
    hands.window.workspace.left.drag_to(start + QPointF(40, 0))
    hands.window.workspace.left.drop()
    assert document.flow is None
    assert not len(document.session.history)
