"""Tracked scenes with known identity errors: the trackers' own, and tracks swapped on purpose."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tracking.editing import apply_change, plan_swap
from tracking.errors import EditError, TrackwrightError
from tracking.formats import read_mot
from tracking.geometry import View
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.review.core.evidence import gather_evidence
from tracking.review.core.material import neighbours
from tracking.scoring import IdentityError, Match, ScoringTable, identity_errors
from tracking.session import Session
from tracking.synthesis import SCENES, render_recording
from tracking.tracks import Labels, Run, TrackTable

TRACKERS = ("stereo-colour", "stereo-direction")
_PLACES = ("lobby", "square", "pillars", "plaza", "uniforms", "corridor")
_PASS_M = 1.0
_AWAY = 3
"""Frames a swap lies at most off the moment at which two people are nearest."""
_SECONDS_PER_SWAP = 20
_MOST_VARIANTS = 3


@dataclass(frozen=True)
class Footage:
    """A scene to render: calm ones last longer with fewer people."""

    scene: str
    seconds: int
    people: int
    seed: int

    @property
    def is_calm(self) -> bool:
        return self.people < 0.3 * self.seconds

    def __str__(self) -> str:
        return f"{self.scene}-{self.seconds}-{self.people}-{self.seed}"


def _footage(seconds: int, people: Sequence[int], seeds: Sequence[int]) -> tuple[Footage, ...]:
    """One footage for each of the places."""
    return tuple(
        Footage(scene, seconds, count, seed)
        for scene, count, seed in zip(_PLACES, people, seeds, strict=True)
    )


_FEW = [24] * len(_PLACES)
_USUAL = [SCENES[scene].people for scene in _PLACES]
TUNING = (
    *_footage(90, _FEW, range(3101, 3107)),
    *_footage(30, _USUAL, range(3111, 3117)),
    *_footage(60, [2 * count for count in _USUAL], range(3121, 3127)),
    Footage("uniforms", 180, 24, 3135),
    Footage("lobby", 90, 24, 3401),
    Footage("square", 90, 24, 3402),
    Footage("uniforms", 90, 24, 3405),
)
"""Scenes that hazards and likelihoods were fitted on."""
REPORTED = (
    *_footage(90, _FEW, range(3301, 3307)),
    Footage("lobby", 180, 30, 3321),
    Footage("uniforms", 180, 24, 3325),
    *_footage(30, _USUAL, (3311, 3312, 3333, 3314, 3315, 3316)),
)
"""Scenes that nothing was fitted on; what was tried was compared on them."""
FRESH = (
    Footage("lobby", 90, 24, 3801),
    Footage("square", 90, 24, 3802),
    Footage("pillars", 90, 24, 3803),
    Footage("lobby", 45, 12, 3811),
    Footage("plaza", 45, 12, 3812),
    Footage("pillars", 45, 12, 3813),
    Footage("uniforms", 45, 12, 3814),
    Footage("square", 45, 12, 3815),
)
"""Scenes that nothing was chosen by: looked at when all was done."""


@dataclass(frozen=True)
class Case:
    """A result and what is wrong with it.

    Attributes:
        swaps: how many tracks were swapped on purpose; 0: the tracker's own errors only.
    """

    footage: Footage
    tracker: str
    swaps: int
    table: TrackTable
    run: Run
    view: View
    fps: float
    errors: tuple[IdentityError, ...]

    @property
    def frames(self) -> int:
        return self.run.frames[1]


def cases(wanted: tuple[Footage, ...], match: Match) -> Iterator[Case]:
    """Each scene with each tracker, as it is and with swaps."""
    for footage in wanted:
        folder = _rendered(footage)
        rows = ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)
        for tracker in TRACKERS:
            run, view, fps = _tracked(folder, tracker)
            for variant in range(_MOST_VARIANTS + 1):
                table = TrackTable(run.tracks)
                swaps = _swap(table, run, fps, footage.seed * 10 + variant) if variant else 0
                if swaps or not variant:
                    result = ScoringTable.from_columns(table.columns())
                    errors = identity_errors(rows, result, match)
                    yield Case(footage, tracker, swaps, table, run, view, fps, errors)


def _folder(footage: Footage) -> Path:
    return Path(tempfile.gettempdir()) / "trackwright-review" / str(footage)


def _rendered(footage: Footage) -> Path:
    folder = _folder(footage)
    if not (folder / "truth.txt").is_file():
        print(f"rendering {folder}", file=sys.stderr)
        render_recording(folder, footage.scene, footage.seconds, footage.people, footage.seed)
    return folder


def _tracked(folder: Path, tracker: str) -> tuple[Run, View, float]:
    """The tracker's run, kept as a session beside the footage."""
    path = folder.with_name(f"{folder.name}-{tracker}.h5")
    with open_recording(folder) as recording:
        assert recording.view is not None
        view, fps = recording.view, recording.fps
        run = _kept(path)
        if run is None:
            print(f"tracking {path}", file=sys.stderr)
            with track(recording, tracker) as tracking:
                for _ in tracking:
                    pass
                run = tracking.run()
            Session.create(recording, [run], path).close()
    return run, view, fps


def _kept(path: Path) -> Run | None:
    """The run kept in a session; None where there is none, or none that this program can read.

    What a program of another day kept and this one refuses is deleted, to be tracked anew.
    """
    if not path.is_file():
        return None
    try:
        with closing(Session.open(path)) as session:
            return session.runs[0]
    except (TrackwrightError, LookupError) as error:
        print(f"tracking anew: {error}", file=sys.stderr)
        path.unlink()
        return None


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
