"""Samples of the failure detector made from truth: what a tracker said, and whether it was so."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.benchmarks.parts.clips import FPS, Clip, folder_of
from tests.benchmarks.parts.tracker_runs import Variant, run_of
from tracking.failure import (
    Curve,
    Detector,
    Samples,
    joined,
    labels_from_truth,
    people_followed,
    samples_of,
)
from tracking.failure.training.questions import NAMES, all_questions
from tracking.tracks import Columns
from tracking.truth import TRUE_PARTS, read_true_parts


def samples_of_clips(clips: Sequence[Clip], variant: Variant, kept: Path | None = None) -> Samples:
    """Samples of a tracker of parts on rendered clips."""
    return joined(_samples_of_clip(clip, variant, kept) for clip in clips)


def _samples_of_clip(clip: Clip, variant: Variant, kept: Path | None) -> Samples:
    folder = folder_of(clip, kept)
    return samples_of_parts(folder, clip, run_of(folder, variant).parts)


def samples_of_parts(folder: Path, clip: Clip, parts: Columns) -> Samples:
    """Samples of the parts that a tracker saw in a clip."""
    truth = read_true_parts(folder / TRUE_PARTS)
    labels = labels_from_truth(truth, parts, FPS)
    people = people_followed(truth, parts, FPS)
    return samples_of(labels, parts, FPS, f"{clip.scene} {clip.seed}", people)


def machine_curves(detector: Detector, samples: Samples) -> dict[str, Curve]:
    """What each machine of a detector says of samples it has not seen, by question."""
    curves = {}
    for question in all_questions(samples):
        value = detector.machines.decide(detector.preparation.of(question.features))
        if question.number >= value.shape[1]:
            continue
        score = value[:, question.number]
        curves[NAMES[question.number]] = Curve(
            np.sort(score[~question.yes]), np.sort(score[question.yes])
        )
    return curves
