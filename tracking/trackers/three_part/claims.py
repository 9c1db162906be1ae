"""Which region of the foreground is whose."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import associate
from tracking.people import Detections
from tracking.trackers.three_part.people import Flags, Floats, Indices
from tracking.tracks.boxes import overlaps

_GRID = (np.arange(5) + 0.5) / 5 - 0.5
"""Where a rectangle is probed, across and down, as shares of its size from its middle."""
_OWN = 0.3
"""Share of somebody's parts that must lie in a region for it to be theirs."""
_WHOLE = (0.85, 1.25)
"""Height of a region, in heights of its person, that shows all of them."""
_TWICE = 1.8
"""The same from which on it is no longer one person."""
_OTHERS = 0.15
"""Share of somebody's parts in other regions from which on they may be hidden there."""
_SAME_BODY = 0.3
"""Intersection over union from which on a detector's box may be somebody's."""
_TAKEN = 0.1
"""The same for it to be possibly theirs: nobody new is started in it."""


@dataclass(frozen=True, slots=True, eq=False)
class Claims:
    """Regions and people.

    Attributes:
        share: (people, regions) of the person's parts that lies in the region.
        support: (people, parts) the share of each part that lies on any foreground; parts outside
            the picture have none.
        region: (people,) the one that holds most of somebody; -1 where none holds enough.
        alone: (people,) whether it holds nobody else and is no larger than a person.
    """

    share: Floats
    support: Floats
    region: Indices
    alone: Flags

    @property
    def own_share(self) -> Floats:
        """(people,) of each one's parts that lies in their own region."""
        padded = np.append(self.share, np.zeros((len(self.share), 1)), axis=1)
        return np.asarray(padded[np.arange(len(padded)), self.region])

    @property
    def is_taken(self) -> Flags:
        """(regions,) in which somebody followed is, or part of them.

        Who is alone in a region has no part in another: there is somebody else.
        """
        theirs = self.share > _TAKEN
        theirs[self.alone] = False
        theirs[np.flatnonzero(self.alone), self.region[self.alone]] = True
        return np.asarray(theirs.any(axis=0))


def claims_of(rectangles: Floats, seen: Detections) -> Claims:
    """Look up in which regions the parts (people, parts, 4) lie."""
    people, parts = rectangles.shape[:2]
    label = _probe(rectangles, seen.regions)
    count = len(seen) + 1
    flat = label + (np.arange(people) * count)[:, None, None]
    votes = np.bincount(flat.ravel(), minlength=people * count).reshape(people, count)
    share = votes[:, 1:] / (parts * len(_GRID) ** 2)
    region = share.argmax(axis=1) if len(seen) else np.zeros(people, np.intp)
    mine = share.max(axis=1, initial=0.0) >= _OWN
    region = np.where(mine, region, -1)
    guests = (share >= _OWN / 2).sum(axis=0)
    alone = mine.copy()
    alone[mine] = (guests[region[mine]] <= 1) & ~seen.merged[region[mine]]
    return Claims(share, (label > 0).mean(axis=2), region, alone)


def associate_detections(
    claims: Claims, boxes: Floats, seen: Detections, alike: Floats | None = None
) -> Claims:
    """The claims with each box of a detector given to one person at most, who has no other.

    A box is of one person, whoever else has parts in it; so they are associated one to one.

    Args:
        boxes: (people, 4) where people are expected.
        alike: (people, regions) how much people look like what is seen there; None: boxes alone
            tell.
    """
    given = np.flatnonzero(seen.from_detector)
    overlap = overlaps(boxes[:, None], seen.box[given])
    cost = 1.0 - overlap
    if alike is not None:
        cost += 1.0 - alike[:, given]
    pairs = associate(cost, overlap >= _SAME_BODY, 2.0)
    row, region = pairs.track, given[pairs.detection]
    share, whose, alone = claims.share.copy(), claims.region.copy(), claims.alone.copy()
    left = np.append(seen.from_detector, False)[whose]
    whose[left], alone[left] = -1, False
    share[:, given] = 0.0
    share[row] = 0.0
    share[row, region] = 1.0
    whose[row], alone[row] = region, True
    left[row] = False
    support = np.where(left[:, None], 0.0, claims.support)  # what they lie on is somebody else's
    return Claims(share, support, whose, alone)


def seen_whole(claims: Claims, seen: Detections, height: Floats) -> Flags:
    """(people,) who is seen alone and from head to foot; height (people,) px, upright."""
    tall = np.append(seen.box[:, 3], 0.0)[claims.region]
    cut = np.append(seen.truncated & ~seen.from_detector, True)[claims.region]
    ratio = tall / np.maximum(height, 1.0)
    alone = claims.alone & (claims.share.sum(axis=1) - claims.own_share <= _OTHERS)
    return np.asarray(alone & ~cut & (ratio > _WHOLE[0]) & (ratio < _WHOLE[1]))


def seen_taller(claims: Claims, seen: Detections, height: Floats) -> Flags:
    """(people,) seen alone and so much taller that they were begun without their feet.

    Clothes like the floor hide legs for a while; somebody twice as tall is two people.
    """
    tall = np.append(seen.box[:, 3], 0.0)[claims.region]
    cut = np.append(seen.truncated, True)[claims.region]
    ratio = tall / np.maximum(height, 1.0)
    return np.asarray(claims.alone & ~cut & (ratio >= _WHOLE[1]) & (ratio < _TWICE))


def is_sharing(claims: Claims, seen: Detections) -> Flags:
    """(people,) who has somebody else in a region that shows no more than one person."""
    count = np.bincount(claims.region[claims.region >= 0], minlength=len(seen))
    two = np.append((count > 1) & ~seen.merged, False)
    return np.asarray(two[claims.region])


def own_boxes(boxes: Floats, claims: Claims, seen: Detections) -> Floats:
    """(people, 4) where people are: the region of those alone in one, else the boxes expected."""
    region = np.append(seen.box, np.zeros((1, 4)), axis=0)[claims.region]
    return np.where(claims.alone[:, None], region, boxes)


def both_in_one(claims: Claims, new: Indices) -> Indices:
    """Who is alone in a region, with parts in a new person's: the two were followed as one."""
    beside = (claims.share[:, new] > _TAKEN).any(axis=1)
    return np.flatnonzero(claims.alone & beside & ~np.isin(claims.region, new))


def shares_on(mask: NDArray[np.integer], rectangles: Floats) -> Floats:
    """(people, parts) the share of each rectangle (people, parts, 4) where a mask is not 0."""
    return np.asarray((_probe(rectangles, mask) > 0).mean(axis=2))


def may_be_theirs(claims: Claims) -> Flags:
    """(people, regions) which regions are not somebody else's alone."""
    share = claims.share
    others = np.array(
        [np.delete(share, row, axis=0).max(axis=0, initial=0.0) for row in range(len(share))]
    )
    return ~((others.reshape(share.shape) > _OWN) & (share < _TAKEN))


def shares_of(theirs: Flags, rectangles: Floats, seen: Detections) -> Floats:
    """(people, parts) the share of rectangles on each one's regions (people, regions)."""
    label = _probe(rectangles, seen.regions)
    own = np.concatenate((np.zeros((len(theirs), 1), bool), theirs), axis=1)
    return np.asarray(own[np.arange(len(own))[:, None, None], label].mean(axis=2))


def _probe(rectangles: Floats, regions: NDArray[np.integer]) -> NDArray[np.int64]:
    """(people, parts, points) the regions' labels on a grid in each rectangle; 0 outside."""
    u = rectangles[..., 0, None] + rectangles[..., 2, None] * np.tile(_GRID, len(_GRID))
    v = rectangles[..., 1, None] + rectangles[..., 3, None] * np.repeat(_GRID, len(_GRID))
    column, row = np.rint(u).astype(np.int64), np.rint(v).astype(np.int64)
    rows, columns = regions.shape
    inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
    label = regions[np.clip(row, 0, rows - 1), np.clip(column, 0, columns - 1)]
    return np.where(inside, label, 0).astype(np.int64)
