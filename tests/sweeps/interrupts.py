"""Interrupt the window at random moments: `python -m tests.sweeps.interrupts [TIMES] [--seed N]`.

The program as it is installed opens a session, or a recording that it plays and tracks, offscreen
or on the screen of `DISPLAY`. SIGINT comes from its first moment to some seconds after it would
have opened. It must end within 10 s, with status 0 or 130, without a traceback or a crash. What
comes while Python itself starts is counted apart.
"""

from __future__ import annotations

import argparse
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from tests.sweeps.shown_session import session_with_particles

TIMES = 100
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
BEFORE = "before the first line of the program"
_OFFSCREEN = """
import sys
from app.interrupts import ending_at_once
with ending_at_once():
    from pathlib import Path
    from app.views.application import run
path = Path(sys.argv[1])
sys.exit(run(path, play=path.is_dir()))
"""
"""The command wants a display; this is the same without, and puts a tracker to work."""
_HOMES = ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME")


def main() -> int:
    """Run it; the exit status."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("times", type=int, nargs="?", default=TIMES)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--session", type=Path, help="made of a rendered recording if left out")
    parser.add_argument("--recording", type=Path, help="of the session")
    asked = parser.parse_args()
    chance = random.Random(asked.seed)
    ends: Counter[str] = Counter()
    with tempfile.TemporaryDirectory(prefix="trackwright-") as folder:
        session = asked.session or session_with_particles(Path(folder))
        recording = asked.recording or session.parent / "recording"
        longest_s = seconds_to_open(Path(folder), session) + _AFTER_S
        for number in range(1, asked.times + 1):
            moment_s = chance.uniform(_STARTING_S, longest_s)
            end = interrupted(Path(folder), chance.choice((session, recording)), moment_s)
            ends[end] += 1
            if end not in ("well", BEFORE):
                print(f"{number}: after {moment_s:.2f} s: {end}", flush=True)
    print(f"{asked.times} interrupts within {longest_s:.1f} s: {dict(ends)}")
    return int(ends["well"] + ends[BEFORE] < asked.times)


def seconds_to_open(home: Path, session: Path) -> float:
    """How long the window takes here: until the settings say that the session is open."""
    begun_s = time.monotonic()
    process = started(home, session)
    settings = home / "trackwright" / "trackwright.conf"
    while not settings.is_file() or session.name not in settings.read_text():
        waits = process.poll() is None and time.monotonic() - begun_s < _OPENING_S
        assert waits, "the window did not open"
        time.sleep(0.05)
    taken_s = time.monotonic() - begun_s
    end_of(process)
    return taken_s


def interrupted(home: Path, path: Path, moment_s: float) -> str:
    """How the program ended that was interrupted then: "well", or what went wrong."""
    process = started(home, path)
    time.sleep(moment_s)
    return end_of(process)


def started(home: Path, path: Path) -> subprocess.Popen[str]:
    """The window on a path."""
    homes = dict.fromkeys(_HOMES, str(home))
    screen = {} if os.environ.get("DISPLAY") else {"QT_QPA_PLATFORM": "offscreen"}
    words = ["-m", "app.launcher", "open"] if os.environ.get("DISPLAY") else ["-c", _OFFSCREEN]
    return subprocess.Popen(
        [sys.executable, *words, str(path)],
        env={**os.environ, **homes, **screen, "PYTHONFAULTHANDLER": "1"},
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
    return f"told {said[-2000:]}" if "Traceback" in said or "Fatal" in said else "well"


if __name__ == "__main__":
    sys.exit(main())
