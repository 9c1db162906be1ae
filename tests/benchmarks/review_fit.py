"""Fits the hazards of rows and the likelihoods of review items: see `tracking.review.hazard`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from sklearn.ensemble import HistGradientBoostingClassifier

import resources
from tests.benchmarks.review_cases import Case
from tracking.review.block import JOINED_S
from tracking.review.core.evidence import Evidence, gather_evidence
from tracking.review.core.material import Material
from tracking.review.hazard import FEATURES, NOTICED, Hazards, Trees, features
from tracking.review.likelihood import LEAST_WEIGHT, NOTHING, WEIGHTS
from tracking.review.reason_groups import Places, Reasons, join_places, stack_findings
from tracking.review.reasons import REASONS
from tracking.review.stretches import Stretches, stretches

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Flags = NDArray[np.bool_]
_AROUND = 2
"""Frames from an error within which the rows of its tracks count as going wrong."""
_NATURAL, _CALM = 3.0, 3.0
"""How much more rows without swaps on purpose, and rows of calm scenes, count."""
_KEPT = 0.1
"""Share of the rows without an error that are fitted on; each then counts for ten."""
_UNNOTICED = 0.1
"""Share of the rows told as of a run that noticed nothing."""
_SMOOTH = 0.2
"""Share of the wrong rows of tracks swapped on purpose told as of a walk without a jump: where a
tracker mistakes people, or a person swaps tracks, they do not always jump."""
_WALK = ("jump", "jump_0.3s", "missed", "missed_0.15s", "turn")
_TREES, _LEAVES, _RATE, _LEAST_ROWS, _SHRINKAGE = 60, 4, 0.1, 60, 5.0
_BINS = (0.0, 0.03, 0.1, 0.2, 0.4, 0.7, 0.9, 1.0)


def fit(cases: Sequence[Case]) -> None:
    """Write the trees into the resources; print the likelihoods' figures for the code."""
    trees = fitted_trees(cases)
    path = Path(next(iter(resources.__path__))) / "review" / "hazard.json"
    path.write_text(trees.as_text(), encoding="utf-8")
    expected, mistaken = _examples(cases, trees)
    theta = _logistic(expected, mistaken)
    print("BASE, EFOLD, ROW =", ", ".join(f"{value:.2f}" for value in theta))
    _print_calibration(1.0 / (1.0 + np.exp(-_odds(theta, expected))), mistaken)


def fitted_trees(cases: Sequence[Case], seed: int = 0) -> Trees:
    """Trees that tell rows of tracks that go wrong from the others."""
    random = np.random.default_rng(seed)
    parts = [_rows(case, random) for case in cases]
    values, wrong, weight = (np.concatenate(each) for each in zip(*parts, strict=True))
    model = HistGradientBoostingClassifier(
        max_iter=_TREES,
        max_leaf_nodes=_LEAVES,
        learning_rate=_RATE,
        min_samples_leaf=_LEAST_ROWS,
        l2_regularization=_SHRINKAGE,
        early_stopping=False,
        random_state=seed,
    ).fit(values, wrong, sample_weight=weight)
    base = float(model._baseline_prediction.ravel()[0])
    return Trees(FEATURES, base, tuple(map(_nodes, model._predictors)))


def _rows(case: Case, random: np.random.Generator) -> tuple[Singles, Flags, Floats]:
    """Features of a case's rows that are fitted on, whether they go wrong, and their weights."""
    material = _material(case)
    wrong = _going_wrong(case, material.evidence)
    kept = np.flatnonzero(wrong | (random.random(len(wrong)) < _KEPT))
    values, wrong = features(material)[kept], wrong[kept]
    unnoticed = np.flatnonzero(random.random(len(kept)) < _UNNOTICED)
    values[np.ix_(unnoticed, [FEATURES.index(name) for name in NOTICED])] = np.nan
    if case.swaps:
        smooth = np.flatnonzero(wrong & (random.random(len(kept)) < _SMOOTH))
        walk = [FEATURES.index(name) for name in _WALK]
        usual = random.choice(np.flatnonzero(~wrong), len(smooth))
        values[np.ix_(smooth, walk)] = values[np.ix_(usual, walk)]
    weight = (1.0 if case.swaps else _NATURAL) * (_CALM if case.calm else 1.0)
    return values, wrong, weight * np.where(wrong, 1.0, 1.0 / _KEPT)


def _going_wrong(case: Case, evidence: Evidence) -> Flags:
    wrong = np.zeros(len(evidence), np.bool_)
    for error in case.errors:
        near = np.abs(evidence.frame - error.frame) <= _AROUND
        wrong |= near & np.isin(evidence.track, error.tracks)
    return wrong


def _nodes(predictor: Sequence[object]) -> tuple[tuple[float, ...], ...]:
    """A tree of scikit-learn's in the form of `Trees`."""
    return tuple(_node(node) for node in predictor[0].nodes)  # type: ignore[attr-defined]  # inner


def _node(node: np.void) -> tuple[float, ...]:
    if node["is_leaf"]:
        return (-1, round(float(node["value"]), 5), 0, 0, 0)
    low, high = int(node["left"]), int(node["right"])
    unknown = low if node["missing_go_to_left"] else high
    return (int(node["feature_idx"]), float(np.float32(node["num_threshold"])), low, high, unknown)


def _material(case: Case) -> Material:
    evidence = gather_evidence(case.table, case.run, case.fps)
    return Material.of(evidence, case.size, ())


def _examples(cases: Sequence[Case], trees: Trees) -> tuple[Floats, Flags]:
    """(k,) hazard expected in each place's stretch; (k,) whether an error lies in it."""
    expected, mistaken = zip(*_places(cases, trees), strict=True)
    return np.concatenate(expected), np.concatenate(mistaken)


def _places(cases: Sequence[Case], trees: Trees) -> Iterator[tuple[Floats, Flags]]:
    weights = [max(WEIGHTS[kind], LEAST_WEIGHT) for kind in REASONS]
    for case in cases:
        material = _material(case)
        reasons = stack_findings([look(material) for look in REASONS.values()], weights)
        places = join_places(reasons, material.evidence.frames_of(JOINED_S))
        watched = stretches(reasons, places, Hazards.of(material, trees))
        kept = watched.expected > NOTHING
        yield watched.expected[kept], _mistaken(case, reasons, places, watched)[kept]


def _mistaken(case: Case, reasons: Reasons, places: Places, watched: Stretches) -> Flags:
    """(k,) whether an error of one of the place's tracks lies in the stretch."""
    one, other = reasons.first[places.leader], reasons.second[places.leader]
    wrong = np.zeros(len(one), np.bool_)
    for error in case.errors:
        named = np.isin(one, error.tracks) | np.isin(other, error.tracks)
        wrong |= named & (watched.start <= error.frame) & (error.frame < watched.end)
    return wrong


def _odds(theta: Floats, expected: Floats) -> Floats:
    return np.asarray(theta[0] + theta[1] * np.log(expected) + theta[2] * expected)


def _logistic(expected: Floats, mistaken: Flags) -> Floats:
    """(3,) what makes the mistakes likeliest."""

    def loss(theta: Floats) -> float:
        odds = _odds(theta, expected)
        return float((np.logaddexp(0.0, odds) - mistaken * odds).sum())

    return np.asarray(minimize(loss, np.array([-1.0, 0.5, 0.3]), method="Nelder-Mead").x)


def _print_calibration(likely: Floats, mistaken: Flags) -> None:
    print("likelihood  places  mean   mistakes")
    for low, high in pairwise(_BINS):
        inside = (likely >= low) & (likely < high)
        if inside.any():
            share = f"{likely[inside].mean():.3f}  {mistaken[inside].mean():.3f}"
            print(f"{low:.2f}-{high:.2f}  {inside.sum():6}  {share}")
