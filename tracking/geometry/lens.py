"""Lens distortion, kept sane outside the field where a calibration holds."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracking.arrays import Floats

_WIDEST_RADIUS = 5.0
"""Tangent of the widest angle looked at (79 degrees off the axis)."""
_SAMPLES = 4001
_LEAST_SLOPE = 0.1
_POLE_MARGIN = 0.9
_ITERATIONS = 30
_CONVERGED = 1e-10
_FOUND = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class Lens:
    """OpenCV's distortion model on normalised image coordinates.

    A rational distortion has poles and a polynomial one turns back, often inside the picture's
    corners (a fit of eight coefficients nearly always does). Past `limit` both directions
    therefore go on with the factor reached there, so that near points stay near and the mapping
    can be undone everywhere. OpenCV's own functions give garbage there.

    Attributes:
        coefficients: (k,) in OpenCV's order, k one of 0, 4, 5, 8, 12, 14.
        limit: largest undistorted radius (tangent of the angle off the axis) that is believed.
        radius, distorted: (m,) matching radii up to `limit`, both increasing.
    """

    coefficients: Floats
    limit: float
    radius: Floats
    distorted: Floats

    @classmethod
    def from_coefficients(cls, coefficients: Floats) -> Lens:
        """The lens of the given coefficients, its limit found by looking along the radius."""
        radius = np.linspace(0.0, _WIDEST_RADIUS, _SAMPLES)
        factor, denominator = _radial_factor(coefficients, radius)
        last = _last_believed(radius, radius * factor, denominator)
        return cls(
            coefficients, float(radius[last]), radius[: last + 1], (radius * factor)[: last + 1]
        )

    @property
    def is_ideal(self) -> bool:
        """Whether the lens distorts nothing."""
        return not self.coefficients.any()

    def distort(self, points: Floats) -> Floats:
        """Normalised image coordinates (n, 2) of ideal rays as the lens shows them."""
        if self.is_ideal or not len(points):
            return points
        stretch = np.maximum(np.hypot(points[:, 0], points[:, 1]) / self.limit, 1.0)[:, None]
        return self._distort_within(points / stretch) * stretch

    def undistort(self, points: Floats) -> Floats:
        """Ideal rays (n, 2) of normalised image coordinates; NaN where none is found."""
        if self.is_ideal or not len(points):
            return points
        points = np.where(np.isfinite(points).all(axis=1, keepdims=True), points, np.nan)
        rays = self._first_guess(points)
        for _ in range(_ITERATIONS):
            miss = points - self.distort(rays)
            if np.nanmax(np.abs(miss), initial=0.0) < _CONVERGED:
                break
            rays = rays + self._step(rays, miss)
        reach = np.maximum(1.0, np.abs(points).max(axis=1))
        found = np.abs(self.distort(rays) - points).max(axis=1) < _FOUND * reach
        return np.where(found[:, None], rays, np.nan)

    def _distort_within(self, points: Floats) -> Floats:
        known = np.isfinite(points).all(axis=1)
        shown = np.full_like(points, np.nan)
        if known.any():
            rays = np.column_stack((points[known], np.ones(known.sum())))
            image, _ = cv2.projectPoints(
                rays, np.zeros(3), np.zeros(3), np.eye(3), self.coefficients
            )
            shown[known] = image[:, 0]
        return shown

    def _first_guess(self, points: Floats) -> Floats:
        seen = np.hypot(points[:, 0], points[:, 1])
        inner = np.interp(seen, self.distorted, self.radius)
        outer = seen * (self.limit / self.distorted[-1])
        radius = np.where(seen > self.distorted[-1], outer, inner)
        return points * (radius / np.maximum(seen, 1e-12))[:, None]

    def _step(self, rays: Floats, miss: Floats) -> Floats:
        """Newton's step with the radial part's derivative; the tangential part is small."""
        length = np.maximum(np.hypot(rays[:, 0], rays[:, 1]), 1e-12)[:, None]
        outward = rays / length
        radial = (miss * outward).sum(axis=1, keepdims=True)
        slope = np.interp(length[:, 0], self.radius, np.gradient(self.distorted, self.radius))
        shown = np.interp(length[:, 0], self.radius, self.distorted)
        factor = np.where(length[:, 0] < 1e-3, 1.0, shown / length[:, 0])[:, None]
        beyond = length[:, 0] > self.limit
        edge_factor = self.distorted[-1] / self.limit
        slope = np.where(beyond, edge_factor, slope)[:, None]
        factor = np.where(beyond[:, None], edge_factor, factor)
        return np.asarray(outward * radial / slope + (miss - outward * radial) / factor)


def _radial_factor(coefficients: Floats, radius: Floats) -> tuple[Floats, Floats]:
    """The radial factor along the radius, and its denominator."""
    k = np.zeros(14)
    k[: len(coefficients)] = coefficients
    u = radius**2
    denominator = 1 + k[5] * u + k[6] * u**2 + k[7] * u**3
    with np.errstate(divide="ignore", invalid="ignore"):
        return (1 + k[0] * u + k[1] * u**2 + k[4] * u**3) / denominator, denominator


def _last_believed(radius: Floats, distorted: Floats, denominator: Floats) -> int:
    """Index of the largest radius before a pole comes near or the mapping turns back."""
    last = len(radius) - 1
    poles = np.flatnonzero(~(denominator > 0))
    if poles.size:
        last = min(last, int(_POLE_MARGIN * poles[0]))
    flat = np.flatnonzero(~(np.diff(distorted) > _LEAST_SLOPE * np.diff(radius)))
    if flat.size:
        last = min(last, int(flat[0]))
    return max(last, 1)
