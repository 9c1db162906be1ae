"""Accuracy of tracks against truth."""

from tracking.scoring.agreement import Agreement, agreement, stretch_gap
from tracking.scoring.clear import Clear
from tracking.scoring.combined_scores import combined
from tracking.scoring.conventions import Conventions
from tracking.scoring.disagreements import Disagreement
from tracking.scoring.either import EitherMatch
from tracking.scoring.errors import NOBODY, ErrorKind, ErrorTable, errors, errors_of
from tracking.scoring.examination import Examination, examine
from tracking.scoring.hota import ALPHAS, CURVES, Hota
from tracking.scoring.identity import Identity
from tracking.scoring.identity_errors import IdentityError, identity_errors
from tracking.scoring.kappa import cohen_kappa
from tracking.scoring.papers import People, PositionError
from tracking.scoring.passages import PassageScore
from tracking.scoring.per_distance import DistanceScore, check_distances, per_distance_of
from tracking.scoring.per_person import Followed, PersonScore, per_person, per_person_of
from tracking.scoring.score import FIGURES, Score, score, score_of
from tracking.scoring.similarity import BoxMatch, FloorMatch, Match
from tracking.scoring.table import ScoringTable
from tracking.scoring.track_map import OVERLAPS, SUBSETS, TrackMap
