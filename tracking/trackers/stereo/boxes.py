"""The people followed as boxes in the picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association
from tracking.geometry import View
from tracking.people import Detections
from tracking.trackers.stereo.population import Population
from tracking.tracks.boxes import common_px2

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
_NO_SIDE = float(np.finfo(np.float64).tiny)
"""What boxes without width or height are divided by: nothing of them is anywhere."""


@dataclass(frozen=True, slots=True)
class Bodies:
    """Where bodies are in the picture, worked out once for as long as people stand as they do.

    Attributes:
        middle: (people, 2) px as recorded, of the bodies' middles.
        px_per_m: (people, 1) how large a metre looks there.
    """

    middle: Floats
    px_per_m: Floats

    @classmethod
    def at(cls, position: Floats, view: View) -> Bodies:
        """Of people who stand at these positions (people, 2) m."""
        range_m = np.maximum(np.hypot(position[:, 0], position[:, 1]), 1e-6)[:, None]
        across = 0.5 * position[:, ::-1] * (-1.0, 1.0) / range_m
        points = np.full((2, len(position), 3), MIDDLE_M)
        points[0, :, :2] = position - across
        points[1, :, :2] = position + across
        one, other = view.pixel_from_world(points.reshape(-1, 3)).reshape(2, -1, 2)
        return cls((one + other) / 2, np.hypot(*(one - other).T)[:, None])

    def select(self, rows: slice | NDArray[np.intp]) -> Bodies:
        """The bodies at these rows."""
        return Bodies(self.middle[rows], self.px_per_m[rows])

    def boxes(self, outline: Floats) -> Floats:
        """The bodies' boxes, hidden or not, by `Population.outline`: (people, 4) px."""
        box = np.concatenate((self.middle, self.middle), axis=1) + outline * self.px_per_m
        box[:, 2:] -= box[:, :2]
        return box

    def outlines(self, box: Floats) -> Floats:
        """The boxes (people, 4) px of these bodies as `Population.outline`."""
        low = box[:, :2] - self.middle
        return np.concatenate((low, low + box[:, 2:]), axis=1) / self.px_per_m


def update_outlines(
    people: Population,
    pairs: Association,
    alone: NDArray[np.bool_],
    seen: Detections,
    elapsed_s: float,
    bodies: Bodies,
) -> Population:
    """The people with the outlines of those matched brought up to date.

    Args:
        alone: (pairs,) False where the region holds somebody else too.
        bodies: of all people, where they are now.
    """
    rows, chosen = pairs.track[alone], pairs.detection[alone]
    mixed = overlap(bodies.boxes(people.outline))[rows] > _MIXED
    memory_s = np.where(mixed, _MIXED_MEMORY_S, _OUTLINE_MEMORY_S)
    share = 1.0 - np.exp(-elapsed_s / memory_s)
    share = np.maximum(share, 1.0 / people.matches[rows])[:, None]
    old = people.outline[rows]
    new = bodies.select(rows).outlines(seen.box[chosen])
    return people.with_rows(rows, outline=old + share * (new - old))


def share_in_view(box: Floats, size: tuple[int, int]) -> Floats:
    """The share of each box (people, 4) that lies inside a picture so large: (people,) 0 to 1."""
    low = np.maximum(box[:, :2], 0.0)
    high = np.minimum(box[:, :2] + box[:, 2:], size)
    share = np.maximum(high - low, 0.0) / np.maximum(box[:, 2:], _NO_SIDE)
    both = share[:, 0] * share[:, 1]
    return np.where(np.isfinite(both), both, 0.0)


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
    left, top, width, height = box.T
    columns = left[:, None] + width[:, None] * _ACROSS
    rows = top[:, None] + height[:, None] * _DOWN
    nearer = range_m[:, None] < range_m
    if covering is not None:
        nearer &= covering[:, None]
    over_columns = _between(columns, left, left + width)
    over_columns &= nearer[:, :, None]
    over_rows = _between(rows, top, top + height)
    # A place is hidden where one nearer box lies over both its column and its row.
    across, down = over_columns.astype(np.float32), over_rows.astype(np.float32)
    shown = across.transpose(1, 2, 0) @ down.transpose(1, 0, 2) == 0.0
    shown &= ((columns >= 0) & (columns < size[0]))[:, :, None]
    shown &= ((rows >= 0) & (rows < size[1]))[:, None, :]
    return np.asarray(shown.mean(axis=(1, 2)))


def _between(places: Floats, low: Floats, high: Floats) -> NDArray[np.bool_]:
    """(others, people, places) whether each person's places (people, k) lie in others' spans."""
    flat = places.ravel()
    between = flat >= low[:, None]
    between &= flat < high[:, None]
    return between.reshape(len(low), *places.shape)


def expected_visibility(
    people: Population,
    box: Floats,
    size: tuple[int, int],
    covering: NDArray[np.bool_] | None = None,
) -> Floats:
    """The share of each body that the others, where they are expected, leave to be seen.

    Args:
        box: (people, 4) px of the bodies there. size: width and height of the picture.
        covering: (people,) whose place is known well enough to cover others; None: everybody's.
    """
    range_m = np.hypot(people.position[:, 0], people.position[:, 1])
    return visibility(box, range_m, size, covering)


def overlap(box: Floats) -> Floats:
    """The largest share of each box that it has in common with another one: (people,)."""
    common = common_px2(box[:, None], box[None])
    np.fill_diagonal(common, 0.0)
    area = np.maximum(box[:, 2] * box[:, 3], _NO_SIDE)
    return np.asarray((common / area[:, None]).max(axis=1, initial=0.0))
