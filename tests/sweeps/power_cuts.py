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
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from tests.sweeps.corrector import Corrector, made_session
from tests.sweeps.disk_model import Disk, File, Folder
from tests.sweeps.runner import Findings, Plan, asked_plan, emptied, sweep
from tests.sweeps.session_state import Said, look, state
from tests.sweeps.system_calls import Call, calls, check, text_of, traced
from tracking.session import Session

_STEPS = 40
_CUTS_A_RECORDING = 25
_LONGEST_S = 120.0
_BLOCKS = (512, 4096)
_IN_ORDER = 0.5
"""Share of the recordings whose names reach the disk in order."""
_TEXT = re.compile(r'"((?:\\x..)*)"')
_HANDLE = re.compile(r"(\d+)<((?:\\x..)*)>")
_NAME = re.compile(r'(?:(?:AT_FDCWD|\d+)<((?:\\x..)*)>, )?"((?:\\x..)*)"')


def main() -> int:
    """Record and cut; the exit status."""
    check()
    plan, _ = asked_plan(__doc__, 500)

    def work(folder: Path, numbers: Sequence[int], findings: Findings) -> None:
        for start in range(0, len(numbers), _CUTS_A_RECORDING):
            if findings.is_over:
                return
            some = numbers[start : start + _CUTS_A_RECORDING]
            record_and_cut(emptied(folder / "run"), some, findings, plan)

    return sweep("power_cuts", plan, work)


def record_and_cut(folder: Path, numbers: Sequence[int], findings: Findings, plan: Plan) -> None:
    """Record a program once, and cut the power of it so many times."""
    chance = random.Random(f"{plan.seed}/{numbers[0]}")
    path, said, seed = made_session(emptied(folder / "tree")), folder / "said.txt", chance.random()
    session = Session.open(path)
    lines = [f"= {state(session)}"]
    session.close()
    replay = Replay(Disk(path.parent), said, lines, in_order=chance.random() < _IN_ORDER)
    work = partial(corrected, path, seed, said)
    outcome, report = traced(work, folder, ("-e", f"trace={_CALLS}"), _LONGEST_S)
    if outcome.status or outcome.hung:
        findings.violation(f"run {numbers[0]}: the program ended with {outcome}")
        return
    record = [call for call in calls(report) if call.result >= 0]
    findings.count("recordings")
    findings.count("calls recorded", len(record))
    done = 0
    for moment, number in sorted((chance.randint(0, len(record)), n) for n in numbers):
        for call in record[done:moment]:
            replay.do(call)
        done = moment
        wrong = replay.cut(folder / "cut", random.Random(f"{plan.seed}/{number}"))
        findings.count("power cuts")
        if wrong:
            findings.violation(f"run {number}, after call {moment} of {len(record)}: {wrong}")
    findings.count("acknowledged steps", sum(line.startswith("= ") for line in replay.lines))


def corrected(path: Path, seed: float, said: Path) -> int:
    """The program that is recorded; what it says goes to a file."""
    handle = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_APPEND, 0o600)

    def tell(line: str) -> None:
        os.write(handle, f"{line}\n".encode())

    corrector = Corrector(path, int(seed * (1 << 30)), tell)
    corrector.work(_STEPS)
    corrector.end()
    return 0


class Replay:
    """Recorded calls done again on a model of the disk, with what the program said meanwhile."""

    def __init__(self, disk: Disk, said: Path, lines: list[str], *, in_order: bool) -> None:
        """The disk as it was before the first call, and the file the program writes lines to."""
        self._disk, self._said, self._in_order = disk, str(said), in_order
        self.lines = lines
        self._at: dict[int, int] = {}
        self._appends: set[int] = set()

    def cut(self, place: Path, chance: random.Random) -> str:
        """What is wrong with what a power cut at this moment leaves; "" where nothing is."""
        shutil.rmtree(place, ignore_errors=True)
        self._disk.cut(place, chance, chance.choice(_BLOCKS), in_order=self._in_order)
        for shared in place.rglob("*-shm"):
            shared.unlink()
        return look(place / "s.h5", Said.of_lines(self.lines))[0]

    def do(self, call: Call) -> None:
        """One more call."""
        kind = _KINDS.get(call.name)
        if kind is not None:
            kind(self, call)

    def _open(self, call: Call) -> None:
        (path,), handle = named(call), call.result
        self._at[handle] = 0
        self._appends.discard(handle)
        if "O_APPEND" in call.arguments:
            self._appends.add(handle)
        node = self._disk.find(path)
        if node is None and "O_CREAT" in call.arguments:
            self._disk.name((path, File()))
        if isinstance(node, File) and "O_TRUNC" in call.arguments and node.now:
            node.resize(0)

    def _write(self, call: Call) -> None:
        handle, path = handle_of(call)
        data = b"".join(map(text_of, _TEXT.findall(call.arguments)))[: call.result]
        if path == self._said:
            self.lines += data.decode().splitlines()
        self._put(handle, path, data)

    def _put(self, handle: int, path: str, data: bytes) -> None:
        node = self._disk.find(path)
        if isinstance(node, File):
            if handle in self._appends:
                self._at[handle] = len(node.now)
            node.write(self._at.get(handle, 0), data)
        self._at[handle] = self._at.get(handle, 0) + len(data)

    def _write_at(self, call: Call) -> None:
        node = self._disk.find(handle_of(call)[1])
        if isinstance(node, File):
            data = b"".join(map(text_of, _TEXT.findall(call.arguments)))[: call.result]
            node.write(int(call.arguments.rsplit(",", 1)[1]), data)

    def _read(self, call: Call) -> None:
        handle, _ = handle_of(call)
        self._at[handle] = self._at.get(handle, 0) + call.result

    def _seek(self, call: Call) -> None:
        self._at[handle_of(call)[0]] = call.result

    def _resize(self, call: Call) -> None:
        node = self._disk.find(handle_of(call)[1])
        if isinstance(node, File):
            node.resize(int(call.arguments.rsplit(",", 1)[1]))

    def _allocate(self, call: Call) -> None:
        node = self._disk.find(handle_of(call)[1])
        _, start, length = call.arguments.rsplit(",", 2)
        if isinstance(node, File) and len(node.now) < int(start) + int(length):
            node.resize(int(start) + int(length))

    def _send(self, call: Call) -> None:
        """`sendfile` and `copy_file_range`, from where the handle that is read stands."""
        handles = [(int(number), decoded(path)) for number, path in _HANDLE.findall(call.arguments)]
        if call.name == "copy_file_range":
            handles.reverse()
        (target, path), (source, read) = handles
        told = re.search(r"\[(\d+)\]", call.arguments)
        start = int(told[1]) if told else self._at.get(source, 0)
        node = self._disk.find(read)
        if isinstance(node, File):
            self._put(target, path, bytes(node.now[start : start + call.result]))
        if told is None:
            self._at[source] = start + call.result

    def _rename(self, call: Call) -> None:
        old, new = named(call)
        self._disk.name((old, None), (new, self._disk.find(old)))

    def _link(self, call: Call) -> None:
        old, new = named(call)
        self._disk.name((new, self._disk.find(old)))

    def _remove(self, call: Call) -> None:
        self._disk.name((named(call)[0], None))

    def _make_folder(self, call: Call) -> None:
        self._disk.name((named(call)[0], Folder()))

    def _sync(self, call: Call) -> None:
        node = self._disk.find(handle_of(call)[1])
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


def handle_of(call: Call) -> tuple[int, str]:
    """The first handle among the arguments, and the path it stands for."""
    number, path = _HANDLE.findall(call.arguments)[0]
    return int(number), decoded(path)


def named(call: Call) -> list[str]:
    """The names among the arguments, each in the folder whose handle stands before it."""
    return [
        str(Path(decoded(folder) or "/", decoded(name)))
        for folder, name in _NAME.findall(call.arguments)
    ]


def decoded(escaped: str) -> str:
    return text_of(escaped).decode(errors="surrogateescape")


if __name__ == "__main__":
    sys.exit(main())
