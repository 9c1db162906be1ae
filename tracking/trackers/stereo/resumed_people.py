"""The people a stereo tracker goes on with: as corrected, in the colours the footage shows."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import associate, scatter
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.shared.corrected_rows import (
    LED_ON_S,
    is_apart,
    is_seen,
    last_rows,
    only,
    place_on_floor,
    slopes,
)
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.cues import Cues
from tracking.trackers.stereo.population import (
    Population,
    unknown_appearance,
    unknown_motion,
)
from tracking.trackers.stereo.settings import StereoFilterSettings
from tracking.tracks.boxes import overlaps
from tracking.tracks.columns import Columns, boxes_of, places_of

Floats = NDArray[np.float64]
Colours = NDArray[np.float32]
Indices = NDArray[np.intp]

_NEAR_M = 0.6
_OVERLAP = 0.5
"""A detection this near to a row, or overlapping it so much, shows the row's person."""
_LEFT_OUT = 10.0
"""More than any pair costs."""
_CROWDED = 0.1
_CUT_OFF = 0.5
"""What a view is worth among others, and one that the picture's edge cuts."""
_GOOD = 0.5
"""Views worth less than this share of a person's best one are left out."""
_WALK_S = 2.0
_WIDER_PER_S = 1.0
"""How much the particles of somebody missed spread with each second."""


@dataclass(frozen=True, slots=True)
class Views:
    """What was seen of the people who are followed on.

    Attributes:
        person: (n,) their number. colour: (n, cues, bins). worth: (n,) 0 to 1.
        usual: (cues, bins) the mean of all detections, whoever they are.
    """

    person: Indices
    colour: Colours
    worth: Floats
    usual: Colours


def resume_people(
    resume: Resume,
    observations: Iterable[Observation],
    view: View,
    settings: StereoFilterSettings,
    cues: Cues,
    random: np.random.Generator,
) -> tuple[Population, float]:
    """Everybody to be followed on, and the seconds at which they stand so.

    Places, velocities and outlines are those of the corrected rows; colours are learnt from
    detections that lie where the rows do, from good views where there are any. Somebody hidden is
    started where the rows say, as one who was missed.

    Args:
        observations: of the frames `resume.colour_frames`, in order.
    """
    rows = place_on_floor(resume.rows, view)
    people = np.unique(rows["track"])
    views, time_s = _collect_views(rows, people, observations, cues)
    population = _resumable(rows, people, views, resume, view, settings, random)
    return _replay_anchors(population, rows, resume, cues), time_s


def _resumable(
    rows: Columns,
    people: NDArray[np.int32],
    views: Views,
    resume: Resume,
    view: View,
    settings: StereoFilterSettings,
    random: np.random.Generator,
) -> Population:
    """The people (n,), ids, where their rows say, before any direction is known."""
    colour, matches = _colours(views, len(people))
    position, velocity, missed_s, confidence = _now(rows, people, resume, settings)
    spread = settings.initial_spread_m * (1.0 + _WIDER_PER_S * missed_s)
    count = (len(people), settings.particles)
    return Population(
        track=people.astype(np.int32),
        particles=scatter(position, spread, settings.particles, random),
        weight=np.full(count, 1.0 / settings.particles, np.float32),
        position=position,
        velocity=velocity,
        matches=matches,
        missed_s=missed_s,
        seen_at=position,
        colour=colour,
        anchors=np.full((len(people), 2, 2), np.nan),
        anchor_age_s=np.zeros(len(people)),
        outline=_outlines(rows, people, view),
        confidence=confidence,
        appearance=unknown_appearance(len(people)),
        motion=unknown_motion(spread),
    )


def _collect_views(
    rows: Columns, people: NDArray[np.int32], observations: Iterable[Observation], cues: Cues
) -> tuple[Views, float]:
    worth = is_seen(rows) * np.nan_to_num(rows["visibility"]).astype(np.float64)
    worth *= np.where(is_apart(rows), 1.0, _CROWDED)
    person, colour, value, everybody = [], [], [], []
    time_s = 0.0
    for observation in observations:
        seen, time_s = observation.people, observation.time_s
        colours = cues.measure_colours(seen)
        here = np.flatnonzero((rows["frame"] == observation.frame) & (worth > 0.0))
        row, detection = _match_rows(only(rows, here), seen)
        person.append(np.searchsorted(people, rows["track"][here[row]]))
        colour.append(colours[detection])
        value.append(worth[here[row]] * np.where(seen.truncated[detection], _CUT_OFF, 1.0))
        everybody.append(colours)
    usual = _mean(np.concatenate(everybody))
    together = np.concatenate(person), np.concatenate(colour)
    return Views(*together, np.concatenate(value), usual), time_s


def _match_rows(rows: Columns, seen: Detections) -> tuple[Indices, Indices]:
    """Rows of a frame and the detections that lie where they do."""
    offset = places_of(rows)[:, None] - seen.position[None, :, :2]
    away_m = np.hypot(offset[..., 0], offset[..., 1])
    shared = overlaps(boxes_of(rows)[:, None], seen.box[None])
    near = ((away_m <= _NEAR_M) | (shared >= _OVERLAP)) & ~seen.merged
    pairs = associate(away_m + 1.0 - shared, near, _LEFT_OUT)
    return pairs.track, pairs.detection


def _mean(colours: Colours) -> Colours:
    """(cues, bins) of (n, cues, bins); all alike where nobody was seen."""
    if len(colours):
        return np.asarray(colours.mean(axis=0))
    return np.full(colours.shape[1:], 1.0 / colours.shape[2], np.float32)


def _colours(views: Views, people: int) -> tuple[Colours, NDArray[np.int32]]:
    """Everybody's colour model and how many views it is made of.

    Of whom nothing was seen the model is the usual one, which the first match mostly replaces.
    """
    best = np.zeros(people)
    np.maximum.at(best, views.person, views.worth)
    worth = np.where(views.worth >= _GOOD * best[views.person], views.worth, 0.0)
    total = np.bincount(views.person, worth, people)
    count = np.bincount(views.person, worth > 0.0, people)
    colour = np.zeros((people, *views.usual.shape))
    np.add.at(colour, views.person, worth[:, None, None] * views.colour)
    colour /= np.maximum(total, 1e-12)[:, None, None]
    known = (count > 0)[:, None, None]
    matches = np.maximum(count, 1).astype(np.int32)
    return np.where(known, colour, views.usual).astype(np.float32), matches


def _now(
    rows: Columns, people: NDArray[np.int32], resume: Resume, settings: StereoFilterSettings
) -> tuple[Floats, Floats, Floats, Floats]:
    """Position, velocity, seconds missed and confidence in the frame before the first one."""
    last = last_rows(rows, people)
    seen = last_rows(rows, people, is_seen(rows))
    now = resume.frame - 1
    unknown_s = (now - rows["frame"][last]) / resume.fps
    missed_s = np.where(seen < 0, settings.unseen_limit_s, (now - rows["frame"][seen]) / resume.fps)
    # A row in the last frame says where the person is, however long nobody has seen them.
    stands = unknown_s == 0.0
    missed_s = np.where(stands, np.minimum(missed_s, settings.unseen_limit_s / 2), missed_s)
    velocity = np.column_stack((rows["vx"][last], rows["vy"][last]))
    known = np.isfinite(velocity).all(axis=1)
    walked = slopes(rows, places_of(rows), people, resume.frame, resume.fps)
    velocity = np.where(known[:, None], velocity, walked)
    position = places_of(rows, last)
    position += velocity * np.minimum(unknown_s, LED_ON_S)[:, None]
    return position, velocity, missed_s, rows["confidence"][last].astype(np.float64)


def _outlines(rows: Columns, people: NDArray[np.int32], view: View) -> Floats:
    """(people, 4) the mean of the outlines of all rows, by how much of the person they show."""
    outline = Bodies.at(places_of(rows), view).outlines(boxes_of(rows))
    weight = 1e-3 + is_seen(rows) * np.nan_to_num(rows["visibility"]).astype(np.float64) ** 2
    weight[~np.isfinite(outline).all(axis=1)] = 0.0
    number = np.searchsorted(people, rows["track"])
    total = np.maximum(np.bincount(number, weight, len(people)), 1e-12)
    sides = [np.bincount(number, weight * np.nan_to_num(side), len(people)) for side in outline.T]
    return np.column_stack(sides) / total[:, None]


def _replay_anchors(people: Population, rows: Columns, resume: Resume, cues: Cues) -> Population:
    """The people with the anchors of their last rows, replayed frame by frame."""
    late = only(rows, rows["frame"] >= resume.frame - round(_WALK_S * resume.fps))
    number = np.searchsorted(people.track, late["track"])
    place = places_of(late)
    first = np.full((len(people), 2), np.nan)
    first[number[::-1]] = place[::-1]
    first = np.where(np.isfinite(first), first, people.position)
    anchors = np.stack((np.full_like(first, np.nan), first), axis=1)
    then = people.replace(position=first, missed_s=np.zeros(len(people)), anchors=anchors)
    for frame in np.unique(late["frame"]):
        here = late["frame"] == frame
        then = then.with_rows(number[here], position=place[here])
        then = cues.update_anchors(then, 1.0 / resume.fps)
    return people.replace(anchors=then.anchors, anchor_age_s=then.anchor_age_s)
