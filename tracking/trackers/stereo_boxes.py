"""The people followed as boxes in the picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association
from tracking.geometry import View
from tracking.people import Detections
from tracking.trackers.population import Population

Floats = NDArray[np.float64]
_ACROSS = (np.arange(6) + 0.5) / 6
_DOWN = (np.arange(12) + 0.5) / 12
"""Where a box is probed for what covers it, as shares of its width and height."""
MIDDLE_M = 0.9
"""Height of a body's middle over the floor."""
_MIXED = 0.1
"""Share of a box that others cover from which on its region may hold pieces of theirs."""
_OUTLINE_MEMORY_S = 0.3
_MIXED_MEMORY_S = 2.0
_TRUST = 0.85
"""Weight of the box seen against the remembered outline."""


def body_boxes(people: Population, view: View) -> Floats:
    """Where the bodies are in the picture, hidden or not: (people, 4) px as recorded."""
    middle, px_per_m = middles(people.position, view)
    low = middle + people.outline[:, :2] * px_per_m
    high = middle + people.outline[:, 2:] * px_per_m
    return np.concatenate((low, high - low), axis=1)


def outlines_of(box: Floats, position: Floats, view: View) -> Floats:
    """Boxes (people, 4) as `Population.outline` of people at these positions (people, 2)."""
    middle, px_per_m = middles(position, view)
    low = box[:, :2] - middle
    return np.concatenate((low, low + box[:, 2:]), axis=1) / np.tile(px_per_m, 4)


def outlined(
    people: Population,
    pairs: Association,
    alone: NDArray[np.bool_],
    seen: Detections,
    elapsed_s: float,
    view: View,
) -> Population:
    """The people with the outlines of those matched brought up to date.

    Args:
        alone: (pairs,) False where the region holds somebody else too.
    """
    rows, chosen = pairs.track[alone], pairs.detection[alone]
    mixed = overlap(body_boxes(people, view))[rows] > _MIXED
    memory_s = np.where(mixed, _MIXED_MEMORY_S, _OUTLINE_MEMORY_S)
    share = 1.0 - np.exp(-elapsed_s / memory_s)
    share = np.maximum(share, 1.0 / people.matches[rows])[:, None]
    old = people.outline[rows]
    new = outlines_of(seen.box[chosen], people.position[rows], view)
    return people.changed(rows, outline=old + share * (new - old))


def shown_boxes(
    people: Population,
    pairs: Association,
    alone: NDArray[np.bool_],
    seen: Detections,
    view: View,
) -> Floats:
    """The boxes to report: what was seen this frame, drawn a little to the remembered outline.

    Where a region holds somebody else too, the outline alone counts.
    """
    box = body_boxes(people, view)
    own = box[pairs.track]
    trust = _TRUST * alone[:, None]
    box[pairs.track] = own + trust * (seen.box[pairs.detection] - own)
    return box


def middles(position: Floats, view: View) -> tuple[Floats, Floats]:
    """Where bodies' middles are, (people, 2) px, and how large a metre looks there, (people, 1)."""
    range_m = np.maximum(np.hypot(position[:, 0], position[:, 1]), 1e-6)[:, None]
    across = 0.5 * position[:, ::-1] * (-1.0, 1.0) / range_m
    points = np.full((2, len(position), 3), MIDDLE_M)
    points[0, :, :2] = position - across
    points[1, :, :2] = position + across
    one, other = view.pixel_from_world(points.reshape(-1, 3)).reshape(2, -1, 2)
    return (one + other) / 2, np.hypot(*(one - other).T)[:, None]


def share_in_view(people: Population, view: View) -> Floats:
    """The share of each body's box that lies inside the picture: (people,) 0 to 1."""
    box = body_boxes(people, view)
    low = np.clip(box[:, :2], 0.0, view.camera.size)
    high = np.clip(box[:, :2] + box[:, 2:], 0.0, view.camera.size)
    share = np.prod((high - low) / box[:, 2:], axis=1)
    return np.asarray(np.nan_to_num(share))


def visibility(
    box: Floats,
    range_m: Floats,
    size: tuple[int, int],
    covering: NDArray[np.bool_] | None = None,
) -> Floats:
    """The share of each box inside the picture and not covered by a nearer one: (people,).

    Args:
        box: (people, 4) px. range_m: (people,) distance from the camera over the floor.
        size: width and height of the picture.
        covering: (people,) who covers others; None: everybody.
    """
    columns = box[:, None, 0] + box[:, None, 2] * _ACROSS
    rows = box[:, None, 1] + box[:, None, 3] * _DOWN
    nearer = range_m[None, :] < range_m[:, None]
    if covering is not None:
        nearer &= covering
    over_columns = _between(columns, box[:, 0], box[:, 2]) & nearer[:, :, None]
    over_rows = _between(rows, box[:, 1], box[:, 3])
    # A place is hidden where one nearer box lies over both its column and its row.
    covers = over_columns.astype(np.float32).transpose(0, 2, 1) @ over_rows.astype(np.float32)
    inside_columns = (columns >= 0) & (columns < size[0])
    inside_rows = (rows >= 0) & (rows < size[1])
    shown = inside_columns[:, :, None] & inside_rows[:, None, :] & (covers == 0)
    return np.asarray(shown.mean(axis=(1, 2)))


def _between(places: Floats, low: Floats, length: Floats) -> NDArray[np.bool_]:
    """(people, others, places) whether each person's places (people, k) lie in others' spans."""
    offset = places[:, None, :] - low[None, :, None]
    return np.asarray((offset >= 0) & (offset < length[None, :, None]))


def expected_visibility(
    people: Population, view: View, covering: NDArray[np.bool_] | None = None
) -> Floats:
    """The share of each body that the others, where they are expected, leave to be seen.

    Args:
        covering: (people,) whose place is known well enough to cover others; None: everybody's.
    """
    range_m = np.hypot(people.position[:, 0], people.position[:, 1])
    return visibility(body_boxes(people, view), range_m, view.camera.size, covering)


def overlap(box: Floats) -> Floats:
    """The largest share of each box that it has in common with another one: (people,)."""
    low, high = box[:, :2], box[:, :2] + box[:, 2:]
    side = np.minimum(high[:, None], high[None]) - np.maximum(low[:, None], low[None])
    common = np.prod(np.clip(side, 0.0, None), axis=2)
    np.fill_diagonal(common, 0.0)
    return np.asarray((common / np.prod(box[:, 2:], axis=1)[:, None]).max(axis=1, initial=0.0))
