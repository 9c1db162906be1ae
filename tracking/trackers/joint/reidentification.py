"""Re-identification of coasting tracks, by log-likelihood ratios of motion and appearance."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import associate
from tracking.trackers.joint.appearance import AppearanceModel, appearance_differences
from tracking.trackers.joint.association_likelihoods import particle_covariance, place_density
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.stereo.population import Population

Floats = NDArray[np.float64]
Rows = NDArray[np.intp]

_LEAST_MISSED_S = 0.1
"""Who was seen more recently is followed on, not re-identified."""


def reidentify(
    people: Population,
    ready: Rows,
    new: Floats,
    model: AppearanceModel,
    embedded: Floats,
    settings: JointSettings,
) -> Population:
    """The people, with tentative tracks that are somebody missed put in their place.

    Args:
        ready: rows of tentative tracks about to get an id; all were seen in this frame.
        embedded: (people, ready) log-likelihood ratio of an appearance network; 0: unknown.
        new: (ready,) log birth intensity where each is seen now.
    """
    lost = np.flatnonzero(people.confirmed & (people.missed_s >= _LEAST_MISSED_S))
    if len(lost) == 0 or len(ready) == 0:
        return people
    missing, fresh = people.select(lost), people.select(ready)
    offset = fresh.position[None] - missing.position[:, None]
    sigma = np.full(len(ready), settings.measurement_noise_m)
    place = place_density(offset, particle_covariance(missing), sigma)
    ratio = model.log_likelihood_ratio(
        appearance_differences(missing, fresh.colour, fresh.appearance)
    )
    cost = new - place - settings.appearance_weight * (ratio + embedded[lost])
    pairs = associate(cost, cost < 0.0, 0.0)
    return _replace_lost(people, lost[pairs.track], ready[pairs.detection])


def _replace_lost(people: Population, lost: Rows, found: Rows) -> Population:
    """The lost ones' ids and appearance go to the rows of those found; their own rows end."""
    old, new = people.select(lost), people.select(found)
    people = people.with_rows(
        found,
        track=old.track,
        matches=old.matches + new.matches,
        colour=old.colour,
        appearance=np.where(np.isfinite(old.appearance), old.appearance, new.appearance),
        outline=old.outline,
    )
    deleted = np.zeros(len(lost), np.int32)
    return people.with_rows(lost, track=deleted, missed_s=np.full(len(lost), np.inf))
