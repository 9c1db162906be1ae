"""The failure detector: which parts a tracker has lost, and whether it lost one or several."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.machines import Machines
from tracking.failure.core.operating_points import Curve
from tracking.failure.core.preparation import Preparation
from tracking.tracks import PARTS

FALSE_ALARMS = 0.02
"""A missed failure costs less than a false alarm [ZhaoLee2009]: at most so many by default."""


@dataclass(frozen=True, slots=True, eq=False)
class Judgement:
    """What the detector says of people, n.

    Attributes:
        failed: (n, 3) whether head, torso and hip-leg are lost.
        score: (n, 3) how far beyond the operating point; above 0 failed, NaN: not judged.
        several: (n,) whether two or three parts are lost, where any is.
    """

    failed: NDArray[np.bool_]
    score: Floats
    several: NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Origin:
    """What a detector was made from, and with what.

    Attributes:
        counts: (3, 2) samples of head, torso, hip-leg: off their part, on it.
        instants: (2,) instants with one part lost, and with several.
        recordings: their names. people: how many.
        samples: hash of the samples.
        made: UTC, ISO 8601. software: names and versions.
        chosen: the parameters the grid search chose, as text.
    """

    counts: NDArray[np.int64] = field(default_factory=lambda: np.zeros((PARTS, 2), np.int64))
    instants: NDArray[np.int64] = field(default_factory=lambda: np.zeros(2, np.int64))
    recordings: tuple[str, ...] = ()
    people: int = 0
    samples: str = ""
    made: str = ""
    software: str = ""
    chosen: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Detector:
    """Three machines for the parts and one for one-or-several [ZhaoLee2009].

    Attributes:
        preparation: of the features.
        machines: head, torso, hip-leg, and several where there were samples to learn it from.
        thresholds: (3,) a part fails where its machine's value is above.
        several_threshold: likewise.
        curves: by part, then several: measured on people that were held out.
        origin: what it was made from.
    """

    preparation: Preparation
    machines: Machines
    thresholds: Floats
    several_threshold: float
    curves: tuple[Curve, ...]
    origin: Origin = field(default_factory=Origin)

    def judge(self, features: Floats) -> Judgement:
        """Judge people by their features (n, 60); where one it sees is NaN no part has failed.

        Without a machine for it, several parts are lost where two or three are judged so.
        """
        value = self.machines.decide(self.preparation.of(features))
        score = value[:, :PARTS] - self.thresholds
        failed = score > 0
        if value.shape[1] > PARTS:
            several = failed.any(axis=1) & (value[:, PARTS] > self.several_threshold)
        else:
            several = failed.sum(axis=1) > 1
        return Judgement(failed, score, several)

    def with_operating_point(self, false_alarms: float | Sequence[float]) -> Detector:
        """The same detector, with at most this share of false alarms: of all parts, or of each."""
        shares = np.broadcast_to(np.asarray(false_alarms, float), (PARTS,))
        thresholds = [
            curve.threshold_for(share)
            for curve, share in zip(self.curves[:PARTS], shares.tolist(), strict=True)
        ]
        return self.with_thresholds(thresholds)

    def with_thresholds(self, thresholds: Sequence[float]) -> Detector:
        """The same detector, with other thresholds (3,)."""
        return replace(self, thresholds=np.array(thresholds, float))

    def rates(self) -> Floats:
        """(3, 2) share of false alarms and share of failures found at the operating point."""
        return np.array(
            [
                (curve.false_alarms(threshold), curve.found(threshold))
                for curve, threshold in zip(self.curves, self.thresholds.tolist(), strict=False)
            ]
        )

    @property
    def fingerprint(self) -> str:
        """Tells detectors apart by what they say: 16 hexadecimal digits."""
        said = hashlib.sha256()
        arrays = [self.preparation.centre, self.preparation.scale, self.thresholds]
        for machine in self.machines.each:
            numbers = np.array([machine.intercept, machine.gamma])
            arrays += [machine.support, machine.coefficient, numbers]
        for array in (*arrays, np.array([self.several_threshold, self.preparation.by_size])):
            said.update(repr(array.shape).encode() + np.ascontiguousarray(array, "<f8").tobytes())
        return said.hexdigest()[:16]
