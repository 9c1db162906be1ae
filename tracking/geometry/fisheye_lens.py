"""The fisheye lens of Kannala and Brandt, on normalised image coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats

_WIDEST_RAD = np.deg2rad(89.0)
"""Farthest off the axis that is looked at: pinhole rays end at 90 degrees."""
_SAMPLES = 2001
_LEAST_SLOPE = 0.05
"""Of the angle shown over the angle seen: where it is less, the fit turns back."""
_ITERATIONS = 20


@dataclass(frozen=True, slots=True, eq=False)
class FisheyeLens:
    """OpenCV's fisheye model: the distance from the middle grows with the angle off the axis.

    `theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)`. Like `Lens` it is
    kept sane outside of the field where the calibration holds: past `limit` angles go on at the
    rate reached there.

    Source: J. Kannala, S. Brandt: A generic camera model and calibration method, 2006.

    Attributes:
        coefficients: (4,) k1 to k4. limit: largest angle in rad that is believed.
        slope: of the angle shown there. edge: the angle shown there.
    """

    coefficients: Floats
    limit: float
    edge: float
    slope: float

    @classmethod
    def from_coefficients(cls, coefficients: Floats) -> FisheyeLens:
        """The lens of up to four coefficients."""
        k = np.zeros(4)
        k[: len(coefficients)] = coefficients
        angle = np.linspace(0.0, _WIDEST_RAD, _SAMPLES)
        slope = _slope(k, angle)
        back = np.flatnonzero(~(slope > _LEAST_SLOPE))
        last = max(int(back[0]) - 1, 1) if back.size else len(angle) - 1
        limit = float(angle[last])
        return cls(k, limit, float(_shown(k, limit)), float(max(slope[last], _LEAST_SLOPE)))

    @property
    def is_ideal(self) -> bool:
        """Whether the lens distorts nothing: a fisheye always does."""
        return False

    def distort(self, points: Floats) -> Floats:
        """Normalised image coordinates (n, 2) of ideal rays (n, 2) as the lens shows them."""
        points = np.asarray(points, float).reshape(-1, 2)
        radius = np.hypot(points[:, 0], points[:, 1])
        shown = self._shown(np.arctan(radius))
        factor = np.where(radius > 1e-9, shown / np.maximum(radius, 1e-9), 1.0)
        return points * factor[:, None]

    def undistort(self, points: Floats) -> Floats:
        """Ideal rays (n, 2) of normalised image coordinates; NaN at 90 degrees and beyond."""
        points = np.asarray(points, float).reshape(-1, 2)
        shown = np.hypot(points[:, 0], points[:, 1])
        angle = self._seen(shown)
        inside = np.isfinite(shown) & (angle <= _WIDEST_RAD)
        radius = np.tan(np.where(inside, angle, 0.0))
        factor = np.where(shown > 1e-9, radius / np.maximum(shown, 1e-9), 1.0)
        return np.where(inside[:, None], points * factor[:, None], np.nan)

    def _shown(self, angle: Floats) -> Floats:
        beyond = self.edge + self.slope * (angle - self.limit)
        return np.where(angle > self.limit, beyond, _shown(self.coefficients, angle))

    def _seen(self, shown: Floats) -> Floats:
        """Newton's steps from a first guess between table values."""
        angle = np.linspace(0.0, self.limit, _SAMPLES)
        found = np.interp(shown, _shown(self.coefficients, angle), angle)
        for _ in range(_ITERATIONS):
            miss = _shown(self.coefficients, found) - shown
            step = miss / np.maximum(_slope(self.coefficients, found), _LEAST_SLOPE)
            found = np.clip(found - step, 0.0, self.limit)
            if np.nanmax(np.abs(step), initial=0.0) < 1e-12:
                break
        beyond = self.limit + (shown - self.edge) / self.slope
        return np.where(shown > self.edge, beyond, found)


def _shown(k: Floats, angle: Floats | float) -> Floats:
    square = np.asarray(angle, float) ** 2
    series = 1 + square * (k[0] + square * (k[1] + square * (k[2] + square * k[3])))
    return np.asarray(angle * series)


def _slope(k: Floats, angle: Floats) -> Floats:
    square = angle**2
    return np.asarray(
        1 + square * (3 * k[0] + square * (5 * k[1] + square * (7 * k[2] + square * 9 * k[3])))
    )
