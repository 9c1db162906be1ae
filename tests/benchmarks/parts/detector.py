"""Makes the built-in failure detector: `python -m tests.benchmarks.parts.detector [--out FILE]`.

It learns from a tracker that adjusts nothing, as in [ZhaoLee2009], labelled from the exact truth
of clips that are used for nothing else, from several cameras. Every person is seen at a size of
its own, drawn at random: the clips show all of them about equally large, and what was learnt in
pixels there would say nothing of other recordings.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

import cv2
import numpy as np

import resources
from tests.benchmarks.parts.clips import TRAINED
from tests.benchmarks.parts.label_effort import samples_of_clips
from tests.benchmarks.parts.tracker_runs import PLAIN
from tracking.failure import Samples, save_detector
from tracking.failure.detector_file import BUILT_IN
from tracking.failure.training import Trained, TrainingPlan, train

SEED = 4100
_SIZES = float(np.log(2.5))


def main() -> None:
    """Render what is missing, track, label, train, save."""
    for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[variable] = "1"
    cv2.setNumThreads(1)
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.parts.detector")
    shipped = Path(next(iter(resources.__path__))) / BUILT_IN
    parser.add_argument("--out", type=Path, default=shipped, help="the detector's file")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    asked = parser.parse_args()
    trained = made(asked.clips)
    save_detector(asked.out, trained.detector)
    print(f"{asked.out}: {trained.detector.fingerprint}")


def made(kept: Path | None) -> Trained:
    """The detector, and what was measured while it was made."""
    random = np.random.default_rng(SEED)
    samples = resized(samples_of_clips(TRAINED, PLAIN, kept), random)
    print(f"samples off and on, by part: {samples.counts().tolist()}", file=sys.stderr)
    return train(samples, TrainingPlan(), random=random)


def resized(samples: Samples, random: np.random.Generator) -> Samples:
    """The samples as if everybody had been filmed from nearer or farther away.

    All features are differences in px or px/s, so a person twice as large has all of them doubled.
    """
    people = samples.people()
    sizes = np.exp(random.uniform(-_SIZES, _SIZES, int(people.max(initial=-1)) + 1))
    return Samples(samples.columns, samples.features * sizes[people, None])


if __name__ == "__main__":
    main()
