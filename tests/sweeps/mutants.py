"""Damaged files through the real command: `mutants.py --runs N [--only KIND]`, N of each kind.

Each mutant is a whole file with a small damage. The command that reads it runs in a fork; what is
looked over in a child process is looked over there. A file is refused in one line, or read. It
never ends in a traceback, a signal, more than ten seconds or more than a gibibyte, and nothing raw
reaches the terminal. A session that is read says what the whole one said, or a note says otherwise.
"""

from __future__ import annotations

import contextlib
import fcntl
import hashlib
import shutil
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.sweeps.command import LONGEST_S, Outcome, complaint, in_child, preload
from tests.sweeps.mutations import mutate
from tests.sweeps.runner import Worker, sweep
from tests.sweeps.seed_files import WINDOW, Kind, Kit, show_window
from tracking.errors import TrackwrightError
from tracking.session import Session

_SELDOM = 10
_NOTE = "note on opening: "


def attack(worker: Worker) -> Iterator[str]:
    """A mutant of each kind a run."""
    preload()
    kit, whole = Kit(worker.folder), dict[str, Outcome]()
    chosen = {name: kind for name, kind in kit.kinds.items() if worker.asked.only in ("", name)}
    for name, kind in chosen.items():
        whole[name] = run(kind, kit, placed(kind, kit))
        if worker.place == 0:
            told = whole[name].status, whole[name].line[:150]
            print(f"{name}: whole file ends with {told[0]}: {told[1]}", flush=True)
        if wrong := complaint(whole[name]):
            yield f"{name}, the whole file: {wrong}"
    for number in worker.numbers:
        for name, kind in chosen.items():
            if worker.is_over:
                return
            if kind.slow and number % _SELDOM:
                continue
            file = placed(kind, kit)
            mutate(file, worker.chance(name, number))
            outcome = run(kind, kit, file)
            worker.count("mutants")
            worker.count("refused in one line" if outcome.status else "read")
            wrong = complaint(outcome)
            is_other = kind.whole and not outcome.status and outcome.stdout != whole[name].stdout
            if is_other and not noted(outcome, whole[name]):
                wrong = wrong or "opened with a difference and no note"
            if wrong:
                yield f"{name} {number}: {wrong}"
                keep(worker, f"{name}-{worker.asked.seed}-{number}")
    worker.count("kinds", len(chosen) * (worker.place == 0))


def keep(worker: Worker, name: str) -> None:
    """Keep the mutant, where that was asked for."""
    if (place := worker.asked.keep) is not None:
        kept = place / name.replace(" ", "-")
        shutil.copytree(worker.folder / "work", kept, dirs_exist_ok=True)


def placed(kind: Kind, kit: Kit) -> Path:
    """The kind's folder, copied to where its commands read it; gives the file in it."""
    work = kit.folder.parent / "work"
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(kit.folder / kind.folder, work)
    return work / kind.file


def noted(outcome: Outcome, whole: Outcome) -> bool:
    """Whether opening the session tells something that it does not tell of the whole one."""
    told, usual = (
        {line for line in each.stdout.split("\n") if line.startswith(_NOTE)}
        for each in (outcome, whole)
    )
    return bool(told - usual)


def run(kind: Kind, kit: Kit, file: Path) -> Outcome:
    """Run the kind's commands in a fork, while another program holds what is a lock."""
    folder = kit.folder.parent
    commands = [[kit.word(word, folder / "work") for word in words] for words in kind.commands]
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
    keeping = {"type": Path, "help": "a folder for mutants that violate something"}
    options = {"--only": {"default": "", "help": "one kind of file"}, "--keep": keeping}
    sys.exit(sweep(attack, 10_000, options=options))
