"""Rendered clips, each made once and kept, and the ground truth beside them."""

from __future__ import annotations

import csv
import hashlib
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from platformdirs import user_cache_path

import tracking
from tests.benchmarks.command import tell
from tests.benchmarks.parts import scenes
from tracking.formats import read_mot
from tracking.scoring import ScoringTable
from tracking.synthesis import SCENES, Disturbances, SceneSpec, render_recording

Columns = dict[str, NDArray[Any]]

LIBRARIES = f"numpy {np.__version__}, OpenCV {cv2.__version__}"
"""Whose arithmetic is in every clip and every run."""
NO_DISTURBANCES = Disturbances()
_LIBRARY = Path(next(iter(tracking.__path__)))
PACKAGES = ("geometry/**/*", "synthesis/**/*")
"""Packages that clips are rendered with."""


@dataclass(frozen=True, slots=True)
class Clip:
    """One rendered scene.

    Attributes:
        scene: its name in `SCENES`, or among the scenes for training.
        seed: says who comes by and how.
        seconds: of the scene's length; the scene's own if None.
        people: the scene's own if None.
        cameras: 1 for the left camera alone; the scene's own if None.
        size: width and height of the images, px; the scene's own if None.
        disturbances: what is out of the ordinary.
    """

    scene: str
    seed: int
    seconds: float | None = None
    people: int | None = None
    cameras: int | None = None
    size: tuple[int, int] | None = None
    disturbances: Disturbances = NO_DISTURBANCES

    @property
    def name(self) -> str:
        """Of the clip's folder."""
        disturbances = self.disturbances
        parts = [self.scene, str(self.seed)]
        for letter, value in (
            ("s", self.seconds),
            ("p", self.people),
            ("cameras", self.cameras),
            ("rows", self.size and self.size[1]),
            ("from", disturbances.begin_s or None),
            ("dim", disturbances.dimmed_s),
            ("bump", disturbances.bumped_s),
        ):
            if value is not None:
                parts.append(f"{letter}{value:g}")
        return "-".join(parts)

    @property
    def spec(self) -> SceneSpec:
        """The scene's definition."""
        return SCENES[self.scene] if self.scene in SCENES else scenes.ELSEWHERE[self.scene]

    @property
    def fps(self) -> float:
        """Frames a second."""
        return self.spec.fps


def folder_of(clip: Clip, kept: Path | None = None) -> Path:
    """The clip's recording, rendered if it is not there yet.

    Args:
        clip: which.
        kept: where clips are kept, taken as they are. None: in the user's cache, apart by what they
            were rendered with, so that none is left over from another rendering.
    """
    folder = (kept or clips_cache() / rendering()) / clip.name
    if not folder.is_dir():
        tell(f"rendering {folder}")
        render_recording(
            folder,
            clip.spec,
            clip.seconds,
            clip.people,
            clip.seed,
            size=clip.size,
            cameras=clip.cameras,
            disturbances=clip.disturbances,
        )
    return folder


def clips_cache() -> Path:
    """The folder for clips and runs in the user's cache."""
    return user_cache_path("trackwright", appauthor=False) / "benchmarks"


@cache
def rendering() -> str:
    """A short hash over whatever clips are rendered with: sources and libraries."""
    more = Path(scenes.__file__).read_text(encoding="utf-8")
    said = "\0".join((sources_of(PACKAGES), LIBRARIES, more))
    return hashlib.sha256(said.encode()).hexdigest()[:8]


def sources_of(packages: Iterable[str]) -> str:
    """A hash over sources of the library, by patterns of their paths."""
    return hash_of_files(_LIBRARY, files_of(packages))


def files_of(packages: Iterable[str]) -> set[Path]:
    """Files of the library by patterns of their paths: sources, and tables beside them."""
    found = {path for name in packages for path in _LIBRARY.glob(name) if path.is_file()}
    return {path for path in found if path.suffix != ".pyc"}


def hash_of_files(root: Path, files: Iterable[Path]) -> str:
    """A hash over what files hold and what they are called below `root`."""
    said = hashlib.sha256()
    for path in sorted(files):
        own = hashlib.sha256(path.read_bytes()).hexdigest()
        said.update(f"{path.relative_to(root).as_posix()}\0{own}\0".encode())
    return said.hexdigest()


def truth_table(folder: Path) -> ScoringTable:
    """`truth.txt` as it is scored, with don't-cares."""
    return ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)


def floor_truth(folder: Path) -> Columns:
    """`floor.csv`: frame, track, x, y of everybody on the floor, hidden or not."""
    table = np.loadtxt(folder / "floor.csv", delimiter=",", skiprows=1, ndmin=2)
    number, place = table[:, :2].astype(np.int64), table[:, 2:]
    return {"frame": number[:, 0], "track": number[:, 1], "x": place[:, 0], "y": place[:, 1]}


@dataclass(frozen=True, slots=True)
class Moment:
    """A row of `moments.csv`: frames from 0, half-open; person 0 is everybody."""

    start: int
    end: int
    person: int
    kind: str
    name: str
    difficulty: int


def moments(folder: Path) -> tuple[Moment, ...]:
    """What of a scenario is looked at."""
    with (folder / "moments.csv").open(encoding="utf-8", newline="") as stream:
        return tuple(
            Moment(
                *(int(row[name]) for name in ("start", "end", "id")),
                row["kind"],
                row["name"],
                int(row["difficulty"]),
            )
            for row in csv.DictReader(stream)
        )
