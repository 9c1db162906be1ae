"""How long a large session takes to be saved, opened and edited: a million rows."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np

from tracking.editing import plan_swap
from tracking.session import Session, SourceFingerprint
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Particles,
    Run,
    empty,
)

TRACKS, FRAMES = 25, 40_000
_EDITS = 20
Done = TypeVar("Done")


@dataclass(frozen=True)
class NoPictures:
    """A recording as far as a session asks for one."""

    folder: Path
    name: str = "benchmark"
    fps: float = 20.0
    frame_count: int = FRAMES
    size: tuple[int, int] = (640, 480)
    is_stereo: bool = True
    manifest_text: str = ""
    own_manifest: bool = True
    calibration_text: str = ""

    def fingerprints(self) -> tuple[SourceFingerprint, ...]:
        return ()


def long_run() -> Run:
    """Everybody is there all the time; no particles are kept."""
    random = np.random.default_rng(0)
    rows = TRACKS * FRAMES
    columns = {name: random.random(rows).astype(dtype) for name, dtype in TRACK_COLUMNS.items()}
    columns["frame"] = np.repeat(np.arange(FRAMES, dtype=np.int32), TRACKS)
    columns["track"] = np.tile(np.arange(1, TRACKS + 1, dtype=np.int32), FRAMES)
    return Run(
        tracker="benchmark",
        settings={},
        seed=0,
        frames=(0, FRAMES),
        tracks=columns,
        detections=empty(DETECTION_COLUMNS),
        particles=Particles(np.zeros(FRAMES + 1, np.int64), empty(PARTICLE_COLUMNS)),
        associations=empty(ASSOCIATION_COLUMNS),
        software="",
    )


def measure() -> dict[str, float]:
    """`rows`, and milliseconds of the clock: the disk's time counts.

    `edit_ms` and `undo_ms` are medians over swaps in the middle, planned, on disk and done.
    """
    run = long_run()
    with tempfile.TemporaryDirectory(prefix="trackwright-benchmark-") as folder:
        path = Path(folder) / "s.h5"
        saved_ms, made = _timed(lambda: Session.create(NoPictures(Path(folder)), [run], path))
        made.close()
        opened_ms, session = _timed(lambda: Session.open(path))
        with closing(session):
            swaps = [_timed(lambda: _swap(session))[0] for _ in range(_EDITS)]
            undone = [_timed(session.undo)[0] for _ in range(_EDITS)]
    return {
        "rows": float(TRACKS * FRAMES),
        "save_ms": saved_ms,
        "open_ms": opened_ms,
        "edit_ms": float(np.median(swaps)),
        "undo_ms": float(np.median(undone)),
    }


def _swap(session: Session) -> None:
    session.apply(plan_swap(session.tracks, 1, 2, FRAMES // 2))


def _timed(work: Callable[[], Done]) -> tuple[float, Done]:
    """Milliseconds of the clock, and what came of it."""
    begun = time.perf_counter()
    done = work()
    return 1000.0 * (time.perf_counter() - begun), done
