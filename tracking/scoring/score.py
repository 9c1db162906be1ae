"""All measures of a result against truth, in one value."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from tracking.scoring.clear import Clear
from tracking.scoring.clear_counting import clear
from tracking.scoring.conventions import Conventions
from tracking.scoring.examination import Examination, examine
from tracking.scoring.figures import figures_of, lines_of
from tracking.scoring.hota import Hota
from tracking.scoring.hota_counting import hota
from tracking.scoring.identity import Identity, identity
from tracking.scoring.papers import People, PositionError, people
from tracking.scoring.passages import PassageScore
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable
from tracking.scoring.track_map import TrackMap
from tracking.scoring.track_map_matching import track_map


@dataclass(frozen=True, slots=True, eq=False)
class Score:
    """How good a result is. Shares are 0 to 1.

    Attributes:
        frames: length of the recording, as far as it is known.
        truth_people: people in the truth. result_tracks: tracks in the result.
        track_map: None where the result has no confidences or rows were not matched by boxes.
        passages: of counting lines, where there are any; see `PassageScore`.
    """

    frames: int
    truth_people: int
    result_tracks: int
    clear: Clear
    identity: Identity
    hota: Hota
    people: People
    position_error: PositionError
    track_map: TrackMap | None = None
    passages: tuple[PassageScore, ...] = ()

    @property
    def tracking_accuracy(self) -> float:
        """People kept / people detected, the papers' measure; NaN when nobody is detected."""
        return self.people.kept / self.people.detected if self.people.detected else math.nan

    def as_json(self) -> dict[str, Any]:
        """The numbers by the names `score --json` has; None where a number is undefined."""
        return figures_of(self)

    def as_text(self) -> str:
        """A table for people, without colours."""
        return lines_of(self)


def score(
    truth: ScoringTable,
    result: ScoringTable,
    match: Match | None = None,
    frames: int = 0,
    conventions: Conventions = Conventions.TRACKEVAL,
) -> Score:
    """Measure a result against truth.

    `MOTA`, `IDF1`, `HOTA` and what belongs to them are counted as TrackEval counts a sequence of
    MOTChallenge, also where a side is empty (0; `LocA` 1).

    Args:
        truth: its rows with `counted` False are don't-cares: a result row that matches one is
            dropped, and they are no misses. (As py-motmetrics has it they only are no misses.)
        result: all rows count.
        match: boxes at an overlap of one half when left out.
        frames: length of the recording, if it is known to be longer than the tracks.
        conventions: whose definitions of CLEAR.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    return score_of(examine(truth, result, match, frames, conventions))


def score_of(examination: Examination) -> Score:
    """The measures of what was compared."""
    comparison, matched = examination.comparison, examination.matched
    return Score(
        frames=examination.frames,
        truth_people=comparison.people,
        result_tracks=comparison.identities,
        clear=replace(
            clear(comparison, matched, examination.frames, examination.conventions),
            unit=examination.unit,
        ),
        identity=identity(comparison, examination.admitted),
        hota=hota(comparison),
        people=people(comparison, matched),
        position_error=PositionError.of(examination.distances_m),
        track_map=track_map(examination),
    )
