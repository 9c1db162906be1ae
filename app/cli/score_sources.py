"""What files of tracks say they are of, and where truth and result disagree about it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from pathlib import Path

from app.cli.tracks import Tracks
from tracking.errors import TrackwrightError
from tracking.scoring.report import Source
from tracking.translation import joined, msg

_MANIFEST = "recording.toml"

_SAME_RATE = 1e-3
"""Relative; files round the rate of frames."""


def source_of(tracks: Tracks) -> Source:
    """What is known of tracks; of a text in a recording's folder also what the manifest says."""
    recording, fps = tracks.recording, tracks.fps
    if tracks.is_text and recording is None:
        recording, told = _manifest_beside(tracks)
        fps = fps or told
    of_tracker = tracks.tracker, tracks.detections, tracks.rough
    return Source(str(tracks.path), recording, tracks.frames or None, fps, *of_tracker)


def disagreement(truth: Source, result: Source) -> str | None:
    """Why they may be of different recordings, in a line; None where nothing tells so."""
    reasons = list(_differences(truth, result))
    if not reasons:
        return None
    return msg(
        "{place} and {truth_place} may be of different recordings: {reasons}; check "
        "that the ground truth is this result's",
        place=result.place,
        truth_place=truth.place,
        reasons=joined("; ", reasons),
    )


def _differences(truth: Source, result: Source) -> Iterator[str]:
    """What both tell and tell differently; the result's first."""
    if truth.recording and result.recording and truth.recording != result.recording:
        yield msg(
            "named {recording} and {truth_recording}",
            recording=result.recording,
            truth_recording=truth.recording,
        )
    if truth.frames and result.frames and truth.frames != result.frames:
        yield msg(
            "{frames} and {truth_frames} frames", frames=result.frames, truth_frames=truth.frames
        )
    if truth.fps and result.fps and not math.isclose(truth.fps, result.fps, rel_tol=_SAME_RATE):
        yield msg(
            "{fps:g} and {truth_fps:g} frames per second", fps=result.fps, truth_fps=truth.fps
        )


def size_of_recording_at(paths: Iterable[Path]) -> tuple[int, int] | None:
    """Width and height in pixels of the first recording that is among paths, or that files are in.

    None where there is none that can be opened: what needs it says so.
    """
    from tracking.recording import open_recording  # brings what reads pictures

    for path in paths:
        folder = path if path.is_dir() else path.parent
        if not (folder / _MANIFEST).is_file():
            continue
        try:
            with open_recording(folder) as recording:
                return recording.size
        except TrackwrightError:
            continue
    return None


def _manifest_beside(tracks: Tracks) -> tuple[str | None, float | None]:
    """Name and rate of frames of the recording in whose folder a text stands."""
    folder = tracks.path.parent
    if not (folder / _MANIFEST).is_file():
        return None, None
    from tracking.recording import read_manifest  # brings what reads pictures

    try:
        manifest = read_manifest(folder)
    except TrackwrightError:  # what scores do without is no reason not to score
        return None, None
    return manifest.name, manifest.fps
