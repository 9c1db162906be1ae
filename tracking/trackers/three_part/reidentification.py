"""Re-identification of lost people by their colours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import associate
from tracking.people import Detections
from tracking.trackers.shared.gating import WideningGate
from tracking.trackers.three_part.appearance import Levels, measure_levels, resemblance
from tracking.trackers.three_part.initiation import (
    complete_bodies,
    is_all_seen,
    regions_rectangles,
)
from tracking.trackers.three_part.people import Flags, Floats, Indices, Layout, PartPeople

_GATE = WideningGate(at_once=0.6, a_second=1.2)
"""Around the place expected, in body heights."""
_ALIKE = 0.75
"""Mean similarity of the parts from which on a region may be somebody lost."""
_NAT = 0.04
"""Similarity that one nat of an appearance network is worth: at most 0.16 either way."""
_SIZE = (0.6, 1.6)
"""Height of such a region, in heights of the person."""
_BETTER = 0.06
"""By how much more somebody who shares a region must look like themselves elsewhere."""


def reidentify(
    people: PartPeople,
    boxes: Floats,
    lost: Flags,
    sharing: Flags,
    seen: Detections,
    free: Indices,
    picture: NDArray[np.uint8],
    layout: Layout,
    embedded: Floats | None = None,
) -> tuple[Floats, Indices]:
    """Where people who were lost have come up again, each in a region nobody has.

    [ZhaoLee2009] says nothing of it: after an occlusion its person is where motion said. People
    turn and stop behind others, so here they are looked for around that place by the colours they
    had before.

    Args:
        boxes: (people, 4) as expected. lost: (people,) who to look for.
        free: regions.
        embedded: (people, all regions) log-likelihood ratio of an appearance network; None: none.

    Returns:
        (people, parts, 4) the parts of those found, NaN for the others; the regions still free.
    """
    parts = np.full((len(people), layout.parts, 4), np.nan)
    who = np.flatnonzero(lost | sharing)
    if not len(who) or not len(free):
        return parts, free
    rectangles = regions_rectangles(seen, free, picture, layout)
    rectangles = complete_bodies(rectangles, seen, free)
    alike, here = _resemblances(people, who, rectangles, picture)
    if embedded is not None:
        alike = alike + _NAT * embedded[np.ix_(who, free)]
    needed = np.where(sharing[who], np.maximum(here + _BETTER, _ALIKE), _ALIKE)[:, None]
    possible = _near(people, boxes, who, seen, free) & (alike >= needed) & is_all_seen(rectangles)
    # Who gains most goes: of two in a region only one does not belong there.
    pairs = associate(1.0 - alike + needed, possible, 2.0)
    parts[who[pairs.track]] = rectangles[pairs.detection]
    return parts, np.delete(free, pairs.detection)


def _resemblances(
    people: PartPeople, who: Indices, rectangles: Floats, picture: NDArray[np.uint8]
) -> tuple[Floats, Floats]:
    """(lost, regions) how much each looks like a region, and (lost,) like where they are thought.

    Args:
        who: rows of the lost. rectangles: (regions, parts, 4).
    """
    known = people.appearance[who]
    look = measure_levels(picture, np.nan_to_num(rectangles))
    look_here = measure_levels(picture, people.rectangles[who])
    here = resemblance(look_here, known)
    both = _has_colours(look_here) & _has_colours(known)
    return resemblances(look, known), _mean_of(here, both)


def resemblances(look: Levels, known: Levels) -> Floats:
    """(people, regions) how alike looks (regions, parts, 3, 256) and people's (people, ...) are.

    It is the mean over the parts of which both are known; 0 where there is none.
    """
    each = (len(known), *look.shape)
    alike = resemblance(np.broadcast_to(look[None], each), np.broadcast_to(known[:, None], each))
    return _mean_of(alike, _has_colours(look)[None] & _has_colours(known)[:, None])


def _has_colours(levels: Levels) -> Flags:
    """(...) which histograms (..., 3, 256) hold anything: parts out of the picture do not."""
    return np.asarray(levels.sum(axis=(-2, -1)) > 0)


def _mean_of(values: Floats, which: Flags) -> Floats:
    """(...) the mean over the last axis of those meant; 0 of none."""
    return np.asarray((values * which).sum(axis=-1) / np.maximum(which.sum(axis=-1), 1))


def _near(
    people: PartPeople, boxes: Floats, who: Indices, seen: Detections, free: Indices
) -> Flags:
    """(lost, regions) within the gate, and of about the size."""
    height = boxes[who, 3]
    middle = boxes[who, :2] + boxes[who, 2:] / 2
    there = seen.box[free, :2] + seen.box[free, 2:] / 2
    away = np.linalg.norm(middle[:, None] - there[None], axis=2)
    missed_s = np.maximum(people.missed_s, people.hidden_s)[who]
    gate = height * _GATE.radius(missed_s)
    ratio = seen.box[free, 3][None] / np.maximum(height, 1.0)[:, None]
    fits = (ratio > _SIZE[0]) & (ratio < _SIZE[1])
    return np.asarray((away <= gate[:, None]) & fits)
