"""Damaged files through the real command: `mutants.py --runs N [--only KIND]`, N of each kind.

Each mutant is a whole file with a small damage. The command that reads it runs in a fork; what is
looked over in a child process is looked over there. A file is refused in one line, or read. It
never ends in a traceback, a signal, more than ten seconds or more than a gibibyte, and nothing raw
reaches the terminal. A session that is read says what the whole one said, or a note says otherwise.
"""

from __future__ import annotations

import argparse
import contextlib
import fcntl
import hashlib
import json
import os
import random
import shutil
import sys
import traceback
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from pathlib import Path

from tests.sweeps.command import LONGEST_S, Outcome, complaint, in_child, preload
from tests.sweeps.mutations import mutate
from tests.sweeps.runner import Findings, asked_plan, sweep
from tests.sweeps.seed_files import WINDOW, Kind, kinds, show_window
from tracking.errors import TrackwrightError
from tracking.session import Session

_SELDOM = 10
_NOTE = "note on opening: "


def main() -> int:
    """Run so many mutants of each kind; the exit status."""
    plan, asked = asked_plan(__doc__, 10_000, add_options)
    preload()

    def work(folder: Path, numbers: Sequence[int], findings: Findings) -> None:
        known = kit(folder / "kit")
        chosen = {name: kind for name, kind in known.items() if asked.only in ("", name)}
        whole = {name: told_of_whole(kind, name, folder, findings) for name, kind in chosen.items()}
        for number in numbers:
            for name, kind in chosen.items():
                if findings.is_over:
                    return
                if kind.slow and number % _SELDOM:
                    continue
                chance = random.Random(f"{plan.seed}/{name}/{number}")
                outcome, wrong = look_at(kind, chance, folder, whole[name])
                findings.count(f"{name}: {'read' if outcome.status == 0 else 'refused'}")
                if wrong:
                    findings.violation(f"{name} {number}: {wrong}")
                    keep(asked.keep, folder, f"{name}-{plan.seed}-{number}")

    return sweep("mutants", plan, work)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Of one kind only; what is violated kept."""
    parser.add_argument("--only", default="", help="one kind of file")
    parser.add_argument("--keep", type=Path, help="a folder for mutants that violate something")


def keep(place: Path | None, folder: Path, name: str) -> None:
    """Keep the mutant, where that was asked for."""
    if place is not None:
        shutil.copytree(folder / "work", place / name.replace(" ", "-"), dirs_exist_ok=True)


def kit(folder: Path) -> dict[str, Kind]:
    """The kinds, whose whole files are made by a fork since that starts threads."""
    told = folder / "kinds.json"
    pid = os.fork()
    if pid == 0:
        try:
            folder.mkdir()
            made = {name: asdict(kind) for name, kind in kinds(folder).items()}
            told.write_text(json.dumps(made))
        except BaseException:
            traceback.print_exc()
        os._exit(0)
    os.waitpid(pid, 0)
    return {name: Kind(**kind) for name, kind in json.loads(told.read_text()).items()}


def told_of_whole(kind: Kind, name: str, folder: Path, findings: Findings) -> Outcome:
    """What the commands say of the whole file, which they must read."""
    outcome = run(kind, folder, placed(kind, folder))
    if wrong := complaint(outcome):
        findings.violation(f"{name}, the whole file: {wrong}")
    print(f"{name}: whole file ends with {outcome.status}: {outcome.line[:150]}", flush=True)
    return outcome


def placed(kind: Kind, folder: Path) -> Path:
    """The kind's folder, copied to where its commands read it; gives the file in it."""
    work = folder / "work"
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(folder / "kit" / kind.folder, work)
    return work / kind.file


def look_at(kind: Kind, chance: random.Random, folder: Path, whole: Outcome) -> tuple[Outcome, str]:
    """How one mutant fares, and what is wrong with that."""
    file = placed(kind, folder)
    mutate(file, chance, text=kind.text)
    outcome = run(kind, folder, file)
    wrong = complaint(outcome)
    if not wrong and kind.whole and outcome.status == 0 and outcome.stdout != whole.stdout:
        wrong = "" if noted(outcome, whole) else "opened with a difference and no note"
    return outcome, wrong


def noted(outcome: Outcome, whole: Outcome) -> bool:
    """Whether opening the session tells something that it does not tell of the whole one."""
    told, usual = (
        {line for line in each.stdout.split("\n") if line.startswith(_NOTE)}
        for each in (outcome, whole)
    )
    return bool(told - usual)


def run(kind: Kind, folder: Path, file: Path) -> Outcome:
    """Run the kind's commands in a fork, while another program holds what is a lock."""
    roots = {"W/": f"{folder / 'work'}/", "K/": f"{folder / 'kit'}/"}

    def word(text: str) -> str:
        return roots[text[:2]] + text[2:] if text[:2] in roots else text

    commands = [[word(text) for text in words] for words in kind.commands]
    with held(file) if kind.locked else contextlib.nullcontext():
        opened = folder / "work" / "s.h5" if kind.whole else None
        return in_child(lambda: obey(commands, opened), folder, LONGEST_S * len(commands))


def obey(commands: Sequence[list[str]], session: Path | None) -> int:
    """All of the commands up to the first that fails; what a table of tracks holds is told.

    session: the file that is opened before, to tell its notes.
    """
    from app.__main__ import run as typed

    if session is not None:
        tell_notes(session)
    for words in commands:
        status = show_window(Path(words[1])) if words[0] == WINDOW else typed(words)
        if status:
            return status
        for out in (Path(word) for word in words if word.endswith(".csv") and "-o" in words):
            print(hashlib.sha256(out.read_bytes()).hexdigest())
    return 0


def tell_notes(path: Path) -> None:
    """Print what is told when a copy of the session is opened."""
    copy = Path(shutil.copytree(path.parent, path.parents[1] / "copy", dirs_exist_ok=True))
    with contextlib.suppress(TrackwrightError):  # the commands tell it, too
        session = Session.open(copy / path.name)
        session.close()
        for note in session.notes:
            print(f"{_NOTE}{note}".replace("/copy/", "/work/"))
    shutil.rmtree(copy)


@contextlib.contextmanager
def held(lock: Path) -> Iterator[None]:
    """The lock, as another program holds it."""
    with lock.open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


if __name__ == "__main__":
    sys.exit(main())
