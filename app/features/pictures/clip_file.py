"""The file of a clip, and the work that fills it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, closing, contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Protocol

import av
import numpy as np
from av.filter import Graph
from numpy.typing import NDArray

from app.features.pictures.clip import ClipChoice, ClipKind, ClipSource
from app.features.pictures.clip_painter import ClipPainter
from tracking.atomic_output import part_of
from tracking.progress import Progress
from tracking.recording import Instants
from tracking.synthesis.video import CLIP_COMMENT, VideoWriter

Bgr = NDArray[np.uint8]


class PictureWriter(Protocol):
    """Takes the pictures of a clip one after the other; `part_of` tells what the disk refuses."""

    def write(self, image: Bgr) -> None:
        """Append a picture; OSError where the disk is full."""


def write_clip(source: ClipSource, choice: ClipChoice, path: Path, report: Progress) -> int:
    """Write a clip, whole or not at all; how many pictures it has.

    Raises:
        CancelledError: the user has stopped it; nothing is left of it.
        OutputError: it cannot be written there. RecordingError: a frame cannot be read.
    """
    painter = ClipPainter(source, choice)
    count = choice.picture_count(source.recording.fps)
    with part_of(path) as part, _writer(choice.kind, part, painter.size, choice.fps) as writer:
        done = 0
        for image, times in _pictures(source, choice, painter):
            for _ in range(times):
                writer.write(image)
                done += 1
                report(done, count)
    return count


def _pictures(
    source: ClipSource, choice: ClipChoice, painter: ClipPainter
) -> Iterator[tuple[Bgr, int]]:
    """Each picture and how often it is shown; frames that are passed over are not painted."""
    wanted = dict(choice.repeats(source.recording.fps))
    instants = Instants(source.recording, source.lag)
    with closing(instants.frames(choice.start, choice.stop)) as frames:
        for frame in frames:
            if frame.number in wanted:
                yield painter.paint(frame), wanted[frame.number]


def _writer(
    kind: ClipKind, path: Path, size: tuple[int, int], fps: float
) -> AbstractContextManager[PictureWriter]:
    if kind is ClipKind.MP4:
        return VideoWriter(path, size, fps, CLIP_COMMENT)
    return _gif(path, size, fps)


@contextmanager
def _gif(path: Path, size: tuple[int, int], fps: float) -> Iterator[PictureWriter]:
    writer = _GifWriter(path, size, fps)
    try:
        yield writer
        writer.end()
    finally:
        writer.close()


class _GifWriter:
    """An animated GIF that runs for ever; each picture has 256 colours of its own."""

    def __init__(self, path: Path, size: tuple[int, int], fps: float) -> None:
        self._next = 0
        rate = Fraction(fps).limit_denominator(100)
        self._base = 1 / rate
        self._container = av.open(str(path), "w", format="gif")
        self._stream = self._container.add_stream("gif", rate=rate)
        self._stream.width, self._stream.height = size
        self._stream.pix_fmt = "pal8"
        self._graph, self._closed = _palette_graph(size, self._base), False

    def write(self, image: Bgr) -> None:
        frame = av.VideoFrame.from_ndarray(image, format="bgr24")
        frame.pts, frame.time_base = self._next, self._base
        self._next += 1
        self._graph.push(frame)
        self._drain()

    def end(self) -> None:
        """Write what is still on its way."""
        self._graph.push(None)
        self._drain()
        self._mux(None)
        self.close()

    def close(self) -> None:
        """Let go of the file."""
        if not self._closed:
            self._closed = True
            self._container.close()

    def _drain(self) -> None:
        while True:
            try:
                frame = self._graph.pull()
            except (av.BlockingIOError, av.EOFError):
                return
            if isinstance(frame, av.VideoFrame):
                self._mux(frame)

    def _mux(self, frame: av.VideoFrame | None) -> None:
        self._container.mux(self._stream.encode(frame))


def _palette_graph(size: tuple[int, int], base: Fraction) -> Graph:
    """Finds each picture's colours, and puts the picture into them."""
    graph = Graph()
    width, height = size
    buffer = graph.add_buffer(
        width=width, height=height, format=av.VideoFormat("bgr24"), time_base=base
    )
    parted = graph.add("split")
    colours = graph.add("palettegen", "stats_mode=single")
    used = graph.add("paletteuse", "new=1:dither=bayer:bayer_scale=4")
    sink = graph.add("buffersink")
    buffer.link_to(parted)
    parted.link_to(colours, 0, 0)
    parted.link_to(used, 1, 0)
    colours.link_to(used, 0, 1)
    used.link_to(sink)
    graph.configure()
    return graph


def clip_work(
    source: ClipSource, choice: ClipChoice, path: Path, check: Callable[[Path], object]
) -> Callable[[Progress], int]:
    """The work of a job; `check` raises where the file is not to be replaced."""

    def work(report: Progress) -> int:
        check(path)
        return write_clip(source, choice, path, report)

    return work
