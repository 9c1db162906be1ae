"""Track initiation: tentative tracks at detections without one, and their confirmation."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import scatter
from tracking.geometry import View
from tracking.trackers.shared.tracker_base import TrackIds
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.population import (
    Population,
    unknown_appearance,
    unknown_motion,
)
from tracking.trackers.stereo.settings import StereoFilterSettings
from tracking.trackers.stereo.stage_values import MeasuredFrame


def initiate_tracks(
    people: Population,
    frame: MeasuredFrame,
    free: NDArray[np.intp],
    settings: StereoFilterSettings,
    random: np.random.Generator,
    view: View,
) -> Population:
    """Tentative tracks at the detections not associated with any ([Kawashita2012] step 1).

    Args:
        people: those followed, with their positions in this frame; a detection close to one that
            was seen in it is another piece of the same body and starts nobody.
        free: rows of these detections.
    """
    if len(free) == 0:
        return people.select(free)
    present = people.position[people.missed_s == 0.0]
    offset = frame.places[free, None] - present[None, :, :]
    nearest = np.hypot(offset[..., 0], offset[..., 1]).min(axis=1, initial=np.inf)
    return start_tracks(frame, free[nearest >= settings.birth_distance_m], settings, random, view)


def start_tracks(
    frame: MeasuredFrame,
    rows: NDArray[np.intp],
    settings: StereoFilterSettings,
    random: np.random.Generator,
    view: View,
) -> Population:
    """A person at each of these detections, seen once, without an id yet."""
    count = len(rows)
    measured = frame.places[rows]
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
        colour=frame.colours[rows],
        anchors=np.stack((np.full((count, 2), np.nan), measured), axis=1),
        anchor_age_s=np.zeros(count),
        outline=Bodies.at(measured, view).outlines(frame.seen.box[rows]),
        confidence=np.full(count, 0.5),
        appearance=unknown_appearance(count),
        motion=unknown_motion(spread),
    )


def confirm_tracks(people: Population, matches: int, ids: TrackIds) -> Population:
    """The people, tentative tracks matched often enough with the next ids."""
    ready = np.flatnonzero((people.track == 0) & (people.matches >= matches))
    return people.with_rows(ready, track=ids.take(len(ready)))
