"""What is drawn in the picture is shown on the floor below it, too."""

import numpy as np
import pytest

from app.core.scenes import Side
from app.core.scenes.labels import Tool
from app.features.labelling.outlines import DrawnLabels, forward_arrow
from tracking.recording import open_recording
from tracking.tracks import CountingLine, Labels, Region

NOTHING = (Tool.PARTS, -1)


@pytest.fixture
def recording(tiny_recording):
    with open_recording(tiny_recording) as recording:
        yield recording


def test_a_line_in_the_picture_lies_on_the_floor_where_its_feet_cross(recording):
    width, height = recording.size
    line = CountingLine("gate", (0.3 * width, 0.9 * height), (0.7 * width, 0.8 * height), True)
    (outline,) = DrawnLabels(recording).floor(Labels(lines=(line,)), NOTHING)
    assert outline.key == (Tool.LINES, 0)
    ends = recording.view.pixel_from_world(np.column_stack((outline.points[[0, -1]], [0.0, 0.0])))
    np.testing.assert_allclose(ends, [line.start, line.end], atol=0.1)
    (x, y), (to_x, to_y) = outline.points[[0, -1]].tolist()
    expected = forward_arrow(CountingLine("gate", (x, y), (to_x, to_y)))
    np.testing.assert_allclose(outline.arrow, expected)


def test_of_what_reaches_above_the_horizon_the_rest_is_shown(recording):
    width, height = recording.size
    whole = Region("all", ((0, 0), (width, 0), (width, height), (0, height)), True)
    (outline,) = DrawnLabels(recording).floor(Labels(regions=(whole,)), NOTHING)
    known = np.isfinite(outline.points).all(axis=1)
    assert known.any()
    assert np.hypot(*outline.points[known].T).max() < 100.0


def test_the_picture_shows_it_as_it_was_drawn(recording):
    line = CountingLine("gate", (10.0, 200.0), (90.0, 200.0), True)
    drawn, labels = DrawnLabels(recording), Labels(lines=(line,))
    (outline,) = drawn.picture(Side.LEFT, labels, NOTHING)
    np.testing.assert_allclose(outline.points, [line.start, line.end])
    assert drawn.picture(Side.RIGHT, labels, NOTHING) == ()
