from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.plots.axis import TimeAxis
from app.core.plots.strips import covered, covered_by_kind, dotted, opacity, spans_in_view
from app.core.scenes import SpanKind

_FRAMES = 200


@st.composite
def _ranges(draw: st.DrawFn) -> np.ndarray:
    edges = sorted(draw(st.sets(st.integers(0, _FRAMES), max_size=20)))
    return np.array(edges[: len(edges) // 2 * 2], np.int64).reshape(-1, 2)


@given(_ranges(), st.floats(0, 150), st.floats(1, 200), st.integers(1, 60))
def test_a_column_is_covered_as_much_as_its_frames_are(ranges, start, frames, columns):
    axis = TimeAxis(0.0, 600.0, start, frames, _FRAMES)
    edges = axis.edges(columns)
    shares = covered(ranges, edges)
    for column, share in enumerate(shares):
        low, high = edges[column], edges[column + 1]
        inside = [max(0.0, min(end, high) - max(first, low)) for first, end in ranges]
        assert share == pytest.approx(sum(inside) / (high - low), abs=1e-6)


@given(_ranges(), st.floats(0, 150), st.floats(1, 50))
def test_stretches_out_of_sight_are_left_out(ranges, start, frames):
    spans = np.column_stack([ranges, np.zeros(len(ranges), np.int64)])
    axis = TimeAxis(0.0, 600.0, start, frames, _FRAMES)
    wanted = [list(one) for one in spans if one[1] > start and one[0] < start + frames]
    assert spans_in_view(spans, axis).tolist() == wanted


def test_each_kind_of_stretch_is_told_apart():
    spans = np.array([[0, 50, 0], [50, 100, 1], [100, 150, 2]])
    shares = covered_by_kind(spans, TimeAxis(0.0, 600.0, 0.0, 200.0, 200), 4)
    assert {kind: share.tolist() for kind, share in shares.items()} == {
        SpanKind.MEASURED: [1, 0, 0, 0],
        SpanKind.PREDICTED: [0, 1, 0, 0],
        SpanKind.INTERPOLATED: [0, 0, 1, 0],
    }


def test_a_single_frame_of_eight_hours_is_seen_and_so_is_a_gap_of_one():
    inked = opacity(np.array([0.0, 1e-4, 1 - 2e-3, 1.0]))
    assert inked[0] == 0
    assert inked[1] >= 0.3
    assert inked[2] <= 0.86
    assert inked[3] == 1


@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_dots_alternate_and_hide_nothing(ratio):
    dots = dotted(np.ones(60), ratio)
    assert set(dots.tolist()) == {0.25, 1.0}
    assert np.flatnonzero(np.diff(dots)).tolist()[0] == 3 * ratio - 1
