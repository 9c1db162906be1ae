"""The reasons to look somewhere: each a small pure function in a module of its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from tracking.review.core.findings import FlaggedPlaces
from tracking.review.core.material import Material
from tracking.review.reasons.colours import colour_changes, height_changes
from tracking.review.reasons.crossings import crossings
from tracking.review.reasons.ends import beginnings, endings, lost_and_found
from tracking.review.reasons.exchanges import exchanges
from tracking.review.reasons.jumps import jumps
from tracking.review.reasons.margins import small_margins
from tracking.review.reasons.particles import split_particles, spread_particles
from tracking.review.reasons.parts import failed_parts
from tracking.review.reasons.predictions import drifts, long_predictions
from tracking.review.reasons.reversals import reversals
from tracking.review.reasons.shared_detections import shared_regions
from tracking.review.reasons.turns import turns

REASONS: Mapping[str, Callable[[Material], FlaggedPlaces]] = MappingProxyType(
    {
        "exchange": exchanges,
        "turn": turns,
        "crossing": crossings,
        "shared": shared_regions,
        "lost": lost_and_found,
        "ended": endings,
        "begun": beginnings,
        "colour": colour_changes,
        "height": height_changes,
        "jump": jumps,
        "reversal": reversals,
        "predicted": long_predictions,
        "drift": drifts,
        "margin": small_margins,
        "spread": spread_particles,
        "split": split_particles,
        "part": failed_parts,
    }
)
"""By the kind of review item they make."""
