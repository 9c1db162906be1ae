"""Kill a program that corrects a session, again and again: `kills.py --runs 2000 --window 300`.

The program edits, undoes, saves, imports, restores older saves and opens anew. It says after each
step, on a pipe, what the session is like then. It is killed (kill -9) at a random moment, of
opening and saving too. What is on the disk must be what it said last, or one step further: a step
that was done and kept, with no time left to say so. Nothing that was ever said may be missing, no
file unreadable, and the log, done again from the tracker's result on, must give the corrected
tracks. Some of the runs are of the real window, driven by keys.
"""

from __future__ import annotations

import argparse
import os
import random
import select
import signal
import sys
import time
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path

from tests.sweeps.corrector import Corrector, made_session
from tests.sweeps.runner import Findings, Plan, asked_plan, slowdown, sweep
from tests.sweeps.session_state import Said, look, state
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.session import Session
from tracking.synthesis import render_recording

_STEPS = 400
_MOST_STEPS_HEARD = 12
"""A program is let live until it said so many steps at most."""
_LONGEST_LIFE_S, _LAST_STEP_S = 5.0, 0.15
"""No program is waited for longer; after the last step it is let live for a moment."""
_BORN_DEAD = 0.25
"""Share of the runs that are killed within a moment of their birth, while the session opens."""
Tell = Callable[[str], None]
Live = Callable[[int, Tell], None]


def main() -> int:
    """Kill as often as asked; the exit status."""
    plan, asked = asked_plan(__doc__, 2000, add_options)

    def work(folder: Path, numbers: Sequence[int], findings: Findings) -> None:
        of_window = [number for number in numbers if number < asked.window]
        others = [number for number in numbers if number >= asked.window]
        kill(folder, others, findings, plan)
        if of_window:
            kill_window(folder, of_window, findings, plan)

    return sweep("kills", plan, work)


def add_options(parser: argparse.ArgumentParser) -> None:
    """How many of the kills are of the window."""
    parser.add_argument("--window", type=int, default=300, help="of the runs, so many")


def kill(folder: Path, numbers: Sequence[int], findings: Findings, plan: Plan) -> None:
    """Kill programs without a window."""
    path = made_session(folder)

    def live(seed: int, tell: Tell) -> None:
        Corrector(path, seed, tell).work(_STEPS)

    kill_in_turn(path, [f"{plan.seed}/{number}" for number in numbers], live, findings)


def kill_window(folder: Path, numbers: Sequence[int], findings: Findings, plan: Plan) -> None:
    """Kill the program with its window."""
    path = tracked_session(folder)

    def live(seed: int, tell: Tell) -> None:
        from tests.sweeps.editor import Editor  # Qt: only in a fork of its own

        Editor(path, folder / "settings.ini", seed, lambda text: tell(f"= {text}")).work()

    before = findings.counts["kills"]
    kill_in_turn(path, [f"{plan.seed}/{number}" for number in numbers], live, findings)
    findings.count("kills of the window", findings.counts["kills"] - before)


def tracked_session(folder: Path) -> Path:
    """A small recording with four people, tracked: by a fork, since that starts threads."""
    path = folder / "tracked.h5"
    pid = os.fork()
    if pid == 0:
        try:
            render_recording(folder / "scene", "plaza", 10.0, 4, 3, size=(320, 240), fps=8.0)
            with open_recording(folder / "scene") as recording, track(recording) as tracking:
                for _ in tracking:
                    pass
                Session.create(recording, [tracking.run()], path).close()
        finally:
            os._exit(0)
    os.waitpid(pid, 0)
    return path


def kill_in_turn(path: Path, names: Sequence[str], live: Live, findings: Findings) -> None:
    """Let one program after the other live on the same session, and look at what each leaves."""
    session = Session.open(path)
    found = state(session)
    session.close()
    for name in names:
        if findings.is_over:
            return
        heard, status = killed(live, random.Random(name))
        said = Said.of_lines([f"= {found}", *heard])
        wrong, found = look(path, said)
        if status not in (0, -signal.SIGKILL):
            findings.violation(f"run {name}: the program ended by itself, with {status}")
        if wrong:
            findings.violation(f"run {name}: {wrong}")
        findings.count("kills")
        findings.count("acknowledged steps", sum(line.startswith("= ") for line in heard))
        findings.count("kills while opening", not heard)


def killed(live: Live, chance: random.Random) -> tuple[list[str], int]:
    """Fork off a program, and kill it at a random moment; what it said, and how it ended."""
    hear, say = os.pipe()
    seed, born_dead = chance.randrange(1 << 30), chance.random() < _BORN_DEAD
    enough = 0 if born_dead else chance.randint(1, _MOST_STEPS_HEARD)
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        os.close(hear)
        try:
            live(seed, lambda text: put(say, text.encode() + b"\n"))
        except BaseException:
            traceback.print_exc()
            os._exit(1)
        os._exit(0)
    os.close(say)
    heard = heard_until(hear, enough)
    time.sleep(chance.uniform(0.0, _LAST_STEP_S))
    os.kill(child, signal.SIGKILL)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    with os.fdopen(hear, "rb") as rest:
        heard += rest.read()
    return heard.decode().splitlines(), status


def heard_until(pipe: int, enough: int) -> bytes:
    """What comes through the pipe until so many lines have, or a long time has passed."""
    heard, until_s = b"", time.monotonic() + _LONGEST_LIFE_S * slowdown()
    while heard.count(b"\n") < enough and (left_s := until_s - time.monotonic()) > 0:
        if select.select([pipe], [], [], left_s)[0]:
            part = os.read(pipe, 1 << 16)
            if not part:
                break
            heard += part
    return heard


def put(pipe: int, text: bytes) -> None:
    """Write all of it: a line is short enough to go at once."""
    if os.write(pipe, text) != len(text):
        raise OSError("the pipe took a part of a line")


if __name__ == "__main__":
    sys.exit(main())
