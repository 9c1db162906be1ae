"""Files and folders made to harm, each through the real command: `hostile.py [--only WORDS]`.

Each case ends as it should: with one line or with what it was asked for, within ten seconds and a
gibibyte, with nothing raw on the terminal. Nothing in the folder elsewhere is changed, made or
removed, and the way to it (PYTHONPATH, the folder the command starts in) brings in no other code.
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

from tests.sweeps.command import Outcome, command, complaint, preload
from tests.sweeps.hostile_files import companions, hdf5_files, recordings, tracks
from tests.sweeps.hostile_files.case import Case
from tests.sweeps.runner import Worker, emptied, sweep
from tests.sweeps.seed_files import Kit

_CASES = (*companions.CASES, *hdf5_files.CASES, *recordings.CASES, *tracks.CASES)
_SHADOWS = ("app", "tracking", "sqlite3", "h5py", "numpy", "json", "typer")
"""Packages that somebody puts in the way of those the command means."""


def attack(worker: Worker) -> Iterator[str]:
    """A case a run."""
    preload()
    kit = Kit(worker.folder)
    if worker.place == 0 and not worker.asked.only:
        worker.count("with modules in the way that have the names of library modules", 2)
        yield from shadowed(emptied(worker.folder / "shadow"), kit.folder / "session" / "s.h5")
    for case in worker.of([case for case in _CASES if worker.asked.only in case.name]):
        place = emptied(worker.folder / "case")
        elsewhere = victims(place / "elsewhere")
        shutil.copytree(kit.folder / case.base, place / "work")
        before = state_of(elsewhere)
        case.make(place / "work")
        outcome = command([kit.word(word, place / "work") for word in case.words], worker.folder)
        worker.count("cases")
        worker.count("refused in one line" if outcome.status else "opened")
        if wrong := complaint(outcome) or unexpected(case, outcome):
            yield f"{case.name}: {wrong}"
        if state_of(elsewhere) != before:
            yield f"{case.name}: a file elsewhere was changed"


def unexpected(case: Case, outcome: Outcome) -> str:
    """What is other than the case expects."""
    if case.status is not None and bool(outcome.status) != bool(case.status):
        return f"ends with {outcome.status}, not {case.status}: {outcome.line}"
    if outcome.status and not re.search(case.says, outcome.line):
        return f"does not say {case.says!r}: {outcome.line}"
    return ""


def victims(folder: Path) -> Path:
    """Files that nothing may touch."""
    emptied(folder / "folder")
    for name in ("victim.txt", "folder/saving-precious.h5", "folder/lock"):
        (folder / name).write_text("precious\n")
    with closing(sqlite3.connect(folder / "victim.sqlite")) as base:
        base.executescript("CREATE TABLE steps(precious); INSERT INTO steps VALUES(1)")
    return folder


def state_of(folder: Path) -> dict[str, str]:
    """All names and contents."""
    return {
        str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in folder.rglob("*")
        if file.is_file()
    }


def shadowed(folder: Path, session: Path) -> Iterator[str]:
    """The command as it is installed, with other packages of the names it uses in its way."""
    for name in _SHADOWS:
        package = folder / name
        package.mkdir()
        code = f"open({str(folder / 'ran')!r}, 'a').write({name!r})\n"
        (package / "__init__.py").write_text(code)
    # What Python itself finds by PYTHONPATH first is the user's own choice; our names are ours.
    ways = {"the folder it starts in": {}, "PYTHONPATH": {"PYTHONPATH": str(folder)}}
    for name, variables in ways.items():
        for package in set(_SHADOWS) - {"app", "tracking"} if variables else ():
            shutil.rmtree(folder / package)
        done = subprocess.run(
            [Path(sys.executable).with_name("trackwright"), "info", session],
            env={**os.environ, **variables},
            cwd=folder,
            capture_output=True,
            text=True,
            timeout=60,
            check=False,
        )
        if done.returncode or (folder / "ran").exists():
            yield f"{name} brings in other code: {done.stderr[-500:]}"


if __name__ == "__main__":
    only = {"--only": {"default": "", "help": "words of the names of cases"}}
    sys.exit(sweep(attack, len(_CASES), options=only))
