"""The system calls of a fork, as strace tells them or makes them fail.

strace is attached to a fork that waits, so that nothing is imported or counted twice. Without
strace there is no sweep: `check` says how to install it.
"""

from __future__ import annotations

import ctypes
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from tests.sweeps.command import LONGEST_S, Outcome, begin, outcome_of

_PR_SET_PTRACER, _ANY = 0x59616D61, -1
_MOST_LETTERS = 1 << 26
_LINE = re.compile(r"(\d+) +(.*)")
_CALL = re.compile(r"(\w+)\((.*)\) += (-?\d+|\?)(.*)")
_RESUMED = re.compile(r"<\.\.\. \w+ resumed>(.*)")
_TEXT = re.compile(r'"((?:\\x..)*)"')
_HANDLE = re.compile(r"(\d+)<((?:\\x..)*)>")
_NAME = re.compile(r'(?:(?:AT_FDCWD|\d+)<((?:\\x..)*)>, )?"((?:\\x..)*)"')
_WITH_DATA = ("read", "pread64", "write", "writev", "pwrite64", "pwritev")
"""Calls whose texts are no names."""
_ATTACHED = "attached"


@dataclass(frozen=True, slots=True)
class Call:
    """One system call: the thread, its name, its arguments as strace prints them, and the result.

    Texts are in hexadecimal escapes (`strace -xx`), and handles bear the paths they stand for.
    """

    thread: int
    name: str
    arguments: str
    result: int
    error: str

    @property
    def handles(self) -> list[tuple[int, str]]:
        """The handles among the arguments, and the paths they stand for."""
        found = _HANDLE.findall(self.arguments)
        return [(int(number), _decoded(path)) for number, path in found]

    @property
    def names(self) -> list[str]:
        """The names among the arguments, each in the folder whose handle stands before it."""
        found = _NAME.findall(self.arguments)
        return [str(Path(_decoded(folder) or "/", _decoded(name))) for folder, name in found]

    @property
    def data(self) -> bytes:
        """What a call that writes has written."""
        return b"".join(map(_bytes, _TEXT.findall(self.arguments)))[: self.result]

    def is_in(self, folder: Path) -> bool:
        """Whether it is of a file in a folder, and not only reads or writes the folder's name."""
        places = [path for _, path in self.handles]
        if self.name not in _WITH_DATA:
            places += self.names
        return any(Path(place).is_relative_to(folder) for place in places)

    def numbers(self, count: int) -> tuple[int, ...]:
        """The last arguments."""
        return tuple(int(word) for word in self.arguments.rsplit(",", count)[1:])


def check() -> None:
    """End the program with a line where there is no strace."""
    if shutil.which("strace") is None:
        sys.exit("this sweep needs strace (Linux): apt-get install strace")


def traced(
    work: Callable[[], int],
    folder: Path,
    asked: Sequence[str],
    longest_s: float = LONGEST_S,
) -> tuple[Outcome, Path]:
    """Do work in a fork under strace with these options; how it ended, and what strace wrote."""
    report, said = folder / "strace.txt", (folder / "stdout.txt", folder / "stderr.txt")
    hear, say = os.pipe()

    def waiting() -> int:
        libc = ctypes.CDLL(None, use_errno=True)
        libc.prctl(_PR_SET_PTRACER, ctypes.c_ulong(_ANY), 0, 0, 0)
        os.read(hear, 1)
        return work()

    pid = begin(waiting, said)
    words = ["strace", "-f", "-y", "-xx", "-s", str(_MOST_LETTERS), "-o", str(report)]
    tracer = subprocess.Popen([*words, *asked, "-p", str(pid)], stderr=subprocess.PIPE, text=True)
    assert tracer.stderr is not None
    attached = tracer.stderr.readline()
    os.write(say, b"!")
    outcome = outcome_of(pid, said, 0, longest_s)
    _, rest = tracer.communicate()
    os.close(hear)
    os.close(say)
    if _ATTACHED not in attached:
        raise OSError(f"strace does not attach: {attached}{rest}")
    return outcome, report


def calls(report: Path) -> Iterator[Call]:
    """The calls strace wrote, in the order in which they ended."""
    begun: dict[int, str] = {}
    with report.open(encoding="ascii") as lines:
        for line in lines:
            match = _LINE.match(line)
            if match is None:
                continue
            thread, text = int(match[1]), match[2]
            if text.endswith("<unfinished ...>"):
                begun[thread] = text.removesuffix("<unfinished ...>")
                continue
            if (rest := _RESUMED.match(text)) is not None:
                text = begun.pop(thread, "") + rest[1]
            call = _CALL.fullmatch(text)
            if call is not None:
                result = -1 if call[3] == "?" else int(call[3])
                yield Call(thread, call[1], call[2], result, call[4].strip())


def _bytes(escaped: str) -> bytes:
    return bytes.fromhex(escaped.replace("\\x", ""))


def _decoded(escaped: str) -> str:
    return _bytes(escaped).decode(errors="surrogateescape")
