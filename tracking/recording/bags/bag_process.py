"""The program that reads a bag, as this one sees it: started, asked, and ended in time."""

from __future__ import annotations

import contextlib
import subprocess
import threading
import weakref
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking import child_program
from tracking.errors import RecordingError
from tracking.message_data import message_from
from tracking.recording.bags.bag_contents import (
    BagContents,
    contents_of,
    keep_contents,
    known_contents,
)
from tracking.translation import msg
from tracking.untrusted.pipe import receive_bytes, receive_head, send

_WORKER = Path(__file__).with_name("bag_worker.py")
_PATIENCE_S = 300.0
"""By the clock; processor time is limited by the program itself."""
_MOST_RESTARTS = 5
"""On end, without a picture between them."""
_MOST_MESSAGES = 20_000_000
_MOST_BYTES = 40_000_000 * 4
_KINDS = {"uint8": np.uint8, "uint16": np.uint16, "float32": np.float32}
_DAMAGED = msg("is damaged: it cannot be read safely")


class BrokenMessageError(Exception):
    """One picture of a bag cannot be read."""


class BagProcess:
    """A bag opened in a program of its own. Reads may come from several threads.

    Args:
        path: the bag. topics: of left, right and depth as a manifest names them; "": not told.

    Attributes:
        contents: what it holds.

    Raises RecordingError, in one line, where it cannot be opened.
    """

    def __init__(self, path: Path, topics: Sequence[str]) -> None:
        self.path = path
        self._topics = list(topics)
        self._lock = threading.Lock()
        self._restarts = 0
        known = known_contents(path, topics)
        if known is not None:
            self.contents = known
        self._start(known)
        if known is None:
            keep_contents(path, topics, self.contents)

    def read(self, side: int, number: int) -> NDArray[Any]:
        """One picture: (height, width, 3) uint8 BGR, or depth (height, width) uint16 or float32.

        Raises BrokenMessageError where it cannot be read.
        """
        with self._lock:
            if self._child.poll() is not None:
                self._restart()
            try:
                with self._in_time():
                    picture = self._picture(self._ask({"side": side, "number": number}))
            except (OSError, EOFError, ValueError, KeyError, TypeError) as error:
                self._end()
                raise BrokenMessageError from error
            self._restarts = 0
            return picture

    def close(self) -> None:
        """End the program."""
        self._end()

    def _start(self, known: BagContents | None) -> None:
        """Start the program; of a bag that was opened before it is told what is known."""
        environment = {"OPENBLAS_NUM_THREADS": "1", "MALLOC_ARENA_MAX": "4"}
        self._child = child_program.begin(_WORKER, more=environment, stderr=subprocess.DEVNULL)
        self._end = weakref.finalize(self, child_program.end, self._child)
        try:
            with self._in_time():
                self._open(known)
        except BrokenMessageError as error:
            self._end()
            raise RecordingError("{path}: {why}", path=self.path, why=error.args[0]) from error
        except (OSError, EOFError, ValueError, KeyError, TypeError) as error:
            self._end()
            raise RecordingError("{path}: {why}", path=self.path, why=_DAMAGED) from error

    def _open(self, known: BagContents | None) -> None:
        """Ask for the bag to be opened."""
        where = str(self.path.resolve())
        if known is None:
            head = self._ask({"path": where, "topics": self._topics})
            self.contents = self._contents(head)
            return
        counts = [table.shape[1] for table in known.tables]
        told = {"path": where, "topics": list(known.topics), "counts": counts}
        self._ask(told, *(table.tobytes() for table in known.tables))

    @contextlib.contextmanager
    def _in_time(self) -> Iterator[None]:
        """End the program where what is asked of it has not all come in time."""
        timer = threading.Timer(_PATIENCE_S, self._child.kill)
        timer.daemon = True
        timer.start()
        try:
            yield
        finally:
            timer.cancel()

    def _restart(self) -> None:
        """A damaged message may have ended the program; others can still be read."""
        self._restarts += 1
        if self._restarts > _MOST_RESTARTS:
            raise RecordingError("{path}: {why}", path=self.path, why=_DAMAGED)
        self._start(self.contents)

    def _ask(self, head: dict[str, Any], *parts: bytes) -> dict[str, Any]:
        """The head of the answer. Raises BrokenMessageError where it is a refusal."""
        assert self._child.stdin is not None
        assert self._child.stdout is not None
        with contextlib.suppress(BrokenPipeError):  # it may have said why it ended
            send(self._child.stdin, head, *parts)
        answer = receive_head(self._child.stdout)
        if answer is None:
            raise EOFError
        if "refused" in answer:
            raise BrokenMessageError(message_from(answer["refused"]))
        return answer

    def _contents(self, head: dict[str, Any]) -> BagContents:
        """What is told of the bag; whatever happened to that program, it is sound."""
        counts = [int(count) for count in head["counts"]]
        if len(counts) != 3 or not all(0 <= count <= _MOST_MESSAGES for count in counts):
            raise ValueError("no counts of messages")
        assert self._child.stdout is not None
        tables = [
            np.frombuffer(receive_bytes(self._child.stdout, 24 * count), np.int64).reshape(3, -1)
            for count in counts
        ]
        return contents_of(head, tables)

    def _picture(self, head: dict[str, Any]) -> NDArray[Any]:
        kind = np.dtype(_KINDS[head["kind"]])
        shape = tuple(int(side) for side in head["shape"])
        size = int(np.prod(shape)) * kind.itemsize
        if len(shape) not in (2, 3) or not 0 < size <= _MOST_BYTES:
            raise ValueError("no picture")
        assert self._child.stdout is not None
        return np.frombuffer(receive_bytes(self._child.stdout, size), kind).reshape(shape)
