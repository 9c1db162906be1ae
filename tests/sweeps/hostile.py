"""Files and folders made to harm, each through the real command: `hostile.py [--only WORDS]`.

Each case ends as it should: with one line or with what it was asked for, within ten seconds and a
gibibyte, with nothing raw on the terminal. Nothing in the folder elsewhere is changed, made or
removed, and the way to it (PYTHONPATH, the folder the command starts in) brings in no other code.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import re
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import tests.sweeps.hostile_files.companions
import tests.sweeps.hostile_files.hdf5_files
import tests.sweeps.hostile_files.recordings
import tests.sweeps.hostile_files.tracks
from tests.sweeps.command import Outcome, command, complaint, preload
from tests.sweeps.hostile_files.case import Case
from tests.sweeps.mutants import kit
from tests.sweeps.runner import Findings, asked_plan, emptied, sweep

_CASES = (
    *tests.sweeps.hostile_files.companions.CASES,
    *tests.sweeps.hostile_files.hdf5_files.CASES,
    *tests.sweeps.hostile_files.recordings.CASES,
    *tests.sweeps.hostile_files.tracks.CASES,
)
_SHADOWS = ("app", "tracking", "sqlite3", "h5py", "numpy", "json", "typer")
"""Packages that somebody puts in the way of those the command means."""


def main() -> int:
    """Run all cases; the exit status."""
    plan, asked = asked_plan(__doc__, len(_CASES), add_options)
    chosen = [case for case in _CASES if asked.only in case.name]
    preload()

    def work(folder: Path, numbers: Sequence[int], findings: Findings) -> None:
        kit(folder / "kit")
        for number in numbers:
            if number < len(chosen) and not findings.is_over:
                meet(chosen[number], folder, findings)
        if 0 in numbers and not asked.only:
            shadowed(emptied(folder / "shadow"), folder / "kit" / "session" / "s.h5", findings)

    return sweep("hostile", plan, work)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Some cases only."""
    parser.add_argument("--only", default="", help="words of the names of cases")


def meet(case: Case, folder: Path, findings: Findings) -> None:
    """One case."""
    place = emptied(folder / "case")
    work, elsewhere = place / "work", victims(place / "elsewhere")
    shutil.copytree(folder / "kit" / case.base, work)
    before = state_of(elsewhere)
    case.make(work)
    roots = {"W/": f"{work}/", "K/": f"{folder / 'kit'}/"}
    outcome = command([roots.get(w[:2], w[:2]) + w[2:] for w in case.words], folder)
    wrong = complaint(outcome) or unexpected(case, outcome)
    findings.count("cases")
    findings.count("refused" if outcome.status else "opened")
    if wrong:
        findings.violation(f"{case.name}: {wrong}")
    if state_of(elsewhere) != before:
        findings.violation(f"{case.name}: a file elsewhere was changed")


def unexpected(case: Case, outcome: Outcome) -> str:
    """What is other than the case expects."""
    if case.status is not None and outcome.status != case.status:
        return f"ends with {outcome.status}, not {case.status}: {outcome.line}"
    if outcome.status and not re.search(case.says, outcome.line):
        return f"does not say {case.says!r}: {outcome.line}"
    return ""


def victims(folder: Path) -> Path:
    """Files that nothing may touch."""
    emptied(folder / "folder")
    for name in ("victim.txt", "folder/saving-precious.h5", "folder/lock"):
        (folder / name).write_text("precious\n")
    base = sqlite3.connect(folder / "victim.sqlite")
    base.execute("CREATE TABLE steps(precious)")
    base.execute("INSERT INTO steps VALUES(1)")
    base.commit()
    base.close()
    return folder


def state_of(folder: Path) -> dict[str, str]:
    """All names and contents."""
    return {
        str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in folder.rglob("*")
        if file.is_file()
    }


def shadowed(folder: Path, session: Path, findings: Findings) -> None:
    """The command as it is installed, with other packages of the names it uses in its way."""
    for name in _SHADOWS:
        package = folder / name
        package.mkdir()
        (package / "__init__.py").write_text(
            f"open({str(folder / 'ran')!r}, 'a').write({name!r})\n"
        )
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
        findings.count("cases")
        if done.returncode or (folder / "ran").exists():
            findings.violation(f"{name} brings in other code: {done.stderr[-500:]}")


if __name__ == "__main__":
    sys.exit(main())
