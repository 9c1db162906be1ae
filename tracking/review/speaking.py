"""The reasons of every place, in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.review.joining import Places, Reasons
from tracking.review.wording import sentence


@dataclass(frozen=True, slots=True)
class Speaker:
    """Says why a place is there.

    Attributes:
        reasons: kind, both tracks, frame and figure of each reason, as plain values.
        cuts: the reasons of place i are numbers cuts[i] to cuts[i + 1] of `spoken`.
        spoken: reasons place after place, each place's weightiest first.
    """

    reasons: Sequence[tuple[str, int, int, int, float]]
    cuts: Sequence[int]
    spoken: Sequence[int]
    fps: float

    @classmethod
    def of(cls, reasons: Reasons, places: Places, fps: float) -> Speaker:
        """Put the reasons of each place in order."""
        order = np.lexsort((-reasons.weight[places.reason], places.place))
        cuts = np.searchsorted(places.place[order], np.arange(len(places.leader) + 1))
        columns = (reasons.first, reasons.second, reasons.frame, reasons.figure)
        kinds = [reasons.kinds[number] for number in reasons.kind.tolist()]
        plain = list(zip(kinds, *(column.tolist() for column in columns), strict=True))
        return cls(plain, cuts.tolist(), places.reason[order].tolist(), fps)

    def said(self, place: int, leader: int) -> list[str]:
        """Sentences: the leader's, then the strongest of each other kind."""
        strongest: dict[str, int] = {}
        for row in (leader, *self.spoken[self.cuts[place] : self.cuts[place + 1]]):
            strongest.setdefault(self.reasons[row][0], row)
        return [self._sentence(row) for row in strongest.values()]

    def _sentence(self, row: int) -> str:
        kind, first, second, frame, figure = self.reasons[row]
        return sentence(kind, first, second, figure, frame / self.fps)
