"""Tracked scenes with known identity errors: the trackers' own, and tracks swapped on purpose."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.benchmarks.clips import Clip, folder_of, truth_table
from tests.benchmarks.footage.recordings import all_footage
from tests.benchmarks.runner import Case as Tracker
from tests.benchmarks.runner import run_of
from tracking.editing import apply_change, plan_swap
from tracking.errors import EditError
from tracking.geometry import View
from tracking.recording import open_recording
from tracking.review.core.evidence import gather_evidence
from tracking.review.core.material import neighbours
from tracking.scoring import (
    BoxMatch,
    FloorMatch,
    IdentityError,
    Match,
    ScoringTable,
    identity_errors,
)
from tracking.synthesis import SCENES
from tracking.tracks import Labels, Run, TrackTable

TRACKERS = ("stereo-colour", "stereo-direction")
CROWD_TRACKERS = ("stereo-joint", "stereo-direction", "spheroid", "three-part", "flow")
_PLACES = ("lobby", "square", "pillars", "plaza", "uniforms", "corridor")
_PASS_M = 1.0
_AWAY = 3
"""Frames a swap lies at most off the moment at which two people are nearest."""
_SECONDS_PER_SWAP = 20
_MOST_VARIANTS = 3


def _footage(seconds: float, people: Sequence[int], seeds: Sequence[int]) -> tuple[Clip, ...]:
    """One clip of each of the places."""
    named = zip(_PLACES, people, seeds, strict=True)
    return tuple(Clip(scene, seed, seconds, count) for scene, count, seed in named)


def is_calm(clip: Clip) -> bool:
    """Whether few people come by: calm clips last longer."""
    assert clip.seconds is not None
    assert clip.people is not None
    return clip.people < 0.3 * clip.seconds


_FEW = [24] * len(_PLACES)
_USUAL = [SCENES[scene].people for scene in _PLACES]
TUNING = (
    *_footage(90, _FEW, range(3101, 3107)),
    *_footage(30, _USUAL, range(3111, 3117)),
    *_footage(60, [2 * count for count in _USUAL], range(3121, 3127)),
    Clip("uniforms", 3135, 180, 24),
    Clip("lobby", 3401, 90, 24),
    Clip("square", 3402, 90, 24),
    Clip("uniforms", 3405, 90, 24),
)
"""Scenes that hazards and likelihoods were fitted on."""
REPORTED = (
    *_footage(90, _FEW, range(3301, 3307)),
    Clip("lobby", 3321, 180, 30),
    Clip("uniforms", 3325, 180, 24),
    *_footage(30, _USUAL, (3311, 3312, 3333, 3314, 3315, 3316)),
)
"""Scenes that nothing was fitted on; what was tried was compared on them."""
FRESH = (
    Clip("lobby", 3801, 90, 24),
    Clip("square", 3802, 90, 24),
    Clip("pillars", 3803, 90, 24),
    Clip("lobby", 3811, 45, 12),
    Clip("plaza", 3812, 45, 12),
    Clip("pillars", 3813, 45, 12),
    Clip("uniforms", 3814, 45, 12),
    Clip("square", 3815, 45, 12),
)
"""Scenes that nothing was chosen by: looked at when all was done."""


@dataclass(frozen=True)
class Case:
    """A result and what is wrong with it.

    Attributes:
        clip: that was rendered for it; None for a recording of the footage trackers are judged by.
        recording: its name.
        swaps: how many tracks were swapped on purpose; 0: the tracker's own errors only.
    """

    clip: Clip | None
    recording: str
    tracker: str
    swaps: int
    table: TrackTable
    run: Run
    view: View | None
    size: tuple[int, int]
    fps: float
    errors: tuple[IdentityError, ...]

    @property
    def calm(self) -> bool:
        """Whether few people come by."""
        return self.clip is not None and is_calm(self.clip)

    @property
    def frames(self) -> int:
        return self.run.frames[1]


def cases(wanted: tuple[Clip, ...], match: Match) -> Iterator[Case]:
    """Each scene with each tracker, as it is and with swaps."""
    for clip in wanted:
        folder = folder_of(clip)
        for tracker in TRACKERS:
            yield from _variants(clip, clip.name, folder, tracker, match, clip.seed * 10)


def crowded_cases(data: Path, only: Collection[str] | None) -> Iterator[Case]:
    """Labelled recordings of the footage that trackers are judged by, with each that suits.

    Args:
        data: where those are that are not ours. only: names; None: all.
    """
    for footage in all_footage(data, only):
        if not footage.labelled:
            continue
        for tracker in filter(footage.suits, CROWD_TRACKERS):
            match = _match(footage.folder, tracker)
            found = _variants(None, footage.name, footage.folder, tracker, match, 0)
            yield next(found)  # as it is


def _match(folder: Path, tracker: str) -> Match:
    """Places on the floor where truth and tracks have them, boxes elsewhere."""
    tracks = run_of(folder, Tracker(tracker)).run.tracks
    placed = truth_table(folder).placed and ScoringTable.from_columns(tracks).placed
    return FloorMatch(0.5) if placed else BoxMatch()


def _variants(
    clip: Clip | None, name: str, folder: Path, tracker: str, match: Match, seed: int
) -> Iterator[Case]:
    """A tracker's result as it is, and with swaps."""
    rows = truth_table(folder)
    with open_recording(folder) as recording:
        view, fps, size = recording.view, recording.fps, recording.size
    run = run_of(folder, Tracker(tracker)).run
    for variant in range(_MOST_VARIANTS + 1):
        table = TrackTable(run.tracks)
        swaps = _swap(table, run, fps, seed + variant) if variant else 0
        if swaps or not variant:
            result = ScoringTable.from_columns(table.columns())
            errors = identity_errors(rows, result, match)
            yield Case(clip, name, tracker, swaps, table, run, view, size, fps, errors)


def _swap(table: TrackTable, run: Run, fps: float, seed: int) -> int:
    """Swap tracks at random meetings, some frames off; gives how many were."""
    random = np.random.default_rng(seed)
    wanted = max(1, round((run.frames[1] - run.frames[0]) / fps / _SECONDS_PER_SWAP))
    done = 0
    for _ in range(20 * wanted):
        meetings = _meetings(table, fps)
        if done == wanted or not meetings:
            break
        one, other, frame = meetings[int(random.integers(len(meetings)))]
        frame += int(random.integers(-_AWAY, _AWAY + 1))
        if _both_go_on(table, one, other, frame, round(fps)):
            try:
                apply_change(table, Labels(), plan_swap(table, one, other, frame))
            except EditError:
                continue
            done += 1
    return done


def _meetings(table: TrackTable, fps: float) -> list[tuple[int, int, int]]:
    """Both tracks and the frame of every closest moment within a metre."""
    evidence = gather_evidence(table, None, fps)
    near = neighbours(evidence, _PASS_M)
    one, other = evidence.track[near.first], evidence.track[near.second]
    frame = evidence.frame[near.first]
    cuts = np.flatnonzero((np.diff(one) != 0) | (np.diff(other) != 0) | (np.diff(frame) > fps)) + 1
    stretches = np.split(np.arange(len(frame)), cuts) if len(frame) else []
    closest = [rows[int(near.distance_m[rows].argmin())] for rows in stretches]
    return [(int(one[row]), int(other[row]), int(frame[row])) for row in closest]


def _both_go_on(table: TrackTable, one: int, other: int, frame: int, least: int) -> bool:
    """Whether both tracks have rows enough before and after the frame."""
    sides = [np.searchsorted(table.frames_of_track(track), frame) for track in (one, other)]
    rows = [len(table.frames_of_track(track)) for track in (one, other)]
    return all(least <= at <= count - least for at, count in zip(sides, rows, strict=True))
