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
        kinds: names. columns: number of the kind, both tracks, frame and figure of each reason.
        cuts: the reasons of place i are numbers cuts[i] to cuts[i + 1] of `spoken`.
        spoken: reasons place after place, each place's weightiest first.
        on_floor: whether figures are metres of the floor.
    """

    kinds: Sequence[str]
    columns: tuple[list[int], list[int], list[int], list[int], list[float]]
    cuts: Sequence[int]
    spoken: Sequence[int]
    fps: float
    on_floor: bool

    @classmethod
    def of(cls, reasons: Reasons, places: Places, fps: float, *, on_floor: bool) -> Speaker:
        """Put the reasons of each place in order."""
        order = np.lexsort((-reasons.weight[places.reason], places.place))
        cuts = np.searchsorted(places.place[order], np.arange(len(places.leader) + 1))
        columns = (
            *(column.tolist() for column in (reasons.kind, reasons.first, reasons.second)),
            *(column.tolist() for column in (reasons.frame, reasons.figure)),
        )
        spoken = places.reason[order].tolist()
        return cls(reasons.kinds, columns, cuts.tolist(), spoken, fps, on_floor)

    def kind(self, reason: int) -> str:
        """Of a reason."""
        return self.kinds[self.columns[0][reason]]

    def tracks(self, reason: int) -> tuple[int, int]:
        """Whom a reason is about; 0 for nobody else."""
        return self.columns[1][reason], self.columns[2][reason]

    def said(self, place: int, leader: int) -> list[str]:
        """Sentences: the leader's, then the strongest of each other kind."""
        strongest: dict[str, int] = {}
        for row in (leader, *self.spoken[self.cuts[place] : self.cuts[place + 1]]):
            strongest.setdefault(self.kind(row), row)
        return [self._sentence(kind, row) for kind, row in strongest.items()]

    def _sentence(self, kind: str, row: int) -> str:
        _, _, _, frame, figure = self.columns
        time_s = frame[row] / self.fps
        return sentence(kind, *self.tracks(row), figure[row], time_s, on_floor=self.on_floor)
