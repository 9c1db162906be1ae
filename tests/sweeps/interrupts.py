"""Interrupt the window at random moments: `python -m tests.sweeps.interrupts [TIMES] [--seed N]`.

The program as it is installed opens a session, or a recording that it plays and tracks, offscreen
or on the screen of `DISPLAY`. SIGINT comes from its first moment to some seconds after it would
have opened. It must end within 10 s, with status 0 or 130, without a traceback or a crash. What
comes while Python itself starts is counted apart.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from tests.sweeps.runner import Worker, sweep
from tests.sweeps.sessions import LOBBY, tracked_session

PATIENCE_S = 10.0
_STARTING_S = 0.5
"""Before that Python itself starts; an interrupt then is its own affair."""
_AFTER_S = 4.0
"""Seconds of playing, tracking and closing after the window has opened."""
_OPENING_S = 600.0
_ALLOWED = (0, 130)
_OF_PYTHON = (1, -signal.SIGINT)
_OURS = re.compile(r'File "[^"]*/(app|tracking)/(?!interrupts|launcher)')
"""A line of a traceback in what runs once interrupts are told in a line."""
WELL, BEFORE = "ended well", "before the first line of the program"
_OFFSCREEN = """
import sys
from app.core.interrupts import ending_at_once
with ending_at_once():
    from pathlib import Path
    from app.shell.application import run
path = Path(sys.argv[1])
sys.exit(run(path, play=path.is_dir()))
"""
"""The command wants a display; this is the same without, and puts a tracker to work."""


def attack(worker: Worker) -> Iterator[str]:
    """An interrupt a run."""
    session = worker.asked.session or tracked_session(worker.folder, **LOBBY)
    recording = worker.asked.recording or session.parent / "recording"
    longest_s = seconds_to_open(session) + _AFTER_S
    worker.count("s at most", round(longest_s))
    for _ in worker.numbers:
        chance = worker.chance()
        moment_s, path = chance.uniform(_STARTING_S, longest_s), chance.choice((session, recording))
        process = started(path)
        time.sleep(moment_s)
        end = end_of(process)
        worker.count("interrupts")
        if end == BEFORE:
            worker.count(end)
        elif end != WELL:
            yield f"{path.name} after {moment_s:.2f} s: {end}"


def seconds_to_open(session: Path) -> float:
    """How long the window takes here: until the settings say that the session is open."""
    begun_s, process = time.monotonic(), started(session)
    settings = Path(os.environ["XDG_CONFIG_HOME"]) / "trackwright" / "trackwright.conf"
    while not settings.is_file() or session.name not in settings.read_text():
        waits = process.poll() is None and time.monotonic() - begun_s < _OPENING_S
        assert waits, "the window did not open"
        time.sleep(0.05)
    end_of(process)
    return time.monotonic() - begun_s


def started(path: Path) -> subprocess.Popen[str]:
    """The window on a path."""
    words = ["-m", "app.launcher", "open"] if os.environ.get("DISPLAY") else ["-c", _OFFSCREEN]
    return subprocess.Popen(
        [sys.executable, *words, str(path)],
        env={**os.environ, "PYTHONFAULTHANDLER": "1"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )


def end_of(process: subprocess.Popen[str]) -> str:
    """Interrupt it and say how it ends."""
    process.send_signal(signal.SIGINT)
    try:
        said = process.communicate(timeout=PATIENCE_S)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        return "hung: " + process.communicate()[1][-500:]
    if process.returncode in _OF_PYTHON and not _OURS.search(said):
        return BEFORE
    if process.returncode not in _ALLOWED:
        return f"status {process.returncode}: {said[-2000:]}"
    return f"told {said[-2000:]}" if "Traceback" in said or "Fatal" in said else WELL


if __name__ == "__main__":
    options = {
        "--session": {"type": Path, "help": "made of a rendered recording if left out"},
        "--recording": {"type": Path, "help": "of the session"},
    }
    sys.exit(sweep(attack, 100, workers=1, options=options))
