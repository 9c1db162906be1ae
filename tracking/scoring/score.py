"""All measures of a result against truth, in one value."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from tracking.scoring.clear import Clear, clear, clear_matches
from tracking.scoring.comparison import compare
from tracking.scoring.hota import Hota, hota
from tracking.scoring.identity import Identity, identity
from tracking.scoring.matching import BoxMatch, Match
from tracking.scoring.papers import People, PositionError, people, position_error
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True)
class Score:
    """How good a result is. Shares are 0 to 1.

    Attributes:
        frames: length of the recording, as far as it is known.
        truth_people: people in the truth.
    """

    frames: int
    truth_people: int
    clear: Clear
    identity: Identity
    hota: Hota
    people: People
    position_error: PositionError

    @property
    def tracking_accuracy(self) -> float:
        """People kept / people detected, the papers' measure; NaN when nobody is detected."""
        return self.people.kept / self.people.detected if self.people.detected else math.nan

    def as_json(self) -> dict[str, Any]:
        """The numbers by the names `score --json` has; None where a number is undefined."""
        error = self.position_error
        return {
            "frames": self.frames,
            "truth_people": self.truth_people,
            "MOTA": self.clear.mota,
            "MOTP": self.clear.motp,
            "IDF1": self.identity.idf1,
            "IDP": self.identity.idp,
            "IDR": self.identity.idr,
            "HOTA": self.hota.hota,
            "DetA": self.hota.deta,
            "AssA": self.hota.assa,
            "LocA": self.hota.loca,
            "id_switches": self.clear.id_switches,
            "fragmentations": self.clear.fragmentations,
            "false_positives": self.clear.false_positives,
            "misses": self.clear.misses,
            "mostly_tracked": self.clear.mostly_tracked,
            "mostly_lost": self.clear.mostly_lost,
            "people_detected": self.people.detected,
            "people_kept": self.people.kept,
            "tracking_accuracy": _defined(self.tracking_accuracy),
            "position_error_m": {
                "mean": _defined(error.mean),
                "std": _defined(error.std),
                "median": _defined(error.median),
                "p95": _defined(error.p95),
            },
        }

    def as_text(self) -> str:
        """A table for people, without colours."""
        table = self.as_json()
        distance = table.pop("position_error_m")
        named = [(name, _shown(value)) for name, value in table.items()]
        named += [
            (f"position error, {name} (m)", _shown(value)) for name, value in distance.items()
        ]
        width = max(len(name) for name, _ in named)
        return "\n".join(f"{name:<{width}}  {value:>9}" for name, value in named)


def score(
    truth: ScoringTable, result: ScoringTable, match: Match | None = None, frames: int = 0
) -> Score:
    """Measure a result against truth.

    `MOTA`, `IDF1`, `HOTA` and what belongs to them are counted as TrackEval counts a sequence of
    MOTChallenge, also where a side is empty (0; `LocA` 1).

    Args:
        truth: its rows with `counted` False are don't-cares: a result row that matches one is
            dropped, and they are no misses.
        result: all rows count.
        match: boxes at an overlap of one half when left out.
        frames: length of the recording, if it is known to be longer than the tracks.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    comparison = compare(truth, result, match or BoxMatch())
    matched = clear_matches(comparison)
    last = max((int(table.frame[-1]) for table in (truth, result) if len(table)), default=-1)
    return Score(
        frames=max(frames, last + 1),
        truth_people=comparison.people,
        clear=clear(comparison, matched),
        identity=identity(comparison),
        hota=hota(comparison),
        people=people(comparison, matched),
        position_error=position_error(comparison, matched),
    )


def _defined(value: float) -> float | None:
    return None if math.isnan(value) else value


def _shown(value: float | None) -> str:
    if value is None:
        return "-"
    return str(value) if isinstance(value, int) else f"{value:.4f}"
