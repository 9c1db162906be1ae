"""How fast the failure detector judges 15 people, beside scikit-learn's machines on the same rows.

`python -m tests.benchmarks.parts.detector_speed [DETECTOR.h5]`; the built-in detector by default.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from sklearn.pipeline import Pipeline
from sklearn.preprocessing import FunctionTransformer
from sklearn.svm import SVC

from tests.benchmarks.command import one_core, parser_of
from tests.benchmarks.timing import least_ms
from tracking.failure import Detector, Machine, built_in_detector, load_detector

PEOPLE = 15
_ROUNDS = 400


def measure(detector: Detector | None = None) -> dict[str, float]:
    """`us` a judgement of 15 people, `vs_scikit_learn` ours over theirs, `difference` at most."""
    detector = detector or built_in_detector()
    random = np.random.default_rng(4100)
    spread = detector.preparation.scale[:36] * (50 if detector.preparation.by_size else 1)
    features = random.normal(size=(PEOPLE, 36)) * spread
    peers = [peer_of(detector, machine) for machine in detector.machines.each]
    theirs = np.stack([peer.decision_function(features) for peer in peers], axis=1)
    ours = detector.machines.decide(detector.preparation.of(features))
    own_us, peer_us = (
        1000 * least_ms(work, _ROUNDS)
        for work in (
            lambda: detector.judge(features),
            lambda: [peer.decision_function(features) for peer in peers],
        )
    )
    return {
        "us": own_us,
        "scikit_learn_us": peer_us,
        "vs_scikit_learn": own_us / peer_us,
        "times_faster": peer_us / own_us,
        "difference": float(np.abs(ours - theirs).max()),
        "support_vectors": float(sum(len(machine.support) for machine in detector.machines.each)),
    }


def peer_of(detector: Detector, machine: Machine) -> Pipeline:
    """What scikit-learn would judge with: the same preparation, and its own machine.

    The machine is fitted to a few rows and then given the detector's own vectors, coefficients
    and constants, as a machine that was fitted to the training samples has them.
    """
    numbers = machine.support.shape[1]
    kernel = {"kernel": "rbf", "gamma": machine.gamma} if machine.gamma else {"kernel": "linear"}
    values = np.random.default_rng(1).normal(size=(len(machine.support) + 2, numbers))
    peer = SVC(**kernel).fit(values, np.arange(len(values)) % 2 == 0)
    rows = len(machine.support)
    peer.support_vectors_ = np.ascontiguousarray(machine.support)
    peer.support_ = np.arange(rows, dtype=np.int32)
    peer._n_support = np.array([rows - 1, 1], np.int32) if rows > 1 else np.array([1, 0], np.int32)
    # For two classes the library holds both with the other sign inside.
    peer._dual_coef_ = -np.ascontiguousarray(machine.coefficient[None])
    peer._intercept_ = -np.array([machine.intercept])
    steps = [("prepare", FunctionTransformer(detector.preparation.of)), ("decide", peer)]
    return Pipeline(steps)


def main() -> None:
    """Print the figures."""
    parser = parser_of("parts.detector_speed", __doc__)
    parser.add_argument("detector", nargs="?", type=Path, metavar="DETECTOR.h5", help="to measure")
    named = parser.parse_args().detector
    one_core()
    for name, value in measure(None if named is None else load_detector(named)).items():
        print(f"{name:<18} {value:.3g}")


if __name__ == "__main__":
    main()
