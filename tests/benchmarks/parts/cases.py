"""Trackers of body parts as they are compared, and how well they do on a clip."""

from __future__ import annotations

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.runner import Case, run_of
from tracking.recording import open_recording
from tracking.scoring.parts import (
    Judged,
    TrackedParts,
    judge,
    read_part_truth,
    tracked_parts,
    tracked_people,
)
from tracking.tracks import Run

ADJUSTED = Case("three-part", name="with adjustment")
PAPER = Case(
    "three-part",
    (
        ("detector", "paper"),
        ("fit_silhouettes", False),
        ("pose_constraints", False),
        ("reidentify", False),
    ),
    "the paper's adjustment",
)
"""Only what a detector with the paper's features finds is put back, as in [ZhaoLee2009] 4.3; the
rest of ours left out."""
PLAIN = Case("three-part", (("adjust", False),), "without adjustment")
JOINT = Case("three-part-joint", name="joint")
WHOLE = Case("whole-body", name="whole body")
CASES = (ADJUSTED, PAPER, PLAIN, JOINT, WHOLE)


def rectangles(run: Run, case: Case) -> TrackedParts:
    """The rectangles of a run: parts, or people where they are followed as a whole."""
    return tracked_people(run.tracks) if case == WHOLE else tracked_parts(run.parts)


def judged_clip(clip: Clip, case: Case) -> list[Judged]:
    """Everybody of a clip, as the case tracks them."""
    folder = folder_of(clip)
    with open_recording(folder) as recording:
        truth = read_part_truth(folder, recording.frame_count, recording.size)
    return judge(truth, rectangles(run_of(folder, case).run, case), clip.fps)
