"""Which of the matched points lie on the floor."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.doctor.matches import Matches
from tracking.doctor.residuals import disparities, focal_px
from tracking.geometry import Ground, StereoCalibration

_ROUNDS = 600
_NEAR_PX = 0.35
"""Disparity by which a point may be off its plane."""
_MOST_TURNED = np.cos(np.deg2rad(40.0))
_LEAST_SCALE, _MOST_SCALE = 0.45, 2.2
"""A plane that is turned or scaled more against the given floor is another one: a wall."""
_FARTHEST_SCALE = 12.0
"""The same of a floor whose height is wrong: in other units, or of another recording."""
_PREFERRED = 2.0
"""So many times the points of a plane near the given floor make another one the floor: a table or
a stage has fewer."""
_FEWEST = 60
"""Points that make a floor: fewer are a table."""
_SEED = 20


def floor_points(
    calibration: StereoCalibration, ground: Ground, matches: Matches
) -> NDArray[np.bool_] | None:
    """(n,) which pairs lie on the plane that most agree on and that may be the floor; None: none.

    Disparity is linear in the place in the image on any plane, also where the calibration is a
    little wrong, so that the floor is found before its height and tilt are believed. The given
    floor only says roughly which plane is meant.
    """
    found = _floor(calibration, ground, matches)
    return None if found is None else found[1]


def height_ratio(calibration: StereoCalibration, ground: Ground, matches: Matches) -> float | None:
    """How many times as high as both cameras see it the given floor says the camera is.

    None where no floor is seen. The cameras' distance is believed.
    """
    found = _floor(calibration, ground, matches)
    if found is None:
        return None
    return float(np.linalg.norm(found[0]) / np.linalg.norm(_given_plane(calibration, ground)))


def _floor(
    calibration: StereoCalibration, ground: Ground, matches: Matches
) -> tuple[Floats, NDArray[np.bool_]] | None:
    """(3,) p with normalised disparity = p . ray on the floor, (n,) which pairs lie on it."""
    rays, disparity = disparities(calibration, matches)
    usable = np.isfinite(disparity)
    if usable.sum() < _FEWEST:
        return None
    near = _NEAR_PX / focal_px(calibration)
    given = _given_plane(calibration, ground)
    best = _vote(rays[usable], disparity[usable], given, near)
    if best is None:
        return None
    on_floor = usable
    for tolerance in (2.0, 1.0, 1.0):
        error = np.abs(rays @ best - disparity)
        on_floor = usable & (error < tolerance * near)
        if on_floor.sum() < _FEWEST:
            return None
        fitted = np.linalg.lstsq(rays[on_floor], disparity[on_floor], rcond=None)[0]
        best = np.asarray(fitted, float)
    return best, np.asarray(on_floor)


def _given_plane(calibration: StereoCalibration, ground: Ground) -> Floats:
    """(3,) p with normalised disparity = p . ray on the floor as it is given."""
    rotation, centre = ground.world_from_camera
    return np.asarray(-rotation[2] * calibration.baseline_m / centre[2])


def _vote(rays: Floats, disparity: Floats, given: Floats, near: float) -> Floats | None:
    """The plane that most points agree on, of those that resemble the given one."""
    generator = np.random.default_rng(_SEED)
    best: list[Floats | None] = [None, None]  # near the given one, far from it
    most = [_FEWEST - 1.0, _FEWEST - 1.0]
    length = np.linalg.norm(given)
    for _ in range(_ROUNDS):
        chosen = generator.choice(len(rays), 3, replace=False)
        try:
            plane = np.asarray(np.linalg.solve(rays[chosen], disparity[chosen]), float)
        except np.linalg.LinAlgError:
            continue
        scale = np.linalg.norm(plane) / length
        if not 1 / _FARTHEST_SCALE < scale < _FARTHEST_SCALE:
            continue
        if plane @ given < _MOST_TURNED * scale * length**2:
            continue
        votes = float((np.abs(rays @ plane - disparity) < near).sum())
        far = not _LEAST_SCALE < scale < _MOST_SCALE
        if votes > most[far]:
            best[far], most[far] = plane, votes
    return best[1] if most[1] > _PREFERRED * most[0] or best[0] is None else best[0]
