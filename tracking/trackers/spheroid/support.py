"""What is seen of people at their estimates, and who is let go."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import FlatView
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople
from tracking.trackers.spheroid.hypothesis_scores import bounds
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.sums import Window, sums_inside
from tracking.trackers.spheroid.view_model import seen_steeply
from tracking.trackers.spheroid.weights import silhouettes

_SEEN = 0.35
"""Share of what can be seen of a silhouette that must be foreground."""
_ENOUGH, _ENOUGH_STEEPLY = 0.25, 0.15
"""Share of a silhouette that must be in sight to tell anything; seen steeply, heads are large."""
_WHOLE = 0.85
_LEFT = 0.2
"""Share of a silhouette in the picture below which the person has left it."""
_EDGE = 0.75
_EMPTY_S, _UNBOXED_S = 0.6, 1.5
"""Who has no foreground for so long, or no box, and is in plain sight, is not there: detectors miss
people now and then."""
_QUIET_M_PER_S = 0.12
"""Slower than this, somebody stands."""


def measure_support(
    people: SpheroidPeople,
    windows: list[Window],
    flat: FlatView,
    settings: SpheroidSettings,
    elapsed_s: float,
) -> SpheroidPeople:
    """The people with how much is seen of them at their estimates.

    Args:
        windows: those in which the hypotheses were judged.
    """
    outlines = silhouettes(people, flat, settings)
    sums = sums_inside(windows, outlines[:, None])
    seen, area = sums.ramp[:, 0], sums.area[:, 0]
    whole = np.maximum(np.nan_to_num(outlines.areas()), 1.0)
    shown = np.clip(area / whole, 0.0, 1.0)
    coverage = seen / np.maximum(area, 1.0)
    enough = np.where(seen_steeply(people, flat), _ENOUGH_STEEPLY, _ENOUGH)
    found = (coverage > _SEEN) & (shown > enough)
    pace = np.hypot(people.mean[:, 2], people.mean[:, 3])
    return people.replace(
        coverage=coverage,
        shown=shown,
        inside=_inside(people, flat, settings),
        missed_s=np.where(found, 0.0, people.missed_s + elapsed_s),
        age_s=people.age_s + elapsed_s,
        quiet_s=np.where(pace < _QUIET_M_PER_S, people.quiet_s + elapsed_s, 0.0),
    )


def _inside(people: SpheroidPeople, flat: FlatView, settings: SpheroidSettings) -> Floats:
    """(people,) share of each silhouette's box in the picture; 0 for who has none."""
    outlines = silhouettes(people, flat, settings)
    left, top, right, bottom = bounds(outlines, flat.size[::-1])
    (low_u, high_u), (low_v, high_v) = outlines.columns(), outlines.rows()
    whole = np.maximum((high_u - low_u) * (high_v - low_v), 1.0)
    return np.clip(np.nan_to_num((right - left) * (bottom - top) / whole), 0.0, 1.0)


def seen_whole(people: SpheroidPeople) -> NDArray[np.bool_]:
    """(people,) who is in sight from head to foot."""
    return np.asarray((people.missed_s == 0.0) & (people.shown > _WHOLE))


def should_keep(people: SpheroidPeople, settings: SpheroidSettings) -> NDArray[np.bool_]:
    """(people,) who is followed on.

    [Waechter2013] 3.3: who has hypotheses spread too wide is not. Where we differ: who is not where
    he would be in plain sight, and who has walked out of the picture, is let go at once, before the
    hypotheses drift onto somebody else.
    """
    gathered = people.spread <= settings.widest_spread_m
    if settings.paper:
        return np.asarray(gathered)
    empty_s = _UNBOXED_S if settings.detections_only else _EMPTY_S
    in_plain_sight = people.shown > 0.5
    patience_s = np.where(in_plain_sight, empty_s, settings.report_occluded_s)
    patience_s = np.where(people.inside < _EDGE, np.minimum(patience_s, empty_s), patience_s)
    return np.asarray(gathered & (people.inside > _LEFT) & (people.missed_s <= patience_s))
