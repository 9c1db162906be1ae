"""How long sessions of ten thousand to ten million rows take to open, correct and save."""

from __future__ import annotations

import os
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

import h5py
import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from app.core.document.edit_history import EditMarks
from app.core.tracks.frame_state import FrameState
from app.core.tracks.session_tracks import SessionTracks
from app.features.timeline.panel import TimelineView
from app.features.timeline.presenter import TimelinePresenter
from tests.benchmarks.command import tell
from tests.benchmarks.large_sessions import NoPictures, crowd
from tests.benchmarks.timing import Peak, clock_ms
from tracking.editing import Change, plan_delete, plan_swap
from tracking.session import Session, session_reader

_EDITS, _OPENINGS, _GESTURES = 20, 9, 40
_FPS = 30.0
_BEAT_S = 0.002


@dataclass(frozen=True, slots=True)
class Size:
    """How long a session is. `particles`: in each frame."""

    name: str
    rows: int
    tracks: int
    frames: int
    particles: int


SIZES = (
    Size("10k", 10_000, 10, 2_000, 500),
    Size("1m", 1_000_000, 100, 100_000, 100),
    Size("10m", 10_000_000, 1_000, 864_000, 50),
)


def measure() -> dict[str, float]:
    """For each size milliseconds of the clock, and MB of memory; the disk's time counts.

    `open_ms`: the session, known by this user's seal, read and its journal looked for.
    `open_unknown_ms`: the same where the file comes from elsewhere and is checked by a program of
    its own first. `open_vs_raw`, `open_unknown_vs_raw`: these over reading the same columns of the
    same file with h5py alone, each the median of several, in turn. `picture_ms`: from there to the
    painted timeline of 1600 x 420, with the run; `timeline_..._ms`: the median from a gesture in it
    until all is painted again, offscreen in software.
    `swap_ms`, `undo_ms`: planned, in the journal on the disk and done; `_max` of twenty; of them
    `first_swap_ms` is the first, soon after opening.
    `save_ms`: all of a save; `save_begin_ms`, `save_end_ms`: what of it the window waits for, and
    `save_gap_ms`: the longest time the thread of the window waited while it was written by another.
    `_peak_mb`: how much more memory was taken than before.
    """
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    application = QApplication.instance() or QApplication([])
    figures: dict[str, float] = {}
    for size in SIZES:
        tell(f"  {size.name}")
        with tempfile.TemporaryDirectory(prefix="trackwright-benchmark-") as folder:
            found = _figures(size, Path(folder))
        figures |= {f"{size.name}_{name}": value for name, value in found.items()}
    del application
    return figures


def _figures(size: Size, folder: Path) -> dict[str, float]:
    path = folder / "s.h5"
    figures = _make(size, path)
    figures["file_mb"] = path.stat().st_size / 1e6
    figures |= _openings(path)
    with closing(Session.open(path)) as session, Peak() as peak:
        figures["picture_ms"], shown = clock_ms(lambda: ShownTimeline(session, size))
        figures |= _gestures(shown, size)
        figures |= _edits(session, size)
        figures["edits_peak_mb"] = peak.grown_mb()
        figures |= _save(session)
    return figures


def _openings(path: Path) -> dict[str, float]:
    taken: dict[str, list[float]] = {"raw": [], "open": [], "open_unknown": []}
    for _ in range(_OPENINGS):
        taken["raw"].append(clock_ms(lambda: _read_raw(path))[0])
        taken["open"].append(_open(path))
        with patch.object(session_reader, "is_sealed", return_value=False):
            taken["open_unknown"].append(_open(path))
    figures = {f"{name}_ms": float(np.median(times)) for name, times in taken.items()}
    for name in ("open", "open_unknown"):
        figures[f"{name}_vs_raw"] = figures[f"{name}_ms"] / figures["raw_ms"]
    return figures


def _open(path: Path) -> float:
    taken, session = clock_ms(lambda: Session.open(path))
    session.close()
    return taken


def _make(size: Size, path: Path) -> dict[str, float]:
    """The session with its run, saved for the first time."""
    run = crowd(size.rows, size.tracks, size.frames, size.particles)
    recording = NoPictures(path.parent, frame_count=size.frames)
    with Peak() as peak:
        taken, session = clock_ms(lambda: Session.create(recording, [run], path))
        grown = peak.grown_mb()
    rows = float(len(session.tracks))
    session.close()
    particles = float(size.frames * size.particles)
    return {"rows": rows, "particles": particles, "first_save_ms": taken, "first_save_mb": grown}


def _read_raw(path: Path) -> list[NDArray[Any]]:
    """The corrected tracks' columns as h5py gives them, all kept."""
    with h5py.File(path, "r") as file:
        return [column[()] for column in file["tracks"].values()]


class ShownTimeline:
    """The timeline over a session, as the window puts it together; painted once."""

    def __init__(self, session: Session, size: Size) -> None:
        self.session, self.frame = session, size.frames // 2
        self._tracks = SessionTracks(session.tracks, session.runs[0])
        self._presenter, self._marks = TimelinePresenter(size.frames, _FPS), EditMarks()
        self._presenter.take(self._tracks, {})
        self.view = TimelineView()
        self.view.resize(1600, 420)
        self._image = QImage(self.view.size(), QImage.Format.Format_RGB32)
        self.paint()

    def paint(self) -> None:
        """Show and paint what there is to see by now."""
        state = FrameState(self.frame, self._tracks)
        self.view.show_scene(self._presenter.scene(self.frame, state, (), None))
        self.view.render(self._image)

    def edit(self, change: Change) -> None:
        """Apply an edit."""
        self.session.apply(change)
        self._take(change)

    def undo(self) -> None:
        """Undo the last one."""
        self._take(self.session.undo().change.inverse)

    def _take(self, change: Change) -> None:
        frames = change.before.rows["frame"], change.after.rows["frame"]
        marks = self._marks.of(self.session.history)
        self._presenter.take_changed(change.tracks, self._tracks, frames, marks)


def _gestures(shown: ShownTimeline, size: Size) -> dict[str, float]:
    """Median ms of each gesture, painted."""
    area, table = shown.view.area, shown.session.tracks
    tracks = np.random.default_rng(3102).permutation(size.tracks)[: 2 * _GESTURES] + 1
    pairs = tracks[: len(tracks) // 2 * 2].reshape(-1, 2).tolist()
    widths = np.geomspace(size.frames, 60 * _FPS, _GESTURES).astype(int).tolist()
    middles = {a: int(np.median(table.frames_of_track(a))) for a, _ in pairs}

    def go(frame: int) -> None:
        shown.frame = frame

    gestures: dict[str, list[Callable[[], object]]] = {
        "playhead": [partial(go, shown.frame + n) for n in range(_GESTURES)],
        "scroll": [partial(area.scroll_bar.setValue, 20 * n) for n in range(_GESTURES)],
        "zoom": [partial(_zoom, shown, width) for width in widths],
        "pan": [partial(area.stretch.pan, 0.3)] * _GESTURES,
        "swap": [lambda a=a, b=b: shown.edit(plan_swap(table, a, b, middles[a])) for a, b in pairs],
        "undo": [shown.undo] * len(pairs),
        "delete": [lambda a=a: shown.edit(plan_delete(table, a)) for a, _ in pairs[:_EDITS]],
    }
    figures = {}
    for name, several in gestures.items():
        taken = [
            clock_ms(lambda gesture=gesture: (gesture(), shown.paint()))[0] for gesture in several
        ]
        figures[f"timeline_{name}_ms"] = float(np.median(taken))
    for _ in gestures["delete"]:
        shown.undo()
    return figures


def _zoom(shown: ShownTimeline, frames: int) -> None:
    area = shown.view.area
    area.stretch.show(area.axis.around(shown.frame, frames))


def _edits(session: Session, size: Size) -> dict[str, float]:
    rng, table = np.random.default_rng(3103), session.tracks
    pairs = [rng.choice(size.tracks, 2, replace=False) + 1 for _ in range(_EDITS)]

    def swap(a: int, b: int) -> None:
        frames = table.frames_of_track(a)
        session.apply(plan_swap(table, a, b, int(frames[len(frames) // 2])))

    swaps = [clock_ms(lambda a=int(a), b=int(b): swap(a, b))[0] for a, b in pairs]  # type: ignore[misc]  # mypy infers no lambda with defaults
    undone = [clock_ms(session.undo)[0] for _ in pairs]
    named = {"swap": swaps, "undo": undone}
    figures = {"first_swap_ms": swaps.pop(0)}
    for name, taken in named.items():
        figures |= {f"{name}_ms": float(np.median(taken)), f"{name}_max_ms": max(taken)}
    return figures


def _save(session: Session) -> dict[str, float]:
    """A save as the window does it: a thread writes while this one goes on."""
    session.apply(plan_swap(session.tracks, 1, 2, 0))
    with Peak() as peak:
        begun_ms, pending = clock_ms(session.begin_save)
        writer = threading.Thread(target=pending.write)
        written_ms, gaps = clock_ms(lambda: list(_beats_beside(writer)))
        ended_ms, _ = clock_ms(lambda: session.finish_save(pending))
        grown = peak.grown_mb()
    return {
        "save_ms": begun_ms + written_ms + ended_ms,
        "save_begin_ms": begun_ms,
        "save_end_ms": ended_ms,
        "save_gap_ms": max(gaps),
        "save_peak_mb": grown,
    }


def _beats_beside(worker: threading.Thread) -> Iterator[float]:
    """How many ms each short wait took beyond what was asked, until the other thread is done."""
    worker.start()
    while True:
        begun_s = time.perf_counter()
        worker.join(_BEAT_S)
        yield max(0.0, 1000 * (time.perf_counter() - begun_s - _BEAT_S))
        if not worker.is_alive():
            return
