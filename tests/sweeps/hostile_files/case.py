"""What a hostile case is."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

EXPORT = ("export", "W/s.h5", "-o", "W/out.csv", "--format", "csv")
INFO = ("info", "W/s.h5", "--json")
RESTORE = ("restore", "W/s.h5")
SHOW = ("info", "W/rec", "--json")
HIDDEN = ".s.h5.trackwright"


@dataclass(frozen=True, slots=True)
class Case:
    """One hostile file or folder.

    Attributes:
        name: what it is, in words.
        base: the whole files it begins as: `session`, `waiting`, `older`, `stereo`, `pictures`...
        make: turns the copy of them into a hostile one. Beside it stands `elsewhere` with files
            that nothing may change.
        words: the command; W/ stands for the copy, K/ for the whole files.
        status: how it ends: 0, 1, or None where either will do.
        says: what its last line on stderr says, a regular expression.
    """

    name: str
    base: str
    make: Callable[[Path], object]
    words: tuple[str, ...]
    status: int | None = 1
    says: str = ""


def elsewhere(work: Path) -> Path:
    """The folder that nothing may touch."""
    return work.parent / "elsewhere"


def linked(file: str, target: str) -> Callable[[Path], None]:
    """Something in the copy becomes a link; E/ stands for the folder nothing may touch."""

    def make(work: Path) -> None:
        place = fresh(work / file)
        place.symlink_to(target.replace("E/", f"{elsewhere(work)}/"))

    return make


def hard_linked(file: str, target: str) -> Callable[[Path], None]:
    """Something in the copy becomes a second name of a file elsewhere."""
    return lambda work: os.link(elsewhere(work) / target, fresh(work / file))


def piped(file: str) -> Callable[[Path], None]:
    """A pipe nobody writes to."""
    return lambda work: os.mkfifo(fresh(work / file))


def foldered(file: str) -> Callable[[Path], None]:
    """A folder where a file is expected."""
    return lambda work: fresh(work / file).mkdir()


def sparse(file: str, size: int) -> Callable[[Path], None]:
    """A file with a hole of that size."""

    def make(work: Path) -> None:
        fresh(work / file).touch()
        os.truncate(work / file, size)

    return make


def text(file: str, said: str | bytes) -> Callable[[Path], None]:
    """A file that says this."""
    data = said if isinstance(said, bytes) else said.encode("utf-8", "surrogateescape")
    return lambda work: fresh(work / file).write_bytes(data)


def later(make: Callable[[], Callable[[Path], object]]) -> Callable[[Path], None]:
    """What is large is made only when its turn comes."""

    def made(work: Path) -> None:
        make()(work)

    return made


def fresh(place: Path) -> Path:
    """The place with nothing at it, in a folder that is there."""
    place.parent.mkdir(parents=True, exist_ok=True)
    if place.is_dir() and not place.is_symlink():
        shutil.rmtree(place)
    else:
        place.unlink(missing_ok=True)
    return place
