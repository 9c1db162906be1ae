"""How many people are still tracked rightly, part by part, so many frames after their start."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.scoring.parts.part_verdicts import Judged
from tracking.scoring.parts.rectangles import Bools
from tracking.text_columns import to_left, to_right
from tracking.tracks import PART_WORDS, PARTS
from tracking.translation import Message, msg, tr

SUBJECTS = (*PART_WORDS, "person")
LAST_FRAME = 150
TOLD_FRAMES = (50, 105)
"""After so many frames people are told the rates: [ZhaoLee2009] gives those of frame 105."""


@dataclass(frozen=True, slots=True, eq=False)
class Rates:
    """Rates by frames since a person's start; row i is frame i, columns are `SUBJECTS`.

    Attributes:
        judged: people who are judged. untracked: those of them on whom no track ever began.
        people: (k,) how many people are in view for so long.
        right: (k, 4) share of them that is right in that frame: the paper's curves, which rise
            again where a part comes back and where people leave.
        unbroken: (k, 4) share of them that was right in every frame until then.
        overall: (4,) share of all frames of all people that is right; NaN where there are none.
        foreign: (3,) mean share of each part's rectangles that holds something else; likewise.
    """

    judged: int
    untracked: int
    people: NDArray[np.int64]
    right: Floats
    unbroken: Floats
    overall: Floats
    foreign: Floats

    def as_json(self) -> dict[str, Any]:
        """What `score --json` has under "parts"; curves end where nobody is in view any longer."""
        length = int(np.count_nonzero(self.people))
        table = {
            subject: {
                "right": _defined(self.overall[column]),
                "right_from_start": self.right[:length, column].tolist(),
                "unbroken_from_start": self.unbroken[:length, column].tolist(),
            }
            for column, subject in enumerate(SUBJECTS)
        }
        for part, share in zip(PART_WORDS, self.foreign.tolist(), strict=True):
            table[part]["foreign"] = _defined(share)
        people = self.people[:length].tolist()
        return {
            "people_judged": self.judged,
            "people_untracked": self.untracked,
            "people_from_start": people,
            **table,
        }

    def as_text(self) -> str:
        """A table for people: a column for each of `SUBJECTS`, and how many it is about."""
        lines = [
            _line(
                msg("body parts"), [tr(name.replace("_", "-")) for name in SUBJECTS], tr("people")
            )
        ]
        lines.append(_line(msg("right, of all frames"), _percent(self.overall), str(self.judged)))
        for frame in TOLD_FRAMES:
            if frame < len(self.people) and self.people[frame]:
                count = str(self.people[frame])
                lines.append(
                    _line(
                        msg("right after {n} frames", n=frame), _percent(self.right[frame]), count
                    )
                )
                lines.append(
                    _line(
                        msg("right for all {n} frames", n=frame),
                        _percent(self.unbroken[frame]),
                        count,
                    )
                )
        lines.append(_line(msg("holding something else"), [*_percent(self.foreign), ""], ""))
        if self.untracked:
            lines.append(tr("no track began on {n} of them", n=self.untracked))
        return "\n".join(line.rstrip() for line in lines)


def rates_of(judged: Sequence[Judged], last: int = LAST_FRAME) -> Rates:
    """The curves of all people, to so many frames after their start."""
    people = np.zeros(last + 1, np.int64)
    right, unbroken = np.zeros((2, last + 1, len(SUBJECTS)))
    for person in judged:
        good = _good(person)[: last + 1]
        people[: len(good)] += 1
        right[: len(good)] += good
        unbroken[: len(good)] += np.logical_and.accumulate(good, axis=0)
    share = np.maximum(people, 1)[:, None]
    everything = np.concatenate([np.zeros((0, len(SUBJECTS)), bool), *map(_good, judged)])
    return Rates(
        len(judged),
        sum(one.track == 0 for one in judged),
        people,
        right / share,
        unbroken / share,
        _mean(everything.astype(np.float64), len(SUBJECTS)),
        _mean(
            np.concatenate([np.zeros((0, PARTS)), *(one.foreign for one in judged)]),
            PARTS,
        ),
    )


def margin(share: float, people: int) -> float:
    """Half the width of Wilson's 95 % interval of a share of so many people."""
    z = 1.96
    spread = np.sqrt(share * (1 - share) / people + z**2 / (4 * people**2))
    return float(z * spread / (1 + z**2 / people))


def _mean(values: Floats, columns: int) -> Floats:
    """(columns,) the mean of all known values; NaN where there are none."""
    there = np.isfinite(values)
    total, count = np.where(there, values, 0.0).sum(axis=0), there.sum(axis=0)
    return np.asarray(np.where(count, total / np.maximum(count, 1), np.nan)).reshape(columns)


def _good(person: Judged) -> Bools:
    return np.column_stack((person.parts, person.person_right))


def _defined(value: float) -> float | None:
    return None if math.isnan(value) else float(value)


def _percent(shares: Floats) -> list[str]:
    return ["-" if math.isnan(share) else f"{100 * share:.1f} %" for share in shares.tolist()]


def _line(name: Message, cells: Sequence[str], people: str) -> str:
    return (
        to_left(tr(name), 24) + "".join(to_right(cell, 9) for cell in cells) + to_right(people, 8)
    )
