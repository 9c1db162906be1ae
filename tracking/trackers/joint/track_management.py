"""Track management: which tracks are reported, coast unreported, or are deleted."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.joint.edges import share_a_step_off
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.stage_values import UpdatedTracks
from tracking.trackers.stereo.boxes import share_in_view
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.termination import OUT_OF_VIEW, TENTATIVE_PATIENCE_S

Flags = NDArray[np.bool_]
Floats = NDArray[np.float64]

_REPORTED_SHARE, _COASTED_SHARE = 1.0, 3.0
"""No track is reported, or coasts, for longer than so many times as it was seen."""
_IN_VIEW, _BY_CHANCE_S = 0.5, 0.4
"""Who shows so much of themselves is missed by chance, and for no longer."""
_AT_THE_EDGE = 0.55
"""Who has less of themselves in the picture a step further off stands at its edge."""


def may_be_occluded(people: Population, shown: Floats) -> Flags:
    """(people,) who may be behind others if not seen: not who is in view and missed by chance.

    Args:
        shown: (people,) share of each body expected to be in sight.
    """
    return np.asarray((shown < _IN_VIEW) | (people.missed_s > _BY_CHANCE_S))


def is_reported(
    people: Population, shown: Floats, settings: JointSettings, interval_s: float
) -> Flags:
    """(people,) who is thought to be where they are predicted.

    Somebody who should be seen and is not may be anywhere: their track coasts unreported.

    Args:
        shown: (people,) share of each body expected to be in sight.
        interval_s: between two frames, as they usually come.
    """
    hidden = shown < settings.min_visibility
    patience_s = np.where(hidden, settings.report_occluded_s, settings.report_s)
    patience_s = np.minimum(patience_s, _REPORTED_SHARE * people.matches * interval_s)
    return np.asarray(people.confirmed & (people.missed_s <= patience_s))


def should_keep(
    updated: UpdatedTracks,
    settings: JointSettings,
    size: tuple[int, int],
    interval_s: float,
) -> Flags:
    """(people,) whose track is kept, reported or coasting.

    Those who were last seen at the picture's edge, or walked out of it, are not: who enters there
    is somebody else.

    Args:
        updated: where they are now. size: of the picture.
        interval_s: between two frames, as they usually come.
    """
    people, inside = updated.people, share_in_view(updated.box, size)
    at_the_edge = share_a_step_off(updated.around, size) < _AT_THE_EDGE
    patience_s = np.where(at_the_edge, settings.delete_at_edge_s, settings.coast_s)
    patience_s = np.minimum(patience_s, _COASTED_SHARE * people.matches * interval_s)
    patience_s = np.where(people.confirmed, patience_s, TENTATIVE_PATIENCE_S)
    patience_s = np.where(inside < OUT_OF_VIEW, 0.0, patience_s)
    return np.asarray(people.missed_s <= patience_s)
