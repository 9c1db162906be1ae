"""Many recordings scored one by one and together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tracking.scoring.combining import combined
from tracking.scoring.conventions import Conventions
from tracking.scoring.matching import Match
from tracking.scoring.score import Score, score
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True, eq=False)
class SequenceScores:
    """A table of scores as TrackEval prints it.

    Attributes:
        scores: by the names of the recordings, sorted.
        combined: over all of them.
    """

    scores: Mapping[str, Score]
    combined: Score


def score_sequences(
    pairs: Mapping[str, tuple[ScoringTable, ScoringTable]],
    match: Match | None = None,
    frames: Mapping[str, int] | None = None,
    conventions: Conventions = Conventions.TRACKEVAL,
) -> SequenceScores:
    """Score each recording, and all of them combined.

    Args:
        pairs: truth and result by the name of the recording; at least one.
        match, conventions: as for `score`.
        frames: lengths of the recordings, as far as they are known.

    Raises:
        FormatError: a side has nothing to be matched by.
        SettingsError: there is no recording.
    """
    lengths = frames or {}
    scores = {
        name: score(truth, result, match, lengths.get(name, 0), conventions)
        for name, (truth, result) in sorted(pairs.items())
    }
    return SequenceScores(scores, combined(list(scores.values())))
