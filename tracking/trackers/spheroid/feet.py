"""What feet say of how far away people are: legs end there, and the floor below them is empty."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView, ellipses_of
from tracking.trackers.spheroid.judging import LINES, Evidence, covered, joined, windows_of
from tracking.trackers.spheroid.sums import Window, sums_inside

Floats = NDArray[np.float64]

_RADIUS_M, _SHIN_M, _BELOW_M = 0.22, 0.15, 0.2
"""Of the shins and of what lies below them: half their width, half their heights."""
_LEGS_FULL, _BELOW_FULL = 0.5, 0.4
"""Shares of foreground there that say all: legs leave a gap."""
_ZONE_M = (0.4, 0.4, 0.3)
"""Semi-axes in m about the shins of people who walk: what lies there may be their feet."""


@dataclass(frozen=True, slots=True)
class Feet:
    """Where legs of hypotheses end, in flat px, and what the camera sees below them.

    Attributes:
        legs, below: of any batch shape. Below the floor lies in the picture what is nearer.
    """

    legs: Ellipses
    below: Ellipses

    @property
    def reach(self) -> Ellipses:
        """(people, 2 n) all of each person's."""
        return joined(self.legs, self.below)

    def at(self, rows: NDArray[np.intp]) -> Feet:
        """Those at these rows, as hypotheses (1, n) of one person."""
        return Feet(self.legs[rows][None], self.below[rows][None])


def feet_of(flat: FlatView, axes: Floats) -> Feet:
    """The feet of people at places (..., 2) m.

    [Waechter2013] has none: spheroids end in a point there, and legs, which leave a gap, fill so
    little of them that people seen from the side were thought to stand farther away, feet aside.
    """
    legs = _upon(flat, axes, _SHIN_M, (_RADIUS_M, _RADIUS_M, _SHIN_M))
    below = _upon(flat, axes, -_BELOW_M, (_RADIUS_M, _RADIUS_M, _BELOW_M))
    return Feet(legs, below)


def foot_zones(flat: FlatView, xy: Floats) -> Ellipses:
    """(people) where feet of people at xy (people, 2) m may be, px of the flat picture."""
    return _upon(flat, xy, _ZONE_M[2], _ZONE_M)


def feet_windows(
    evidence: Evidence,
    flat: FlatView,
    own: Ellipses,
    axes: Floats,
    feet: Feet,
    rows: NDArray[np.intp],
) -> list[Window]:
    """The windows in which feet are looked for, other people's silhouettes and feet masked out.

    Strides reach out of silhouettes, and who stands behind would be drawn to the feet before him.

    Args:
        evidence: with everybody's silhouettes as cover. own: (people) these silhouettes.
        axes: (people, 2) m where everybody is. feet: of the hypotheses of those at the rows.
    """
    zones = foot_zones(flat, axes)
    cover = evidence.cover + covered(evidence.cover.shape, zones)
    return windows_of(replace(evidence, cover=cover), feet.reach, own[rows], LINES, zones[rows])


def feet_said(windows: list[Window], feet: Feet) -> Floats:
    """(people, n) -1 to 1: how much more legs are seen where they should end than below.

    What is hidden by others or out of the picture says nothing.
    """
    return _filled(windows, feet.legs, _LEGS_FULL) - _filled(windows, feet.below, _BELOW_FULL)


def _filled(windows: list[Window], outlines: Ellipses, full: float) -> Floats:
    inside = sums_inside(windows, outlines)
    whole = np.maximum(np.nan_to_num(outlines.areas(), nan=1.0), 1.0)
    in_sight = np.clip(inside.area / whole, 0.0, 1.0)
    return in_sight * np.minimum(inside.ramp / np.maximum(inside.area, 1.0) / full, 1.0)


def _upon(flat: FlatView, xy: Floats, z_m: float, axes_m: tuple[float, float, float]) -> Ellipses:
    """Ellipsoids about places (..., 2) m, their centres so high above the floor."""
    centre = np.concatenate((xy, np.full((*xy.shape[:-1], 1), z_m)), axis=-1)
    return ellipses_of(flat.projection, centre, np.broadcast_to(axes_m, centre.shape))
