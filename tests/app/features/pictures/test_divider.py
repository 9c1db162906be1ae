"""The line that divides a picture between two versions of the tracks."""

from __future__ import annotations

import pytest
from drawn_scenes import BLUE, person, picture
from PySide6.QtCore import QPointF, QRectF, Qt

from app.core.scenes import Side
from app.core.scenes.ground_truth import ErrorsOf, PicturedTruth, TruthMark
from app.core.scenes.other_people import Divider, OtherMark
from app.core.scenes.pictured_parts import PartBox, PicturedParts
from app.features.pictures import picture_painter
from app.features.pictures.box_names import BoxNamePainter
from app.features.pictures.divider import halves, is_at_divider, share_at
from app.features.pictures.picture_view import PictureView
from tracking.scoring import ErrorKind

PLACE = QRectF(100, 0, 400, 300)


@pytest.fixture
def view(qtbot, dark):
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.resize(640, 480)
    view.show_scene(picture(person(1, (20, 100, 40, 80)), person(2, (240, 100, 40, 80))))
    view.show_others(
        (OtherMark((80, 100, 40, 80), "8", BLUE), OtherMark((180, 20, 40, 60), "9", BLUE))
    )
    view.fit()
    return view


def is_red(colour):
    return colour.red() - max(colour.green(), colour.blue()) > 60


def is_blue(colour):
    return colour.blue() - max(colour.red(), colour.green()) > 30


def inked(shot, view, box, is_ink):
    """Whether a box's upper edge has been drawn in a colour."""
    left, top, width, _ = box
    found = 0
    for across in range(1, 39):
        at = view.viewport.point(left + across * width / 40, top).toPoint()
        found += any(is_ink(shot.pixelColor(at.x(), at.y() + down)) for down in range(-6, 7))
    return found > 8


def test_each_half_shows_one_version_alone(view, drawn):
    view.show_divider(None)
    both = drawn(view)
    assert inked(both, view, (240, 100, 40, 80), is_red)
    assert inked(both, view, (80, 100, 40, 80), is_blue)
    view.show_divider(Divider(0.5, "run 0", "run 1"))
    divided = drawn(view)
    assert inked(divided, view, (20, 100, 40, 80), is_red)
    assert not inked(divided, view, (240, 100, 40, 80), is_red)
    assert not inked(divided, view, (80, 100, 40, 80), is_blue)
    assert inked(divided, view, (180, 20, 40, 60), is_blue)


def test_halves_follow_the_picture_when_it_is_zoomed():
    own, other = halves(Divider(0.25, "a", "b"), PLACE, QRectF(150, 0, 300, 300))
    assert (own.left(), own.right(), other.right()) == (150, 200, 450)
    own, other = halves(Divider(0.0, "a", "b"), PLACE, QRectF(150, 0, 300, 300))
    assert own.width() == 0
    assert other == QRectF(150, 0, 300, 300)


def test_the_line_is_taken_hold_of_where_it_stands_and_nowhere_else(view):
    view.show_divider(Divider(0.5, "a", "b"))
    middle = view.viewport.point(159.5, 120)
    assert view.grabs(middle)
    assert view.cursor_at(middle) is Qt.CursorShape.SplitHCursor
    view.drop()
    assert not view.grabs(middle + QPointF(40, 0))


def test_dragging_stays_within_the_picture():
    assert share_at(PLACE, QPointF(200, 10)) == 0.25
    assert share_at(PLACE, QPointF(-50, 10)) == 0.0
    assert share_at(PLACE, QPointF(900, 10)) == 1.0
    assert not is_at_divider(None, PLACE, QPointF(300, 10))


def test_people_of_the_other_version_are_named_like_ones_own(view, drawn):
    view.show_divider(Divider(0.5, "run 0", "run 1"))
    drawn(view)
    painter = view._painter
    assert painter.naming.named == {1}
    assert painter._naming.named == {9}


def test_parts_lie_on_the_half_of_the_version_that_has_them(view, drawn):
    view.show_parts(
        PicturedParts(
            tuple(
                PartBox(track, 0, box, BLUE, failed=False, occluded=False, text="head")
                for track, box in ((1, (25, 130, 30, 30)), (2, (245, 130, 30, 30)))
            )
        )
    )
    view.show_divider(Divider(0.5, "run 0", "run 1"))
    divided = drawn(view)
    assert inked(divided, view, (25, 130, 30, 30), is_blue)
    assert not inked(divided, view, (245, 130, 30, 30), is_blue)


@pytest.mark.parametrize("version", ErrorsOf)
def test_errors_are_marked_on_the_half_of_the_version_that_was_scored(view, drawn, version):
    alarms = [(60, 180, 40, 40), (260, 180, 40, 40)]
    view.show_truth(
        PicturedTruth(
            alarms=tuple(TruthMark(box, "", ErrorKind.FALSE_ALARM) for box in alarms),
            errors_of=version,
        )
    )
    view.show_divider(Divider(0.5, "run 0", "run 1"))
    divided = drawn(view)
    seen = [marked(divided, view, box) for box in alarms]
    assert seen == [version is ErrorsOf.SOLID, version is ErrorsOf.DASHED]


def marked(shot, view, box):
    """Whether the magenta sign of a false alarm stands at a box."""
    left, top, width, height = box
    a, b = view.viewport.point(left, top - 10), view.viewport.point(left + width, top + height)
    return any(
        (colour := shot.pixelColor(x, y)).red() > 150 and colour.blue() > 150 > colour.green() + 60
        for x in range(round(a.x()), round(b.x()))
        for y in range(round(a.y()), round(b.y()))
    )


def test_names_stand_over_the_corners_of_the_truth(view, drawn, monkeypatch):
    order = []
    name, corners = BoxNamePainter.draw, picture_painter.draw_truth_corners
    monkeypatch.setattr(
        BoxNamePainter, "draw", lambda *given: (order.append("names"), name(*given))[1]
    )
    monkeypatch.setattr(
        picture_painter,
        "draw_truth_corners",
        lambda *given: (order.append("corners"), corners(*given))[1],
    )
    view.show_truth(PicturedTruth((TruthMark((20, 100, 40, 80), "T1"),)))
    view.show_divider(Divider(0.5, "run 0", "run 1"))
    drawn(view)
    assert order == ["corners", "corners", "names", "names"]
