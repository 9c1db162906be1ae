"""Every system call of saving, journalling, restoring, importing and exporting fails once.

`failed_calls.py [--only SCENARIO] [--runs N]`. Each scenario runs once to list its calls on files
of the session's folder; then once for each of those calls and each error it may give, with that one
call failing (`strace --inject`). Whatever fails: no traceback, no hang, one clear line where a
command ends, no acknowledged edit lost, nothing half-written under a final name, and a program that
goes on can edit and save again. The scenarios take turns; of each, all calls that write come first,
then those that read, in random order.

Left out: `close`, since the system closes the handle even where it fails, and `fcntl`, since EACCES
says there that another program holds a lock.
"""

from __future__ import annotations

import contextlib
import os
import random
import shutil
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import zip_longest
from pathlib import Path

from tests.sweeps.command import Outcome, complaint, preload
from tests.sweeps.runner import Worker, emptied, sweep
from tests.sweeps.session_state import Said, look, state
from tests.sweeps.sessions import made_session
from tests.sweeps.system_calls import calls, check, traced
from tracking.editing import plan_rename, plan_swap
from tracking.errors import TrackwrightError
from tracking.session import Session, find_backups
from tracking.session.session_writer import companions

_READING = ("read", "pread64", "openat", "newfstatat", "statx", "getdents64", "flock")
_WRITING = (
    *("write", "pwrite64", "fsync", "fdatasync", "ftruncate", "fallocate", "rename", "renameat"),
    *("renameat2", "unlink", "unlinkat", "link", "linkat", "mkdir", "mkdirat", "rmdir", "chmod"),
    *("fchmod", "fchmodat", "sendfile", "copy_file_range", "utimensat"),
)
_ERRORS = ("ENOSPC", "EIO", "EINTR", "EACCES", "EROFS")
"""Of calls that write; those that read give the three in the middle."""
_STATUS_NO_RECOVERY = 97


@dataclass(frozen=True, slots=True)
class Scenario:
    """What runs while one call fails.

    Attributes:
        work: in a folder made by `made_session` with edits waiting; says lines to a file.
        made: names of files it makes. restores: it restores what was saved before.
        only_opens: it changes nothing, so nothing may be kept aside either.
    """

    work: Callable[[Path, Path], int]
    made: tuple[str, ...] = ()
    restores: bool = False
    only_opens: bool = False


Fault = tuple[str, str]
"""The name of a call, and what strace is told to make one of them fail."""


def attack(worker: Worker) -> Iterator[str]:
    """List the calls of all scenarios, and fail one a run: one scenario after the other in turn."""
    preload()
    names = [name for name in SCENARIOS if worker.asked.only in ("", name)]
    lists = [in_turn(faults_of(name, worker), worker.asked.seed) for name in names]
    turns = [zip(names, turn, strict=True) for turn in zip_longest(*lists)]
    for name, fault in worker.of([one for turn in turns for one in turn if one[1]]):
        path, said, scenario = made(worker.folder), worker.folder / "said", SCENARIOS[name]
        if scenario.restores:
            say_coming(path, said)
        options = ("-e", f"trace={fault[0]}", "-e", fault[1])
        outcome, report = traced(partial(scenario.work, path, said), worker.folder, options)
        worker.count(f"faults of {name}")
        worker.count("ended with an error in one line", outcome.status == 1)
        failed = [call for call in calls(report) if call.error.endswith("(INJECTED)")]
        what = "; ".join(f"{each.name} {each.handles or each.names}" for each in failed)
        for wrong in wrongs(outcome, path, said, scenario):
            yield f"{name}, {fault[1]} ({what or 'nothing'}): {wrong}"


def in_turn(faults: list[Fault], seed: int) -> list[Fault]:
    """Those of calls that write before those of calls that read, each in random order."""
    random.Random(seed).shuffle(faults)
    return sorted(faults, key=lambda fault: fault[0] in _READING)


def faults_of(name: str, worker: Worker) -> list[Fault]:
    """All calls a scenario makes on its folder, each with all the errors it may give."""
    path, work = made(worker.folder), SCENARIOS[name].work
    options = ("-e", f"trace={','.join((*_READING, *_WRITING))}")
    outcome, report = traced(partial(work, path, worker.folder / "said"), worker.folder, options)
    if outcome.status:
        raise RuntimeError(f"{name}: fails without a fault: {outcome.stderr}")
    counted, found = Counter[tuple[int, str]](), set[tuple[str, int]]()
    for call in calls(report):
        counted[call.thread, call.name] += 1
        if call.is_in(path.parent):
            found.add((call.name, counted[call.thread, call.name]))
    if worker.place == 0:
        print(f"{name}: {len(found)} calls", flush=True)
    return [
        (call, f"inject={call}:error={error}:when={number}")
        for call, number in sorted(found)
        for error in (_ERRORS if call not in _READING or call == "openat" else _ERRORS[1:4])
    ]


def wrongs(outcome: Outcome, path: Path, said: Path, scenario: Scenario) -> Iterator[str]:
    """What is wrong with how a scenario ended and what it left."""
    if outcome.status == _STATUS_NO_RECOVERY:
        yield f"does not recover: {outcome.stderr.strip()[-500:]}"
    elif told := complaint(outcome):
        yield told
    wrong, _ = look(path, Said.of_lines(said.read_text().splitlines()))
    if wrong and not kept_aside(path, outcome):
        yield wrong
    if scenario.only_opens and list(companions(path).glob("kept-aside-*")):
        yield "a journal was kept aside"
    if outcome.status == 0:
        for file in map(path.with_name, scenario.made):
            if not file.is_file() or not file.stat().st_size:
                yield f"done, but {file.name} is not there"


def kept_aside(path: Path, outcome: Outcome) -> bool:
    """Whether the program says that it keeps a file, or a journal, that it could not read."""
    folder = companions(path)
    aside = (*folder.glob("damaged-*.h5"), *folder.glob("kept-aside-*.sqlite"))
    return bool(aside) and all(file.name in outcome.stderr for file in aside)


def made(folder: Path) -> Path:
    """A session of two saves with an edit that waits; what it is like is said."""
    kept = folder / "kept"
    if not kept.exists():
        path = made_session(emptied(kept))
        session = Session.open(path)
        session.apply(plan_swap(session.tracks, 1, 2, 10))
        session.save()
        session.apply(plan_rename(session.tracks, session.labels, 1, "waits"))
        session.close()
    target = folder / "work"
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(kept, target)
    session = Session.look_into(target / "s.h5")
    (folder / "said").write_text(f"= {state(session)}\n")
    return target / "s.h5"


# Scenarios


def opened(path: Path) -> Session:
    """The session; the program ends with a line where it cannot be opened."""
    try:
        return Session.open(path)
    except TrackwrightError as why:
        tell(why)
        sys.exit(1)


def opened_for_writing(path: Path) -> Session:
    """The session; the program ends where only reading is possible: the next opening is as ever."""
    session = opened(path)
    if session.read_only:
        session.close()
        sys.exit(0)
    return session


def tell(why: object) -> None:
    """As a command does."""
    print(f"trackwright: {why}", file=sys.stderr)


def correct(path: Path, said: Path) -> int:
    """Open, edit, save, undo; go on where something is refused."""
    handle, session = os.open(said, os.O_WRONLY | os.O_APPEND), opened_for_writing(path)
    steps = (
        *(renamed("a"), Session.save, renamed("b"), Session.undo, renamed("c"), Session.save),
        *(Session.undo, Session.save, renamed("d")),
    )
    for step in steps:
        with contextlib.suppress(TrackwrightError):
            step(session)
        os.write(handle, f"= {state(session)}\n".encode())
    return went_on(session, handle)


def renamed(name: str) -> Callable[[Session], object]:
    """An edit."""
    return lambda session: session.apply(plan_rename(session.tracks, session.labels, 2, name))


def went_on(session: Session, handle: int) -> int:
    """One more edit and save: where the fault comes then, the second try does it."""
    for left in (1, 0):
        try:
            renamed(f"e{left}")(session)
            os.write(handle, f"= {state(session)}\n".encode())
            session.save()
            session.close()
            return 0
        except TrackwrightError as why:
            tell(why)
    return _STATUS_NO_RECOVERY


def restore_and_correct(path: Path, said: Path) -> int:
    """Restore, go on with what there is then, and edit."""
    handle, session = os.open(said, os.O_WRONLY | os.O_APPEND), opened_for_writing(path)
    with contextlib.suppress(TrackwrightError):
        session = session.restore(1)
    os.write(handle, f"= {state(session)}\n".encode())
    return went_on(session, handle)


def open_only(path: Path, said: Path) -> int:
    """Open and close: what fails meanwhile is no damage, and nothing is kept aside."""
    session = opened(path)
    session.close()
    for line in session.damage:
        tell(line)
    return _STATUS_NO_RECOVERY if session.damage else 0


def typed(*words: str) -> Callable[[Path, Path], int]:
    """A scenario: the command; S stands for the session, T for the tracks, D/ for the folder."""

    def work(path: Path, said: Path) -> int:
        from app.__main__ import run

        known = {"S": str(path), "T": str(path.with_name("tracks.txt"))}
        return run([known.get(word, word.replace("D/", f"{path.parent}/")) for word in words])

    return work


def say_coming(path: Path, said: Path) -> None:
    """Say what a restore leads to."""
    with said.open("a") as lines:
        lines.write(f"~ {state(Session.look_into(find_backups(path)[0]))}\n")


def exporting(name: str, file: str) -> Scenario:
    """A session's tracks for another tool."""
    return Scenario(typed("export", "S", "-o", f"D/{file}", "--format", name), (file,))


SCENARIOS = {
    "open": Scenario(open_only, only_opens=True),
    "correct": Scenario(correct),
    "restore": Scenario(restore_and_correct, restores=True),
    "restore by command": Scenario(typed("restore", "S"), restores=True),
    "import into": Scenario(typed("import", "T", "--into", "S", "--as-new")),
    "log": Scenario(typed("log", "S", "--csv", "D/log.csv"), ("log.csv",)),
    "export mot": exporting("mot", "out.txt"),
    "export csv": exporting("csv", "out.csv"),
    "export coco": exporting("coco", "out.json"),
    "export cvat": exporting("cvat", "out.xml"),
    "export pedpy-h5": exporting("pedpy-h5", "out.h5"),
    "export jupedsim-sqlite": exporting("jupedsim-sqlite", "out.sqlite"),
}

if __name__ == "__main__":
    check()
    only = {"--only": {"default": "", "choices": list(SCENARIOS), "help": "one scenario"}}
    sys.exit(sweep(attack, sys.maxsize, options=only))
