"""Accuracy of tracks against truth."""

from tracking.scoring.clear import Clear
from tracking.scoring.hota import ALPHAS, Hota
from tracking.scoring.identity import Identity
from tracking.scoring.matching import BoxMatch, FloorMatch, Match
from tracking.scoring.papers import People, PositionError
from tracking.scoring.score import Score, score
from tracking.scoring.table import ScoringTable

__all__ = [
    "ALPHAS",
    "BoxMatch",
    "Clear",
    "FloorMatch",
    "Hota",
    "Identity",
    "Match",
    "People",
    "PositionError",
    "Score",
    "ScoringTable",
    "score",
]
