"""Newcomers who are somebody lost before: found again by where they may have walked and looks.

Standard term: re-identification of coasted tracks, by log-likelihood ratios.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import associate
from tracking.trackers.joint.appearance import Telling, differences
from tracking.trackers.joint.evidence import place_density, spread_of
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.population import Population

Floats = NDArray[np.float64]
Rows = NDArray[np.intp]

_LEAST_MISSED_S = 0.1
"""Who was seen more recently is followed on, not found again."""


def found_again(
    people: Population, ready: Rows, new: Floats, telling: Telling, settings: JointSettings
) -> Population:
    """The people, with newcomers who are somebody missed in their place.

    Args:
        ready: rows of newcomers about to get an id; all were seen in this frame.
        new: (ready,) log of how many new people are expected a m² where each is seen now.
    """
    lost = np.flatnonzero(people.confirmed & (people.missed_s >= _LEAST_MISSED_S))
    if len(lost) == 0 or len(ready) == 0:
        return people
    missing, fresh = people.select(lost), people.select(ready)
    offset = fresh.position[None] - missing.position[:, None]
    sigma = np.full(len(ready), settings.sigma_near_m)
    place = place_density(offset, spread_of(missing), sigma)
    told = telling.likeness(differences(missing, fresh.colour, fresh.looks))
    cost = new - place - settings.looks_weight * told
    pairs = associate(cost, cost < 0.0, 0.0)
    return _replaced(people, lost[pairs.track], ready[pairs.detection])


def _replaced(people: Population, lost: Rows, found: Rows) -> Population:
    """The lost ones' ids and looks go to the rows of those found; their own rows end."""
    old, new = people.select(lost), people.select(found)
    people = people.changed(
        found,
        track=old.track,
        matches=old.matches + new.matches,
        colour=old.colour,
        looks=np.where(np.isfinite(old.looks), old.looks, new.looks),
        outline=old.outline,
    )
    gone = np.zeros(len(lost), np.int32)
    return people.changed(lost, track=gone, missed_s=np.full(len(lost), np.inf))
