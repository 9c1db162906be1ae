"""Places on the floor of people seen by one camera, from their feet and their heads."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracking.arrays import Floats
from tracking.filtering import Chains, smooth_paths, trust
from tracking.geometry import View
from tracking.people import PeopleSettings
from tracking.trackers.linking import link_tracks
from tracking.trackers.three_part.people import Flags, Indices
from tracking.tracks.columns import Columns
from tracking.tracks.run import Run

_USUAL_M = "people.body_height_m"
"""The setting with the height that perception takes people for whose feet are hidden."""
_USUAL_ROWS = 10
"""Rows of usual height that are counted among somebody's own."""
_END_OFF = 0.03
"""How much the rows in the picture where a body ends err, in heights of its box."""
_HEIGHT_OFF_M = 0.05
"""How much heights err that were measured of somebody."""
_RANGE_OFF_M = 0.03
"""How much ranges err apart from that."""
_TAIL = 2.0
"""In errors of a range: what is farther off was measured of something else."""
_UNCONFIRMED = 0.2
"""Weight of a range that only the head tells, before there is a path to compare it with."""
_PATH_ERROR_M = 0.1
"""A range that errs no more than this leads the path as fast as its memory allows."""
_PATH_MEMORY_S = 0.4
_ROUNDS = 4
_SURE_S = 0.4
"""So long it is known about where somebody walks unseen whose place one camera tells by a box."""


@dataclass(frozen=True, slots=True)
class _Sights:
    """Detections of people followed, by track and frame; each tells a range twice.

    Attributes:
        row: (n,) of the run's detections. chains: their frames and tracks.
        bearing: (n, 2) unit vectors on the floor, from below the camera.
        range_m: (n, 2) by the feet, by the head. error_m: (n, 2) of these; infinite: not known.
    """

    row: Indices
    chains: Chains
    bearing: Floats
    range_m: Floats
    error_m: Floats


def link_refined(run: Run, view: View, fps: float, given: Columns | None = None) -> Run:
    """The run with one id for each person, linked by refined places; see `link_tracks`."""
    run = refine_places(run, view, fps)
    return link_tracks(run, view, fps, given, longest_gap_s=_SURE_S)


def refine_places(run: Run, view: View, fps: float) -> Run:
    """The run with the ranges of its detections found along the whole of each track.

    One camera tells well in which direction people are and badly how far: a shadow, a leg of
    somebody else or a hidden foot is a metre or more. A range follows twice from a box, from the
    feet and from the head of a body as high as this person is at other times. Each is sometimes of
    something else, so that both count as far as they suit a path between earlier and later ones
    (Geman and McClure's weights, see `tracking.filtering`).

    Args:
        view: the camera the boxes were seen by. fps: frames a second.
    """
    seen = run.detections
    placed = np.isfinite(seen["x"]) & np.isfinite(seen["y"]) & (seen["track"] > 0)
    row = np.flatnonzero(placed)
    row = row[np.lexsort((seen["frame"][row], seen["track"][row]))]
    if not len(row):
        return run
    sights = _sights(
        seen, row, float(run.settings.get(_USUAL_M, PeopleSettings().body_height_m)), view
    )
    range_m = _settled_ranges(sights, fps)
    place = _below(view) + sights.bearing * range_m[:, None]
    x, y = seen["x"].copy(), seen["y"].copy()
    x[row], y[row] = place.T
    return replace(run, detections={**seen, "x": x, "y": y})


def _sights(seen: Columns, row: Indices, usual_m: float, view: View) -> _Sights:
    """What these detections say of ranges."""
    values = {name: seen[name][row].astype(np.float64) for name in ("x", "y", "z", "height")}
    head = np.column_stack((seen["left"][row] + seen["width"][row] / 2, seen["top"][row]))
    away = np.column_stack((values["x"], values["y"])) - _below(view)
    by_feet = np.maximum(np.hypot(*away.T), 1e-6)
    measured_m = 2 * values["z"]
    feet_seen = np.abs(measured_m - usual_m) > 1e-6
    own_m = _own_heights(measured_m, feet_seen, seen["track"][row], usual_m)
    by_head = _ranges(head, own_m, view)
    down = np.column_stack((np.zeros(len(row)), _END_OFF * values["height"]))
    standing = np.column_stack((values["x"], values["y"], np.zeros(len(row))))
    foot = view.pixel_from_world(standing)
    error = np.stack(
        (
            np.abs(_ranges(foot + down, 0.0, view) - by_feet),
            np.abs(_ranges(head + down, own_m, view) - by_head)
            + np.abs(_ranges(head, own_m + _HEIGHT_OFF_M, view) - by_head),
        ),
        axis=1,
    )
    range_m = np.stack((by_feet, by_head), axis=1)
    known = np.isfinite(range_m) & np.isfinite(error)
    known[:, 1] &= head[:, 1] > 0.5  # else the picture ends there
    known[:, 0] &= feet_seen | ~known[:, 1]
    return _Sights(
        row,
        Chains(seen["frame"][row].astype(np.int64), seen["track"][row]),
        away / by_feet[:, None],
        np.where(known, range_m, by_feet[:, None]),
        np.where(known, error + _RANGE_OFF_M, np.inf),
    )


def _own_heights(measured_m: Floats, feet_seen: Flags, track: Indices, usual_m: float) -> Floats:
    """(n,) m, the median of each person's heights measured, and of some usual ones."""
    own = np.full(len(track), usual_m)
    for rows in np.split(np.arange(len(track)), np.flatnonzero(np.diff(track)) + 1):
        theirs = measured_m[rows][feet_seen[rows]]
        own[rows] = np.median(np.append(theirs, np.full(_USUAL_ROWS, usual_m)))
    return own


def _settled_ranges(sights: _Sights, fps: float) -> Floats:
    """(n,) m along the bearings, of smooth paths that most of the ranges suit."""
    range_m, error_m = sights.range_m, sights.error_m
    certain = np.square(_PATH_ERROR_M / error_m)
    confirmed = trust(range_m[:, 0] - range_m[:, 1], _TAIL * np.hypot(*error_m.T))
    weight = certain * np.where(np.isfinite(error_m).all(axis=1), confirmed, _UNCONFIRMED)[:, None]
    found = range_m[:, 0]
    for _ in range(_ROUNDS + 1):
        total = weight.sum(axis=1)
        mean = (weight * range_m).sum(axis=1) / np.maximum(total, 1e-12)
        mean = np.where(total > 0, mean, found)
        place, share = sights.bearing * mean[:, None], np.minimum(total, 1.0)
        path = smooth_paths(place, share, sights.chains, _PATH_MEMORY_S * fps)
        found = (path * sights.bearing).sum(axis=1)
        weight = certain * trust(range_m - found[:, None], _TAIL * error_m)
    return found


def _ranges(pixel: Floats, z_m: float | Floats, view: View) -> Floats:
    """(n,) m on the floor from below the camera to what is seen at so much over it."""
    return np.asarray(np.hypot(*(view.floor_from_pixel(pixel, z_m) - _below(view)).T))


def _below(view: View) -> Floats:
    """(2,) m, the place on the floor below the camera."""
    return view.world_from_camera[1][:2]
