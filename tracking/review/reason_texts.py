"""The reasons of every place, in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.review.reason_groups import Places, Reasons
from tracking.review.reason_phrases import sentence
from tracking.translation import Message

_SAME_MOMENT_S = 0.25


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

    def describe(self, place: int, leader: int, frame: int) -> list[Message]:
        """Sentences: the leader's, then the strongest of each other kind.

        The leader's is told for `frame`, that of the place, so that one moment is named alone.
        """
        strongest: dict[str, int] = {}
        for row in self.spoken[self.cuts[place] : self.cuts[place + 1]]:
            strongest.setdefault(self.kind(row), row)
        strongest.pop(self.kind(leader), None)
        others = [self._sentence(row, self.columns[3][row]) for row in strongest.values()]
        return [self._sentence(leader, frame), *others]

    def _sentence(self, row: int, frame: int) -> Message:
        """A reason told for a frame: with "about" where its own lies elsewhere."""
        own_s, told_s = self.columns[3][row] / self.fps, frame / self.fps
        return sentence(
            self.kind(row),
            *self.tracks(row),
            self.columns[4][row],
            told_s,
            on_floor=self.on_floor,
            about=abs(own_s - told_s) > _SAME_MOMENT_S,
        )
