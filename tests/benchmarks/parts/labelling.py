"""Samples of the failure detector made from truth: what a tracker said, and whether it was so."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from tests.benchmarks.parts.clips import FPS, Clip, folder_of
from tests.benchmarks.parts.judging import Judged, judge
from tests.benchmarks.parts.running import Variant, run_of, tracked_by
from tests.benchmarks.parts.truth import read_truth
from tracking.failure import Curve, Detector, Samples, joined, samples_of
from tracking.failure.training.questions import NAMES, questions_of
from tracking.recording import open_recording
from tracking.tracks import PartLabel
from tracking.tracks.run import Run

ON, OFF = 0.4, 0.6
"""A rectangle with less than this share of something else is on its part, with more than the other
off it; what lies between is neither and is dropped, as in [ZhaoLee2009]."""

EVERY = 3
"""Of so many frames one is labelled: neighbours say the same."""


def samples_of_clips(clips: Sequence[Clip], variant: Variant, kept: Path | None = None) -> Samples:
    """Samples of a tracker of parts on rendered clips."""
    return joined(_samples_of_clip(clip, variant, kept) for clip in clips)


def _samples_of_clip(clip: Clip, variant: Variant, kept: Path | None) -> Samples:
    folder = folder_of(clip, kept)
    run = run_of(folder, variant)
    with open_recording(folder) as recording:
        truth = read_truth(folder, recording.frame_count, recording.size)
    judged = judge(truth, tracked_by(run, variant), FPS)
    labels = [label for one in judged for label in _labels(one, run)]
    return samples_of(labels, run.parts, FPS, f"{clip.scene} {clip.seed}, {variant.name}")


def _labels(one: Judged, run: Run) -> Iterator[PartLabel]:
    """What truth says of a person's rectangles."""
    parts = run.parts
    first, end = one.first_frame, one.first_frame + len(one.parts)
    own = (parts["track"] == one.track) & (parts["frame"] >= first) & (parts["frame"] < end)
    for row in np.flatnonzero(own & (parts["frame"] % EVERY == 0)):
        frame, part = int(parts["frame"][row]), int(parts["part"][row])
        foreign = one.foreign[frame - first, part]
        if parts["occluded"][row] or not (foreign < ON or foreign > OFF):
            continue
        x, y, width, height = (float(parts[n][row]) for n in ("cx", "cy", "width", "height"))
        box = (x - width / 2, y - height / 2, width, height)
        yield PartLabel(frame, one.track, part, box, bool(foreign < ON), "truth", "truth")


def machine_curves(detector: Detector, samples: Samples) -> dict[str, Curve]:
    """What each machine of a detector says of samples it has not seen, by question."""
    curves = {}
    for question in questions_of(samples):
        value = detector.machines.decide(detector.preparation.of(question.features))
        if question.number >= value.shape[1]:
            continue
        score = value[:, question.number]
        curves[NAMES[question.number]] = Curve(
            np.sort(score[~question.yes]), np.sort(score[question.yes])
        )
    return curves
