"""What is done to features before a machine sees them: it belongs to the detector, not to them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.failure.core.features import FEATURES, PAPER_FEATURES

_CENTRES = [0, 1, 6, 7, 12, 13]
"""Columns of the parts' relative centres."""
_LEAST_PX = 1.0
"""Three parts on one point have no size to measure by."""


@dataclass(frozen=True, slots=True, eq=False)
class Preparation:
    """Measures features in bodies if asked, standardises them, and draws far-off values in.

    A part lost at the other end of the picture lies far outside of everything learnt, where a
    kernel machine knows nothing and falls back to its constant. So numbers beyond the usual are
    drawn in by the inverse hyperbolic sine: a straight line for the usual, a logarithm far out.
    The paper does not say how it scales.

    Attributes:
        by_size: whether features are divided by how far the parts lie apart, with the logarithm
            of that as one number more. In pixels, near and far people differ.
        centre, scale: (d,) of the usual values; scale > 0. d is 36 where the machines see the
            paper's features alone, 60 where evidence, too; one more by size.
    """

    by_size: bool
    centre: Floats
    scale: Floats

    @property
    def paper(self) -> bool:
        """Whether the machines see the features of [ZhaoLee2009] alone."""
        return len(self.centre) == numbers_seen(by_size=self.by_size, paper=True)

    def of(self, features: Floats) -> Floats:
        """(n, d) what the machines see of features (n, 60); of the paper's alone (n, 36) do."""
        prepared = _numbers(features, self.by_size, self.paper) - self.centre
        prepared /= self.scale
        return np.arcsinh(prepared, out=prepared)


def fitted_preparation(features: Floats, *, by_size: bool, paper: bool) -> Preparation:
    """The preparation that makes the usual of these features (n, 60) zero and one.

    Median and half the range of the middle two thirds, since parts that failed may be anywhere;
    of what is nearly always the same, as nothing above a head, the standard deviation.
    """
    values = _numbers(features, by_size, paper)
    low, centre, high = np.quantile(values, (1 / 6, 1 / 2, 5 / 6), axis=0)
    spread = (high - low) / 2
    spread = np.where(spread > 0, spread, values.std(axis=0))
    return Preparation(by_size, centre, np.where(spread > 0, spread, 1.0))


def numbers_seen(*, by_size: bool, paper: bool) -> int:
    """How many numbers the machines see."""
    return (PAPER_FEATURES if paper else FEATURES) + by_size


def body_sizes(features: Floats) -> Floats:
    """(n,) px, how far the parts of a person lie apart: about half of their height."""
    centres = features[:, _CENTRES]
    size: Floats = np.maximum(np.sqrt(np.einsum("nc,nc->n", centres, centres)), _LEAST_PX)
    return size


def _numbers(features: Floats, by_size: bool, paper: bool) -> Floats:
    """(n, d) features, the paper's in sizes of the person with the logarithm of the size in px.

    Evidence is in shares and in heights of the person already.
    """
    own = features[:, :PAPER_FEATURES]
    ours = features[:, PAPER_FEATURES : PAPER_FEATURES if paper else FEATURES]
    if not by_size:
        return np.concatenate((own, ours), axis=1)
    size = body_sizes(features)[:, None]
    return np.concatenate((own / size, np.log(size), ours), axis=1)
