"""Two programs on one session whose lock is removed by hand: `two_programs.py --runs 500`.

Each run is another interleaving: one of the programs, or both at once, open the session, edit,
undo, save or close it; now and then the lock is removed, or another file put in its place. Every
edit that was acknowledged must be found in the end: in the session, in what was saved before, or in
a journal that was kept aside. A program may refuse; it may not crash, hang, or take back what the
other was told is done.
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import select
import signal
import sqlite3
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from tests.sweeps.corrector import made_session
from tests.sweeps.runner import Findings, Plan, asked_plan, emptied, slowdown, sweep
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


def main() -> int:
    """Run as many interleavings as asked; the exit status."""
    plan, _ = asked_plan(__doc__, 500)

    def work(folder: Path, numbers: Sequence[int], findings: Findings) -> None:
        for number in numbers:
            if findings.is_over:
                return
            interleave(emptied(folder / "run"), number, findings, plan)

    return sweep("two_programs", plan, work)


@dataclass(slots=True)
class Other:
    """One of the two programs, a fork that does what it is told, and what it acknowledged."""

    name: str
    pid: int
    tell: int
    hear: int
    edits: list[str] = field(default_factory=list)
    broken: str = ""
    is_open: bool = False
    _asked: int = 0
    _lines: bytes = b""

    @classmethod
    def begun(cls, name: str, path: Path) -> Other:
        """Fork it off."""
        (told, tell), (hear, say) = os.pipe(), os.pipe()
        sys.stdout.flush()
        pid = os.fork()
        if pid == 0:
            os.close(tell)
            os.close(hear)
            serve(path, name, told, say)
        os.close(told)
        os.close(say)
        return cls(name, pid, tell, hear)

    def ask(self, act: str) -> None:
        """Have it do something; `heard` waits until it did."""
        if not self.broken:
            self._asked += 1
            os.write(self.tell, f"{act}\n".encode())

    def heard(self, findings: Findings) -> None:
        """What came of all that was asked."""
        while self._asked and not self.broken:
            if b"\n" not in self._lines:
                self._hear()
                continue
            line, self._lines = self._lines.split(b"\n", 1)
            self._asked -= 1
            self._note(json.loads(line), findings)

    def _hear(self) -> None:
        if not select.select([self.hear], [], [], _LONGEST_S * slowdown())[0]:
            self.broken = "hung"
        elif said := os.read(self.hear, 1 << 16):
            self._lines += said
        else:
            self.broken = "crashed"

    def _note(self, told: dict[str, str], findings: Findings) -> None:
        kind = told["kind"]
        findings.count(kind)
        if kind == "bug":
            self.broken = told["text"]
        elif kind == "edit":
            self.edits.append(told["text"])
        elif kind in ("open", "close"):
            self.is_open = kind == "open"

    def end(self) -> None:
        """End it as if its power was cut, where it did not go by itself."""
        os.close(self.tell)
        os.close(self.hear)
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)


def interleave(folder: Path, number: int, findings: Findings, plan: Plan) -> None:
    """One run."""
    path, chance = made_session(folder), random.Random(f"{plan.seed}/{number}")
    programs = [Other.begun(name, path) for name in ("a", "b")]
    story, saves = list[str](), 0
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
            program.heard(findings)
    for program in programs:
        if chance.random() < 0.5:
            program.ask("close")
            program.heard(findings)
        program.end()
    findings.count("interleavings")
    wrong = [f"{program.name} {program.broken}" for program in programs if program.broken]
    found = "\n".join(everything_kept(path))
    lost = [edit for program in programs for edit in program.edits if f"{edit}." not in found]
    wrong += [f"lost {', '.join(lost)}"] if lost else []
    if wrong:
        findings.violation(f"run {number}: {'; '.join(wrong)} after {', '.join(story)}")


def turn(program: Other, chance: random.Random, *, saves: bool) -> list[str]:
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
        with (
            contextlib.closing(sqlite3.connect(journal)) as base,
            contextlib.suppress(sqlite3.Error),
        ):
            yield from (row[0] for row in base.execute("SELECT after FROM steps"))


# The programs


def serve(path: Path, name: str, told: int, say: int) -> None:
    """Do what is told, a line each; say of each what came of it. Never returns."""
    session: Session | None = None
    count = 0
    with os.fdopen(told) as acts:
        for line in acts:
            act = line.strip()
            count += 1
            try:
                session, kind, text = acted(path, session, act, f"{name}{count}")
            except TrackwrightError as why:
                kind, text = "refused", str(why)
            except BaseException:
                kind, text = "bug", traceback.format_exc()[-1500:]
            os.write(say, json.dumps({"kind": kind, "text": text}).encode() + b"\n")
    os._exit(0)


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
    sys.exit(main())
