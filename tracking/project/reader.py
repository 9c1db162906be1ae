"""Reads facts in a process of its own: `python -m tracking.project.reader`.

It gets one file after the other on standard input and answers on standard output; see
`untrusted.pipe`. The end of input ends it.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from pathlib import Path
from typing import Any

import cv2

from tracking.batch.worker import own_output
from tracking.project.fact_reader import read_facts
from tracking.project.readings import Reading
from tracking.untrusted.pipe import receive_head, send

_NICENESS = 5


def main() -> None:
    """Read until there is nothing more to be read."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # typed at whoever waits for this
    cv2.setNumThreads(1)
    with contextlib.suppress(OSError, AttributeError):
        os.nice(_NICENESS)
    answers = own_output()
    with contextlib.suppress(BrokenPipeError):
        while (said := receive_head(sys.stdin.buffer)) is not None:
            read = read_facts(_reading(said))
            send(answers, {"facts": read.facts.as_text(), "bytes": len(read.image)}, read.image)


def _reading(said: dict[str, Any]) -> Reading:
    recording = said["recording"]
    return Reading(
        Path(said["path"]), bool(said["of_session"]), Path(recording) if recording else None
    )


if __name__ == "__main__":
    main()
