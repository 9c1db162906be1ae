"""Head, torso and hip-leg: where they are in a person's region, and what colours they have."""

from tracking.people.parts.equalisation import (
    bhattacharyya,
    equalisation,
    equalised,
    even_division,
)
from tracking.people.parts.histograms import (
    candidate_histograms,
    level_histograms,
    similarities,
    ycbcr,
)
from tracking.people.parts.lines import decompose
from tracking.people.parts.rectangles import inner_rectangle, inner_rectangles
from tracking.people.parts.regions import PartRegions, around, part_regions
