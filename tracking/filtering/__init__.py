"""The particle filter, batched over people, and smoothers for what it found.

The particles of all people stand in one array (people, N, 2) of metres on the floor, with their
weights (people, N) beside it. Nothing here loops over particles or people.
"""

from tracking.filtering.association import Association, associate, margins
from tracking.filtering.clouds import cloud_shapes
from tracking.filtering.direction import direction_cost, turning_angle
from tracking.filtering.hiding import hiding_reach, out_of_hiding
from tracking.filtering.histograms import bhattacharyya_distance
from tracking.filtering.particles import (
    effective_share,
    likelihood,
    move,
    resample,
    scatter,
    weigh,
    weighted_mean,
)
from tracking.filtering.smoothing import (
    Chains,
    robust_levels,
    robust_paths,
    slopes,
    smooth_levels,
    smooth_paths,
    trust,
)

__all__ = [
    "Association",
    "Chains",
    "associate",
    "bhattacharyya_distance",
    "cloud_shapes",
    "direction_cost",
    "effective_share",
    "hiding_reach",
    "likelihood",
    "margins",
    "move",
    "out_of_hiding",
    "resample",
    "robust_levels",
    "robust_paths",
    "scatter",
    "slopes",
    "smooth_levels",
    "smooth_paths",
    "trust",
    "turning_angle",
    "weigh",
    "weighted_mean",
]
