"""The program that runs a network: pictures through its standard input, boxes or embeddings back.

A damaged network can crash the library that reads it, or keep it busy for ever: it ends this
program only. It may take so much memory and, for each message, so much processor time, and can open
no file: a network may name files of any place as its weights.
"""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Callable, Mapping
from typing import IO, Any, Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.message_data import message_data
from tracking.networks.candidates import chosen_boxes
from tracking.networks.decoders import Found, decode
from tracking.networks.embedder import Embedder
from tracking.networks.letterbox import Picture, Placement, network_input
from tracking.networks.network_spec import EMBEDDING, ONNXRUNTIME, OPENCV, NetworkSpec
from tracking.untrusted.pipe import receive_bytes, receive_head, send

_MOST_THREADS = 8
_ALIKE, _ALIKE_PX = 1e-3, 0.1
"""How far scores and boxes of a picture alone and of one in a batch may be apart."""
_DARKER = 0.25
"""The second picture of a trial beside the first: a network that mixes them is told by that."""
_LONGEST_REASON = 300

Outputs = Mapping[str, NDArray[Any]]
Answer = Callable[[list[Picture], dict[str, Any]], tuple[Any, ...]]


class Engine(Protocol):
    """What runs a network, of the bytes of an ONNX file; which raises FormatError."""

    def __init__(self, onnx: bytes) -> None: ...

    @staticmethod
    def load() -> None:
        """Read what it needs from files. Raises FormatError where it is not installed."""

    def run(self, batch: NDArray[np.float32], spec: NetworkSpec) -> Outputs:
        """Its outputs by name. Raises FormatError."""


class OpenCvEngine:
    """OpenCV's new engine; never the classic one, which is silently wrong for some networks."""

    @staticmethod
    def load() -> None:
        """See `Engine`."""
        cv2.getNumberOfCPUs()  # it reads files of the system

    def __init__(self, onnx: bytes) -> None:
        self._onnx = np.frombuffer(onnx, np.uint8)
        self._read()

    def _read(self) -> None:
        try:
            self._net = cv2.dnn.readNetFromONNX(self._onnx, engine=cv2.dnn.ENGINE_NEW)
            self._names = list(self._net.getUnconnectedOutLayersNames())
        except (cv2.error, SystemError) as error:
            raise FormatError(
                "OpenCV's engine cannot read it ({why})",
                'try engine = "onnxruntime", which is to be installed',
                why=_reason(error),
            ) from error

    def run(self, batch: NDArray[np.float32], spec: NetworkSpec) -> Outputs:  # noqa: ARG002
        """See `Engine`."""
        try:
            self._net.setInput(batch)
            outputs = self._net.forward(self._names)
        except (cv2.error, SystemError) as error:
            self._read()  # it may be left half way
            raise FormatError(
                "OpenCV's engine cannot run it ({why})", why=_reason(error)
            ) from error
        return dict(zip(self._names, outputs, strict=True))


class OnnxRuntimeEngine:
    """The library onnxruntime, where it is installed."""

    @staticmethod
    def load() -> None:
        """See `Engine`."""
        try:
            import onnxruntime  # noqa: F401 - later it could not be read
        except ImportError as error:
            raise FormatError(
                "it asks for onnxruntime, which is not installed",
                'install the extra "onnx", or write engine = "opencv"',
            ) from error

    def __init__(self, onnx: bytes) -> None:
        import onnxruntime

        onnxruntime.set_default_logger_severity(4)
        options = onnxruntime.SessionOptions()
        options.intra_op_num_threads = _threads()
        options.inter_op_num_threads = 1
        options.log_severity_level = 4
        try:
            self._session = onnxruntime.InferenceSession(
                onnx, options, providers=["CPUExecutionProvider"]
            )
        except Exception as error:  # it has many kinds of its own
            raise FormatError("onnxruntime cannot read it ({why})", why=_reason(error)) from error

    def run(self, batch: NDArray[np.float32], spec: NetworkSpec) -> Outputs:
        """See `Engine`."""
        size = np.tile(np.array(spec.size_px, np.int64), (len(batch), 1))
        given = {
            each.name: size if each.name == spec.size_input else batch
            for each in self._session.get_inputs()
        }
        try:
            outputs = self._session.run(None, given)
        except Exception as error:  # it has many kinds of its own
            raise FormatError("onnxruntime cannot run it ({why})", why=_reason(error)) from error
        names = [each.name for each in self._session.get_outputs()]
        return {
            name: values
            for name, values in zip(names, outputs, strict=True)
            if isinstance(values, np.ndarray)
        }


ENGINES: Mapping[str, type[Engine]] = {OPENCV: OpenCvEngine, ONNXRUNTIME: OnnxRuntimeEngine}


class Finder:
    """Finds the people in pictures; where it can, in two at once."""

    def __init__(
        self,
        engine: Engine,
        spec: NetworkSpec,
        max_overlap: float,
        cameras: int,
        noise: np.random.Generator,
    ) -> None:
        """Raises FormatError where the network cannot be run or understood."""
        self._engine, self._spec, self._max_overlap = engine, spec, max_overlap
        self.batches = self._try_out(cameras, noise)

    def _try_out(self, cameras: int, noise: np.random.Generator) -> bool:
        """Whether two pictures may be one batch: they give what each of them gives alone.

        Raises FormatError where what the network says of a picture is not to be understood.
        """
        width, height = self._spec.size_px
        batch = noise.random((2, 3, height, width), np.float32)
        batch[1] *= _DARKER
        alone = [self._decoded(batch[at : at + 1])[0] for at in range(cameras)]
        if cameras < 2:
            return False
        try:
            both = self._decoded(batch)
        except FormatError:
            return False
        return all(map(_is_same, both, alone))

    def _decoded(self, batch: NDArray[np.float32]) -> list[Found]:
        return decode(self._engine.run(batch, self._spec), self._spec, len(batch))

    def find(self, pictures: list[Picture], least_score: float) -> list[NDArray[np.float32]]:
        """(n, 5) left, top, width, height px and score of the people in each picture."""
        batch, placed = network_input(pictures, self._spec)
        step = len(pictures) if self.batches else 1
        found = []
        for first in range(0, len(pictures), step):
            part = batch[first : first + step]
            for at, (corners, score) in enumerate(self._decoded(part)):
                place: Placement = placed[first + at]
                found.append(chosen_boxes(corners, score, place, least_score, self._max_overlap))
        return found


def _is_same(part: Found, alone: Found) -> bool:
    return all(
        one.shape == other.shape
        and np.allclose(one, other, rtol=_ALIKE, atol=within, equal_nan=True)
        for one, other, within in zip(part, alone, (_ALIKE_PX, _ALIKE), strict=True)
    )


def _reason(error: BaseException) -> str:
    """What a library says, in one line that is not too long."""
    said = " ".join(str(error).split())
    said = said.rpartition("error: ")[2] or said
    return said if len(said) <= _LONGEST_REASON else f"{said[:_LONGEST_REASON]}..."


def _threads() -> int:
    return min(os.cpu_count() or 1, _MOST_THREADS)


class _Allowance:
    """Memory in all, and processor time that each message renews; where the system knows it."""

    def __init__(self, memory_bytes: int, cpu_s: int) -> None:
        self._cpu_s = cpu_s
        try:
            import resource
        except ImportError:  # Windows
            self._resource = None
            return
        self._resource = resource
        self._limit(resource.RLIMIT_AS, memory_bytes)

    def renew(self) -> None:
        """The next message may take as much processor time as any."""
        if self._resource is None:
            return
        spent = self._resource.getrusage(self._resource.RUSAGE_SELF)
        spent_s = int(spent.ru_utime + spent.ru_stime)
        self._limit(self._resource.RLIMIT_CPU, spent_s + 1 + self._cpu_s)

    def close_files(self) -> None:
        """From now on nothing can be opened."""
        if self._resource is None:
            return
        free = os.dup(0)
        os.close(free)
        self._resource.setrlimit(self._resource.RLIMIT_NOFILE, (free, free))

    def _limit(self, kind: int, most: int) -> None:
        assert self._resource is not None
        _, hard = self._resource.getrlimit(kind)
        most = most if hard == self._resource.RLIM_INFINITY else min(most, hard)
        with contextlib.suppress(OSError, ValueError):  # macOS knows RLIMIT_AS but may refuse it
            self._resource.setrlimit(kind, (most, hard))


def main() -> None:
    """Read the network, say how it is run, and answer until nobody asks any more."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print is no answer
    asked = sys.stdin.buffer
    start = receive_head(asked)
    if start is None:
        return
    allowance = _Allowance(start["memory_bytes"], start["cpu_s"])
    allowance.renew()
    onnx = receive_bytes(asked, start["onnx_bytes"])
    spec = NetworkSpec.from_data(start["spec"])
    cv2.setNumThreads(_threads())
    with _refusals(answers):
        engine = ENGINES[spec.engine]
        engine.load()
        noise = np.random.default_rng(0)  # its modules are read from files
        allowance.close_files()
        answer, batches = _role(engine(onnx), spec, start, noise)
        send(answers, {"batches": batches})
        del onnx
        while (head := receive_head(asked)) is not None:
            allowance.renew()
            pictures = [_picture(asked, *size) for size in head["sizes"]]
            send(answers, *answer(pictures, head))


def _role(
    engine: Engine, spec: NetworkSpec, start: dict[str, Any], noise: np.random.Generator
) -> tuple[Answer, bool]:
    """What answers about pictures, and whether it takes many at once."""
    if spec.decoder == EMBEDDING:
        embedder = Embedder(lambda batch: engine.run(batch, spec), spec, noise)
        return lambda pictures, _: _described(embedder, pictures), embedder.batches
    finder = Finder(engine, spec, start["max_overlap"], start["cameras"], noise)
    return lambda pictures, head: _found(finder, pictures, head), finder.batches


def _found(finder: Finder, pictures: list[Picture], head: dict[str, Any]) -> tuple[Any, ...]:
    found = finder.find(pictures, head["least_score"])
    return {"counts": [len(each) for each in found]}, *map(_bytes_of, found)


def _described(embedder: Embedder, crops: list[Picture]) -> tuple[Any, ...]:
    embedded = embedder.embed(crops)
    return {"shape": list(embedded.shape)}, _bytes_of(embedded)


def _picture(asked: IO[bytes], height: int, width: int) -> Picture:
    held = receive_bytes(asked, height * width * 3)
    return np.frombuffer(held, np.uint8).reshape(height, width, 3)


def _bytes_of(boxes: NDArray[np.float32]) -> bytes:
    return np.ascontiguousarray(boxes, np.float32).tobytes()


@contextlib.contextmanager
def _refusals(answers: IO[bytes]) -> Any:
    """Tell why it goes no further, in one line."""
    try:
        yield
    except FormatError as error:
        send(answers, {"refused": message_data(error.message)})
    except MemoryError:
        send(answers, {"refused": message_data(FormatError("it takes too much memory").message)})


if __name__ == "__main__":
    main()
