"""People as clusters of 3-D points seen from above."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.people.settings import PeopleSettings
from tracking.stereo import SightLines

Floats = NDArray[np.float32]
_SEED_CELL_M = 0.12
_SEED_SHARE = 0.75
_MOST_POINTS = 4000
_MOST_SEEDS = 80
_KERNEL = 0.28
"""Standard deviation of the mean-shift kernel, as a share of a person's breadth."""
_STEPS = 5
_FAINTEST = np.float32(-60.0)
"""Logarithm of a weight that counts for nothing: processors multiply much smaller numbers, which
they cannot hold whole, a hundred times as slowly."""
_SAME_PERSON = 0.35
"""Squared distance of two places, in units of a person's breadth, below which they are one."""
_AROUND = np.ones((5, 5), np.uint8)
"""Places of the grid, as wide as the window of block matching, whose ranges may blend."""
_BETWEEN_PX, _BETWEEN_M = 0.3, 0.15
"""What lies by both behind one neighbour and before another is a mixture of the two."""
_MIXTURE = 0.3
"""What a mixture counts for when people are told apart: a hand or a hip is one at times."""


@dataclass(frozen=True, slots=True)
class SurfacePoints:
    """Points of what was matched, a row each.

    Attributes:
        pixel: (n,) flat index into the grid of disparities they come from.
        world: (n, 3) metres.
        area: (n,) m² of surface, seen squarely, that the pixel covers.
        range_noise: (n,) m, the spread of the distance from the camera on the floor.
        mass: (n,) m², what the point counts for when people are told apart: its area, but less
            where it lies between a nearer and a farther surface, which the window of block
            matching blends into people who are not there.
    """

    pixel: NDArray[np.intp]
    world: Floats
    area: Floats
    range_noise: Floats
    mass: Floats

    def chosen(self, rows: NDArray[np.intp]) -> SurfacePoints:
        """The points of some rows, by number."""
        return SurfacePoints(
            self.pixel.take(rows),
            self.world.take(rows, axis=0),
            self.area.take(rows),
            self.range_noise.take(rows),
            self.mass.take(rows),
        )


def surface_points(
    disparity: Floats, lines: SightLines, rays: Floats, pixel_area: float, noise_px: float
) -> SurfacePoints:
    """The world points of a grid of disparities.

    Args:
        disparity: (rows, columns) px, NaN where unknown.
        lines: of the camera.
        rays: (rows, columns, 3) those of `lines` at the grid's places.
        pixel_area: working pixels a grid place stands for.
        noise_px: spread of disparity.
    """
    pixel = np.flatnonzero(np.isfinite(disparity))
    depth = lines.depth(disparity.ravel().take(pixel))
    per_m = np.float32(lines.focal_baseline) / depth**2
    sight = rays.reshape(-1, 3).take(pixel, axis=0)
    world = np.empty_like(sight)
    # An axis at a time: rows of three numbers each take longer.
    for axis, middle in enumerate(lines.centre.astype(np.float32)):
        np.multiply(depth, sight[:, axis], out=world[:, axis])
        world[:, axis] += middle
    area = (depth / np.float32(lines.focal)) ** 2 * np.float32(pixel_area)
    # Straight below the camera, noise of range is noise of height: it moves nobody on the floor.
    level = np.hypot(sight[:, 0], sight[:, 1])
    noise = depth**2 * level * np.float32(noise_px / lines.focal_baseline)
    mixed = _mixed(disparity, pixel, np.maximum(per_m * _BETWEEN_M, np.float32(_BETWEEN_PX)))
    mass = np.where(mixed, np.float32(_MIXTURE), np.float32(1)) * area
    return SurfacePoints(pixel, world, area, noise, mass)


def _mixed(disparity: Floats, pixel: NDArray[np.intp], limit_px: Floats) -> NDArray[np.bool_]:
    """(n,) which of the places lie between a nearer and a farther neighbour, by the limit each."""
    if len(pixel) == 0:
        return np.zeros(0, np.bool_)
    columns = disparity.shape[1]
    first, stop = int(pixel[0]) // columns, int(pixel[-1]) // columns + 1
    here, place = disparity.ravel().take(pixel), pixel - first * columns
    least, most = (np.full((stop - first, columns), none, np.float32) for none in (np.inf, -np.inf))
    least.ravel()[place] = most.ravel()[place] = here
    behind = here - np.asarray(cv2.erode(least, _AROUND), np.float32).ravel().take(place)
    before = np.asarray(cv2.dilate(most, _AROUND), np.float32).ravel().take(place) - here
    return np.asarray(np.minimum(behind, before) > limit_px, np.bool_)


def find_people(points: SurfacePoints, camera_xy: Floats, settings: PeopleSettings) -> Floats:
    """(k, 2) places on the floor where people stand, seen surface's middle, best first.

    Mean shift over the points from above, with a kernel of a person's breadth that is drawn out
    along the line of sight by the noise of range ([Kawashita2014] labels the foreground picture
    instead; labels alone join everybody who overlaps in the picture, although range tells them
    apart).

    Args:
        points: of the foreground, those near the floor left out.
        camera_xy: (2,) the floor point below the camera.
        settings: of people.
    """
    if len(points.area) == 0:
        return np.zeros((0, 2), np.float32)
    count = len(points.area)
    thinned = points.chosen(np.arange(0, count, -(-count // _MOST_POINTS)))
    share = np.float32(points.mass.sum() / max(float(thinned.mass.sum()), 1e-9))
    places = _seeds(thinned, share, settings)
    floor, noise = thinned.world[:, :2], thinned.range_noise
    units = Units.of(floor, noise, camera_xy, settings.body_width_m * _KERNEL)
    summed = np.column_stack((floor, noise, np.ones_like(noise))) * thinned.mass[:, None]
    mass = noise = np.zeros(len(places), np.float32)
    for _ in range(_STEPS):
        weight = units.squared(places)
        weight *= np.float32(-0.5)
        np.maximum(weight, _FAINTEST, out=weight)
        sums = np.exp(weight, out=weight) @ summed
        mass = sums[:, 3]
        means = sums[:, :3] / np.maximum(mass, 1e-9)[:, None]
        places, noise = means[:, :2], means[:, 2]
    return _distinct(places, mass * share, noise, camera_xy, settings)


@dataclass(frozen=True, slots=True)
class Units:
    """Points on the floor, each with a person's breadth as its unit of length.

    Along the line of sight the unit is longer by the noise of range.

    Attributes:
        along: (3, n) what a place's x, y and 1 are multiplied with for its distance along the
            line of sight; x and y are from the camera. across: (2, n) the same across it.
        camera_xy: (2,) m.
    """

    along: Floats
    across: Floats
    camera_xy: Floats

    @classmethod
    def of(cls, points: Floats, spread: Floats, camera_xy: Floats, width_m: float) -> Units:
        """Of points (n, 2) m with noise of range (n,) m; `width_m` is the unit across."""
        x, y = np.subtract(points.T, camera_xy[:, None], order="C")
        distance = np.maximum(np.hypot(x, y), np.float32(1e-3))
        along = np.array((x / distance, y / distance, -distance))
        along /= np.sqrt(np.float32(width_m**2) + spread * spread)
        across = np.array((-y, x))
        across /= distance * np.float32(width_m)
        return cls(along, across, camera_xy)

    def squared(self, places: Floats) -> Floats:
        """(k, n) squared distances of the points from places (k, 2) m."""
        at = np.ones((len(places), 3), np.float32)
        at[:, :2] = places - self.camera_xy
        squared = at @ self.along
        squared *= squared
        across = at[:, :2] @ self.across
        across *= across
        squared += across
        return squared


def apart(
    places: Floats, points: Floats, spread: Floats, camera_xy: Floats, width_m: float
) -> Floats:
    """(k, n) squared distance of points from places, in units of a person's breadth.

    Along the line of sight the unit is longer by the noise of range.

    Args:
        places: (k, 2) m. points: (n, 2) m. spread: (n,) m noise of range of the points.
        camera_xy: (2,) m. width_m: the unit across.
    """
    return Units.of(points, spread, camera_xy, width_m).squared(places)


def _seeds(points: SurfacePoints, share: np.float32, settings: PeopleSettings) -> Floats:
    """(k, 2) local maxima of a coarse map of surface per floor cell."""
    # A row for each axis: taken along the short side, extremes cost many times as much.
    floor = np.ascontiguousarray(points.world[:, :2].T)
    low = floor.min(axis=1) - _SEED_CELL_M
    cell = ((floor - low[:, None]) / _SEED_CELL_M).astype(np.intp)
    columns, rows = (cell.max(axis=1) + 2).tolist()
    flat = cell[1] * columns + cell[0]
    surface = np.bincount(flat, points.mass * share, rows * columns).reshape(rows, columns)
    around = cv2.boxFilter(
        surface.astype(np.float32), -1, (3, 3), normalize=False, borderType=cv2.BORDER_CONSTANT
    )
    top = around >= cv2.dilate(around, np.ones((3, 3), np.uint8))
    y, x = np.nonzero(top & (around > _SEED_SHARE * settings.min_area_m2))
    best = np.argsort(-around[y, x], kind="stable")[:_MOST_SEEDS]
    middle = np.column_stack((x[best], y[best])) + 0.5
    return np.asarray(middle * _SEED_CELL_M + low, np.float32)


def _distinct(
    places: Floats, mass: Floats, noise: Floats, camera_xy: Floats, settings: PeopleSettings
) -> Floats:
    """The places with enough surface, each once."""
    order = np.argsort(-mass, kind="stable")
    order = order[mass[order] > settings.min_area_m2]
    places, noise = places[order], noise[order]
    near = apart(places, places, noise, camera_xy, settings.body_width_m) < _SAME_PERSON
    kept = np.ones(len(places), np.bool_)
    # Most have nobody better near them.
    number = np.arange(len(places))
    for row in np.flatnonzero((near & (number[:, None] < number)).any(axis=0)).tolist():
        kept[row] = not near[:row, row][kept[:row]].any()
    return places[kept]
