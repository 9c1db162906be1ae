"""Kill a batch and its workers at random moments: `python -m tests.sweeps.batches --runs 200`.

40 recordings are worked on by 4 workers: 5 are damaged, one kills its worker, one takes all memory,
one never ends. Each run kills the program or one of its workers, or interrupts the program; then
the batch is begun again where it ended. When all is done, it must be as one worker leaves it that
nobody kills: the same states, causes and tracks to the last bit; no recording was tracked twice,
nothing was ever called done that was not in place, and every failure has a reason.
"""

from __future__ import annotations

import contextlib
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from tests.batch.batches import ledger_of, leftovers
from tests.batch.walks import make_damaged, make_walk
from tests.sweeps.runner import Worker, slowdown, sweep
from tracking.batch import Ledger, read_rows
from tracking.batch.order import content_digest
from tracking.session import Session

RECORDINGS = 40
_WORKERS = 4
_LONGEST_LIFE_S = 8.0
_LONGEST_SLOWDOWN = 3.0
"""More patience than that would leave little to kill."""
_ROOT = Path(__file__).parents[2]
_OTHERS = ("killer", "bomb", "hang")


def make_recordings(top: Path) -> Path:
    """All recordings in a folder."""
    for number in range(5):
        make_damaged_in(top, number)
    for name in _OTHERS:
        make_walk(top / name, 1)
    for number in range(RECORDINGS - 5 - len(_OTHERS)):
        make_walk(top / f"walk{number:02}", number, truth=number % 4 == 0)
    return top


def make_damaged_in(top: Path, number: int) -> Path:
    """One of the damaged ones."""
    top.mkdir(parents=True, exist_ok=True)
    return make_damaged(top / f"bad{number}", number)


@dataclass(frozen=True, slots=True)
class Result:
    """What a finished batch says of a recording; tracks: a digest of their bytes."""

    state: str
    cause: str
    people: int
    score: str
    tracks: str


def attack(worker: Worker) -> Iterator[str]:
    """Kill one batch after the other until all kills are done."""
    top = make_recordings(worker.folder / "recordings")
    alone = worker.folder / "alone"
    ended(start(top, alone, 1))
    wanted = results(alone)
    batch = 0
    out = worker.folder / f"out{batch}"
    for _ in worker.numbers:
        chance = worker.chance()
        finished = kill_once(top, out, chance, worker)
        yield from wrong_now(out)
        if finished:
            yield from wrong_in_the_end(top, out, wanted, worker)
            batch += 1
            out = worker.folder / f"out{batch}"
    yield from wrong_in_the_end(top, out, wanted, worker)


def kill_once(top: Path, out: Path, chance: random.Random, worker: Worker) -> bool:
    """Have the batch go on, and kill somebody; whether the batch came to its end by then."""
    program = start(top, out, _WORKERS)
    time.sleep(chance.uniform(0.0, _LONGEST_LIFE_S) * min(slowdown(), _LONGEST_SLOWDOWN))
    if program.poll() is not None:
        worker.count("came too late")
        return True
    kind = chance.choice(("program", "program", "worker", "worker", "worker", "interrupt"))
    worker.count(f"kills of {kind}")
    if kind == "worker":
        with contextlib.suppress(IndexError, ProcessLookupError):
            os.kill(chance.choice(children_of(program.pid)), signal.SIGKILL)
        time.sleep(chance.uniform(0.0, 2.0) * min(slowdown(), _LONGEST_SLOWDOWN))
        program.kill()
    elif kind == "program":
        program.kill()
    else:
        program.send_signal(chance.choice((signal.SIGINT, signal.SIGTERM)))
    program.wait()
    return False


def start(top: Path, out: Path, workers: int) -> subprocess.Popen[bytes]:
    """The program at work."""
    command = [sys.executable, "-m", "tests.sweeps.batch_driver", top, out, str(workers)]
    return subprocess.Popen(command, cwd=_ROOT, stderr=subprocess.DEVNULL)


def ended(program: subprocess.Popen[bytes]) -> None:
    """Wait for a program that nobody kills."""
    if program.wait() != 0:
        raise RuntimeError(f"the batch ended with {program.returncode}")


def children_of(pid: int) -> list[int]:
    """The workers of a program."""
    tasks = Path(f"/proc/{pid}/task").glob("*/children")
    return [int(word) for task in tasks for word in task.read_text().split()]


def wrong_now(out: Path) -> Iterator[str]:
    """What must not be, however early the batch ended."""
    if not (out / "batch.sqlite").exists():
        return
    for row in read_rows(out / "batch.sqlite"):
        if not row.outcome.is_done:
            if not row.outcome.why:
                yield f"{row.name} failed without a reason"
            continue
        session = out / f"{row.name}.h5"
        if not session.exists() or content_digest([session]) != row.outcome.session:
            yield f"{row.name} is called done and is not"


def wrong_in_the_end(
    top: Path, out: Path, wanted: dict[str, Result], worker: Worker
) -> Iterator[str]:
    """What must not be once the batch came to its end."""
    ended(start(top, out, _WORKERS))
    worker.count("batches")
    yield from wrong_now(out)
    found = results(out)
    for name in sorted(wanted.keys() | found.keys()):
        if found.get(name) != wanted.get(name):
            yield f"{name} is {found.get(name)}, alone it was {wanted.get(name)}"
    tracked = Counter(each.name for each in ledger_of(out)[1] if each.tracked)
    for name, times in tracked.items():
        if times > 1:
            yield f"{name} was tracked {times} times"
    worker.count("attempts", len(ledger_of(out)[1]))
    if left := leftovers(out):
        yield f"left behind: {left}"


def results(out: Path) -> dict[str, Result]:
    """What a batch says of its recordings."""
    with Ledger(out / "batch.sqlite") as ledger:
        rows = list(ledger.rows())
    return {
        row.name: Result(
            str(row.outcome.state),
            str(row.outcome.cause),
            row.outcome.people,
            str(row.outcome.score),
            tracks_of(out / f"{row.name}.h5") if row.outcome.is_done else "",
        )
        for row in rows
    }


def tracks_of(path: Path) -> str:
    """All columns of a session's tracks, as a digest."""
    from tracking.batch.order import digest_of

    with closing(Session.look_into(path)) as session:
        columns = session.tracks.columns()
        return digest_of({name: column.tobytes().hex() for name, column in columns.items()})


if __name__ == "__main__":
    sys.exit(sweep(attack, 200, workers=1))
