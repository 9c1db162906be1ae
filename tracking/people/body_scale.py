"""How large people are in one camera's picture, and where on the floor they stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.geometry import View
from tracking.people.boxes import full_body_boxes, standing_boxes
from tracking.people.settings import PeopleSettings

_SLENDER = 0.29
"""Breadth of a person over height where nothing is known in metres."""
_LARGEST = 3.0
"""A body that should be this many times as high as what is seen: the floor tells nothing here."""
_STRETCH = 1.8
_HEIGHTS_M = (0.5, 2.1)
_GROWN_UP_M = (1.5, 1.92)
_FROM_ABOVE = 1.3
"""How much broader than that, seen from above, before it counts: a camera's height is known to
no better."""
_ARM_S_REACH, _AS_LOW = 0.6, 0.1
_CHILD, _LIMB = 0.78, 0.4
"""How far beside somebody their limbs and bags are, how much higher than their feet these end at
most, and how high they are at most: on the ground, and in the air. All in heights of theirs."""
_ELBOW_ROOM = 0.8
"""In breadths, between the feet of two people."""
_SLACK = 0.05
"""Of a body's height, that what is seen of it may go on below its feet."""


@dataclass(frozen=True, slots=True)
class Bodies:
    """Upright bodies in working pixels, a row each.

    Attributes:
        head: (n, 2) the top of the head.
        foot: (n, 2) between the feet.
        height, width: (n,) px.
        reach: (n,) how far below the head the tallest body's feet could be, over `height`.
        stretch: (n,) how much broader bodies of this height look than people seen from the side;
            1 or more, from above people look short but no narrower.
    """

    head: Floats
    foot: Floats
    height: Floats
    width: Floats
    reach: Floats
    stretch: Floats

    def __len__(self) -> int:
        """The number of bodies."""
        return len(self.head)

    def away_from(self, others: Bodies) -> NDArray[np.bool_]:
        """(n,) who stands where nobody of the others does; told of people seen from above only.

        From the side, rows of the picture tell too little of who stands behind whom.
        """
        apart = np.linalg.norm(self.foot[:, None] - others.foot[None], axis=2)
        near = apart < _ELBOW_ROOM * self.width[:, None]
        return np.asarray(~near.any(axis=1) | (self.stretch <= 1.0))

    def as_tall_as(self, others: Bodies) -> NDArray[np.bool_]:
        """(n,) who is about as tall as the others beside them, if they stand as near.

        Where nothing is known in metres: what ends as low as somebody and is clearly lower is a
        bag on their back, and what hangs in the air beside them an arm.
        """
        height, foot = others.height[None], others.foot[None, :, 1]
        share = self.height[:, None] / height
        beside = np.abs(self.foot[:, :1] - others.foot[None, :, 0]) < _ARM_S_REACH * height
        as_near = self.foot[:, 1:] > foot - _AS_LOW * height
        piece = beside & ((as_near & (share < _CHILD)) | (share < _LIMB))
        return np.asarray(~piece.any(axis=1))

    def chosen(self, rows: NDArray[np.bool_] | NDArray[np.intp]) -> Bodies:
        """Some of the bodies."""
        return Bodies(*(getattr(self, name)[rows] for name in self.__slots__))

    def with_others(self, others: Bodies) -> Bodies:
        """These and other bodies."""
        pairs = ((getattr(self, name), getattr(others, name)) for name in self.__slots__)
        return Bodies(*(np.concatenate(pair) for pair in pairs))


def nobody() -> Bodies:
    """No bodies."""
    return Bodies(np.zeros((0, 2)), np.zeros((0, 2)), *np.zeros((4, 0)))


class Standing:
    """Sizes and places of people in one camera's picture.

    Args:
        view: the camera over its floor; None where nothing is known in metres: people are then as
            high as what is seen of them.
        shrink: recorded pixels a working pixel is wide.
        settings: of people.
    """

    def __init__(self, view: View | None, shrink: int, settings: PeopleSettings) -> None:
        self._view = view
        self._shrink = shrink
        self._settings = settings

    @property
    def calibrated(self) -> bool:
        """Whether metres are known."""
        return self._view is not None

    def below(self, head: Floats, bottom: Floats) -> Bodies:
        """Bodies under the tops of heads.

        Where metres are known they are of the usual height, unless what is seen ends where the
        feet of somebody smaller or taller would be: then that is where they stand.

        Args:
            head: (n, 2) working px.
            bottom: (n,) rows of the lowest pixel seen under each head.
        """
        foot = np.column_stack((head[:, 0], bottom))
        height = np.maximum(bottom - head[:, 1], 1.0)
        width = height * _SLENDER
        unknown = np.full(len(head), np.inf)
        bodies = Bodies(head, foot, height, width, unknown, np.ones(len(head)))
        return bodies if self._view is None or len(head) == 0 else self._measured(bodies)

    def _measured(self, seen: Bodies) -> Bodies:
        """The bodies, as large as metres say."""
        settings = self._settings
        head, bottom = seen.head, seen.foot[:, 1]
        heights = (settings.body_height_m, *_GROWN_UP_M)
        under, short, tall = self._under(head, heights)
        high = np.hypot(*(under - head).T)
        tallest = np.nan_to_num(tall[:, 1], nan=np.inf)
        # Near the horizon heads tell nothing, but feet do.
        known = np.isfinite(high) & (high < _LARGEST * seen.height) & (under[:, 1] > head[:, 1])
        over = np.nan_to_num(self.above(seen.foot).height, nan=1.0)
        high = np.where(known, high, np.maximum(over, seen.height))
        grown_up = (bottom >= short[:, 1]) & (bottom <= tallest)
        foot = np.column_stack((np.where(known, under[:, 0], head[:, 0]), bottom))
        stretch = self._stretches(np.where(known[:, None], under, foot), high)
        # Seen from above bodies lean: below a head's column there may be an arm only.
        grown_up &= stretch == 1.0
        foot[:, 1] = np.where(known & ~grown_up, under[:, 1], bottom)
        return Bodies(
            head,
            foot,
            np.where(known & grown_up, seen.height, high),
            high * settings.body_width_m / settings.body_height_m * stretch,
            np.where(known, (tallest - head[:, 1]) / high + _SLACK, np.inf),
            stretch,
        )

    def _under(self, head: Floats, heights_m: tuple[float, ...]) -> Floats:
        """(k, n, 2) working px of the floor under heads (n, 2) at each of k heights."""
        assert self._view is not None
        many = np.tile(self.recorded(head), (len(heights_m), 1))
        xy = self._view.floor_from_pixel(many, np.repeat(heights_m, len(head)))
        under = self._working(self._view.pixel_from_world(_lifted(xy, 0.0)))
        return under.reshape(len(heights_m), len(head), 2)

    def above(self, foot: Floats) -> Bodies:
        """Bodies of the usual height over feet (n, 2), working px; needs a calibration.

        NaN where feet are at or above the horizon, or the head is behind the camera.
        """
        assert self._view is not None
        settings = self._settings
        xy = self._view.floor_from_pixel(self.recorded(foot))
        head = self._working(self._view.pixel_from_world(_lifted(xy, settings.body_height_m)))
        high = np.hypot(*(foot - head).T)
        stretch = self._stretches(foot, high)
        width = high * settings.body_width_m / settings.body_height_m * stretch
        return Bodies(head, foot, high, width, np.full(len(foot), 1 + _SLACK), stretch)

    def _stretches(self, foot: Floats, high: Floats) -> Floats:
        """(n,) `Bodies.stretch` of bodies over feet (n, 2), so high in working px."""
        assert self._view is not None
        settings = self._settings
        xy = self._view.floor_from_pixel(self.recorded(foot))
        position = np.column_stack((xy, np.full(len(xy), settings.body_height_m / 2)))
        across = settings.body_height_m / self.metres_per_pixel(position)
        return np.nan_to_num(np.maximum(across / (_FROM_ABOVE * high), 1.0), nan=1.0)

    def positions(self, top: Floats, foot: Floats, foot_seen: NDArray[np.bool_]) -> Floats:
        """(n, 3) m on the floor under people, and half their height; NaN without calibration.

        Args:
            top, foot: (n, 2) working px of the highest and the lowest point of the body's middle.
            foot_seen: (n,) whether the feet are seen; else the head tells, of a usual body.
        """
        found = np.full((len(top), 3), np.nan)
        if self._view is None or len(top) == 0:
            return found
        usual = self._settings.body_height_m
        by_foot = self._view.floor_from_pixel(self.recorded(foot))
        by_head = self._view.floor_from_pixel(self.recorded(top), usual)
        use = foot_seen & np.isfinite(by_foot).all(axis=1)
        found[:, :2] = np.where(use[:, None], by_foot, by_head)
        found[:, 2] = np.where(use, self._heights(found[:, :2], top), usual) / 2
        return found

    def _heights(self, xy: Floats, top: Floats) -> Floats:
        """(n,) m of bodies that stand at xy and end at a row of the picture."""
        assert self._view is not None
        z = np.linspace(*_HEIGHTS_M, 33)
        points = np.empty((len(xy), len(z), 3))
        points[..., :2], points[..., 2] = xy[:, None], z
        rows = self._working(self._view.pixel_from_world(points.reshape(-1, 3)))[:, 1]
        apart = np.abs(rows.reshape(len(xy), len(z)) - top[:, 1:])
        return np.asarray(z[np.nan_to_num(apart, nan=np.inf).argmin(axis=1)], np.float64)

    def metres_per_pixel(self, position: Floats) -> Floats:
        """(n,) m that a working pixel is wide at half the height of people; NaN where unknown."""
        if self._view is None or len(position) == 0:
            return np.full(len(position), np.nan)
        half_m = np.array((0.5, 0.0, 0.0))
        right = self._view.pixel_from_world(position + half_m)
        apart = right - self._view.pixel_from_world(position - half_m)
        return np.asarray(self._shrink / np.maximum(np.hypot(*apart.T), 1e-6), np.float64)

    def distances(self, position: Floats, boxes: Floats) -> Floats:
        """(n,) larger for people farther away: metres from the camera, or where feet are."""
        lowest = -(boxes[:, 1] + boxes[:, 3])
        if self._view is None:
            return lowest
        known = np.hypot(position[:, 0], position[:, 1])
        return np.where(np.isfinite(known), known, 0.0)

    def whole(self, boxes: Floats, position: Floats, hidden: NDArray[np.bool_]) -> Floats:
        """(n, 4) boxes in recorded px of whole bodies, from (n, 4) boxes seen in working px.

        Args:
            boxes: of the regions.
            position: of `positions`.
            hidden: (n, 4) bool: left, top, right and bottom side end at somebody nearer or at the
                picture's edge.
        """
        near = self.recorded(boxes[:, :2] - 0.5)
        seen = np.concatenate((near, boxes[:, 2:] * self._shrink), axis=1)
        if self._view is None or len(boxes) == 0:
            return seen
        width = self._settings.body_width_m
        height = np.clip(2 * position[:, 2], *_HEIGHTS_M)
        height = np.where(hidden[:, 1], self._settings.body_height_m, height)
        standing = standing_boxes(self._view, position[:, :2], height, width)
        reach = standing_boxes(self._view, position[:, :2], height * 1.1, width * 2 * _STRETCH)
        return full_body_boxes(seen, standing, reach, hidden)

    def recorded(self, points: Floats) -> Floats:
        """Recorded pixels of working ones."""
        return (np.asarray(points, np.float64) + 0.5) * self._shrink - 0.5

    def _working(self, points: Floats) -> Floats:
        return (points + 0.5) / self._shrink - 0.5


def _lifted(xy: Floats, z_m: float) -> Floats:
    return np.concatenate((xy, np.full((len(xy), 1), z_m)), axis=1)
