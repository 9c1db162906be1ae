"""Which fault explains the matched points best, and which others do so as well."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.doctor.faults import Fault, Rig
from tracking.doctor.floor_points import floor_points
from tracking.doctor.matches import Matches
from tracking.doctor.residuals import floor_residuals, row_residuals

_CELLS = (10, 8)
"""Parts of the image, across and down. Errors of points beside each other are alike, so that a
part counts once, however many points it has."""
_FEWEST_IN_CELL = 4
_LEAST_SIGMA_PX = (0.02, 0.06)
"""Of rows and of disparity on the floor: by which matching itself is off over a part of the
image, as patches on the floor look different to both cameras."""
SURE = 30.0
"""Drop of chi squared from which a fault is told: 5.5 standard deviations of one number."""
ALIKE = 12.0
"""Faults whose chi squared differs by less are not told apart: 3.5 standard deviations."""
_STEP = 1e-4
_ROUNDS = 3


@dataclass(frozen=True, slots=True, eq=False)
class Cells:
    """Medians over parts of the image, as one vector of numbers with an uncertainty each.

    Attributes:
        residual, sigma: (m,) px.
        slope: (m, faults) px for one of each fault.
        rows: how many of them are of rows; the others are of the floor.
    """

    residual: Floats
    sigma: Floats
    slope: Floats
    rows: int

    @property
    def chi2(self) -> float:
        """Of no fault at all."""
        return float(((self.residual / self.sigma) ** 2).sum())

    def fitted(self, chosen: Sequence[int]) -> tuple[Floats, Floats, float]:
        """Amounts of the chosen faults, their standard deviations, and chi squared with them."""
        a = self.slope[:, chosen] / self.sigma[:, None]
        b = self.residual / self.sigma
        amounts = np.linalg.lstsq(a, -b, rcond=None)[0]
        spread = np.sqrt(np.diag(np.linalg.pinv(a.T @ a)))
        chi2 = float(((b + a @ amounts) ** 2).sum())
        return np.asarray(amounts, float), np.asarray(spread, float), chi2


@dataclass(frozen=True, slots=True, eq=False)
class Explained:
    """A fault that the pictures show.

    Attributes:
        amount, sigma: in the fault's fitted unit. z: square root of the drop in chi squared.
        alike: codes of the faults that explain it as well.
        mended: calibration and floor without it.
    """

    fault: Fault
    amount: float
    sigma: float
    z: float
    alike: tuple[str, ...]
    mended: Rig


def explain(rig: Rig, matches: Matches, faults: Sequence[Fault]) -> list[Explained]:
    """The faults that are sure, surest first; each is fitted with those before it mended."""
    told: list[Explained] = []
    floor = None if rig[1] is None else floor_points(rig[0], rig[1], matches)
    while len(told) < _MOST_FAULTS:
        found = _next(rig, matches, floor, faults)
        if found is None:
            break
        told.append(found)
        rig = found.mended
    return told


_MOST_FAULTS = 3
"""More at once are no longer faults, but another calibration."""


def _next(
    rig: Rig, matches: Matches, floor: NDArray[np.bool_] | None, faults: Sequence[Fault]
) -> Explained | None:
    faults = [fault for fault in faults if floor is not None or not fault.needs_floor]
    cells = measured(rig, matches, floor, faults)
    if cells is None:
        return None
    fits = [cells.fitted([number]) for number in range(len(faults))]
    drops = np.array(
        [
            cells.chi2 - chi2 if abs(amounts[0]) <= fault.most else -np.inf
            for fault, (amounts, _, chi2) in zip(faults, fits, strict=True)
        ]
    )
    best = int((drops > drops.max() - ALIKE).argmax())
    if drops[best] < SURE * max(1.0, fits[best][2] / max(1, len(cells.residual) - 1)):
        return None
    alike = [
        fault.code for number, fault in enumerate(faults)
        if number != best and drops.max() - drops[number] < ALIKE
    ]  # fmt: skip
    amount, sigma = fits[best][0][0], fits[best][1][0]
    amount, mended = _refined(rig, matches, floor, faults[best], amount)
    return Explained(
        faults[best], amount, float(sigma), float(np.sqrt(drops[best])), tuple(alike), mended
    )


def _refined(
    rig: Rig, matches: Matches, floor: NDArray[np.bool_] | None, fault: Fault, amount: float
) -> tuple[float, Rig]:
    """The amount once more, about itself: large ones are not linear."""
    mended = fault.apply(*rig, amount)
    for _ in range(_ROUNDS):
        cells = measured(mended, matches, floor, [fault])
        if cells is None:
            break
        amount += float(cells.fitted([0])[0][0])
        mended = fault.apply(*rig, amount)
    return amount, mended


def measured(
    rig: Rig, matches: Matches, floor: NDArray[np.bool_] | None, faults: Sequence[Fault]
) -> Cells | None:
    """Residuals of parts of the image, and what each fault does to them."""
    calibration, ground = rig
    everywhere = np.ones(len(matches), bool)
    chosen = [everywhere] if ground is None or floor is None else [everywhere, floor]
    blocks = [
        _block(rig, matches.only(kept), kind, faults, calibration.left.size)
        for kind, kept in enumerate(chosen)
    ]
    if not len(blocks[0][0]):
        return None
    residual, sigma, slope = (np.concatenate(each) for each in zip(*blocks, strict=True))
    return Cells(residual, sigma, slope, len(blocks[0][0]))


def _block(
    rig: Rig, matches: Matches, kind: int, faults: Sequence[Fault], size: tuple[int, int]
) -> tuple[Floats, Floats, Floats]:
    now = _residual(rig, matches, kind)
    slopes = np.column_stack(
        [(_residual(fault.apply(*rig, _STEP), matches, kind) - now) / _STEP for fault in faults]
    )
    place = (matches.first / size * _CELLS).astype(int).clip(0, np.array(_CELLS) - 1)
    cell = place[:, 1] * _CELLS[0] + place[:, 0]
    rows = []
    for number in np.unique(cell):
        inside = (cell == number) & np.isfinite(now)
        if inside.sum() < _FEWEST_IN_CELL:
            continue
        middle = np.median(now[inside])
        spread = _NORMAL * np.median(np.abs(now[inside] - middle))
        sigma = np.hypot(spread / np.sqrt(inside.sum()), _LEAST_SIGMA_PX[kind])
        rows.append((middle, sigma, *np.median(slopes[inside], axis=0)))
    table = np.array(rows).reshape(len(rows), 2 + len(faults))
    return table[:, 0], table[:, 1], table[:, 2:]


_NORMAL = 1.4826
"""Standard deviation over median absolute deviation of normal errors."""


def _residual(rig: Rig, matches: Matches, kind: int) -> Floats:
    calibration, ground = rig
    if kind == 0:
        return row_residuals(calibration, matches)
    assert ground is not None
    return floor_residuals(calibration, ground, matches)
