"""The program that runs a network, as this one sees it: started, asked, and ended in time."""

from __future__ import annotations

import contextlib
import math
import os
import subprocess
import threading
import weakref
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking import child_program
from tracking.errors import FormatError
from tracking.message_data import message_from
from tracking.networks.candidates import MOST_CANDIDATES
from tracking.networks.embedder import LENGTHS
from tracking.networks.letterbox import Picture
from tracking.networks.model_file import Model
from tracking.people.detection_source import FrameDetections
from tracking.untrusted.pipe import receive_bytes, receive_head, send

_WORKER = Path(__file__).with_name("network_worker.py")
_COLUMNS = 5
_ARENAS = "4"
"""Of glibc's allocator: each of them takes 64 MB of the address space, which is limited."""


@dataclass(frozen=True, slots=True)
class Limits:
    """What running a network may take.

    Attributes:
        memory_bytes: of address space, beside what the size of the ONNX file explains.
        start_s: until it is read and tried out. frame_s: for the pictures of one instant. By the
            clock; each processor may be busy so long.
    """

    memory_bytes: int = 4 << 30
    start_s: float = 120.0
    frame_s: float = 60.0

    def memory_for(self, model: Model) -> int:
        """Bytes of address space to run a network in; weights are copied and packed anew."""
        return self.memory_bytes + _COPIES * len(model.onnx)


_COPIES = 8
_LENGTH_ERROR = 1e-3
"""Of an embedding, which has length 1."""


class NetworkProcess:
    """A network in a program of its own, ready to be asked.

    Args:
        model: what to run. max_overlap: see `chosen_boxes`.
        cameras: how many pictures are asked for at once, 1 or 2.

    Attributes:
        batches: whether it takes both pictures in one batch.

    Raises FormatError, in one line, where the network cannot be read, tried out, or takes too much.
    """

    def __init__(
        self, model: Model, max_overlap: float = 1.0, cameras: int = 1, limits: Limits | None = None
    ) -> None:
        self._limits = limits or Limits()
        self._path = model.path
        environment = {"OPENBLAS_NUM_THREADS": "1", "MALLOC_ARENA_MAX": _ARENAS}
        self._child = child_program.begin(_WORKER, more=environment, stderr=subprocess.DEVNULL)
        self._end = weakref.finalize(self, child_program.end, self._child)
        longest_s = max(self._limits.start_s, self._limits.frame_s)
        start = {
            "spec": model.spec.as_data(),
            "onnx_bytes": len(model.onnx),
            "memory_bytes": self._limits.memory_for(model),
            "cpu_s": math.ceil(longest_s * (os.cpu_count() or 1)),
            "max_overlap": max_overlap,
            "cameras": cameras,
        }
        with self._told(self._limits.start_s):
            self.batches = self._ask(start, model.onnx).get("batches") is True

    def find(self, pictures: Sequence[Picture], least_score: float) -> tuple[FrameDetections, ...]:
        """The people in each of some pictures of one instant.

        Args:
            pictures: (height, width, 3) uint8 each, in BGR order. least_score: of boxes wanted.

        Raises FormatError where the network says what no boxes are, fails, or takes too long.
        """
        sizes = [list(picture.shape[:2]) for picture in pictures]
        parts = [np.ascontiguousarray(picture).data.cast("B") for picture in pictures]
        with self._told(self._limits.frame_s):
            head = self._ask({"sizes": sizes, "least_score": least_score}, *parts)
            return tuple(map(self._boxes, _counts_of(head, len(pictures))))

    def embed(self, crops: Sequence[Picture]) -> NDArray[np.float32]:
        """(n, d) embeddings of unit length of n crops, at least one, by an appearance network.

        Args:
            crops: (height, width, 3) uint8 each, in BGR order.

        Raises FormatError where the network says what is no embedding, fails, or takes too long.
        """
        sizes = [list(crop.shape[:2]) for crop in crops]
        parts = [np.ascontiguousarray(crop).data.cast("B") for crop in crops]
        assert self._child.stdout is not None
        with self._told(self._limits.frame_s):
            width = _width_of(self._ask({"sizes": sizes}, *parts), len(crops))
            held = receive_bytes(self._child.stdout, len(crops) * width * 4)
            rows = np.frombuffer(held, np.float32).reshape(len(crops), width)
            if not (np.abs(np.linalg.norm(rows, axis=1) - 1.0) < _LENGTH_ERROR).all():
                raise ValueError("embeddings that are none")
            return rows

    def close(self) -> None:
        """End the program; it may be at work."""
        self._end()

    def _ask(self, head: dict[str, Any], *parts: bytes | memoryview) -> dict[str, Any]:
        """The head of the answer. Raises FormatError where it is a refusal."""
        assert self._child.stdin is not None
        assert self._child.stdout is not None
        with contextlib.suppress(BrokenPipeError):  # it may have said why it ended
            send(self._child.stdin, head, *parts)
        answer = receive_head(self._child.stdout)
        if answer is None:
            raise EOFError
        if "refused" in answer:
            raise FormatError("{path}: {why}", path=self._path, why=message_from(answer["refused"]))
        return answer

    def _boxes(self, count: int) -> FrameDetections:
        """The next boxes of an answer; whatever happened to that program, these are sound."""
        assert self._child.stdout is not None
        held = receive_bytes(self._child.stdout, count * _COLUMNS * 4)
        rows = np.frombuffer(held, np.float32).reshape(count, _COLUMNS).astype(np.float64)
        if not np.isfinite(rows).all() or (rows[:, 2:4] <= 0).any():
            raise ValueError("boxes that are none")
        return FrameDetections(rows[:, :4], rows[:, 4])

    @contextlib.contextmanager
    def _told(self, seconds: float) -> Iterator[None]:
        """End the program where it takes longer, and tell in one line whatever goes wrong."""
        late = threading.Event()

        def end() -> None:
            late.set()
            self._child.kill()

        timer = threading.Timer(seconds, end)
        timer.start()
        try:
            yield
        except (OSError, EOFError, ValueError) as error:
            if late.is_set():
                raise FormatError(
                    "{path}: the network took longer than {seconds:.0f} s; take a smaller one",
                    path=self._path,
                    seconds=seconds,
                ) from error
            raise FormatError(
                "{path}: the program that ran the network ended; the ONNX file is damaged, or "
                "needs more than {size:.1f} GB of memory or too much time",
                path=self._path,
                size=self._limits.memory_bytes / (1 << 30),
            ) from error
        finally:
            timer.cancel()
            timer.join()


def _counts_of(head: dict[str, Any], pictures: int) -> list[int]:
    """How many boxes each picture has. Raises ValueError for what is no answer."""
    counts = head.get("counts")
    if not isinstance(counts, list) or len(counts) != pictures:
        raise ValueError("no answer about these pictures")
    if not all(isinstance(n, int) and 0 <= n <= MOST_CANDIDATES for n in counts):
        raise ValueError("no count of boxes")
    return counts


def _width_of(head: dict[str, Any], crops: int) -> int:
    """How many numbers an embedding has. Raises ValueError for what is no answer."""
    shape = head.get("shape")
    if not isinstance(shape, list) or len(shape) != 2 or shape[0] != crops:
        raise ValueError("no answer about these crops")
    width = shape[1]
    if not isinstance(width, int) or not LENGTHS[0] <= width <= LENGTHS[1]:
        raise ValueError("no length of an embedding")
    return width
