"""Cut the power, again and again: `power_cuts.py --runs 500`.

A program corrects a session while strace records all it writes, names, removes and syncs. What
a power cut would have left at any moment is then made from that (see `disk_model`) and opened. All
that was acknowledged before that moment must be there.

Shared memory of SQLite's (`-shm`) is left out: whoever opens a journal first makes it anew.
"""

from __future__ import annotations

import os
import random
import re
import shutil
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

from tests.sweeps.corrector import Corrector
from tests.sweeps.disk_model import Disk, File, Folder
from tests.sweeps.runner import Worker, emptied, sweep
from tests.sweeps.session_state import Said, look
from tests.sweeps.sessions import made_session
from tests.sweeps.system_calls import Call, calls, check, traced

_STEPS = 40
_CUTS_A_RECORDING = 25
_LONGEST_S = 120.0
_BLOCKS = (512, 4096)
_IN_ORDER = 0.5
"""Share of the recordings whose names reach the disk in order."""


def attack(worker: Worker) -> Iterator[str]:
    """Cut the power of recorded programs, later and later; now and then record another one."""
    begun = None
    for number in worker.numbers:
        turn, place = divmod(number, worker.asked.workers)
        one, cut = divmod(turn, _CUTS_A_RECORDING)
        if one != begun:
            begun, chance = one, worker.chance("recording", place, one)
            record, replay = recorded(emptied(worker.folder / "run"), chance)
            moments = sorted(chance.randint(0, len(record)) for _ in range(_CUTS_A_RECORDING))
            worker.count("recordings")
            worker.count("calls recorded", len(record))
        worker.count("acknowledged steps", replay.go_on(record[: moments[cut]]))
        worker.count("power cuts")
        if wrong := replay.cut(worker.folder / "cut", worker.chance()):
            yield f"after call {moments[cut]} of {len(record)}: {wrong}"


def recorded(folder: Path, chance: random.Random) -> tuple[list[Call], Replay]:
    """Record the calls of a program; the replay stands before the first of them."""
    path, said, seed = made_session(folder / "tree"), folder / "said.txt", chance.randrange(1 << 30)
    lines = [f"= {look(path, None)[1]}"]
    replay = Replay(Disk(path.parent), said, lines, in_order=chance.random() < _IN_ORDER)
    asked = "-e", f"trace={_CALLS}"
    outcome, report = traced(lambda: corrected(path, seed, said), folder, asked, _LONGEST_S)
    if outcome.status or outcome.hung:
        raise RuntimeError(f"the program ended with {outcome}")
    return [call for call in calls(report) if call.result >= 0], replay


def corrected(path: Path, seed: int, said: Path) -> int:
    """The program that is recorded; what it says goes to a file."""
    handle = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600)
    corrector = Corrector(path, seed, lambda line: os.write(handle, f"{line}\n".encode()))
    corrector.work(_STEPS)
    corrector.end()
    return 0


class Replay:
    """Recorded calls done again on a model of the disk, with what the program said meanwhile."""

    def __init__(self, disk: Disk, said: Path, lines: list[str], *, in_order: bool) -> None:
        """The disk as it was before the first call, and the file the program writes lines to."""
        self._disk, self._said, self._in_order = disk, str(said), in_order
        self._lines, self._done = lines, 0
        self._at: dict[int, int] = {}
        self._appends: set[int] = set()

    def go_on(self, record: Sequence[Call]) -> int:
        """Do those of the calls that are not yet done; how many steps were said meanwhile."""
        before = len(self._lines)
        for call in record[self._done :]:
            _KINDS[call.name](self, call)
        self._done = len(record)
        return sum(line.startswith("= ") for line in self._lines[before:])

    def cut(self, place: Path, chance: random.Random) -> str:
        """What is wrong with what a power cut at this moment leaves; "" where nothing is."""
        shutil.rmtree(place, ignore_errors=True)
        self._disk.cut(place, chance, chance.choice(_BLOCKS), in_order=self._in_order)
        for shared in place.rglob("*-shm"):
            shared.unlink()
        return look(place / "s.h5", Said.of_lines(self._lines))[0]

    def _open(self, call: Call) -> None:
        (path,), handle = call.names, call.result
        self._at[handle] = 0
        self._appends.discard(handle)
        if "O_APPEND" in call.arguments:
            self._appends.add(handle)
        node = self._disk.find(path)
        if node is None and "O_CREAT" in call.arguments:
            self._disk.name((path, File()))
        if isinstance(node, File) and "O_TRUNC" in call.arguments and node.now:
            node.resize(0)

    def _file(self, call: Call) -> File:
        """The file that a call is about; one of no name where it is none of the tree's."""
        node = self._disk.find(call.handles[0][1])
        return node if isinstance(node, File) else File()

    def _write(self, call: Call) -> None:
        handle, path = call.handles[0]
        if path == self._said:
            self._lines += call.data.decode().splitlines()
        self._put(handle, self._file(call), call.data)

    def _put(self, handle: int, file: File, data: bytes) -> None:
        at = len(file.now) if handle in self._appends else self._at.get(handle, 0)
        file.write(at, data)
        self._at[handle] = at + len(data)

    def _write_at(self, call: Call) -> None:
        self._file(call).write(*call.numbers(1), call.data)

    def _read(self, call: Call) -> None:
        handle, _ = call.handles[0]
        self._at[handle] = self._at.get(handle, 0) + call.result

    def _seek(self, call: Call) -> None:
        self._at[call.handles[0][0]] = call.result

    def _resize(self, call: Call) -> None:
        self._file(call).resize(*call.numbers(1))

    def _allocate(self, call: Call) -> None:
        file, end = self._file(call), sum(call.numbers(2))
        if len(file.now) < end:
            file.resize(end)

    def _send(self, call: Call) -> None:
        """`sendfile` and `copy_file_range`, from where the handle that is read stands."""
        (target, path), (source, read) = call.handles[:: -1 if "copy" in call.name else 1]
        told = re.search(r"\[(\d+)\]", call.arguments)
        start = int(told[1]) if told else self._at.get(source, 0)
        node, other = self._disk.find(read), self._disk.find(path)
        if isinstance(node, File) and isinstance(other, File):
            self._put(target, other, bytes(node.now[start : start + call.result]))
        if told is None:
            self._at[source] = start + call.result

    def _rename(self, call: Call) -> None:
        old, new = call.names
        self._disk.name((old, None), (new, self._disk.find(old)))

    def _link(self, call: Call) -> None:
        old, new = call.names
        self._disk.name((new, self._disk.find(old)))

    def _remove(self, call: Call) -> None:
        self._disk.name((call.names[0], None))

    def _make_folder(self, call: Call) -> None:
        self._disk.name((call.names[0], Folder()))

    def _sync(self, call: Call) -> None:
        node = self._disk.find(call.handles[0][1])
        if isinstance(node, File):
            node.sync()
        elif node is not None:
            self._disk.sync_folder(node, in_order=self._in_order)


_KINDS: Mapping[str, Callable[[Replay, Call], None]] = {
    **dict.fromkeys(("open", "openat", "creat"), Replay._open),
    **dict.fromkeys(("write", "writev"), Replay._write),
    **dict.fromkeys(("pwrite64", "pwritev"), Replay._write_at),
    "read": Replay._read,
    "lseek": Replay._seek,
    "ftruncate": Replay._resize,
    "fallocate": Replay._allocate,
    **dict.fromkeys(("sendfile", "copy_file_range"), Replay._send),
    **dict.fromkeys(("rename", "renameat", "renameat2"), Replay._rename),
    **dict.fromkeys(("link", "linkat"), Replay._link),
    **dict.fromkeys(("unlink", "unlinkat", "rmdir"), Replay._remove),
    **dict.fromkeys(("mkdir", "mkdirat"), Replay._make_folder),
    **dict.fromkeys(("fsync", "fdatasync"), Replay._sync),
}
_CALLS = ",".join(_KINDS)


if __name__ == "__main__":
    check()
    sys.exit(sweep(attack, 500))
