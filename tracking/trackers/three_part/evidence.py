"""What in a frame speaks for each part being where its rectangle is."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Clouds
from tracking.people import Detections
from tracking.trackers.three_part.appearance import measure_levels, resemblance
from tracking.trackers.three_part.claims import Claims, may_be_theirs, shares_of
from tracking.trackers.three_part.part_filter import carry_along
from tracking.trackers.three_part.people import Flags, Floats, PartPeople
from tracking.tracks import PART_EVIDENCE

_STRIP = 0.12
"""How deep a strip beside a rectangle is, in heights of the person: less than a head."""


def measure_evidence(
    people: PartPeople, seen: Detections, claims: Claims, picture: NDArray[np.uint8]
) -> Floats:
    """(people, parts, 8) the columns `PART_EVIDENCE`.

    Beyond [ZhaoLee2009], whose features are states alone: a head on the wall and a torso on
    somebody else stand as parts of a body do. All are shares or in heights of the person, so that
    they mean the same in any camera.

    Args:
        picture: (height, width, 3) of `ycbcr`.
    """
    height = np.maximum(people.height, 1.0)[:, None]
    theirs = may_be_theirs(claims)
    look = measure_levels(picture, people.rectangles)
    columns = {
        **_coverage(people.rectangles, height, seen, theirs),
        "likeness": resemblance(look, people.appearance),
        "change": resemblance(look, people.model) - people.usual,
        "offset": offsets(people) / height,
        "spread": _spreads(people.clouds).reshape(people.failed.shape) / height,
    }
    return np.stack([columns[name] for name in PART_EVIDENCE], axis=-1)


def offsets(people: PartPeople) -> Floats:
    """(people, parts) px, how far each part is from where the others take it."""
    away = np.zeros(people.failed.shape)
    for part in range(people.failed.shape[1]):
        which = np.zeros(people.failed.shape, bool)
        which[:, part] = True
        there = carry_along(people.state, people.pose, which)[:, part, :2]
        away[:, part] = np.linalg.norm(there - people.state[:, part, :2], axis=1)
    return away


def _coverage(
    rectangles: Floats, height: Floats, seen: Detections, theirs: Flags
) -> dict[str, Floats]:
    """(people, parts) each: the shares of the rectangle and of the strips around it."""
    middle, size = rectangles[..., :2], rectangles[..., 2:]
    deep = np.broadcast_to(_STRIP * height, middle.shape[:2])
    away = (size + deep[..., None]) / 2
    x, y = np.array((1.0, 0.0)), np.array((0.0, 1.0))
    across = np.stack((size[..., 0], deep), axis=-1)
    down = np.stack((deep, size[..., 1]), axis=-1)
    places = {
        "support": rectangles,
        "above": np.concatenate((middle - y * away, across), axis=-1),
        "below": np.concatenate((middle + y * away, across), axis=-1),
        "left": np.concatenate((middle - x * away, down), axis=-1),
        "right": np.concatenate((middle + x * away, down), axis=-1),
    }
    share = {name: shares_of(theirs, place, seen) for name, place in places.items()}
    share["beside"] = (share.pop("left") + share.pop("right")) / 2
    return share


def _spreads(clouds: Clouds) -> Floats:
    """(filters, parts together) px, the standard deviation of the rectangles' middles."""
    place, owner = clouds.state[..., :2].astype(np.float64), clouds.owner
    count = len(clouds.start) - 1
    total = np.maximum(np.bincount(owner, clouds.weight, count), 1e-30)[:, None]
    variance = np.zeros((count, place.shape[1]))
    for axis in range(2):
        first, second = np.zeros((2, count, place.shape[1]))
        for beside in range(place.shape[1]):
            values = place[:, beside, axis]
            first[:, beside] = np.bincount(owner, clouds.weight * values, count)
            second[:, beside] = np.bincount(owner, clouds.weight * values**2, count)
        variance += second / total - (first / total) ** 2
    return np.sqrt(np.maximum(variance, 0.0))
