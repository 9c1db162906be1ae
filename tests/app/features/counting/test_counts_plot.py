"""Counts over time as they are drawn."""

import numpy as np
import pytest

from app.core.plots.axis import TimeAxis
from app.features.counting import counts_plot
from app.features.counting.counts_plot import CountsPlot
from app.features.counting.scene import FORWARD_COLOUR, CountCurve, CountingScene, CountPlot

FRAMES = 2000


@pytest.fixture
def plot(qtbot, dark):
    plot = CountsPlot()
    qtbot.addWidget(plot)
    plot.resize(500, 200)
    plot.show_axis(TimeAxis(left=0, width=500.0, start=0, frames=FRAMES, frame_count=FRAMES))
    return plot


def shown(plot: CountsPlot, values: np.ndarray) -> None:
    curve = CountCurve("forward", values, FORWARD_COLOUR)
    plots = (CountPlot("Per 0.5 s", "", (curve,), 1.0),)
    plot.show_scene(CountingScene(plots=plots, frame=0, frame_count=FRAMES, fps=20.0))


def test_a_single_high_count_is_drawn_higher_than_those_around_it(plot, drawn, dark, near):
    values = np.zeros(FRAMES)
    values[::40] = 1.0
    values[1000:1006] = 4.0  # less than half a percent of all
    shown(plot, values)
    picture, colour = drawn(plot), dark.track(FORWARD_COLOUR)

    def highest(frame: int) -> int:
        x = round(plot.axis.x_of(frame))
        inked = [
            y
            for column in range(x - 8, x + 9)
            for y in range(plot.height())
            if near(picture.pixelColor(column, y), colour)
        ]
        return min(inked)

    assert highest(1003) + 60 < highest(420)


def test_curves_of_two_plots_are_explained_once(plot, drawn, monkeypatch):
    told = []
    monkeypatch.setattr(counts_plot, "_draw_key", lambda _, plot, *__: told.append(plot.name))
    both = tuple(
        CountCurve(label, np.ones(FRAMES), FORWARD_COLOUR) for label in ("forward", "backward")
    )
    plots = (CountPlot("So far", "", both, 1.0), CountPlot("Per 1 s", "", both, 1.0))
    plot.show_scene(CountingScene(plots=plots, frame=0, frame_count=FRAMES, fps=20.0))
    drawn(plot)
    assert told == ["So far"]
