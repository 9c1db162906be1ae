"""The horizon of one camera that is not calibrated, from how high people are in its image.

People of about one height on a level floor: the height of a body in the image grows linearly with
how far its feet are below the horizon (D. Hoiem, A. Efros, M. Hebert: Putting Objects in
Perspective, 2008). The line is fitted robustly, as boxes of groups, of parts of bodies and of what
is no person are among those it is fitted to. Steep cameras see no such line, and have none.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats

_FEWEST = 12
"""Boxes below which nothing is fitted."""
_SPREAD = 0.10
"""Of people's heights and of measured boxes, as a share of the height."""
_ROLL_SD = 0.05
"""Of the horizon's slope: cameras stand about level."""
_ROUNDS = 40
_CUT = 3.0
"""Spreads beyond which a box is of no whole body and says nothing: Tukey's weights."""
_MOST_ALIKE = 0.6
"""Share of boxes that are of the height expected; steep cameras and empty scenes have fewer."""
_SURE = 0.08
"""Uncertainty of an expected height, as a share of it, up to which it is used."""
_SIZES = (0.35, 1.8)
"""Heights of boxes that may be of people, in those expected: half hidden ones, and children, up to
groups with somebody on shoulders."""
_DEVIATIONS = 3.0
"""How far feet may be above the horizon."""
_APART = 0.02
"""Least distance of the feet of such a pair, as a share of that of all."""
_STARTS = 60
"""Pairs of boxes that the fit is tried from."""


@dataclass(frozen=True, slots=True, eq=False)
class Horizon:
    """Where the horizon is, and how high people are.

    Attributes:
        line: (3,) a body's height in px is line[0] + line[1] * u + line[2] * v of its foot, px.
        covariance: (3, 3) of it. spread: of people about it, as a share of their height.
    """

    line: Floats
    covariance: Floats
    spread: float

    def heights(self, foot: Floats) -> Floats:
        """(n,) px expected of people with feet (n, 2) px; 0 or less above the horizon."""
        return np.asarray(_terms(foot) @ self.line)

    def is_sure(self, foot: Floats) -> Flags:
        """(n,) where the height expected is known well enough to be used."""
        terms = _terms(foot)
        sd = np.sqrt(np.einsum("ni,ij,nj->n", terms, self.covariance, terms))
        return np.asarray(sd <= _SURE * np.maximum(self.heights(foot), 1e-9))

    def row(self, u: float) -> float:
        """Where the horizon crosses a column, px."""
        return float(-(self.line[0] + self.line[1] * u) / self.line[2])

    def row_sd(self, u: float) -> float:
        """The uncertainty of that, px."""
        slope = np.array([-1.0, -u, -self.row(u)]) / self.line[2]
        return float(np.sqrt(slope @ self.covariance @ slope))

    def allows(self, box: Floats) -> Flags:
        """(n,) whether boxes (n, 4) px may be of people: not above the horizon, of their size.

        Where the height expected is not known well enough, all may be.
        """
        foot = np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))
        share = box[:, 3] / np.maximum(self.heights(foot), 1e-9)
        fits = (share > _SIZES[0]) & (share < _SIZES[1])
        middle = float(foot[:, 0].mean()) if len(foot) else 0.0
        row, sd = self.row(middle), self.row_sd(middle)
        return np.asarray((fits | ~self.is_sure(foot)) & (foot[:, 1] > row - _DEVIATIONS * sd))


def fit_horizon(box: Floats) -> Horizon | None:
    """The horizon of people's boxes (n, 4) px; None where they do not tell it.

    Args:
        box: of people seen at different times; several of one are one look each.
    """
    known = box[(box[:, 3] > 0) & np.isfinite(box).all(axis=1)]
    if len(known) < _FEWEST:
        return None
    foot = np.column_stack((known[:, 0] + known[:, 2] / 2, known[:, 1] + known[:, 3]))
    terms, height = _terms(foot), known[:, 3]
    best = _best_start(terms, height)
    line, weight = _refined(best, terms, height)
    expected = terms @ line
    if line[2] <= 0.0 or np.mean(weight > 0.5) < _MOST_ALIKE:
        return None
    precise = terms / (_SPREAD * np.maximum(expected, 1.0))[:, None]
    information = (precise * weight[:, None]).T @ precise + _prior(line)
    covariance = np.asarray(np.linalg.inv(information), np.float64)
    off = (height - expected)[weight > 0.5] / expected[weight > 0.5]
    return Horizon(line, covariance, float(np.sqrt(np.mean(np.square(off)))))


def _terms(foot: Floats) -> Floats:
    return np.column_stack((np.ones(len(foot)), foot))


def _prior(line: Floats) -> Floats:
    """Information that the horizon is about level, and hardly any of the rest."""
    prior = np.zeros((3, 3))
    prior[1, 1] = 1.0 / (_ROLL_SD * max(line[2], 1e-3)) ** 2
    return prior + np.diag((1e-9, 0.0, 1e-6))


def _best_start(terms: Floats, height: Floats) -> Floats:
    """The level line through two of the boxes that suits most."""
    rng = np.random.default_rng(0)
    best, cost = np.array([0.0, 0.0, 0.3]), np.inf
    for one, other in rng.integers(0, len(height), (_STARTS, 2)):
        down = terms[one, 2] - terms[other, 2]
        if abs(down) <= _APART * np.ptp(terms[:, 2]):
            continue
        slope = (height[one] - height[other]) / down
        line = np.array([height[one] - slope * terms[one, 2], 0.0, slope])
        off = _shares(line, terms, height)
        found = np.log1p(np.square(off / _SPREAD)).sum()
        if slope > 0 and found < cost:
            best, cost = line, found
    return best


def _shares(line: Floats, terms: Floats, height: Floats) -> Floats:
    """(n,) how far off heights are, as shares of those expected."""
    expected = np.maximum(terms @ line, 0.02 * height + 1.0)
    return np.asarray((height - expected) / np.maximum(expected, 1.0))


def _refined(line: Floats, terms: Floats, height: Floats) -> tuple[Floats, Floats]:
    """The line of the least robust cost from there on, and the weight of each box."""
    weight = np.ones(len(height))
    for _ in range(_ROUNDS):
        off = np.square(_shares(line, terms, height) / (_CUT * _SPREAD))
        weight = np.square(np.maximum(1.0 - off, 0.0))
        scale = 1.0 / (_SPREAD * np.maximum(terms @ line, 1.0))
        scaled = terms * scale[:, None]
        information = (scaled * weight[:, None]).T @ scaled + _prior(line)
        wanted = (scaled * weight[:, None]).T @ (height * scale)
        line = np.asarray(np.linalg.solve(information, wanted), np.float64)
    return line, weight
