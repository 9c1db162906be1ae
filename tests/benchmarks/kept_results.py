"""Runs over clips, kept beside them for as long as nothing they were made with has changed.

A run is found again by what its recording holds, the sources of every room it goes through, the
libraries, and whatever else its maker names: so no figure on a page is of an older state than the
others, and none is measured twice.
"""

from __future__ import annotations

import hashlib
import io
import os
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any, Protocol

import cv2
import numpy as np

import tracking
from tracking.tracks import Columns

LIBRARIES = f"numpy {np.__version__}, OpenCV {cv2.__version__}"
"""Whose arithmetic is in every clip and every run."""

_RENDERING = ("geometry/**/*.py", "synthesis/**/*.py")
"""Rooms that clips are rendered with."""

Tables = Mapping[str, Columns]


class Named(Protocol):
    """What is done to a clip; its `repr` says all of it."""

    @property
    def name(self) -> str:
        """In tables, and of folders."""


def beside(folder: Path, done: Named, source: Path) -> Path:
    """Where a clip is kept that is made of another one, by what is done to it and by which code.

    Args:
        folder: of the other one. source: the module that does it.
    """
    said = hashlib.sha256(repr(done).encode() + source.read_bytes()).hexdigest()[:8]
    name = done.name.replace(" ", "-").replace(",", "")
    return folder.with_name(f"{folder.name}-{name}-{said}")


def path_of(folder: Path, *said: str) -> Path:
    """Where a run over a recording is kept.

    Args:
        folder: of the recording.
        said: all else that the run depends on.
    """
    name = hashlib.sha256("\0".join((contents(folder), *said)).encode()).hexdigest()[:16]
    return folder.parent / "runs" / f"{folder.name}-{name}.npz"


def tables_in(path: Path, names: Iterable[str]) -> dict[str, Columns]:
    """The named tables of a kept run."""
    with np.load(path) as held:
        return {name: _of(held, name) for name in names}


def keep(path: Path, tables: Tables) -> None:
    """Keep the tables of a run; the file appears whole."""
    columns = {
        f"{table}/{name}": column for table, its in tables.items() for name, column in its.items()
    }
    image = io.BytesIO()
    np.savez_compressed(image, **columns)  # type: ignore[arg-type]  # names are not its options
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(f".{os.getpid()}.part")
    part.write_bytes(image.getvalue())
    part.replace(path)


@cache
def rendering(*said: str) -> str:
    """A short hash over whatever clips are rendered with: sources and libraries.

    Args:
        said: all else that they depend on and that their own names do not tell.
    """
    told = "\0".join((sources_of(_RENDERING), LIBRARIES, *said))
    return hashlib.sha256(told.encode()).hexdigest()[:8]


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
