"""How likely a track goes wrong in each of its rows: orders and places review items."""

from tracking.review.hazard.expected_errors import Hazards, corrected_by
from tracking.review.hazard.features import FEATURES, NOTICED, features
from tracking.review.hazard.picture import picture_features
from tracking.review.hazard.trees import CORRECTED_BY, Trees, built_in_trees
