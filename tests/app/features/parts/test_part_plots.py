"""Plots of a person's parts, and the small pictures of what a detector is wrong about."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtGui import QFontMetricsF

from app.core.look.theme import scaled_font
from app.core.plots.axis import TimeAxis
from app.core.scenes.part_curve import PartCurve
from app.features.parts.curves_plot import CurvesPlot
from app.features.parts.mistakes import MistakesList
from app.features.parts.roc import RocPlot
from app.features.parts.scene import CurvesScene
from app.features.parts.training_result import MistakeItem
from app.features.parts.training_set import Source
from tracking.failure import Mistake
from tracking.failure.core.samples import samples_from_rows

SOURCE = Source("lobby", None, samples_from_rows([], np.zeros((0, 36))), "")


def _curve(count: int = 100) -> PartCurve:
    share = np.linspace(0.0, 1.0, count)
    no = np.zeros(count, bool)
    return PartCurve(np.arange(count), share, 200 + 800 * share, 2 * share - 1, no, no)


def _mistake(frame: int) -> MistakeItem:
    wrong = Mistake(frame, 0, "lobby", 1, frame, False, -1.0)
    return MistakeItem(SOURCE, "lobby", wrong, None, "head of 1", "missed", "00:00.00")


@pytest.fixture
def plot(qtbot, dark):
    plot = CurvesPlot()
    qtbot.addWidget(plot)
    plot.resize(500, 300)
    plot.show_axis(TimeAxis(left=0.0, width=500.0, start=0.0, frames=50.0, frame_count=100))
    names = ("head", "torso", "hip-leg")
    plot.show_scene(CurvesScene("", (_curve(),) * 3, names, frame=90, frame_count=100, fps=20.0))
    return plot


def test_plots_follow_the_frames_the_timeline_shows(plot, drawn):
    before = drawn(plot)
    plot.show_axis(TimeAxis(left=0.0, width=500.0, start=0.0, frames=20.0, frame_count=100))
    assert drawn(plot) != before


@pytest.fixture
def cutting(qtbot, dark):
    """Makes a list of mistakes; it lives on until its jobs are gone."""
    made = []

    def make(cut):
        made.append(MistakesList(cut))
        qtbot.addWidget(made[-1])
        return made[-1]

    yield make
    for one in made:
        one.close_pictures()


def test_mistakes_shown_while_others_are_cut_get_their_pictures_too(qtbot, cutting):
    cut = []

    def none_found(items, _report):
        cut.extend(one.frame for one in items)
        return dict.fromkeys(items)

    mistakes = cutting(none_found)
    mistakes.show_items([_mistake(1)])
    mistakes.show_items([_mistake(2)])
    qtbot.waitUntil(lambda: mistakes._job is None)
    assert cut == [1, 2]


def test_a_mistake_names_recording_person_and_frame(cutting):
    mistakes = cutting(lambda items, _report: dict.fromkeys(items))
    mistakes.show_items([_mistake(12)])
    assert mistakes.item(0).text().split("\n") == ["head of 1", "frame 12", "lobby", "missed"]


def test_why_pictures_are_missing_is_told(qtbot, cutting):
    def broken(*_: object) -> None:
        raise ValueError("no picture")

    mistakes = cutting(broken)
    with qtbot.waitSignal(mistakes.failed) as told:
        mistakes.show_items([_mistake(1)])
    assert str(told.args[0]) == "no picture"
    qtbot.waitUntil(lambda: mistakes._job is None)


def test_figures_beside_the_plot_of_a_training_touch_neither_its_frame_nor_each_other(qtbot, dark):
    plot = RocPlot()
    qtbot.addWidget(plot)
    plot.resize(360, 560)
    metrics = QFontMetricsF(scaled_font(plot.font(), 0.88))
    area = plot._area()
    assert area.left() - 6 - metrics.horizontalAdvance("100 %") > 4
    told = [f"{20 * fifth * plot._most:.3g} %" for fifth in range(6)]
    assert max(map(metrics.horizontalAdvance, told)) < area.width() / 5
    assert metrics.height() < area.height() / 5


@pytest.mark.parametrize("larger", [1.0, 1.3, 1.7, 3.0])
@pytest.mark.parametrize("most", [0.2, 0.0333, 0.00125])
def test_labels_of_the_training_plot_never_touch_each_other(qtbot, dark, larger, most):
    plot = RocPlot()
    qtbot.addWidget(plot)
    plot.resize(plot.minimumSizeHint() * larger)
    plot.show_up_to(most)
    labels = plot.tick_labels()
    metrics = QFontMetricsF(scaled_font(plot.font(), 0.88))
    assert len(labels) >= 4  # both ends of both axes
    for at, (place, text) in enumerate(labels):
        assert metrics.horizontalAdvance(text) <= place.width()
        assert not any(place.intersects(other) for other, _ in labels[at + 1 :])
