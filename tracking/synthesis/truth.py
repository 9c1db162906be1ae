"""What is exactly true of a rendered frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.synthesis.body import topology
from tracking.synthesis.painter import FINE, PeopleSamples
from tracking.synthesis.rig import BASELINE_M, Rig
from tracking.tracks import PARTS

CARED_FOR = 0.3
"""Whoever is seen less than this is a don't-care in truth.txt."""


@dataclass(frozen=True, slots=True, eq=False)
class SceneTruth:
    """The people of whom something is seen in the left camera, a row each; n rows.

    Attributes:
        track: (n,) ids from 1.
        box: (n, 4) left, top, width, height in 0-based px of the left image: the whole person,
            hidden or outside of the image too.
        position: (n, 2) world x, y in metres on the floor under the person.
        visibility: (n,) share of the person that is seen, 0..1.
        part_box: (n, 3, 4) boxes of head, torso and hip-leg, whole like `box`.
        part_pixels: (n, 3) pixels seen of each part.
    """

    track: NDArray[np.int32]
    box: Floats
    position: Floats
    visibility: Floats
    part_box: Floats
    part_pixels: NDArray[np.int32]

    def __len__(self) -> int:
        """The number of people seen."""
        return len(self.track)


def nobody() -> SceneTruth:
    """The truth of an empty frame."""
    return SceneTruth(
        np.zeros(0, np.int32),
        np.zeros((0, 4)),
        np.zeros((0, 2)),
        np.zeros(0),
        np.zeros((0, PARTS, 4)),
        np.zeros((0, PARTS), np.int32),
    )


@dataclass(frozen=True, slots=True, eq=False)
class Surfaces:
    """What the left camera's pixels show.

    Attributes:
        track: (height, width) id of the person who covers most of a pixel; 0: nobody.
        disparity_px: (height, width) left u less right u of what is seen there; NaN: nobody.
    """

    track: NDArray[np.int32]
    disparity_px: NDArray[np.float32]


def no_surfaces(size: tuple[int, int]) -> Surfaces:
    """An empty picture of `size` (width, height)."""
    shape = size[1], size[0]
    return Surfaces(np.zeros(shape, np.int32), np.full(shape, np.nan, np.float32))


def surfaces_of(drawn: PeopleSamples, people: NDArray[np.intp], rig: Rig) -> Surfaces:
    """What is seen in the left camera's picture of people (n,), indices in the cast."""
    surfaces = no_surfaces(rig.size)
    pixels = surfaces.track.size
    place = (drawn.seen.y // FINE) * rig.size[0] + drawn.seen.x // FINE
    person = drawn.person[drawn.seen.triangle]
    most = np.zeros(pixels, np.int64)
    for row, index in enumerate(people):
        count = np.bincount(place[person == row], minlength=pixels)
        ahead = count > np.maximum(most, FINE**2 // 2 - 1)
        surfaces.track[ahead.reshape(surfaces.track.shape)] = index + 1
        most = np.maximum(most, count)
    own = surfaces.track.reshape(-1)[place] == people[person] + 1
    count = np.bincount(place[own], minlength=pixels)
    total = np.bincount(place[own], drawn.seen.depth[own], minlength=pixels)
    there = np.flatnonzero(surfaces.track)
    scale = rig.focal_px * BASELINE_M
    surfaces.disparity_px.reshape(-1)[there] = scale * total[there] / count[there]
    return surfaces


def truth_of(
    people: NDArray[np.intp], position: Floats, pixels: Floats, drawn: PeopleSamples
) -> SceneTruth:
    """The truth of a drawn frame.

    Args:
        people: (n,) indices in the cast.
        position: (n, 2) where they stand.
        pixels: (n, v, 3) their vertices as the left camera sees them.
        drawn: the left camera's picture, covering more than the picture itself.
    """
    seen = _part_samples(drawn, len(people))
    whole = _whole_samples(drawn, len(people))
    visible = seen.sum(axis=1)
    part_box = np.stack([_boxes(pixels, part) for part in range(PARTS)], axis=1)
    rows = np.flatnonzero(visible > 0)
    return SceneTruth(
        track=(people[rows] + 1).astype(np.int32),
        box=_union(part_box)[rows],
        position=position[rows],
        visibility=np.minimum(visible / np.maximum(whole, 1), 1.0)[rows],
        part_box=part_box[rows],
        part_pixels=np.rint(seen[rows] / FINE**2).astype(np.int32),
    )


def _part_samples(drawn: PeopleSamples, people: int) -> NDArray[np.int64]:
    """Samples seen (n, 3) of each person's parts."""
    kind = drawn.person * PARTS + drawn.part
    count = np.bincount(kind[drawn.seen.triangle], minlength=people * PARTS)
    return count.reshape(people, PARTS)


def _whole_samples(drawn: PeopleSamples, people: int) -> NDArray[np.int64]:
    """Samples (n,) each person would cover, were nothing in the way and no edge of the image."""
    person = drawn.person[drawn.covered.triangle]
    x, y = drawn.covered.x, drawn.covered.y
    low = np.full((people, 2), np.iinfo(np.int32).max, np.int32)
    high = np.full((people, 2), np.iinfo(np.int32).min, np.int32)
    for axis, values in enumerate((x, y)):
        np.minimum.at(low[:, axis], person, values)
        np.maximum.at(high[:, axis], person, values)
    there = high[:, 0] >= low[:, 0]
    size = np.where(there[:, None], high.astype(np.int64) - low + 1, 0)
    area = size[:, 0] * size[:, 1]
    first = np.cumsum(area) - area
    covered = np.zeros(int(area.sum()), np.bool_)
    place = first[person] + (y - low[person, 1]) * size[person, 0] + (x - low[person, 0])
    covered[place] = True
    owner = np.repeat(np.arange(people), area)
    return np.bincount(owner[covered], minlength=people)


def _boxes(pixels: Floats, part: int) -> Floats:
    """Extents (n, 4) of a body part of each person."""
    triangles, parts = topology()
    vertices = np.unique(triangles[parts == part])
    points = pixels[:, vertices, :2]
    low, high = np.nanmin(points, axis=1), np.nanmax(points, axis=1)
    return np.concatenate((low, high - low), axis=1)


def _union(boxes: Floats) -> Floats:
    """The smallest box (n, 4) round several (n, k, 4)."""
    low = boxes[..., :2].min(axis=1)
    high = (boxes[..., :2] + boxes[..., 2:]).max(axis=1)
    return np.concatenate((low, high - low), axis=1)
