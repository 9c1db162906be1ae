"""The z-buffer over triangles."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.synthesis.raster import DepthBuffer, fill

WINDOW = (0, 0, 40, 30)


def _triangle(*corners: tuple[float, float, float]) -> np.ndarray:
    return np.array(corners, np.float32)


@settings(deadline=None)
@given(st.integers(0, 10_000))
def test_triangles_that_share_an_edge_cover_each_sample_once(seed: int) -> None:
    rng = np.random.default_rng(seed)
    corners = [((0, 0), (8, 8)), ((30, 0), (39, 9)), ((30, 20), (39, 29)), ((0, 20), (9, 29))]
    a, b, c, d = ((*rng.uniform(low, high), 1.0) for low, high in corners)
    samples = fill(np.stack((_triangle(a, b, c), _triangle(a, c, d))), WINDOW)
    count = np.zeros((30, 40), int)
    np.add.at(count, (samples.y, samples.x), 1)
    assert count.max() == 1
    # The inside of the whole has no hole.
    assert (count[10:19, 11:29] == 1).all()


def test_nothing_is_filled_outside_the_window() -> None:
    samples = fill(_triangle((-50, -40, 1), (90, -40, 1), (20, 90, 1))[None], WINDOW)
    assert len(samples.x) == 40 * 30
    assert (samples.x.min(), samples.y.min(), samples.x.max(), samples.y.max()) == (0, 0, 39, 29)


def test_depth_is_interpolated_over_the_triangle() -> None:
    samples = fill(_triangle((0, 0, 1), (39, 0, 40), (0, 29, 1))[None], WINDOW)
    assert np.allclose(samples.depth, 1 + samples.x, atol=1e-4)


def test_the_nearer_triangle_hides_the_farther() -> None:
    far = _triangle((0, 0, 0.2), (39, 0, 0.2), (0, 29, 0.2))
    near = _triangle((5, 5, 0.5), (12, 5, 0.5), (5, 12, 0.5))
    samples = fill(np.stack((far, near)), WINDOW)
    buffer = DepthBuffer(40, 30)
    seen = samples.where(buffer.nearest(samples))
    assert len(np.unique(seen.y * 40 + seen.x)) == len(seen.x)
    hidden = (samples.triangle == 0) & (samples.x == 6) & (samples.y == 6)
    assert hidden.any()
    assert not ((seen.triangle == 0) & (seen.x == 6) & (seen.y == 6)).any()
    assert buffer.depth()[6, 6] == np.float32(0.5)


def test_things_that_stand_still_hide_what_is_behind_them() -> None:
    still = np.zeros((30, 40), np.float32)
    still[:, 10:20] = 0.3
    samples = fill(_triangle((0, 0, 0.2), (39, 0, 0.2), (0, 29, 0.2))[None], WINDOW)
    seen = samples.where(DepthBuffer(40, 30, still).nearest(samples))
    assert not ((seen.x >= 10) & (seen.x < 20)).any()
    assert (seen.x < 10).any()


def test_no_triangles_fill_nothing() -> None:
    assert len(fill(np.zeros((0, 3, 3), np.float32), WINDOW).x) == 0
