"""Names and counts of lines are read while people walk over the lines."""

from __future__ import annotations

import numpy as np
import pytest
from drawn_scenes import RED, person, picture
from PySide6.QtCore import QRectF

from app.core.drawing import label_marks
from app.core.scenes.labels import Outline, PictureLabels
from app.features.pictures import box_names
from app.features.pictures.picture_view import PictureView

LINE = Outline("Door", np.array([[150.0, 120.0], [200.0, 120.0]]), False, (250, 200, 40), said="3")


def plate_of(view: PictureView, monkeypatch: pytest.MonkeyPatch) -> QRectF:
    """Where the line's name stands."""
    drawn: list[QRectF] = []
    really = label_marks.draw_name

    def noted(painter, rect, *rest):
        drawn.append(rect)
        really(painter, rect, *rest)

    monkeypatch.setattr(label_marks, "draw_name", noted)
    view.grab()
    monkeypatch.undo()
    return drawn[0]


def test_a_persons_box_does_not_cover_a_lines_name(view, monkeypatch) -> None:
    view.show_labels(PictureLabels(outlines=(LINE,)))
    plate = plate_of(view, monkeypatch).toRect().adjusted(2, 2, -2, -2)
    alone = view.grab().toImage().copy(plate)
    view.show_scene(picture(person(1, (145.0, 60.0, 60.0, 90.0))))
    assert view.grab().toImage().copy(plate) == alone


def test_a_persons_name_stands_off_a_lines_name(view, monkeypatch) -> None:
    view.show_labels(PictureLabels(outlines=(LINE,)))
    plate = plate_of(view, monkeypatch)
    found: list[QRectF] = []
    monkeypatch.setattr(box_names, "draw_plate", lambda _, rect, *__: found.append(rect))
    corner = view.viewport.to_content(plate.bottomLeft())
    view.show_scene(picture(person(1, (corner.x(), corner.y(), 30.0, 60.0))))
    view.grab()
    assert found
    assert not any(rect.intersects(plate) for rect in found)


@pytest.mark.parametrize("picked", [False, True])
def test_a_line_ends_with_the_image_unless_it_is_being_drawn(view, picked) -> None:
    view.resize(640, 700)  # with room above and below the image
    beyond = np.array([[160.0, 200.0], [160.0, 270.0]])  # the image is 240 px high
    view.show_scene(picture())
    view.show_labels(PictureLabels(outlines=(Outline("", beyond, False, RED, picked=picked),)))
    drawn, at = view.grab().toImage(), view.viewport.point
    ratio = drawn.devicePixelRatio()
    inside, outside = ((at(160, y) * ratio).toPoint() for y in (230, 256))
    assert drawn.pixelColor(inside).red() > drawn.pixelColor(inside).blue() + 60
    assert (drawn.pixelColor(outside).red() > drawn.pixelColor(outside).blue() + 60) is picked
