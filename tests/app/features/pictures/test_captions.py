"""An image's name, message and legend do not cover each other, however narrow it is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import person, picture
from PySide6.QtCore import QRectF
from PySide6.QtGui import QFontMetricsF, QImage

from app.core.look.theme import scaled_font
from app.core.scenes import LegendEntry
from app.features.pictures import box_names
from app.features.pictures.captions import lay_out
from app.features.pictures.picture_view import PictureView

SAID = "Nothing was recorded at this instant: another frame is shown"
LEGEND = (
    LegendEntry((40, 200, 80), "foreground"),
    LegendEntry((60, 90, 220), "shadow, taken for ground"),
)
LOW = (190, 110)
SIZES = ((900, 600), (480, 360), (290, 217))


@pytest.fixture
def view(qtbot, dark):
    widget = PictureView(picture().side)
    qtbot.addWidget(widget)
    return widget


@pytest.fixture
def looks(view):
    """Draws a camera of this name, message and legend: (height, width, 4)."""

    def drawn(name="", said="", legend=(), people=()):
        view.show_scene(replace(picture(*people), message=said, legend=legend))
        view._camera_name = name
        shot = view.grab().toImage().convertToFormat(QImage.Format.Format_RGB32)
        return np.array(shot.constBits()).reshape(shot.height(), shot.width(), 4).copy()

    return drawn


@pytest.fixture
def inked(looks):
    """Where (height, width) a picture is not as without any words."""
    return lambda *words, **more: (looks(*words, **more) != looks()).any(axis=2)


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("name", ["Right camera", "Both cameras, for red and cyan glasses"])
@pytest.mark.parametrize("said", ["Frame 128 of this camera: the same instant", SAID])
def test_none_of_them_hides_another(view, inked, size, name, said):
    view.resize(*size)
    alone = [inked(name), inked("", said), inked(legend=LEGEND)]
    assert inked(name, said, LEGEND).sum() > 0.98 * sum(one.sum() for one in alone)


def test_a_picture_too_low_for_all_has_name_and_message(view, inked):
    view.resize(*LOW)
    both = inked("Right camera", SAID)
    assert both.sum() > 0.98 * (inked("Right camera").sum() + inked("", SAID).sum())
    assert (inked("Right camera", SAID, LEGEND) == both).all()


@pytest.mark.parametrize("size", [*SIZES, LOW])
def test_a_message_wider_than_the_picture_goes_on_below(view, inked, size):
    view.resize(*size)
    for ink in (inked("", SAID), inked("Both cameras, for red and cyan glasses")):
        assert ink.any()
        assert not ink[:, :4].any()
        assert not ink[:, -4:].any()


def _words(view):
    """Where name, message and legend stand beside the people who are shown."""
    metrics = QFontMetricsF(scaled_font(view.font(), 0.92))
    people = [view.viewport.rect(QRectF(*one.box)) for one in view._scene.people]
    return lay_out(metrics, QRectF(view.rect()), "Right camera", SAID, LEGEND, people).taken


def test_names_of_people_are_under_none_of_them(view, looks, monkeypatch):
    view.resize(480, 360)
    plates = []
    monkeypatch.setattr(box_names, "draw_plate", lambda _, rect, *__: plates.append(rect))
    two_rows = [
        person(10 * row + n, (40 * n - 30, 100 + 57 * row, 24, 55))
        for row in range(2)
        for n in range(1, 8)
    ]
    looks("Right camera", SAID, LEGEND, two_rows)
    assert len(plates) > 8
    assert len(_words(view)) == 3
    assert not any(plate.intersects(words) for plate in plates for words in _words(view))


@pytest.mark.parametrize("size", [(290, 217), (360, 270)])
def test_the_number_of_who_is_selected_is_under_none_of_them(view, looks, monkeypatch, size):
    view.resize(*size)
    plates = []
    monkeypatch.setattr(box_names, "draw_plate", lambda _, rect, *__: plates.append(rect))
    looks("Right camera", SAID, LEGEND, [person(1, (120, 150, 40, 90), selected=True)])
    assert not any(plates[0].intersects(words) for words in _words(view))


def test_the_legend_of_a_picture_goes_where_it_hides_nobody(view):
    view.resize(480, 360)
    metrics = QFontMetricsF(scaled_font(view.font(), 0.92))
    area = QRectF(view.rect())
    alone = lay_out(metrics, area, "Right camera", "", LEGEND).legend
    below = QRectF(alone.left(), alone.top() - 40, 30, 100)
    moved = lay_out(metrics, area, "Right camera", "", LEGEND, [below]).legend
    assert not moved.isEmpty()
    assert moved != alone
    assert not moved.intersects(below)
    corner = QRectF(0, 0, 60, 60)
    again = lay_out(metrics, area, "Right camera", "", LEGEND, [below, corner]).legend
    assert not any(again.intersects(one) for one in (below, corner))
    assert lay_out(metrics, area, "Right camera", "", LEGEND, [corner]).legend == alone


def test_the_legend_hides_no_other_words_at_the_top(qapp):
    metrics = QFontMetricsF(scaled_font(qapp.font(), 0.92))
    area = QRectF(0, 0, 480, 360)
    low = [QRectF(0, 200, 480, 160)]  # people where it would stand
    free = lay_out(metrics, area, "", "", LEGEND, low)
    assert free.legend.top() < 20
    stamp = QRectF(6, 6, 120, 20)
    kept = lay_out(metrics, area, "", "", LEGEND, low, [stamp])
    assert not kept.legend.isEmpty()
    assert not kept.legend.intersects(stamp)
