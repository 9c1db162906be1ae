"""The people followed as boxes in the picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.population import Population

Floats = NDArray[np.float64]
_ACROSS, _DOWN = np.meshgrid((np.arange(6) + 0.5) / 6, (np.arange(12) + 0.5) / 12)
_SAMPLES = np.column_stack((_ACROSS.ravel(), _DOWN.ravel()))
"""Where a box is probed for what covers it, as shares of its width and height."""

_RINGS = ((0.0, 0.2), (0.1, 0.4), (0.5, 0.5), (0.8, 0.5), (0.93, 0.25), (1.0, 0.15))
"""A standing body as rings: height and radius as shares of its height and its width."""
_TURN = np.arange(8) * (np.pi / 4)
_BODY = np.concatenate(
    [
        np.stack((radius * np.cos(_TURN), radius * np.sin(_TURN), np.full(8, z)), axis=1)
        for z, radius in _RINGS
    ]
)


def body_boxes(people: Population, view: View) -> Floats:
    """Where the bodies are in the picture, hidden or not: (people, 4) px as recorded."""
    height, width = people.stature.T
    points = _BODY * np.stack((width, width, height), axis=1)[:, None]
    points[..., :2] += people.position[:, None]
    pixels = view.pixel_from_world(points.reshape(-1, 3)).reshape(len(people), len(_BODY), 2)
    low, high = pixels.min(axis=1), pixels.max(axis=1)
    return np.concatenate((low, high - low), axis=1)


def share_in_view(people: Population, view: View) -> Floats:
    """The share of each body's box that lies inside the picture: (people,) 0 to 1."""
    box = body_boxes(people, view)
    low = np.clip(box[:, :2], 0.0, view.camera.size)
    high = np.clip(box[:, :2] + box[:, 2:], 0.0, view.camera.size)
    share = np.prod((high - low) / box[:, 2:], axis=1)
    return np.asarray(np.nan_to_num(share))


def visibility(box: Floats, range_m: Floats, size: tuple[int, int]) -> Floats:
    """The share of each box inside the picture and not covered by a nearer one: (people,).

    Args:
        box: (people, 4) px. range_m: (people,) distance from the camera over the floor.
        size: width and height of the picture.
    """
    points = box[:, None, :2] + box[:, None, 2:] * _SAMPLES
    inside = ((points >= 0) & (points < size)).all(axis=2)
    low, high = box[:, :2], box[:, :2] + box[:, 2:]
    covered = (points[:, None] >= low[None, :, None]) & (points[:, None] < high[None, :, None])
    nearer = range_m[None, :] < range_m[:, None]
    hidden = (covered.all(axis=3) & nearer[:, :, None]).any(axis=1)
    return np.asarray((inside & ~hidden).mean(axis=1))


def expected_visibility(people: Population, view: View) -> Floats:
    """The share of each body that the others, where they are expected, leave to be seen."""
    range_m = np.hypot(people.position[:, 0], people.position[:, 1])
    return visibility(body_boxes(people, view), range_m, view.camera.size)
