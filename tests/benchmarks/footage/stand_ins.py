"""What stands in the place of mechanisms that are left out; see `mechanisms`."""

from __future__ import annotations

from typing import Any

import numpy as np

from tracking.foreground import BodyMasks, ShadowWeights
from tracking.trackers.flow.trajectory_selection import WalkerTrajectory
from tracking.trackers.flow.witnesses import Witnesses
from tracking.trackers.joint.appearance import AppearanceModel
from tracking.trackers.joint.noise import MeasurementNoise
from tracking.trackers.linking import motion
from tracking.trackers.spheroid import perception_hints, weights
from tracking.trackers.stereo import shared_detections

_BODY_MASKS = perception_hints.body_masks
_BALANCE = weights._BALANCE


def first(given: Any, *_: Any, **__: Any) -> Any:
    """What is given first, as it is."""
    return given


def second(_given: Any, other: Any, *_: Any, **__: Any) -> Any:
    """What is given second, as it is."""
    return other


def tracks_of(run: Any, *_: Any) -> Any:
    """The tracks of a run, as they are."""
    return run.tracks


def nothing(*_: Any, **__: Any) -> None:
    """Nothing is found."""


def no_list(*_: Any, **__: Any) -> list[Any]:
    """Nothing is found."""
    return []


def false(*_: Any) -> bool:
    """It is never so."""
    return False


def no_rows(*_: Any, **__: Any) -> Any:
    """No rows."""
    return np.zeros(0, np.intp)


def no_ids(*_: Any) -> Any:
    """Nobody gets another id."""
    return np.zeros(0, np.intp), np.zeros(0, np.int64)


def no_shares(_tracks: Any, place: Any, *_: Any) -> Any:
    """Nobody hides anybody."""
    return np.zeros(len(place[0]))


def zeros(given: Any, *_: Any) -> Any:
    """(n,) 0 for each of what is given."""
    return np.zeros(len(given))


def zeros_like(given: Any, *_: Any) -> Any:
    """0 in the shape of what is given."""
    return np.zeros(np.shape(given))


def straight_likelihood(ends: Any, starts: Any, end: Any, start: Any, gap_s: Any) -> Any:
    """Everybody walks straight on."""
    return motion._density(ends, starts, end, start, *motion._straight(gap_s))


def paths_as_tracked(paths: Any, measured: Any, *_: Any) -> Any:
    """Paths as measured, velocities as tracked."""
    return measured, np.stack((paths.columns["vx"], paths.columns["vy"]), axis=1)


def boxes_as_tracked(paths: Any, *_: Any) -> Any:
    """Boxes as tracked."""
    return paths.box


def no_clear_sides(tracks: Any, *_: Any) -> Any:
    """Somebody is near everybody."""
    return np.zeros((len(tracks["frame"]), 2), bool)


def no_ghosts(_flat: Any, outlines: Any, *_: Any) -> Any:
    """Nobody is a ghost."""
    return np.zeros(len(outlines.u), bool)


def unprotected_masks(*given: Any) -> Any:
    """Body masks that keep nothing of the background as it is."""
    masks = _BODY_MASKS(*given)
    return BodyMasks(masks.on, masks.beside, np.zeros_like(masks.kept))


def one_balance(people: Any, *_: Any) -> Any:
    """The same balance for everybody."""
    return np.full(len(people), _BALANCE)


class NoShadows(ShadowWeights):
    """Nothing is a shadow."""

    def weigh(self, seen: Any) -> Any:
        """All is body."""
        super().weigh(seen)
        return np.full(seen.mask.shape, 255, np.uint8)


class NoWitnesses(Witnesses):
    """There is room everywhere."""

    def allow(self, place: Any, frame: Any) -> Any:  # noqa: ARG002 - nobody is asked
        """Everywhere."""
        return np.ones(len(place), bool)


class FixedNoise(MeasurementNoise):
    """The error that the settings say."""

    __slots__ = ()

    def update(self, *_: Any) -> Any:
        """Nothing is learnt."""
        return self


class FixedLooks(AppearanceModel):
    """The appearance that is expected beforehand."""

    __slots__ = ()

    def update(self, *_: Any) -> Any:
        """Nothing is learnt."""
        return self


def no_trends(number: Any, time_s: Any, z_m: Any, aside_m: Any, for_s: Any) -> Any:
    """(m,) nothing rises or drifts."""
    return np.zeros(len(for_s))


def by_first(walks: Any) -> Any:
    """All of them, sorted."""
    found: list[WalkerTrajectory] = sorted(walks, key=lambda one: one.trajectory.first)
    return found


def no_feet_cost(ratio: Any) -> Any:
    """(k,) feet say nothing."""
    return np.zeros(ratio.shape[1])


def no_legs(people: Any, *_: Any) -> Any:
    """Nobody's legs are elsewhere."""
    return np.zeros(len(people), bool), np.full((len(people), 4), np.nan)


def no_failures(people: Any, *_: Any) -> Any:
    """No part has failed."""
    return np.zeros_like(people.failed, dtype=bool)


def not_sharing(claims: Any, *_: Any) -> Any:
    """Nobody shares a region."""
    return np.zeros(len(claims.region), bool)


def nobody_shares(*_: Any) -> Any:
    """No region holds two people."""
    return shared_detections.NONE_SHARED


def nothing_behind(boxes: Any, *_: Any) -> Any:
    """Nothing hides a side."""
    return np.zeros((len(boxes), 4), bool)
