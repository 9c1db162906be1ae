"""What is learnt of people in each frame: colours, outlines, places on the floor."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.people import Detections
from tracking.trackers.three_part.appearance import measure_levels, resemblance
from tracking.trackers.three_part.bodies import heights_after
from tracking.trackers.three_part.claims import Claims
from tracking.trackers.three_part.initiation import pose_of
from tracking.trackers.three_part.people import Flags, Floats, PartPeople
from tracking.trackers.three_part.settings import WholeBodySettings

_USUAL_MEMORY = 0.9
_APPEARANCE_MEMORY = 0.97
_GOOD_VIEW = 0.6
"""Share of foreground under a part from which on its colours are the person's."""
_PLACE_MEMORY_S = 0.12
_POSE_MEMORY_S = 0.2


def learn_colours(
    people: PartPeople,
    picture: NDArray[np.uint8],
    claims: Claims,
    lost: Flags,
    settings: WholeBodySettings,
) -> PartPeople:
    """Colour models after a frame: `H_t = 0.9 H_(t-1) + 0.1 Q_t` [ZhaoLee2009] eq. 1.

    Q is taken at the estimate, unequalised. Models of parts that are occluded or lost are frozen.

    Args:
        picture: (height, width, 3) of `ycbcr`.
        lost: (people, parts).
    """
    seen = measure_levels(picture, people.rectangles)
    alike = resemblance(seen, people.model)
    learnt = ~people.occluded & ~lost & (seen.sum(axis=(2, 3)) > 0)
    model = _blend(people.model, seen, learnt, settings.colour_forgetting_factor)
    good = learnt & claims.alone[:, None] & (claims.support >= _GOOD_VIEW)
    appearance = _blend(people.appearance, seen, good, _APPEARANCE_MEMORY)
    usual = people.usual + (1.0 - _USUAL_MEMORY) * learnt * (alike - people.usual)
    return people.replace(model=model, appearance=appearance, similarity=alike, usual=usual)


def learn_poses(
    people: PartPeople,
    box: Floats,
    claims: Claims,
    whole: Flags,
    taller: Flags,
    unsure: Flags,
    elapsed_s: float,
) -> PartPeople:
    """How the parts stand to each other and how high people are, from clear views of them.

    Args:
        box: (people, 4) of their regions. whole: (people,) seen alone and all of them.
        taller: (people,) seen alone and taller than they are taken for.
        unsure: (people,) of whom a part is hidden or lost.
    """
    clear = ~unsure & (~people.touching | whole) & ~people.is_cut
    clear &= claims.support.min(axis=1) >= _GOOD_VIEW
    share = np.where(clear, 1.0 - np.exp(-elapsed_s / _POSE_MEMORY_S), 0.0)[:, None, None]
    height = heights_after(people.height, box, whole | taller, elapsed_s)
    # Of somebody whom the picture cuts off the pose grows with the body.
    grown = np.where(people.is_cut, height / np.maximum(people.height, 1.0), 1.0)[:, None, None]
    pose = people.pose * grown
    return people.replace(
        pose=pose + share * (pose_of(people.rectangles) - pose),
        height=height,
    )


def learn_places(
    people: PartPeople,
    box: Floats,
    seen: Detections,
    claims: Claims,
    elapsed_s: float,
    view: View | None,
) -> PartPeople:
    """Where people stand on the floor: as perception measured them, else below their box."""
    if view is None:
        return people
    foot = np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))
    below = view.floor_from_pixel(foot)
    measured = np.append(seen.position[:, :2], np.full((1, 2), np.nan), axis=0)
    own = measured[np.where(claims.alone, claims.region, -1)]
    there = np.where(np.isfinite(own).all(axis=1, keepdims=True), own, below)
    expected = people.place + people.walk * elapsed_s
    known = np.isfinite(expected).all(axis=1, keepdims=True)
    off = np.where(np.isfinite(there).all(axis=1, keepdims=True), there - expected, 0.0)
    share = 1.0 - np.exp(-elapsed_s / _PLACE_MEMORY_S)
    turn = share**2 / (2.0 - share) / max(elapsed_s, 1e-3)
    return people.replace(
        place=np.where(known, expected + share * off, there),
        walk=np.where(known, people.walk + turn * off, 0.0),
    )


def _blend(
    model: NDArray[np.float32], seen: NDArray[np.float32], learnt: Flags, memory: float
) -> NDArray[np.float32]:
    share = ((1.0 - memory) * learnt).astype(np.float32)[..., None, None]
    return model + share * (seen - model)
