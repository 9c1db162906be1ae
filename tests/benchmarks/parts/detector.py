"""Makes the built-in failure detector: `python -m tests.benchmarks.parts.detector [--out FILE]`.

It learns in two rounds, both labelled from the exact truth of clips that are used for nothing
else: first from a tracker that adjusts nothing, as in [ZhaoLee2009], then also from one that
adjusts by the first round's verdicts, since that is the tracker it is going to judge.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

import cv2
import numpy as np

import resources
from tests.benchmarks.parts.clips import TRAINED, TRAINED_CROUCHING
from tests.benchmarks.parts.labelling import samples_of_clips
from tests.benchmarks.parts.running import PLAIN, Variant
from tracking.failure import Samples, joined, save_detector
from tracking.failure.detector_file import BUILT_IN
from tracking.failure.training import Trained, TrainingPlan, train

SEED = 4100


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
    """The detector of both rounds."""
    clips = (*TRAINED, *TRAINED_CROUCHING)
    first = samples_of_clips(clips, PLAIN, kept)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "first.h5"
        save_detector(path, _trained(first).detector)
        adjusting = Variant("with adjustment", "three-part", {"detector": str(path)})
        second = samples_of_clips(clips, adjusting, kept)
    return _trained(joined((first, second)))


def _trained(samples: Samples) -> Trained:
    counts = samples.counts()
    print(f"{len(samples)} samples, off and on: {counts.tolist()}", file=sys.stderr)
    return train(samples, TrainingPlan(), random=np.random.default_rng(SEED))


if __name__ == "__main__":
    main()
