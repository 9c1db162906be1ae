"""Trackers of body parts over the clips, judged."""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from tests.benchmarks.parts.clips import FPS, Clip, folder_of
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.scoring.parts import (
    Judged,
    TrackedParts,
    judge,
    read_part_truth,
    tracked_parts,
    tracked_people,
)
from tracking.trackers import settings_from, tracker_named
from tracking.tracks.run import Run


@dataclass(frozen=True, slots=True)
class Variant:
    """A tracker as it is compared.

    Attributes:
        name: in tables and pictures.
        tracker: in the catalogue.
        settings: other than the defaults.
        parts: whether it follows parts, and not people as a whole.
    """

    name: str
    tracker: str
    settings: tuple[tuple[str, Any], ...] = ()
    parts: bool = True


ADJUSTED = Variant("with adjustment", "three-part")
PLAIN = Variant("without adjustment", "three-part", (("adjust", False),))
JOINT = Variant("joint", "three-part-joint")
WHOLE = Variant("whole body", "whole-body", parts=False)
VARIANTS = (ADJUSTED, PLAIN, JOINT, WHOLE)


@cache
def run_of(folder: Path, variant: Variant, seed: int = 0) -> Run:
    """The variant's run over a recording; tracked once, however many sections look at it."""
    settings = settings_from(tracker_named(variant.tracker).settings_type, dict(variant.settings))
    with (
        open_recording(folder) as recording,
        track(recording, variant.tracker, settings, seed) as tracking,
    ):
        for _ in tracking:
            pass
        return tracking.run()


def tracked_by(run: Run, variant: Variant) -> TrackedParts:
    """The rectangles of a run."""
    return tracked_parts(run.parts) if variant.parts else tracked_people(run.tracks)


def judged_clip(clip: Clip, variant: Variant, kept: Path | None = None) -> list[Judged]:
    """Everybody of a clip, as the variant tracks them."""
    folder = folder_of(clip, kept)
    began = time.perf_counter()
    run = run_of(folder, variant)
    took = time.perf_counter() - began
    print(f"{variant.name}: {clip.scene} {clip.seed} in {took:.0f} s", file=sys.stderr)
    with open_recording(folder) as recording:
        truth = read_part_truth(folder, recording.frame_count, recording.size)
    return judge(truth, tracked_by(run, variant), FPS)


def judged_clips(
    clips: Sequence[Clip], variant: Variant, kept: Path | None = None
) -> list[list[Judged]]:
    """The same of several clips, a list for each."""
    return [judged_clip(clip, variant, kept) for clip in clips]
