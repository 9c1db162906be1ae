"""People who were out of sight for long, and came back."""

from __future__ import annotations

import numpy as np

from tracking.review.core.findings import FlaggedPlaces, join_findings, of_pairs, of_tracks, ramp
from tracking.review.core.material import Material

_LEAST_S, _LONG_S = 0.5, 4.0

_DRIFT_S, _FAR_S = 1.0, 3.0


def drifts(material: Material) -> FlaggedPlaces:
    """Where somebody is last seen whose track goes on for long, only predicted."""
    evidence = material.evidence
    seen = np.flatnonzero(~evidence.predicted)
    track = evidence.track[seen]
    final = seen[np.append(track[1:] != track[:-1], np.ones(min(len(seen), 1), bool))]
    stop = material.last[np.searchsorted(material.last, final)]
    seconds = (evidence.frame[stop] - evidence.frame[final]) / evidence.fps
    strength = ramp(seconds, _DRIFT_S, _FAR_S)
    return of_tracks("drift", evidence.track[final], evidence.frame[final] + 1, strength, seconds)


def long_predictions(material: Material) -> FlaggedPlaces:
    """Where somebody who was only predicted, or missing, is seen again.

    It is about whoever is near then as well: one may have been taken for the other.
    """
    evidence = material.evidence
    seen = np.flatnonzero(~evidence.predicted)
    again, before = seen[1:], seen[:-1]
    seconds = (evidence.frame[again] - evidence.frame[before] - 1) / evidence.fps
    seconds[evidence.track[again] != evidence.track[before]] = 0.0
    told = np.flatnonzero(seconds >= _LEAST_S)
    rows, seconds = again[told], seconds[told]
    other = material.nearest[rows]
    track, frame = evidence.track[rows], evidence.frame[rows]
    strength = 0.1 + ramp(seconds, _LEAST_S, _LONG_S)
    alone, near = np.flatnonzero(other == 0), np.flatnonzero(other > 0)
    return join_findings(
        (
            of_pairs(
                *("predicted", track[near], other[near], frame[near], strength[near]),
                seconds[near],
            ),
            of_tracks("predicted", track[alone], frame[alone], strength[alone], seconds[alone]),
        )
    )
