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


def body_boxes(people: Population, view: View) -> Floats:
    """Where the bodies are in the picture, hidden or not: (people, 4) px as recorded."""
    height, width = people.stature.T
    return view.box_of_person(people.position, height, width)


def share_in_view(people: Population, view: View) -> Floats:
    """The share of each body's box that lies inside the picture: (people,) 0 to 1."""
    box = body_boxes(people, view)
    low = np.clip(box[:, :2], 0.0, view.camera.size)
    high = np.clip(box[:, :2] + box[:, 2:], 0.0, view.camera.size)
    share = np.prod((high - low) / box[:, 2:], axis=1)
    return np.nan_to_num(share)


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
    return (inside & ~hidden).mean(axis=1)
