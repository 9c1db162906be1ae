"""The child: `python -m app.core.tracking_process.child`, driven through its pipes.

The first line on standard input is the request. A further line asks for the end after the frame in
work; the end of input says that the parent is gone, however it went, and ends this process at once.
Standard output carries the messages; what libraries print goes to standard error.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
import time
import traceback
from typing import IO

from app.core.tracking_process.memory_limit import give_way
from app.core.tracking_process.messages import (
    Kind,
    packed_error,
    packed_input,
    packed_learning,
    packed_notes,
    packed_steps,
    send,
)
from app.core.tracking_process.request import TrackingRequest
from tracking.trackers import StepResult
from tracking.trackers.catalogue import BUILT_IN

_BATCH_EVERY_S = 0.04
_NICER = 5
"""The window goes first where there are fewer cores than work."""


def main() -> None:
    """Track what is asked for."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # typed at the parent, which ends us
    if hasattr(os, "nice"):
        os.nice(_NICER)
    answers = _own_output()
    request = TrackingRequest.from_line(sys.stdin.buffer.readline())
    give_way(foreign=request.tracker not in BUILT_IN)
    stop = threading.Event()
    threading.Thread(target=_listen, args=(stop,), daemon=True).start()
    with contextlib.suppress(BrokenPipeError):
        try:
            _track(request, answers, stop)
            send(answers, Kind.DONE)
        except BrokenPipeError:
            raise
        except Exception as error:
            send(answers, Kind.ERROR, packed_error(error, traceback.format_exc()))
    os._exit(0)  # not through the interpreter's end: the listener still reads


def _own_output() -> IO[bytes]:
    """The pipe to the parent, kept from whoever prints."""
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    elsewhere = sys.stderr.fileno() if sys.stderr else os.open(os.devnull, os.O_WRONLY)
    os.dup2(elsewhere, sys.stdout.fileno())
    return answers


def _listen(stop: threading.Event) -> None:
    while sys.stdin.buffer.readline():
        stop.set()
    os._exit(0)


def _track(request: TrackingRequest, answers: IO[bytes], stop: threading.Event) -> None:
    with request.open() as recording, request.begin(recording) as tracking:
        tracking.learning = lambda done, total: send(
            answers, Kind.LEARNING, packed_learning(done, total)
        )
        batch: list[StepResult] = []
        sent_s = time.monotonic()
        try:
            for result in tracking:
                batch.append(result)
                if stop.is_set():
                    break
                if time.monotonic() - sent_s >= _BATCH_EVERY_S:
                    send(answers, Kind.STEPS, packed_steps(batch))
                    batch, sent_s = [], time.monotonic()
        finally:  # what was tracked is kept, also where the tracker cannot go on
            send(answers, Kind.STEPS, packed_steps(batch))
            if tracking.notes:
                send(answers, Kind.NOTES, packed_notes(tracking.notes))
            if tracking.detections_input:
                send(answers, Kind.DETECTIONS_INPUT, packed_input(tracking.detections_input))


if __name__ == "__main__":
    main()
