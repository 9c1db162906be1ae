"""Tracks that coast after a loss, and their re-identification."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import nearest_first
from tracking.trackers.shared.corrected_rows import LED_ON_S
from tracking.trackers.shared.gating import WideningGate
from tracking.trackers.spheroid.appearance import difference
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople, concatenate

_GATE_M = WideningGate(at_once=0.7, a_second=1.3, widest=4.0)
"""Around where people were expected."""
_KEPT = ("track", "height", "height_sd", "outline", "appearance", "counts", "age_s")
"""What is known of somebody whom they keep."""
_UNLIKE = 0.3
"""Difference of colours from which on somebody is somebody else."""
_NAT = 0.04
"""Difference of colours that one nat of an appearance network is worth."""
_FAR = 0.3
"""What the whole gate counts beside the colours."""


@dataclass(frozen=True, slots=True, eq=False)
class CoastingPeople:
    """Coasting tracks.

    Attributes:
        people: as they were last. at_s: (people,) when.
    """

    people: SpheroidPeople
    at_s: Floats

    def append(self, people: SpheroidPeople, now_s: float) -> CoastingPeople:
        """With the people lost now."""
        at_s = np.concatenate((self.at_s, np.full(len(people), now_s)))
        return CoastingPeople(concatenate([self.people, people]), at_s)

    def select(self, rows: NDArray[np.bool_]) -> CoastingPeople:
        """Some of them."""
        return CoastingPeople(self.people.select(rows), self.at_s[rows])

    def restore(
        self, new: SpheroidPeople, found: NDArray[np.bool_], rows: NDArray[np.intp]
    ) -> tuple[SpheroidPeople, CoastingPeople]:
        """The new people, some of whom are coasting ones again, and who goes on coasting.

        Args:
            found: (new,) who is re-identified. rows: (found,) of the coasting ones they are.
        """
        known = {name: getattr(self.people, name)[rows] for name in _KEPT}
        left = ~np.isin(np.arange(len(self.at_s)), rows)
        return new.with_rows(found, **known), self.select(left)


def reidentify(
    lost: CoastingPeople, tentative: SpheroidPeople, now_s: float, embedded: Floats | None = None
) -> NDArray[np.intp]:
    """(tentative,) the row of the lost each of them is; -1: somebody new.

    The pair that fits best is taken first.

    Args:
        embedded: (lost, tentative) log-likelihood ratio of an appearance network; None: none.
    """
    found = np.full(len(tentative), -1)
    if len(lost.people) == 0 or len(tentative) == 0:
        return found
    cost = _costs(lost, tentative, now_s, 0.0 if embedded is None else _NAT * embedded.T)
    pairs = nearest_first(cost, np.isfinite(cost))
    found[pairs.track] = pairs.detection
    return found


def _costs(
    lost: CoastingPeople, tentative: SpheroidPeople, now_s: float, alike: Floats | float
) -> Floats:
    """(tentative, lost) infinite where they cannot be the same.

    Args:
        alike: (tentative, lost) what else than colours says so, as a difference of colours.
    """
    missed_s = now_s - lost.at_s + lost.people.missed_s
    led_on = lost.people.mean[:, 2:] * np.minimum(missed_s, LED_ON_S)[:, None]
    apart = tentative.xy[:, None] - (lost.people.xy + led_on)
    far = np.hypot(apart[..., 0], apart[..., 1]) / _GATE_M.radius(missed_s)
    unlike = difference(
        tentative.appearance[:, None],
        tentative.counts[:, None],
        lost.people.appearance,
        lost.people.counts,
    )
    unlike = unlike - alike
    return np.where((far < 1.0) & (unlike < _UNLIKE), unlike + _FAR * far, np.inf)
