"""The particle filter, batched over people, and smoothers for what it found.

The particles of all people stand in one array (people, N, 2) of metres on the floor, with their
weights (people, N) beside it. Particles that are rectangles in the picture stand in flat arrays,
as their number differs; see `Clouds`. Nothing here loops over particles or people.
"""

from tracking.filtering.association import (
    Association,
    associate,
    bhattacharyya_distance,
    cheapest_pairs,
    direction_cost,
    margins,
    nearest_first,
    turning_angle,
)
from tracking.filtering.clouds import cloud_shapes
from tracking.filtering.occlusion import hiding_reach, out_of_hiding
from tracking.filtering.particles import (
    effective_share,
    likelihood,
    move,
    resample,
    scatter,
    weigh,
    weighted_mean,
)
from tracking.filtering.rectangles import (
    Clouds,
    drifted,
    entropies,
    joined_clouds,
    mean_states,
    no_clouds,
    particle_counts,
    redrawn,
    restarted,
    scattered,
    weighed_by,
)
from tracking.filtering.track_smoother import (
    Chains,
    robust_levels,
    robust_paths,
    slopes,
    smooth_levels,
    smooth_paths,
    trust,
)
