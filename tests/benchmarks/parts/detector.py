"""Makes the built-in failure detectors: `python -m tests.benchmarks.parts.detector [--paper]`.

It learns from a tracker that adjusts nothing, as in [ZhaoLee2009], labelled from the exact truth
of clips that are used for nothing else, from several cameras. Every person is seen at a size of
its own, drawn at random: the clips show all of them about equally large, and what was learnt in
pixels there would say nothing of other recordings.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

import resources
from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.command import one_core, parser_of, tell
from tests.benchmarks.parts.cases import PLAIN
from tests.benchmarks.parts.clips import TRAINED, TRAINED_PAPER, title_of
from tests.benchmarks.runner import run_of
from tracking.failure import (
    Samples,
    joined,
    labels_from_truth,
    people_followed,
    samples_of,
    save_detector,
)
from tracking.failure.core.features import PAPER_FEATURES
from tracking.failure.detector_file import BUILT_IN, BUILT_IN_PAPER
from tracking.failure.training import GRID, TrainingPlan, train
from tracking.truth import TRUE_PARTS, read_true_parts

SEED = 4100
_SIZES = float(np.log(2.5))
SMOOTH = tuple(one for one in GRID if 0.0 < one.gamma <= 1.0 and one.cost <= 10.0)
"""Parameters to try: it must hold for cameras that no clip shows."""


FALSE_ALARMS_OF_PARTS = (0.02, 0.005, 0.02)
"""Of head, torso and hip-leg: torsos are so seldom lost that two false alarms in a hundred would be
more than there are failures."""


def main() -> None:
    """Render what is missing, track, label, train, save."""
    one_core()
    parser = parser_of("parts.detector", __doc__)
    parser.add_argument("--paper", action="store_true", help="the one with the paper's features")
    parser.add_argument("--out", type=Path, help="the detector's file, if not the program's own")
    asked = parser.parse_args()
    name = BUILT_IN_PAPER if asked.paper else BUILT_IN
    out = asked.out or Path(next(iter(resources.__path__))) / name
    random = np.random.default_rng(SEED)
    samples = resized(samples_of_clips(TRAINED_PAPER if asked.paper else TRAINED), random)
    tell(f"samples off and on, by part: {samples.counts().tolist()}")
    plan = TrainingPlan(paper=True) if asked.paper else TrainingPlan(grid=SMOOTH)
    detector = train(samples, plan, random=random).detector
    if not asked.paper:
        detector = detector.with_operating_point(FALSE_ALARMS_OF_PARTS)
    save_detector(out, detector)
    print(f"{out}: {detector.fingerprint}")


def samples_of_clips(clips: Sequence[Clip]) -> Samples:
    """What the tracker that adjusts nothing said of parts, and whether the truth says so."""
    return joined(_samples_of_clip(clip, folder_of(clip)) for clip in clips)


def _samples_of_clip(clip: Clip, folder: Path) -> Samples:
    parts, truth = run_of(folder, PLAIN).run.parts, read_true_parts(folder / TRUE_PARTS)
    labels = labels_from_truth(truth, parts, clip.fps)
    people = people_followed(truth, parts, clip.fps)
    return samples_of(labels, parts, clip.fps, title_of(clip), people)


def resized(samples: Samples, random: np.random.Generator) -> Samples:
    """The samples as if everybody had been filmed from nearer or farther away.

    The paper's features are differences in px or px/s, so a person twice as large has all of them
    doubled; evidence is in shares and in heights of the person.
    """
    people = samples.people()
    sizes = np.exp(random.uniform(-_SIZES, _SIZES, int(people.max(initial=-1)) + 1))
    features = samples.features.copy()
    features[:, :PAPER_FEATURES] *= sizes[people, None]
    return Samples(samples.columns, features)


if __name__ == "__main__":
    main()
