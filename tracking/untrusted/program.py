"""Looking files over in a program of its own, since reading some of them can crash it.

Such a program takes file names and prints one line of JSON a file, as soon as it is found:
{"version": [major, minor]} (or what else such a program tells of a file that may be read), or
{"refused": why, "held": what}, a message that follows the file's name; "unreadable" where nothing
better is known than that the file is damaged.
"""

from __future__ import annotations

import contextlib
import json
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from tracking import child_program
from tracking.message_data import message_data, message_from
from tracking.translation import joined, msg
from tracking.untrusted.patience import begin, memory_for
from tracking.untrusted.walk import Refused

MEMORY_BYTES = 4 << 30
SECONDS = 10
"""Of processor time that a file may cost."""
PATIENCE_S = 120
"""By the clock: other programs may have the processor, and that says nothing of a file."""
_DAMAGED = joined(" ", ("", msg("is damaged or cut short")))
"""Why a file is refused of which nothing better is known."""


def bare_packages(*names: str) -> None:
    """Have packages of this library found without what they import: a program needs a few names.

    Such a program calls it before it imports its room; loading all of the rooms would take longer
    than all of its work.
    """
    root = Path(__file__).parents[1]
    for name in names:
        bare = ModuleType(f"{root.name}.{name}")
        bare.__path__ = [str(root / name)]
        sys.modules[bare.__name__] = bare


def say_verdicts(inspect: Callable[[Path], object], told: str = "version") -> None:
    """The program: print the verdict on each file named on the command line, within limits.

    told: what `inspect` tells of a file that may be read.
    """
    for name in sys.argv[1:]:
        limit(memory_for(Path(name), MEMORY_BYTES))
        begin()
        verdict = verdict_by(inspect, Path(name), told)
        if "refused" in verdict:
            verdict["refused"] = message_data(verdict["refused"])
        print(json.dumps(verdict), flush=True)


def verdict_by(
    inspect: Callable[[Path], object], path: Path, told: str = "version"
) -> dict[str, Any]:
    """The verdict of one file."""
    try:
        return {told: inspect(path)}
    except Refused as why:
        return {"refused": joined(" ", ("", why)), "held": why.held}
    except Exception:  # what the library says of a damaged file tells its users nothing
        return {"refused": _DAMAGED, "unreadable": True}


def limit(memory_bytes: int = MEMORY_BYTES) -> None:
    """Where the system knows limits: a file that makes reading run away ends this program only.

    Limits can be moved as long as the hard ones stay.
    """
    try:
        import resource
    except ImportError:  # Windows
        return
    for kind, most in ((resource.RLIMIT_AS, memory_bytes), (resource.RLIMIT_CPU, SECONDS)):
        _, hard = resource.getrlimit(kind)
        most = most if hard == resource.RLIM_INFINITY else min(most, hard)
        with contextlib.suppress(OSError, ValueError):  # macOS knows RLIMIT_AS but may refuse it
            resource.setrlimit(kind, (most, hard))


def verdicts_of(program: str, name: str, paths: Sequence[Path]) -> list[dict[str, Any]]:
    """What a program, a file of Python, says of each file; one it does not survive is damaged.

    Args:
        name: what people call such a file.
    """
    verdicts: list[dict[str, Any]] = []
    while len(verdicts) < len(paths):
        found, in_time = _looked_over(program, paths[len(verdicts) :])
        verdicts += found
        if len(verdicts) < len(paths):
            why = msg("the {name} file is damaged: it cannot be read safely", name=name)
            if not in_time:
                why = msg(
                    "the {name} file was not checked within {seconds} s; nothing is wrong with it "
                    "if the machine is busy: try again",
                    name=name,
                    seconds=PATIENCE_S,
                )
            verdicts.append({"refused": joined(": ", ("", why))})
    return verdicts


def _looked_over(program: str, paths: Sequence[Path]) -> tuple[list[dict[str, Any]], bool]:
    """The verdicts on the first files, until the other program ended; whether it did by itself."""
    try:
        done = subprocess.run(
            child_program.command(program, *(path.resolve() for path in paths)),
            env=child_program.environment({"OPENBLAS_NUM_THREADS": "1"}),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=PATIENCE_S,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            check=False,
        )
        said, in_time = done.stdout, True
    except subprocess.TimeoutExpired as why:
        said, in_time = why.stdout or b"", False
    verdicts = []
    for line in said.splitlines():
        try:
            verdict = json.loads(line)
            if "refused" in verdict:
                verdict["refused"] = message_from(verdict["refused"])
            verdicts.append(verdict)
        except ValueError:  # it ended within the line
            break
    return verdicts, in_time
