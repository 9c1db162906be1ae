"""How likely a track goes wrong in each of its rows: orders and places review items."""

from tracking.review.hazard.expected_errors import Hazards
from tracking.review.hazard.features import FEATURES, NOTICED, features
from tracking.review.hazard.trees import Trees, built_in_trees
