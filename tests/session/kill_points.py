"""Kill a program that edits and saves a session, again and again: `killing.py FOLDER KILLS SEED`.

The editing program is a fork that says on a pipe after each step that it is done. It is killed at
a random moment; what is on the disk then must be the state after the last step it said, or after
the one it was about to say. Prints how many steps and kills there were; fails with a traceback.
"""

from __future__ import annotations

import os
import random
import signal
import sys
import time
import traceback
from pathlib import Path

from made_up_sessions import make_recording, make_run, state_of

from tracking.editing import plan_delete, plan_draw_box, plan_rename, plan_split, plan_swap
from tracking.errors import EditError
from tracking.session import Session, session_reader
from tracking.session.inspection import inspect

STEPS_A_LIFE = 400


def take_step(session: Session, chance: random.Random) -> None:
    """One step of an editor's day, the same for the same state and chance."""
    a, b = chance.randint(1, 6), chance.randint(1, 6)
    frame, end = chance.randint(0, 40), chance.choice((None, 41))
    table = session.tracks
    steps = (
        lambda: session.apply(plan_swap(table, a, b, frame, end)),
        lambda: session.apply(plan_swap(table, a, b, frame, end)),
        lambda: session.apply(plan_split(table, a, frame)),
        lambda: session.apply(plan_delete(table, a, frame, frame + 1)),
        lambda: session.apply(plan_draw_box(table, a, frame, (1.0, 2.0, 3.0, 4.0))),
        lambda: session.apply(plan_rename(table, session.labels, a, f"person {frame}")),
        session.undo,
        session.redo,
    )
    try:
        chance.choice(steps)()
    except EditError:
        return


def edit_until_killed(path: Path, seed: int, said: int) -> None:
    session = Session.open(path)
    chance, saving = random.Random(seed), random.Random(seed + 1)
    for _ in range(STEPS_A_LIFE):
        take_step(session, chance)
        os.write(said, b".")
        if saving.random() < 0.1:
            session.save()
        elif saving.random() < 0.05:
            session.close()
            session = Session.open(path)


def life(path: Path, seed: int, seconds: float, from_first_step: bool) -> int:
    """Let the editor live for so long; gives how many steps it said it had done.

    Counted from its first step on, or from its birth, so that it dies opening the session too.
    """
    hear, say = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(hear)
        try:
            edit_until_killed(path, seed, say)
        except BaseException:
            traceback.print_exc()
            os._exit(1)  # never into what the parent does next
        os._exit(0)
    os.close(say)
    first = os.read(hear, 1) if from_first_step else b""
    time.sleep(seconds)
    os.kill(child, signal.SIGKILL)
    _, ending = os.waitpid(child, 0)
    code = os.waitstatus_to_exitcode(ending)
    assert code in (0, -signal.SIGKILL), f"life {seed}: the editor ended by itself with {code}"
    with os.fdopen(hear, "rb") as heard:
        return len(first) + len(heard.read())


def main(folder: Path, kills: int, seed: int) -> None:
    session_reader.check_file = inspect
    chance = random.Random(seed)
    recording = make_recording(folder / "recording")
    path = folder / "s.h5"
    Session.create(recording, [make_run()], path).close()
    model = Session.create(recording, [make_run()])
    steps = 0
    for number in range(kills):
        said = life(path, number, chance.uniform(0.0, 0.2), chance.random() < 0.75)
        again = Session.open(path)
        assert not again.read_only, again.notes
        step = random.Random(number)
        for _ in range(said):
            take_step(model, step)
        if state_of(again) != state_of(model):
            take_step(model, step)  # done and kept, but no time to say so
        assert state_of(again) == state_of(model), f"life {number}: lost after {said} steps"
        again.close()
        steps += said
    print(f"{steps} steps, {kills} kills, nothing lost")


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
