"""Curves in panels."""

from __future__ import annotations

import numpy as np
import pytest
from defusedxml import ElementTree

from tracking.pages import Axis, Panel, svg

SVG = "{http://www.w3.org/2000/svg}"


def _panel() -> Panel:
    x = np.arange(4.0)
    curves = {"one": np.array([1.0, 0.5, np.nan, 0.2]), "<two>": np.ones(4)}
    chosen = {"chosen": (1.0, 0.5)}
    return Panel("Heads", curves, x, ("frames", "share"), (0.0, 3.0), (0.0, 1.0), chosen)


def test_each_curve_is_a_line_with_its_name_and_a_gap_lifts_the_pen() -> None:
    root = ElementTree.fromstring(svg([_panel(), _panel()]))
    paths = root.findall(f".//{SVG}path")
    assert [path.get("d", "").count("M") for path in paths] == [2, 1, 2, 1]
    texts = [text.text for text in root.iter(f"{SVG}text")]
    assert {"one", "<two>", "Heads", "frames", "share"} <= set(texts)
    assert [each.text for each in root.iter(f"{SVG}title")].count("chosen") == 2


@pytest.mark.parametrize("span", [(0.0, 1.0), (-3.0, 17.0), (0.0, 9000.0), (0.05, 0.95)])
def test_ticks_are_a_few_round_numbers_within_the_span(span: tuple[float, float]) -> None:
    ticks = Axis(span, 100.0).ticks()
    assert 3 <= len(ticks) <= 8
    assert span[0] <= ticks[0] < ticks[-1] <= span[1]
    assert all(len(f"{tick:g}".lstrip("-")) <= 5 for tick in ticks)


def test_greater_values_stand_higher_and_none_beyond_the_frame() -> None:
    axis = Axis((0.0, 10.0), 200.0, upward=True)
    assert [axis.place(value) for value in (0.0, 10.0, 99.0)] == [200.0, 0.0, 0.0]
    assert axis.places(np.array([5.0, -1.0])).tolist() == [100.0, 200.0]
    assert axis.places(np.array([20.0]), beyond=True).tolist() == [-200.0]
