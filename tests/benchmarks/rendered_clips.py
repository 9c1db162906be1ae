"""Rendered clips that benchmarks share, each made once and kept, and trackers run over them."""

from __future__ import annotations

import csv
import sys
import time
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from platformdirs import user_cache_path

from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.synthesis import SCENES, Disturbances, render_recording
from tracking.trackers import settings_from, tracker_named
from tracking.tracks.run import Run

Columns = dict[str, NDArray[Any]]
Settings = tuple[tuple[str, Any], ...]

NO_DISTURBANCES = Disturbances()


@dataclass(frozen=True, slots=True)
class Clip:
    """One rendered scene.

    Attributes:
        scene: its name in `SCENES`.
        seed: says who comes by and how.
        seconds: of the scene's length; the scene's own if None.
        people: the scene's own if None.
        cameras: 1 for the left camera alone; the scene's own if None.
        disturbances: what is out of the ordinary.
    """

    scene: str
    seed: int
    seconds: float | None = None
    people: int | None = None
    cameras: int | None = None
    disturbances: Disturbances = NO_DISTURBANCES

    @property
    def name(self) -> str:
        """Of the clip's folder."""
        disturbances = self.disturbances
        parts = [self.scene, str(self.seed)]
        for letter, value in (
            ("s", self.seconds),
            ("p", self.people),
            ("eyes", self.cameras),
            ("from", disturbances.begin_s or None),
            ("dim", disturbances.dimmed_s),
            ("bump", disturbances.bumped_s),
        ):
            if value is not None:
                parts.append(f"{letter}{value:g}")
        return "-".join(parts)

    @property
    def fps(self) -> float:
        """Frames a second."""
        return SCENES[self.scene].fps


def folder_of(clip: Clip, kept: Path | None = None) -> Path:
    """The clip's recording, rendered if it is not there yet.

    Args:
        clip: which.
        kept: where clips are kept; a folder of the user's cache if None.
    """
    above = kept or user_cache_path("trackwright", appauthor=False) / "one-camera"
    folder = above / clip.name
    if not (folder / "truth.txt").is_file():
        print(f"rendering {folder}", file=sys.stderr)
        render_recording(
            folder,
            clip.scene,
            clip.seconds,
            clip.people,
            clip.seed,
            cameras=clip.cameras,
            disturbances=clip.disturbances,
        )
    return folder


@dataclass(frozen=True, slots=True)
class Tracked:
    """A tracker's run, and what it would tell the user, a line each."""

    run: Run
    notes: tuple[str, ...]


def run_of(folder: Path, tracker: str) -> Run:
    """A tracker's run over a recording."""
    return tracked(folder, tracker).run


@cache
def tracked(folder: Path, tracker: str, settings: Settings = (), seed: int = 0) -> Tracked:
    """The same with its notes; tracked once, however many sections look at it."""
    chosen = settings_from(tracker_named(tracker).settings_type, dict(settings))
    began = time.perf_counter()
    with (
        open_recording(folder) as recording,
        track(recording, tracker, chosen, seed) as tracking,
    ):
        for _ in tracking:
            pass
        found = Tracked(tracking.run(), tracking.notes)
    print(f"{tracker}: {folder.name} in {time.perf_counter() - began:.0f} s", file=sys.stderr)
    return found


def floor_truth(folder: Path) -> Columns:
    """`floor.csv`: frame, track, x, y of everybody on the floor, hidden or not."""
    table = np.loadtxt(folder / "floor.csv", delimiter=",", skiprows=1, ndmin=2)
    return {
        "frame": table[:, 0].astype(np.int64),
        "track": table[:, 1].astype(np.int64),
        "x": table[:, 2],
        "y": table[:, 3],
    }


@dataclass(frozen=True, slots=True)
class Looked:
    """A row of `moments.csv`: frames from 0, half-open; person 0 is everybody."""

    start: int
    end: int
    person: int
    kind: str
    name: str
    difficulty: int


def moments(folder: Path) -> tuple[Looked, ...]:
    """What of a scenario is looked at."""
    with (folder / "moments.csv").open(encoding="utf-8", newline="") as stream:
        return tuple(
            Looked(
                int(row["start"]),
                int(row["end"]),
                int(row["id"]),
                row["kind"],
                row["name"],
                int(row["difficulty"]),
            )
            for row in csv.DictReader(stream)
        )
