"""Track-mAP: whole tracks as detections, the surest first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats, Integers

OVERLAPS = np.arange(0.5, 0.96, 0.05)
"""Track overlaps from which a track counts as found, 0.5 to 0.95."""

SUBSETS = ("all", "area_s", "area_m", "area_l", "time_s", "time_m", "time_l")
"""Which tracks are looked for: all, or those of a size or length; TrackEval's (TAO's) ranges."""

_RECALLS = np.linspace(0.0, 1.0, 101)


@dataclass(frozen=True, slots=True, eq=False)
class TrackMap:
    """TrackEval's TrackMAP, after [Dave2020] (TAO).

    Attributes:
        confidence: (n,) mean of each track's rows, the surest track first.
        found: (7, 10, n) by `SUBSETS` and `OVERLAPS`: the track stands for a person.
        ignored: (7, 10, n) it is not of the subset, or stands for a person who is not.
        people: (7,) how many people are looked for.
    """

    confidence: Floats
    found: Flags
    ignored: Flags
    people: Integers

    def average_precision(self, subset: str = "all") -> Floats:
        """(10,) mean precision over 101 recalls at each overlap; NaN with nobody to look for."""
        return self._measured(subset)[0]

    def average_recall(self, subset: str = "all") -> Floats:
        """(10,) share of the people found at each overlap; NaN with nobody to look for."""
        return self._measured(subset)[1]

    @property
    def ap(self) -> float:
        """Mean of `average_precision` over the overlaps."""
        return float(self.average_precision().mean())

    @property
    def ar(self) -> float:
        """Mean of `average_recall` over the overlaps."""
        return float(self.average_recall().mean())

    def _measured(self, subset: str) -> tuple[Floats, Floats]:
        number = SUBSETS.index(subset)
        people = int(self.people[number])
        if not people:
            return np.full(len(OVERLAPS), np.nan), np.full(len(OVERLAPS), np.nan)
        counted = ~self.ignored[number]
        right = np.cumsum(self.found[number] & counted, axis=1)
        wrong = np.cumsum(~self.found[number] & counted, axis=1)
        curves = [_precision(*each, people) for each in zip(right, wrong, strict=True)]
        reached = right[:, -1] / people if right.shape[1] else np.zeros(len(OVERLAPS))
        return np.array(curves), reached


def _precision(right: Integers, wrong: Integers, people: int) -> float:
    """Mean over the recalls of the best precision at that recall or a higher one."""
    precision = right / (right + wrong + np.spacing(1))
    best = np.append(np.maximum.accumulate(precision[::-1])[::-1], 0.0)
    return float(best[np.searchsorted(right / people, _RECALLS, side="left")].mean())


def combined_track_map(parts: Sequence[TrackMap]) -> TrackMap:
    """Of several recordings: their tracks together, the surest first; of equals in order."""
    confidence = np.concatenate([part.confidence for part in parts])
    order = np.argsort(-confidence, kind="stable")
    return TrackMap(
        confidence[order],
        np.concatenate([part.found for part in parts], axis=2)[..., order],
        np.concatenate([part.ignored for part in parts], axis=2)[..., order],
        np.sum([part.people for part in parts], axis=0),
    )
