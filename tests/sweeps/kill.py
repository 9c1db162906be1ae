"""Kill the real program while somebody corrects tracks in it: `kill.py [KILLS] [SEED]`.

The program is a process with the real window, driven by keys. It says after each step, on a pipe,
what the session is like then. It is killed (kill -9) at a random moment, of opening and saving
too. What is on the disk must be what it said last, or one step further: a step that was done and
kept, with no time left to say so. Nothing that was ever said may be missing, no file unreadable,
and the log, done again from the tracker's result on, must give the corrected tracks.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from pathlib import Path

from tests.sweeps.editor import Editor, digest, state
from tracking.editing import apply_change
from tracking.errors import TrackwrightError
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.session import Session
from tracking.synthesis import render_recording
from tracking.tracks import Labels, TrackTable

LONGEST_LIFE_S = 2.5


def main() -> int:
    """Kill as often as asked; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kills", type=int, nargs="?", default=1000)
    parser.add_argument("seed", type=int, nargs="?", default=1)
    asked = parser.parse_args()
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory(prefix="trackwright-") as folder:
        return sweep(Path(folder), asked.kills, asked.seed)


def sweep(folder: Path, kills: int, seed: int) -> int:
    """Kill so many times; says what was lost and gives the exit status."""
    path = make_session(folder)
    chance = random.Random(seed)
    steps, moments, lost = 0, Counter[str](), 0
    for number in range(kills):
        said = life(folder, path, seed * 1_000_003 + number, chance.uniform(0.0, LONGEST_LIFE_S))
        steps += max(len(said) - 1, 0)
        problem = look(path, said)
        moments["opening" if len(said) < 2 else "editing"] += 1
        if problem:
            lost += 1
            print(f"life {number}: {problem}", flush=True)
        if (number + 1) % 50 == 0:
            print(f"{number + 1} kills, {steps} steps, {lost} problems", flush=True)
    print(f"{kills} kills ({dict(moments)}), {steps} acknowledged steps, {lost} problems")
    return 1 if lost else 0


def make_session(folder: Path) -> Path:
    """A small recording with four people, tracked."""
    render_recording(folder / "scene", "plaza", 10.0, 4, 3, size=(320, 240), fps=8.0)
    with open_recording(folder / "scene") as recording, track(recording) as tracking:
        for _ in tracking:
            pass
        Session.create(recording, [tracking.run()], folder / "s.h5").close()
    return folder / "s.h5"


def life(folder: Path, path: Path, seed: int, seconds: float) -> list[str]:
    """Let the program live for so long; what it said, the state it was born into first."""
    born = Session.open(path)
    said = [state(born)]
    born.close()
    hear, say = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(hear)
        try:
            editor = Editor(
                path, folder / "settings.ini", seed, lambda text: put(say, text.encode() + b"\n")
            )
            editor.work()
        except BaseException:
            traceback.print_exc()
            os._exit(1)
        os._exit(0)
    os.close(say)
    time.sleep(seconds)
    os.kill(child, signal.SIGKILL)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    with os.fdopen(hear, "rb") as heard:
        said += heard.read().decode().splitlines()
    if status > 0 or (status < 0 and status != -signal.SIGKILL):
        raise AssertionError(f"the program ended by itself, with {status}, after {len(said)} steps")
    return said


def put(pipe: int, text: bytes) -> None:
    """Write all of it: a line is short enough to go at once."""
    if os.write(pipe, text) != len(text):
        raise OSError("the pipe took a part of a line")


def look(path: Path, said: list[str]) -> str:
    """What is wrong with what was left on the disk; "" where nothing is."""
    try:
        session = Session.open(path)
    except TrackwrightError as error:
        return f"unreadable: {error}"
    try:
        if session.read_only:
            return f"read only: {session.notes}"
        if not follows_from_its_log(session):
            return "the log, done again, gives other tracks"
        if state(session) == said[-1] or one_step_further(session, said[-1]):
            return ""
        return "an acknowledged step is lost"
    finally:
        session.close()


def follows_from_its_log(session: Session) -> bool:
    """Whether the run with the edits in force done again is the corrected table."""
    table, labels = TrackTable(session.runs[0].tracks), Labels()
    for entry in session.history:
        if not entry.undone:
            labels = apply_change(table, labels, entry.change)
    now, again = session.tracks.columns(), table.columns()
    same = all(now[name].tobytes() == again[name].tobytes() for name in now)
    return same and labels == session.labels


def one_step_further(session: Session, said: str) -> bool:
    """Whether the session is what was said and one step more: an edit, an undo or a redo."""
    then, entries, undone = said.split()
    history = session.history
    now = len(history), sum(entry.undone for entry in history)
    steps = [(history.next_undo, True, (1, 0)), (history.next_undo, True, (0, -1))]
    steps.append((history.next_redo, False, (0, 1)))
    for entry, back, (more, more_undone) in steps:
        if entry is None or now != (int(entries) + more, int(undone) + more_undone):
            continue
        table, change = session.tracks.snapshot(), entry.change
        labels = apply_change(table, session.labels, change.inverse if back else change)
        if digest(table, labels) == then:
            return True
    return False


if __name__ == "__main__":
    sys.exit(main())
