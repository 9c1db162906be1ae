"""What a hostile case is, and what makes files hostile whatever they are."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

EXPORT = ("export", "W/s.h5", "-o", "W/out.csv", "--format", "csv")
INFO = ("info", "W/s.h5", "--json")
RESTORE = ("restore", "W/s.h5")
SHOW = ("info", "W/rec", "--json")
HIDDEN = ".s.h5.trackwright"
EITHER = None
"""Of a case that may be refused or not."""
Make = Callable[[Path], object]
"""Turns a copy of whole files into hostile ones. Beside it stands `elsewhere` with files that
nothing may change."""


@dataclass(frozen=True, slots=True)
class Case:
    """One hostile file or folder.

    Attributes:
        name: what it is, in words.
        base: the whole files it begins as: `session`, `waiting`, `older`, `stereo`, `pictures`...
        words: the command; W/ stands for the copy, K/ for the whole files.
        status: how it ends: 0, 1 (or 2, of a word of the command), or `EITHER`.
        says: what its last line on stderr says, a regular expression.
    """

    name: str
    base: str
    make: Make
    words: tuple[str, ...]
    status: int | None = 1
    says: str = ""


def cases(
    base: str, words: tuple[str, ...], made: Mapping[str, Make], status: int | None = 1
) -> tuple[Case, ...]:
    """Cases by their names that begin and end alike."""
    return tuple(Case(name, base, make, words, status) for name, make in made.items())


def no_files(
    what: str, base: str, file: str, words: tuple[str, ...], status: int | None = 1
) -> tuple[Case, ...]:
    """A file of the copy replaced by everything that is no file of the user's own."""
    made = {
        "a device": linked(file, "/dev/zero"),
        "a pipe": piped(file),
        "a folder": foldered(file),
        "a link to a file elsewhere": linked(file, "E/victim.txt"),
        "a link to a database elsewhere": linked(file, "E/victim.sqlite"),
        "a link to a file to be made": linked(file, "E/made.txt"),
        "a second name of a file elsewhere": hard_linked(file, "victim.txt"),
        "a second name of a database elsewhere": hard_linked(file, "victim.sqlite"),
        "20 GiB of nothing": sparse(file, 20 << 30),
    }
    return cases(base, words, {f"{what}: {name}": make for name, make in made.items()}, status)


def elsewhere(work: Path) -> Path:
    """The folder that nothing may touch."""
    return work.parent / "elsewhere"


def linked(file: str, target: str) -> Make:
    """Something in the copy becomes a link; E/ stands for the folder nothing may touch."""
    return lambda work: fresh(work / file).symlink_to(target.replace("E/", f"{elsewhere(work)}/"))


def hard_linked(file: str, target: str) -> Make:
    """Something in the copy becomes a second name of a file elsewhere."""
    return lambda work: os.link(elsewhere(work) / target, fresh(work / file))


def piped(file: str) -> Make:
    """A pipe nobody writes to."""
    return lambda work: os.mkfifo(fresh(work / file))


def foldered(file: str) -> Make:
    """A folder where a file is expected."""
    return lambda work: fresh(work / file).mkdir()


def sparse(file: str, size: int) -> Make:
    """A file with a hole of that size."""

    def make(work: Path) -> None:
        fresh(work / file).touch()
        os.truncate(work / file, size)

    return make


def text(file: str, said: str | bytes) -> Make:
    """A file that says this."""
    data = said if isinstance(said, bytes) else said.encode("utf-8", "surrogateescape")
    return lambda work: fresh(work / file).write_bytes(data)


def later(make: Callable[[], Make]) -> Make:
    """What is large is made only when its turn comes."""
    return lambda work: make()(work)


def fresh(place: Path) -> Path:
    """The place with nothing at it, in a folder that is there."""
    place.parent.mkdir(parents=True, exist_ok=True)
    if place.is_dir() and not place.is_symlink():
        shutil.rmtree(place)
    else:
        place.unlink(missing_ok=True)
    return place
