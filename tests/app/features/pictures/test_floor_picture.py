"""The overhead view as a picture of its own."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import floor_person, overhead
from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QFont, QFontMetricsF, QImage, QPainter

from app.core.drawing.viewport import Viewport
from app.core.look.theme import load_theme, scaled_font
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.labels import FloorLabels, Outline
from app.features.pictures import floor_painter
from app.features.pictures.floor import scale_bar_plate
from app.features.pictures.floor_painter import FloorInput, FloorPainter, blank_image
from app.features.pictures.floor_picture import legible, write_floor
from tracking.errors import OutputError


@pytest.fixture
def given(qapp):
    scene = overhead(floor_person(4, (1.0, 4.0), label="4 <red> & coat"))
    viewport = Viewport.fitting(QRectF(-5, 0, 10, 10), QRectF(0, 0, 400, 400), upward=True)
    return FloorInput(
        scene, FloorMarks(), viewport, QSize(400, 400), 2.0, QFont(), explained=False, kept=False
    )


def test_a_png_has_twice_the_pixels_of_the_view_and_the_person_in_it(given, tmp_path, near):
    path = tmp_path / "floor.png"
    write_floor(given, load_theme("dark"), path)
    image = QImage(str(path))
    assert image.size() == QSize(800, 800)
    colour = load_theme("dark").track((220, 40, 40))
    at = given.viewport.point(1.0, 4.0) * 2
    around = [
        image.pixelColor(int(at.x()) + dx, int(at.y()) + dy)
        for dx in range(-24, 25, 2)
        for dy in range(-24, 25, 2)
    ]
    assert any(near(one, colour) for one in around)


def test_a_small_view_gives_a_legible_picture_of_the_same_floor(given):
    small = replace(given, size=QSize(200, 300))
    large = legible(small)
    assert large.size == QSize(600, 900)
    before, now = small.viewport.point(1.0, 4.0), large.viewport.point(1.0, 4.0)
    assert (now.x(), now.y()) == pytest.approx((3 * before.x(), 3 * before.y()))
    assert legible(large) is large


def test_an_svg_is_sound_xml_with_names_as_words(given, tmp_path):
    path = tmp_path / "floor.SVG"
    write_floor(given, load_theme("light"), path)
    root = ET.fromstring(path.read_text("utf-8"))
    assert root.tag.endswith("svg")
    words = "".join(root.itertext())
    assert "<red> & coat" in words


@pytest.mark.parametrize("explained", [True, False])
def test_an_svg_has_the_legend_and_what_was_drawn_and_counted(given, tmp_path, explained):
    gate = Outline(
        "gate", np.array([[-3.0, 2.0], [3.0, 2.0]]), False, (255, 120, 0), said="2 forward"
    )
    marks = FloorMarks(labels=FloorLabels((gate,)))
    path = tmp_path / "floor.svg"
    write_floor(replace(given, marks=marks, explained=explained), load_theme("light"), path)
    words = "".join(ET.fromstring(path.read_text("utf-8")).itertext())
    assert ("where the tracker has a person" in words) == explained
    assert "gate" in words
    assert "2 forward" in words


def test_the_scale_bar_lies_over_no_counts(given, noted_plates):
    bar = scale_bar_plate(QFontMetricsF(scaled_font(QFont(), 0.85)), given.area, given.viewport)
    top = given.viewport.to_content(bar.center()).y()
    gate = Outline("gate", np.array([[3.0, 0.0], [3.0, top]]), False, (255, 120, 0), said="0 back")
    image = blank_image(given.size, 1.0)
    painter = QPainter(image)
    marks = FloorMarks(labels=FloorLabels((gate,)))
    FloorPainter().paint(painter, replace(given, marks=marks), load_theme("dark"))
    painter.end()
    (plate,) = noted_plates
    assert not plate.intersects(bar)


@pytest.fixture
def noted_plates(monkeypatch):
    """Where names of outlines were drawn."""
    plates, draw = [], floor_painter.draw_outline_names

    def noted(painter, names, theme):
        plates.extend(one.rect for one in names)
        draw(painter, names, theme)

    monkeypatch.setattr(floor_painter, "draw_outline_names", noted)
    return plates


def test_nothing_is_written_where_no_file_can_be(given, tmp_path):
    with pytest.raises(OutputError):
        write_floor(given, load_theme("dark"), tmp_path / "missing" / "floor.png")
    assert list(tmp_path.iterdir()) == []
