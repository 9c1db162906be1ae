"""Errors that review items state against those there are, and what decisions teach about the rest.

Of recordings that hazards and likelihoods were not fitted to. An item counts as an error where one
of its tracks goes wrong in the stretch that is watched. For what decisions teach, each recording's
items are decided one after the other, the most worth first, as somebody would who always decides
right; before each decision, what is stated of the item is held against what came of it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise

import numpy as np
from scipy.optimize import minimize
from scipy.stats import nbinom

from tests.benchmarks.review_cases import Case
from tracking.review import (
    DecidedItems,
    ErrorsLeft,
    ReviewItem,
    errors_left,
    find_review_items,
    rank,
    records_of,
    with_learned_likelihoods,
)
from tracking.review.risk import RiskModel

STRENGTHS = (1.0, 2.0, 4.0, 8.0, 16.0)
"""Priors that are compared, in decisions."""
_DECIDED = (0.0, 0.25, 0.5, 0.75)
"""Shares of the items that are decided where errors left are told."""
_BINS = (0.0, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0)


@dataclass(frozen=True)
class CaseRisk:
    """What is stated of a result's items, and what is so.

    Attributes:
        items: in the order of their worth. wrong: (n,) whether an error lies in each.
        errors: how many there are. shown: how many lie in any item. shown_by: (n,) how many of
            them lie in the items up to each.
    """

    recording: str
    tracker: str
    items: tuple[ReviewItem, ...]
    wrong: tuple[bool, ...]
    errors: int
    shown: int
    shown_by: tuple[int, ...]

    @property
    def stated(self) -> float:
        """Items that are errors as stated."""
        return sum(one.likelihood for one in self.items)

    def left_after(self, decided: int) -> int:
        """Errors that do not lie in the first items, which were put right."""
        return self.errors - (self.shown_by[decided - 1] if decided else 0)

    @property
    def found(self) -> int:
        """Items that are errors."""
        return sum(self.wrong)


def risk_of(case: Case) -> CaseRisk:
    """Search a result for review items and hold them against its errors."""
    found = find_review_items(case.table, case.run, case.fps, view=case.view, size=case.size)
    items = rank(found, "worth")
    held = np.array(
        [
            [
                one.start <= error.frame < one.end and not set(one.tracks).isdisjoint(error.tracks)
                for error in case.errors
            ]
            for one in items
        ],
        bool,
    ).reshape(len(items), len(case.errors))
    wrong = tuple(held.any(axis=1).tolist())
    by = tuple(np.logical_or.accumulate(held, axis=0).sum(axis=1).tolist())
    shown = by[-1] if by else 0
    return CaseRisk(case.recording, case.tracker, items, wrong, len(case.errors), shown, by)


def print_risks(risks: Sequence[CaseRisk]) -> None:
    """Tables: by recording, by stated likelihood, and what decisions teach."""
    print("| recording | results | items | stated | items that are errors | errors | in items |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for recording, group in groupby(risks, lambda one: one.recording):
        print(_row(recording, list(group)), flush=True)
    print(_row("all", risks))
    _print_bins(risks)
    _print_expected(risks)
    print("\n| prior worth | log loss a decision | stated | found |")
    print("| --- | --- | --- | --- |")
    for name, strength in (("no learning", None), *((f"{s:g} decisions", s) for s in STRENGTHS)):
        said = [one for risk in risks for one in _walked(risk, strength)]
        print(f"| {name} | {_log_loss(said):.4f} | {_sum(said, 0):.1f} | {_sum(said, 1):.0f} |")


def _row(name: str, group: Sequence[CaseRisk]) -> str:
    def total(of: Callable[[CaseRisk], float]) -> float:
        return sum(map(of, group))

    counts = len(group), total(lambda one: len(one.items))
    stated, found = total(lambda one: one.stated), total(lambda one: one.found)
    errors, shown = total(lambda one: one.errors), total(lambda one: one.shown)
    return f"| {name} | {counts[0]} | {counts[1]} | {stated:.1f} | {found} | {errors} | {shown} |"


def _print_bins(risks: Sequence[CaseRisk]) -> None:
    stated = np.array([one.likelihood for risk in risks for one in risk.items])
    wrong = np.array([one for risk in risks for one in risk.wrong])
    print("\n| stated likelihood | items | mean stated | errors |")
    print("| --- | --- | --- | --- |")
    for low, high in pairwise(_BINS):
        inside = (stated >= low) & (stated < high)
        if inside.any():
            means = f"{stated[inside].mean():.3f} | {wrong[inside].mean():.3f}"
            print(f"| {low:g} to {high:g} | {inside.sum()} | {means} |")


def _print_expected(risks: Sequence[CaseRisk]) -> None:
    """Errors expected by the model of all other recordings against those there are."""
    print(
        "\n| result | expected | likely | errors | half decided: expected | likely | errors left |"
    )
    print("| --- | --- | --- | --- | --- | --- | --- |")
    models = {name: _model_without(risks, name) for name in {one.recording for one in risks}}
    told: dict[float, list[tuple[ErrorsLeft, int]]] = {share: [] for share in _DECIDED}
    for risk in risks:
        for share, every in told.items():
            decided = int(len(risk.items) * share)
            left = _expected(risk, decided, models[risk.recording])
            every.append((left, risk.left_after(decided)))
        line = [
            f"{left.mean:.1f} | {left.low} to {left.high} | {errors}"
            for left, errors in (told[0.0][-1], told[0.5][-1])
        ]
        print(f"| {risk.recording}, {risk.tracker} | {' | '.join(line)} |")
    print(f"\nFor all footage: {_fitted_model(risks)}\n")
    print("| decided | expected | errors left | within the range for four in five | mean error |")
    print("| --- | --- | --- | --- | --- |")
    for share, every in told.items():
        inside = np.mean([left.low <= errors <= left.high for left, errors in every])
        stated, there = (sum(one) for one in zip(*((e.mean, n) for e, n in every), strict=True))
        off = np.mean([abs(left.mean - errors) for left, errors in every])
        print(f"| {share:.0%} | {stated:.0f} | {there} | {inside:.0%} | {off:.1f} |")


def _expected(risk: CaseRisk, decided: int, model: RiskModel) -> ErrorsLeft:
    """Errors left once the items worth most are decided, and nothing else was reviewed."""
    outcome, left = _decided(risk, decided)
    return errors_left(left, outcome, risk.stated, model)


def _decided(risk: CaseRisk, decided: int) -> tuple[DecidedItems, float]:
    """What came of the items worth most, and what is stated of the others."""
    done, left = risk.items[:decided], risk.items[decided:]
    outcome = DecidedItems(sum(one.likelihood for one in done), sum(risk.wrong[:decided]))
    return outcome, sum(one.likelihood for one in left)


def _model_without(risks: Sequence[CaseRisk], recording: str) -> RiskModel:
    return _fitted_model([one for one in risks if one.recording != recording])


def _fitted_model(risks: Sequence[CaseRisk]) -> RiskModel:
    """The likeliest figures, over all results at each share that is decided."""
    rows = []
    for risk in risks:
        for share in _DECIDED:
            decided = int(len(risk.items) * share)
            outcome, left = _decided(risk, decided)
            rows.append(
                (outcome.stated, outcome.errors, left, risk.stated, risk.left_after(decided))
            )
    stated, errors, left, whole, there = np.array(rows, float).T

    def unlikely(logs: np.ndarray) -> float:
        model = RiskModel(*np.exp(logs))
        shape = model.shape + model.weight * errors
        rate = model.shape + model.weight * model.shown * stated
        exposure = np.maximum(model.shown * left + model.hidden * whole, 1e-9)
        return -float(nbinom(shape, rate / (rate + exposure)).logpmf(there).sum())

    best = minimize(unlikely, np.log([1.1, 0.4, 0.7, 0.4]), method="Nelder-Mead")
    return RiskModel(*(round(float(one), 2) for one in np.exp(best.x)))


def _walked(risk: CaseRisk, strength: float | None) -> list[tuple[float, bool]]:
    """What is stated of each item just before it is decided, and what came of it."""
    said, outcomes = [], []
    for one, wrong in zip(risk.items, risk.wrong, strict=True):
        now = one
        if strength is not None:
            (now,) = with_learned_likelihoods([one], records_of(outcomes), strength)
        said.append((now.likelihood, wrong))
        outcomes.append((one.kind, one.likelihood, wrong))
    return said


def _log_loss(said: Iterable[tuple[float, bool]]) -> float:
    every = [np.log(max(stated if wrong else 1.0 - stated, 1e-9)) for stated, wrong in said]
    return float(-np.mean(every)) if every else float("nan")


def _sum(said: Iterable[tuple[float, bool]], side: int) -> float:
    return sum(float(one[side]) for one in said)
