"""Looks through one block of frames."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracking.arrays import Floats
from tracking.review.core.evidence import Rows, body_px, boxes, evidence_of
from tracking.review.core.material import REACH_M, Material, extent_of_boxes
from tracking.review.footage import AROUND_S, Footage
from tracking.review.hazard.expected_errors import Hazards
from tracking.review.likelihood import LEAST_WEIGHT, WEIGHTS, likelihoods
from tracking.review.made_by_hand import made_by_hand
from tracking.review.reason_groups import Places, Reasons, join_places, stack_findings
from tracking.review.reason_phrases import fix
from tracking.review.reason_texts import Speaker
from tracking.review.reasons import REASONS
from tracking.review.review_item import ReviewItem
from tracking.review.stretches import stretches
from tracking.tracks import Occluder, Run
from tracking.tracks.run_rows import run_within

JOINED_S = 0.75
"""Reasons about the same people so near in time are one review item."""
_LEAST = 0.01
"""Less likely review items are not mentioned."""


@dataclass(frozen=True, slots=True)
class Scene:
    """What counts for all blocks.

    Attributes:
        fps: frames a second. stop: one past the last frame.
        size: of the picture in px; of what the boxes reach where no camera is known.
        usual_px: see `tracking.review.core.evidence.body_px`.
        hand_made: what a person made is flagged, too.
    """

    fps: float
    stop: int
    size: tuple[float, float]
    usual_px: int
    occluders: tuple[Occluder, ...]
    hand_made: bool = False

    @classmethod
    def of(
        cls,
        footage: Footage,
        run: Run | None,
        fps: float,
        size: tuple[float, float] | None,
        occluders: tuple[Occluder, ...],
        *,
        hand_made: bool = False,
    ) -> Scene:
        """size: of the picture in px, None where it is not known."""
        columns = footage.columns
        stop = max(int(columns["frame"].max()) + 1, run.frames[1] if run else 0)
        reach = size or extent_of_boxes(boxes(columns))
        return cls(fps, stop, reach, body_px(columns), occluders, hand_made)

    @property
    def around(self) -> int:
        """How many frames before and after a block can tell about it."""
        return round(AROUND_S * self.fps)


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """What was found in a block, a row each.

    Attributes:
        items: their cost, which depends on rows far away, is written in later. frame,
            likelihood: (k,) of these. tracks: (k, 2) whom they are about, 0 for nobody else.
        meeting: (m,) keys of the block's rows that are near somebody, see `costs`.
    """

    items: list[ReviewItem]
    frame: Rows
    likelihood: Floats
    tracks: Rows
    meeting: Rows

    def with_cost(self, row: int, cost: float) -> ReviewItem:
        """One of the review items; most cost what they did when they were asked for last."""
        if self.items[row].cost != cost:
            self.items[row] = replace(self.items[row], cost=cost)
        return self.items[row]


def search_block(
    footage: Footage, rows: Rows, run: Run | None, scene: Scene, start: int, end: int
) -> Block:
    """Look through a half-open range of frames; rows: those in it and around it."""
    columns = {name: column[rows] for name, column in footage.columns.items()}
    noticed = run_within(run, start - scene.around, end + scene.around)
    evidence = evidence_of(columns, noticed, scene.fps, scene.stop, scene.usual_px)
    material = Material.of(evidence, scene.size, scene.occluders)
    inside = (evidence.frame >= start) & (evidence.frame < end)
    meeting = evidence.key[inside & (material.near.nearest_m < REACH_M)]
    return _told(material, meeting, start, end, hand_made=scene.hand_made)


def _told(material: Material, meeting: Rows, start: int, end: int, *, hand_made: bool) -> Block:
    """The review items whose frame lies in the range."""
    evidence = material.evidence
    found = [look(material) for look in REASONS.values()]
    reasons = stack_findings(found, [max(WEIGHTS[each.kind], LEAST_WEIGHT) for each in found])
    places = join_places(reasons, evidence.frames_of(JOINED_S))
    watched = stretches(reasons, places, Hazards.of(material))
    likely = likelihoods(reasons.kinds, places.strength, watched.expected)
    frame = watched.frame
    told = np.flatnonzero((likely >= _LEAST) & (frame >= start) & (frame < end))
    tracks = _tracks_of(reasons, places, told)
    if not hand_made:
        made = made_by_hand(evidence, tracks, watched.start[told], watched.end[told])
        told, tracks = told[~made], tracks[~made]
    leader = places.leader[told]
    columns = (leader, frame[told], watched.start[told], watched.end[told], likely[told])
    figures = (column.tolist() for column in columns)
    speaker = Speaker.of(reasons, places, evidence.fps, on_floor=evidence.on_floor)
    items = [
        _review_item(speaker, place, *numbers)
        for place, *numbers in zip(told.tolist(), *figures, strict=True)
    ]
    return Block(items, frame[told], likely[told], tracks, meeting)


def _tracks_of(reasons: Reasons, places: Places, told: Rows) -> Rows:
    """(k, 2) whom places are about, 0 for nobody else."""
    leader = places.leader[told]
    return np.stack((reasons.first[leader], reasons.second[leader]), axis=1)


def _review_item(
    speaker: Speaker, place: int, leader: int, frame: int, start: int, end: int, likelihood: float
) -> ReviewItem:
    kind, (first, second) = speaker.kind(leader), speaker.tracks(leader)
    text, *others = speaker.describe(place, leader, frame)
    return ReviewItem(
        kind=kind,
        tracks=(min(first, second), max(first, second)) if second else (first,),
        frame=frame,
        start=start,
        end=end,
        likelihood=likelihood,
        cost=0.0,
        text=text,
        fix=fix(kind, second),
        others=tuple(others),
    )
