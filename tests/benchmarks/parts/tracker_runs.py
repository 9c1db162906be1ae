"""Trackers of body parts over the clips, judged."""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from tests.benchmarks.parts.clips import FPS, Clip, folder_of
from tests.benchmarks.parts.kept_people import Seen, kept_run
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


@dataclass(frozen=True, slots=True)
class Variant:
    """A tracker as it is compared.

    Attributes:
        name: in tables and pictures.
        tracker: in the catalogue.
        settings: other than the defaults.
        parts: whether it follows parts, and not people as a whole.
        judged: whether what it does depends on the failure detector.
    """

    name: str
    tracker: str
    settings: tuple[tuple[str, Any], ...] = ()
    parts: bool = True
    judged: bool = True


ADJUSTED = Variant("with adjustment", "three-part")
PAPER = Variant(
    "the paper's adjustment",
    "three-part",
    (("fit_silhouettes", False), ("pose_constraints", False), ("reidentify", False)),
)
"""Only what the detector finds is put back, as in [ZhaoLee2009] 4.3; the rest of ours left out."""
PLAIN = Variant("without adjustment", "three-part", (("adjust", False),), judged=False)
JOINT = Variant("joint", "three-part-joint")
WHOLE = Variant("whole body", "whole-body", parts=False, judged=False)
VARIANTS = (ADJUSTED, PAPER, PLAIN, JOINT, WHOLE)


@cache
def run_of(folder: Path, variant: Variant) -> Seen:
    """What the variant saw in a recording; tracked once, however many sections look at it."""
    chosen = (variant.tracker, *variant.settings)
    return kept_run(folder, chosen, variant.judged, lambda: fresh_run(folder, variant))


def fresh_run(folder: Path, variant: Variant) -> Seen:
    """The same, tracked now: with the verdicts of the detector in force."""
    settings = settings_from(tracker_named(variant.tracker).settings_type, dict(variant.settings))
    began = time.perf_counter()
    with (
        open_recording(folder) as recording,
        track(recording, variant.tracker, settings, 0) as tracking,
    ):
        for _ in tracking:
            pass
        run = tracking.run()
    print(
        f"{variant.name}: {folder.name} in {time.perf_counter() - began:.0f} s",
        file=sys.stderr,
        flush=True,
    )
    return Seen(run.tracks, run.parts)


def tracked_by(run: Seen, variant: Variant) -> TrackedParts:
    """The rectangles of a run."""
    return tracked_parts(run.parts) if variant.parts else tracked_people(run.tracks)


def judged_clip(clip: Clip, variant: Variant, kept: Path | None = None) -> list[Judged]:
    """Everybody of a clip, as the variant tracks them."""
    folder = folder_of(clip, kept)
    run = run_of(folder, variant)
    with open_recording(folder) as recording:
        truth = read_part_truth(folder, recording.frame_count, recording.size)
    return judge(truth, tracked_by(run, variant), FPS)
