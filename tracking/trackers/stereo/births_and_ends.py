"""Track initiation, confirmation and deletion."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import scatter
from tracking.geometry import View
from tracking.people import Detections
from tracking.trackers.stereo.boxes import Bodies, expected_visibility, share_in_view
from tracking.trackers.stereo.population import (
    Population,
    unknown_appearance,
    unknown_motion,
)
from tracking.trackers.stereo.settings import StereoFilterSettings, StereoTrackerSettings

Floats = NDArray[np.float64]

TENTATIVE_PATIENCE_S = 0.15
"""How long a tentative track may go unseen before it is deleted as noise."""
_AT_THE_EDGE = 0.75
OUT_OF_VIEW = 0.35
"""Share of a body inside the picture below which somebody not seen has left it."""


@dataclass(frozen=True, slots=True)
class BirthCandidates:
    """Detections at which tracks may be initiated.

    Attributes:
        seen: all detections. colours: (detections, cues, bins) of all.
        free: those not associated with any track.
    """

    seen: Detections
    colours: NDArray[np.float32]
    free: NDArray[np.intp]


def initiate_tracks(
    people: Population,
    spots: BirthCandidates,
    settings: StereoFilterSettings,
    random: np.random.Generator,
    view: View,
) -> Population:
    """Tentative tracks at the detections not associated with any ([Kawashita2012] step 1).

    Args:
        people: those followed, with their positions in this frame; a detection close to one that
            was seen in it is another piece of the same body and starts nobody.
        spots: where somebody may be.
    """
    seen, free = spots.seen, spots.free
    if len(free) == 0:
        return people.select(free)
    present = people.position[people.missed_s == 0.0]
    offset = seen.position[free, None, :2] - present[None, :, :]
    nearest = np.hypot(offset[..., 0], offset[..., 1]).min(axis=1, initial=np.inf)
    rows = free[nearest >= settings.birth_distance_m]
    return start_tracks(replace(spots, free=rows), settings, random, view)


def start_tracks(
    spots: BirthCandidates, settings: StereoFilterSettings, random: np.random.Generator, view: View
) -> Population:
    """A person at each free detection, seen once, without an id yet."""
    seen, rows = spots.seen, spots.free
    count = len(rows)
    measured = seen.position[rows, :2]
    spread = np.full(count, settings.initial_spread_m)
    return Population(
        track=np.zeros(count, np.int32),
        particles=scatter(measured, spread, settings.particles, random),
        weight=np.full((count, settings.particles), 1.0 / settings.particles, np.float32),
        position=measured,
        velocity=np.zeros((count, 2)),
        matches=np.ones(count, np.int32),
        missed_s=np.zeros(count),
        seen_at=measured,
        colour=spots.colours[rows],
        anchors=np.stack((np.full((count, 2), np.nan), measured), axis=1),
        anchor_age_s=np.zeros(count),
        outline=Bodies.at(measured, view).outlines(seen.box[rows]),
        confidence=np.full(count, 0.5),
        appearance=unknown_appearance(count),
        motion=unknown_motion(spread),
    )


def confirm_tracks(people: Population, matches: int, last_id: int) -> tuple[Population, int]:
    """Tentative tracks matched often enough get the next ids, so that ids have no gaps.

    Returns the people and the last id given.
    """
    ready = np.flatnonzero((people.track == 0) & (people.matches >= matches))
    ids = np.arange(last_id + 1, last_id + 1 + len(ready), dtype=np.int32)
    return people.with_rows(ready, track=ids), last_id + len(ready)


def should_keep(
    people: Population, box: Floats, settings: StereoTrackerSettings, size: tuple[int, int]
) -> NDArray[np.bool_]:
    """Whether each track is kept or deleted: (people,).

    Args:
        box: (people, 4) px of their bodies. size: width and height of the picture.
    """
    inside = share_in_view(box, size)
    patience_s = np.where(inside < _AT_THE_EDGE, settings.delete_at_edge_s, settings.delete_after_s)
    hidden = expected_visibility(people, box, size) < settings.min_visibility * inside
    patience_s = np.where(hidden, settings.delete_occluded_s, patience_s)
    patience_s = np.where(people.confirmed, patience_s, TENTATIVE_PATIENCE_S)
    left = inside < OUT_OF_VIEW
    return np.asarray((people.missed_s == 0.0) | ((people.missed_s <= patience_s) & ~left))
