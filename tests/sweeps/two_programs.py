"""Two programs on one session whose lock is removed by hand: `two_programs.py --runs 500`.

Each run is another interleaving: one of the programs, or both at once, open the session, edit,
undo, save or close it; now and then the lock is removed, or another file put in its place. Every
edit that was acknowledged must be found in the end: in the session, in what was saved before, or in
a journal that was kept aside. A program may refuse; it may not crash, hang, or take back what the
other was told is done.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import random
import sqlite3
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import closing
from multiprocessing.connection import Connection
from pathlib import Path

from tests.sweeps.runner import Worker, emptied, slowdown, sweep
from tests.sweeps.sessions import made_session
from tracking.editing import plan_rename
from tracking.errors import TrackwrightError
from tracking.session import Session, find_backups
from tracking.session.session_writer import companions

_TURNS = 14
_REMOVED, _AT_ONCE = 0.4, 0.15
"""How often the lock is removed before a turn, and how often both take theirs at once."""
_MOST_SAVES = 4
"""Of a run: no older save is dropped, so that what is in none of them is lost."""
_LONGEST_S = 15.0


def attack(worker: Worker) -> Iterator[str]:
    """An interleaving a run."""
    for _ in worker.numbers:
        worker.count("interleavings")
        path = made_session(emptied(worker.folder / "run"))
        programs, story = [Program(name, path) for name in ("a", "b")], list[str]()
        interleave(path, programs, worker.chance(), story)
        for program in programs:
            worker.counts.update(program.done)
            program.end()
        wrong = [f"{program.name} {program.broken}" for program in programs if program.broken]
        found = "\n".join(everything_kept(path))
        lost = [edit for each in programs for edit in each.edits if f"{edit}." not in found]
        wrong += [f"lost {', '.join(lost)}"] if lost else []
        if wrong:
            yield f"{'; '.join(wrong)} after {', '.join(story)}"


class Program:
    """One of the two, a fork that does what it is told.

    Attributes:
        edits: those it acknowledged. done: all it did, by kind. broken: how it failed.
    """

    def __init__(self, name: str, path: Path) -> None:
        self.name, self.broken, self.is_open = name, "", False
        self.edits, self.done, self._asked = list[str](), list[str](), 0
        fork = multiprocessing.get_context("fork")
        self._pipe, other = fork.Pipe()
        self._process = fork.Process(target=serve, args=(path, name, other), daemon=True)
        self._process.start()
        other.close()

    def ask(self, act: str) -> None:
        """Have it do something; `hear` waits until it did."""
        if not self.broken:
            self._asked += 1
            with contextlib.suppress(BrokenPipeError):
                self._pipe.send(act)

    def hear(self) -> None:
        """Wait for what comes of all that was asked."""
        while self._asked and not self.broken:
            if not self._pipe.poll(_LONGEST_S * slowdown()):
                self.broken = "hung"
                return
            try:
                kind, text = self._pipe.recv()
            except (EOFError, ConnectionResetError):
                self.broken = "crashed"
                return
            self._asked -= 1
            self.done.append(kind)
            if kind == "bug":
                self.broken = text
            elif kind == "edit":
                self.edits.append(text)
            elif kind in ("open", "close"):
                self.is_open = kind == "open"

    def end(self) -> None:
        """End it as if its power was cut."""
        self._process.kill()
        self._process.join()
        self._pipe.close()


def interleave(
    path: Path, programs: list[Program], chance: random.Random, story: list[str]
) -> None:
    """Have both take their turns; what they are asked goes into the story."""
    saves = 0
    for _ in range(_TURNS):
        if chance.random() < _REMOVED:
            story.append(without_lock(path, chance))
        asked = programs if chance.random() < _AT_ONCE else [chance.choice(programs)]
        for program in asked:
            for act in turn(program, chance, saves=saves < _MOST_SAVES):
                saves += act == "save"
                story.append(f"{program.name} {act}")
                program.ask(act)
        for program in asked:
            program.hear()
    for program in programs:
        if chance.random() < 0.5:
            program.ask("close")
            program.hear()


def turn(program: Program, chance: random.Random, *, saves: bool) -> list[str]:
    """What a program is told to do in its turn: it works in a session once it has opened it."""
    if not program.is_open:
        return ["open"]
    acts = [chance.choice(("edit", "edit", "edit", "undo")) for _ in range(chance.randint(1, 2))]
    if saves and chance.random() < 0.15:
        acts.append("save")
    if chance.random() < 0.4:
        acts.append("close")
    return acts


def without_lock(path: Path, chance: random.Random) -> str:
    """Remove the lock by hand, or put another file in its place."""
    lock = companions(path) / "lock"
    with contextlib.suppress(OSError):
        lock.unlink()
        if chance.random() < 0.3:
            lock.touch()
            return "the lock is replaced"
    return "the lock is removed"


def everything_kept(path: Path) -> Iterator[str]:
    """All edits anywhere: in the session, in older saves, in journals that were kept aside."""
    for file in (path, *find_backups(path)):
        with contextlib.suppress(TrackwrightError):
            session = Session.look_into(file) if file != path else Session.open(file)
            yield from (entry.after for entry in session.history)
            session.close()
    for journal in companions(path).glob("*.sqlite"):
        with closing(sqlite3.connect(journal)) as base, contextlib.suppress(sqlite3.Error):
            yield from (row[0] for row in base.execute("SELECT after FROM steps"))


def serve(path: Path, name: str, pipe: Connection) -> None:
    """One of the programs: do what is told, and say of each what came of it."""
    session: Session | None = None
    count = 0
    while act := pipe.recv():
        count += 1
        try:
            session, kind, text = acted(path, session, act, f"{name}{count}")
        except TrackwrightError as why:
            kind, text = "refused", str(why)
        except BaseException:
            kind, text = "bug", traceback.format_exc()[-1500:]
        pipe.send((kind, text))


def acted(
    path: Path, session: Session | None, act: str, token: str
) -> tuple[Session | None, str, str]:
    """Do one thing: the session then, and what was done."""
    if act == "open" and session is None:
        return Session.open(path), "open", ""
    if session is None or act == "open":
        return session, "nothing to do", ""
    if act == "close":
        session.close()
        return None, "close", ""
    doing: dict[str, Callable[[], object]] = {
        # The dot ends the name, so that a1 is not found in a12.
        "edit": lambda: session.apply(plan_rename(session.tracks, session.labels, 1, f"{token}.")),
        "undo": session.undo,
        "save": session.save,
    }
    doing[act]()
    return session, act, token


if __name__ == "__main__":
    sys.exit(sweep(attack, 500))
