"""Runs over clips, kept beside them for as long as nothing they were made with has changed.

A run is found again by what its recording holds, the sources of every room it goes through, the
libraries, the tracker with its settings and, where it acts on one, the failure detector: so no
figure on a page is of an older state than the others, and none is measured twice.
"""

from __future__ import annotations

import hashlib
import io
import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import cv2
import numpy as np

import tracking
from tracking.failure import built_in_detector
from tracking.tracks import Columns

_ROOMS = (
    *("failure/*.py", "filtering/**/*.py", "foreground/**/*.py", "geometry/**/*.py"),
    *("people/**/*.py", "pipeline.py", "recording/**/*.py", "setting*.py"),
    *("trackers/*.py", "trackers/three_part/**/*.py", "tracks/**/*.py"),
)

LIBRARIES = f"numpy {np.__version__}, OpenCV {cv2.__version__}"
"""Whose arithmetic is in every clip and every run."""


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """What a tracker saw: the columns of its tracks and of their parts."""

    tracks: Columns
    parts: Columns


def kept_run(folder: Path, chosen: tuple[Any, ...], judged: bool, make: Callable[[], Seen]) -> Seen:
    """The run over a clip's folder as it is kept, made where it is not.

    Args:
        chosen: the tracker and its settings. judged: whether it acts on the built-in detector.
    """
    detector = built_in_detector().fingerprint if judged else ""
    said = [contents(folder), sources(), LIBRARIES, repr(chosen), detector]
    name = hashlib.sha256("\0".join(said).encode()).hexdigest()[:16]
    path = folder.parent / "runs" / f"{folder.name}-{name}.npz"
    if path.is_file():
        with np.load(path) as held:
            return Seen(_of(held, "tracks"), _of(held, "parts"))
    seen = make()
    _keep(path, seen)
    return seen


@cache
def sources() -> str:
    """A hash over the sources of all rooms that a run goes through."""
    return sources_of(_ROOMS)


def sources_of(rooms: Iterable[str]) -> str:
    """A hash over sources, by patterns of their paths."""
    root = Path(next(iter(tracking.__path__)))
    return _hash_of(root, {path for room in rooms for path in root.glob(room)})


def contents(folder: Path) -> str:
    """A hash over the files of a recording's folder."""
    return _hash_of(folder, (path for path in folder.rglob("*") if path.is_file()))


def _hash_of(root: Path, files: Iterable[Path]) -> str:
    said = hashlib.sha256()
    for path in sorted(files):
        own = hashlib.sha256(path.read_bytes()).hexdigest()
        said.update(f"{path.relative_to(root).as_posix()}\0{own}\0".encode())
    return said.hexdigest()


def _of(held: Any, table: str) -> Columns:
    return {
        name.partition("/")[2]: held[name] for name in held.files if name.startswith(f"{table}/")
    }


def _keep(path: Path, seen: Seen) -> None:
    columns = {f"tracks/{name}": column for name, column in seen.tracks.items()}
    columns |= {f"parts/{name}": column for name, column in seen.parts.items()}
    image = io.BytesIO()
    np.savez_compressed(image, **columns)  # type: ignore[arg-type]  # names are not its options
    path.parent.mkdir(exist_ok=True)
    part = path.with_suffix(f".{os.getpid()}.part")
    part.write_bytes(image.getvalue())
    part.replace(path)
