"""Fits the likelihoods of suspicions anew: see `tracking.review.likelihood`."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from tests.benchmarks.review_cases import Case
from tracking.review.crowding import crowding
from tracking.review.evidence import gathered
from tracking.review.found import Found
from tracking.review.joining import Places, Reasons, joined_places, stacked
from tracking.review.likelihood import LEAST_WEIGHT
from tracking.review.material import Material
from tracking.review.reasons import REASONS
from tracking.review.searching import JOINED_S
from tracking.review.stretches import stretches

Floats = NDArray[np.float64]
_ROUNDS = 4
_SHRINKAGE = 0.5
_BINS = (0.0, 0.03, 0.1, 0.2, 0.4, 0.7, 0.9, 1.0)


def fit(cases: Sequence[Case]) -> None:
    """Print the table, and how often places of each likelihood were mistakes.

    Weights also decide which reason leads a place, so both are found in turns.
    """
    looked = [(case, *_looked(case)) for case in cases]
    weights = np.ones(len(REASONS))
    for _ in range(_ROUNDS):
        strength, mistaken = _examples(looked, weights)
        fitted = _logistic(strength, mistaken)
        weights = fitted[3:]
    _print(fitted)
    strength, mistaken = _examples(looked, weights)
    _print_calibration(1.0 / (1.0 + np.exp(-(fitted[0] + strength @ fitted[1:]))), mistaken)


def _looked(case: Case) -> tuple[Material, list[Found]]:
    evidence = gathered(case.table, case.run, case.fps)
    material = Material.of(evidence, case.view.camera.size, ())
    return material, [look(material) for look in REASONS.values()]


def _examples(
    looked: Sequence[tuple[Case, Material, list[Found]]], weights: Floats
) -> tuple[Floats, Floats]:
    """(k, 2 + kinds) two tracks or one, crowding, and strengths; (k,) 1 for mistakes."""
    strengths, mistaken = [], []
    for case, material, found in looked:
        reasons = stacked(found, np.maximum(weights, LEAST_WEIGHT).tolist())
        places = joined_places(reasons, material.evidence.frames_of(JOINED_S))
        two = reasons.second[places.leader] > 0
        crowd = crowding(material, reasons.frame[places.leader])
        strengths.append(np.column_stack((two, crowd, places.strength)))
        mistaken.append(_mistaken(case, reasons, places, material))
    return np.concatenate(strengths), np.concatenate(mistaken).astype(float)


def _mistaken(
    case: Case, reasons: Reasons, places: Places, material: Material
) -> NDArray[np.bool_]:
    """(k,) whether an error of one of the place's tracks lies in the stretch."""
    start, end = stretches(reasons, places, material.evidence)
    one, other = reasons.first[places.leader], reasons.second[places.leader]
    wrong = np.zeros(len(start), np.bool_)
    for error in case.errors:
        named = np.isin(one, error.tracks) | np.isin(other, error.tracks)
        wrong |= named & (start <= error.frame) & (error.frame < end)
    return wrong


def _logistic(strength: Floats, mistaken: Floats) -> Floats:
    """(3 + kinds,) intercept, and weights that are not below 0."""

    def loss(theta: Floats) -> tuple[float, Floats]:
        odds = theta[0] + strength @ theta[1:]
        off = 1.0 / (1.0 + np.exp(-odds)) - mistaken
        value = (np.logaddexp(0.0, odds) - mistaken * odds).sum()
        gradient = np.concatenate(([off.sum()], strength.T @ off + 2 * _SHRINKAGE * theta[1:]))
        return float(value + _SHRINKAGE * np.square(theta[1:]).sum()), gradient

    count = strength.shape[1]
    start = np.concatenate(([-3.0], np.ones(count)))
    bounds = [(None, None)] + [(0.0, None)] * count
    return np.asarray(minimize(loss, start, jac=True, bounds=bounds, method="L-BFGS-B").x)


def _print(fitted: Floats) -> None:
    print(f"ONE, TWO = {fitted[0]:.2f}, {fitted[0] + fitted[1]:.2f}")
    print(f"CROWD = {fitted[2]:.2f}")
    for kind, weight in zip(REASONS, fitted[3:], strict=True):
        print(f'"{kind}": {weight:.2f},')


def _print_calibration(likely: Floats, mistaken: Floats) -> None:
    print("likelihood  places  mean   mistakes")
    for low, high in pairwise(_BINS):
        inside = (likely >= low) & (likely < high)
        if inside.any():
            share = f"{likely[inside].mean():.3f}  {mistaken[inside].mean():.3f}"
            print(f"{low:.2f}-{high:.2f}  {inside.sum():6}  {share}")
