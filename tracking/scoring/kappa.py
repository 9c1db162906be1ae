"""Agreement of two raters beyond chance."""

from __future__ import annotations

import math

import numpy as np

from tracking.arrays import Integers


def cohen_kappa(first: Integers, second: Integers) -> float:
    """Cohen's kappa of two raters who each put the same n items into classes [Cohen1960].

    kappa = (p_o - p_e) / (1 - p_e): p_o is the share of items both put into one class, p_e the
    share expected of two raters who draw by lot, each with their own shares of the classes.
    1: they agree in everything. 0: no more than by lot. Below: less than that.

    [Cohen1960] J. Cohen, "A coefficient of agreement for nominal scales", Educational and
    Psychological Measurement 20(1), 1960. Where both name nothing but one and the same class the
    fraction is 0 / 0; as they agree in everything it is 1 here. NaN without items.

    Args:
        first, second: (n,) classes, as any whole numbers.
    """
    if not len(first):
        return math.nan
    classes, numbers = np.unique(np.concatenate([first, second]), return_inverse=True)
    one, other = numbers[: len(first)], numbers[len(first) :]
    agreed = float(np.mean(one == other))
    shares = [np.bincount(side, minlength=len(classes)) / len(first) for side in (one, other)]
    by_lot = float(shares[0] @ shares[1])
    return 1.0 if agreed == 1.0 else (agreed - by_lot) / (1.0 - by_lot)
