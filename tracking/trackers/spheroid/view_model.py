"""How the camera sees people: steeply, cut off at the head, with somebody before their feet."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView
from tracking.trackers.spheroid.hypotheses import SpheroidPeople

Flags = NDArray[np.bool_]

_BEFORE_M = 0.4
"""What hides the floor so far before somebody's feet hides the near side of the body."""


def seen_steeply(people: SpheroidPeople, flat: FlatView) -> Flags:
    """(people,) whom the camera looks down on by more than 45 degrees."""
    return steep_places(people.xy, flat)


def steep_places(xy: NDArray[np.float64], flat: FlatView) -> Flags:
    """(n,) whether the camera looks down so on places xy (n, 2) m of the floor."""
    camera_position = np.asarray(flat.camera_position)
    return np.asarray(np.hypot(*(xy - camera_position[:2]).T) < camera_position[2])


def headless(people: SpheroidPeople, flat: FlatView) -> Flags:
    """(people,) whose head is out of the picture where they are expected."""
    head = flat.flat_from_world(np.column_stack((people.xy, people.height)))
    inside = (head >= 0) & (head <= np.array(flat.size) - 1)
    return np.asarray(~inside.all(axis=1))


def near_side_hidden(people: SpheroidPeople, outlines: Ellipses, flat: FlatView) -> Flags:
    """(people,) before whose feet, as the camera sees it, there is somebody else.

    Args:
        outlines: (people) their silhouettes.
    """
    towards = flat.camera_position[:2] - people.xy
    away_m = np.maximum(np.hypot(*towards.T), 1e-6)
    before = people.xy + towards * np.minimum(_BEFORE_M / away_m, 1.0)[:, None]
    u, v = flat.flat_from_world(np.column_stack((before, np.zeros(len(people))))).T
    begin, end = outlines.ends(np.broadcast_to(v, (len(people), len(people))))
    with np.errstate(invalid="ignore"):
        inside = (u >= begin) & (u <= end)
    np.fill_diagonal(inside, False)
    return np.asarray(inside.any(axis=0))
