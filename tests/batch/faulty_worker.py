"""A worker that some recordings are bad for, by their names: `python -m tests.batch.faulty_worker`.

"killer..." kills it, "bomb..." takes all memory there is, "hang..." never ends, "flaky..." meets a
disk that fails twice.
"""

from __future__ import annotations

import errno
import os
import signal
import time
from pathlib import Path
from typing import Any

import tracking.batch.job as job
from tracking.batch.worker import main

_really_open = job.open_recording
_CHUNK_BYTES = 32 << 20


def open_badly(path: Path, options: Any) -> Any:
    """Open a recording, unless its name says what happens instead."""
    if path.name.startswith("killer"):
        os.kill(os.getpid(), signal.SIGKILL)
    if path.name.startswith("bomb"):
        held = []
        while True:
            held.append(bytearray(_CHUNK_BYTES))
    while path.name.startswith("hang"):
        time.sleep(1)
    if path.name.startswith("flaky"):
        fail_twice(path)
    return _really_open(path, options)


def fail_twice(path: Path) -> None:
    """Raise OSError the first two times."""
    count = path.parent / f".{path.name}.count"
    tries = len(count.read_text()) if count.exists() else 0
    count.write_text("x" * (tries + 1))
    if tries < 2:
        raise OSError(errno.EIO, os.strerror(errno.EIO), str(path))


if __name__ == "__main__":
    job.open_recording = open_badly
    main()
