"""Every error of a result, one by one: for reports, the timeline and the map."""

from __future__ import annotations

from dataclasses import dataclass, fields
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.clear_counts import Successions, successions
from tracking.scoring.examination import Examination, examine
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable

NOBODY = 0
"""Stands in `ErrorTable` for a person or a track that is not concerned."""


class ErrorKind(IntEnum):
    """What went wrong; the value stands in `ErrorTable.kind`."""

    SWITCH = 0
    MISS = 1
    FALSE_ALARM = 2
    FRAGMENTATION = 3


@dataclass(frozen=True, slots=True, eq=False)
class ErrorTable:
    """A row for each error, sorted by frame, kind, truth, result.

    Attributes:
        kind: (n,) uint8, see `ErrorKind`.
        frame: (n,) from 0; of switches and fragmentations the first frame after it.
        truth: (n,) the person's id in the truth; `NOBODY` for false alarms.
        result: (n,) the track's id; `NOBODY` for misses.
        earlier: (n,) of switches and fragmentations the track that was matched before.
        earlier_frame: (n,) the last frame in which it was; elsewhere the error's own frame.
        position: (n, 2) x, y on the floor in metres, NaN where unknown: of the person, of false
            alarms of the track.
        box: (n, 4) left, top, width, height in pixels, likewise.
    """

    kind: NDArray[np.uint8]
    frame: Integers
    truth: Integers
    result: Integers
    earlier: Integers
    earlier_frame: Integers
    position: Floats
    box: Floats

    def __len__(self) -> int:
        """The number of errors."""
        return len(self.kind)

    def rows(self, kept: Flags | Integers) -> ErrorTable:
        """Some of them."""
        return ErrorTable(
            self.kind[kept],
            self.frame[kept],
            self.truth[kept],
            self.result[kept],
            self.earlier[kept],
            self.earlier_frame[kept],
            self.position[kept],
            self.box[kept],
        )

    def of_kind(self, kind: ErrorKind) -> ErrorTable:
        """Those of one kind."""
        return self.rows(self.kind == kind)

    def count(self, kind: ErrorKind) -> int:
        """How many there are of one kind."""
        return int(np.count_nonzero(self.kind == kind))


def errors(truth: ScoringTable, result: ScoringTable, match: Match | None = None) -> ErrorTable:
    """All switches, misses, false alarms and fragmentations: as many as `score` counts.

    A person found again under another id after a gap is both a switch and a fragmentation.

    Args:
        truth, result, match: as for `score`.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    return errors_of(examine(truth, result, match))


def errors_of(examination: Examination) -> ErrorTable:
    """All errors of what was compared."""
    follow = successions(examination.comparison, examination.matched, examination.conventions)
    handed_on = (
        (ErrorKind.SWITCH, follow.switched),
        (ErrorKind.FRAGMENTATION, follow.interrupted),
    )
    found = _joined(
        [_missed(examination), _false_alarms(examination)]
        + [_of_successions(examination, follow, *each) for each in handed_on]
    )
    return found.rows(np.lexsort((found.result, found.truth, found.kind, found.frame)))


def _missed(examination: Examination) -> ErrorTable:
    truth = examination.comparison.truth
    alone = np.ones(len(truth), bool)
    alone[examination.matched.rows.truth] = False
    return _alone(truth.rows(alone), ErrorKind.MISS)


def _false_alarms(examination: Examination) -> ErrorTable:
    result = examination.comparison.result
    alone = np.ones(len(result), bool)
    alone[examination.matched.rows.result] = False
    return _alone(result.rows(alone), ErrorKind.FALSE_ALARM)


def _alone(rows: ScoringTable, kind: ErrorKind) -> ErrorTable:
    nobody = np.full(len(rows), NOBODY, np.int64)
    missed = kind is ErrorKind.MISS
    return ErrorTable(
        kind=np.full(len(rows), kind, np.uint8),
        frame=rows.frame,
        truth=rows.track if missed else nobody,
        result=nobody if missed else rows.track,
        earlier=nobody,
        earlier_frame=rows.frame,
        position=rows.position,
        box=rows.box,
    )


def _of_successions(
    examination: Examination, follow: Successions, kind: ErrorKind, kept: Flags
) -> ErrorTable:
    truth, result = examination.comparison.truth, examination.comparison.result
    rows = examination.matched.rows
    now, then = follow.after[kept], follow.before[kept]
    person, track = rows.truth[now], rows.result[now]
    return ErrorTable(
        kind=np.full(len(now), kind, np.uint8),
        frame=truth.frame[person],
        truth=truth.track[person],
        result=result.track[track],
        earlier=result.track[rows.result[then]],
        earlier_frame=truth.frame[rows.truth[then]],
        position=_known(truth.position[person], result.position[track]),
        box=_known(truth.box[person], result.box[track]),
    )


def _known(first: Floats, second: Floats) -> Floats:
    """The first where it is known, else the second."""
    return np.where(np.isnan(first), second, first)


def _joined(parts: list[ErrorTable]) -> ErrorTable:
    names = [field.name for field in fields(ErrorTable)]
    columns = {name: np.concatenate([getattr(one, name) for one in parts]) for name in names}
    return ErrorTable(**columns)
