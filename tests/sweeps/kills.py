"""Kill a program that corrects a session, again and again: `kills.py --runs 2000 --window 300`.

The program edits, undoes, saves, imports, restores older saves and opens anew. It says after each
step what the session is like then. It is killed (kill -9) at a random moment, of opening and saving
too. What is on the disk must be what it said last, or one step further: a step that was done and
kept, with no time left to say so. Nothing that was ever said may be missing, no file unreadable,
and the log, done again from the tracker's result on, must give the corrected tracks. Some of the
runs are of the real window, driven by keys.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import random
import signal
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from tests.sweeps.corrector import Corrector
from tests.sweeps.runner import Worker, slowdown, sweep
from tests.sweeps.session_state import Said, look
from tests.sweeps.sessions import SMALL, made_session, tracked_session

_STEPS = 400
_MOST_STEPS_HEARD = 12
"""A program is let live until it said so many steps at most."""
_LONGEST_LIFE_S, _LAST_STEP_S = 5.0, 0.15
"""No program is waited for longer; after the last step it is let live for a moment."""
_BORN_DEAD = 0.25
"""Share of the runs that are killed within a moment of their birth, while the session opens."""
Live = Callable[[Path, int, Callable[[str], None]], None]
"""Corrects a session, by a seed, and tells each step."""


def correct(path: Path, seed: int, tell: Callable[[str], None]) -> None:
    """Without a window."""
    Corrector(path, seed, tell).work(_STEPS)


def edit_in_window(path: Path, seed: int, tell: Callable[[str], None]) -> None:
    """With the window."""
    from tests.sweeps.editor import Editor  # Qt: only in a fork of its own

    editor = Editor(path, seed)
    for _ in range(_STEPS):
        tell(f"= {editor.step()}")


def attack(worker: Worker) -> Iterator[str]:
    """Let one program after the other live on the same session, and look at what each leaves."""
    sessions: dict[Live, tuple[Path, str]] = {}
    for number in worker.numbers:
        live = edit_in_window if number < worker.asked.window else correct
        if live not in sessions:
            made = made_session(worker.folder / "made") if live is correct else None
            path = made or tracked_session(worker.folder, **SMALL)
            sessions[live] = path, look(path, None)[1]
        path, found = sessions[live]
        heard, status = killed(live, path, worker.chance())
        wrong, found = look(path, Said.of_lines([f"= {found}", *heard]))
        sessions[live] = path, found
        if status not in (0, -signal.SIGKILL):
            yield f"the program ended by itself, with {status}"
        if wrong:
            yield wrong
        worker.count("kills")
        worker.count("of them of the window", live is edit_in_window)
        worker.count("of them while a session opened", not heard)
        worker.count("acknowledged steps", sum(line.startswith("= ") for line in heard))


def killed(live: Live, path: Path, chance: random.Random) -> tuple[list[str], int]:
    """Start a program, and kill it at a random moment; what it said, and how it ended."""
    hear, say = multiprocessing.Pipe(duplex=False)
    seed, born_dead = chance.randrange(1 << 30), chance.random() < _BORN_DEAD
    enough = 0 if born_dead else chance.randint(1, _MOST_STEPS_HEARD)
    program = multiprocessing.get_context("fork").Process(
        target=live, args=(path, seed, lambda text: say.send_bytes(text.encode()))
    )
    program.start()
    say.close()
    heard, until_s = list[str](), time.monotonic() + _LONGEST_LIFE_S * slowdown()
    with contextlib.suppress(EOFError):
        while len(heard) < enough and hear.poll(max(0.0, until_s - time.monotonic())):
            heard.append(hear.recv_bytes().decode())
    time.sleep(chance.uniform(0.0, _LAST_STEP_S))
    program.kill()
    program.join()
    with contextlib.suppress(EOFError):
        while True:
            heard.append(hear.recv_bytes().decode())
    hear.close()
    return heard, program.exitcode or 0


if __name__ == "__main__":
    window = {"--window": {"type": int, "default": 300, "help": "so many runs are of the window"}}
    sys.exit(sweep(attack, 2000, options=window))
