"""Accuracy of tracks against truth."""

from tracking.scoring.agreement import Agreement, agreement
from tracking.scoring.clear import Clear
from tracking.scoring.disagreements import Disagreement
from tracking.scoring.either import EitherMatch
from tracking.scoring.hota import ALPHAS, Hota
from tracking.scoring.identity import Identity
from tracking.scoring.identity_errors import IdentityError, identity_errors
from tracking.scoring.kappa import cohen_kappa
from tracking.scoring.matching import BoxMatch, FloorMatch, Match
from tracking.scoring.papers import People, PositionError
from tracking.scoring.score import Score, score
from tracking.scoring.table import ScoringTable

__all__ = [
    "ALPHAS",
    "Agreement",
    "BoxMatch",
    "Clear",
    "Disagreement",
    "EitherMatch",
    "FloorMatch",
    "Hota",
    "Identity",
    "IdentityError",
    "Match",
    "People",
    "PositionError",
    "Score",
    "ScoringTable",
    "agreement",
    "cohen_kappa",
    "identity_errors",
    "score",
]
