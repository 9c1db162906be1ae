"""What keeping the particles of every frame costs: while they come, and in the session."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tests.benchmarks.pipeline import recording
from tests.benchmarks.timing import least_ms
from tracking.pipeline import KeptSteps, track
from tracking.recording import open_recording
from tracking.session.image_file import ImageFile
from tracking.session.layout import CHUNK_ROWS
from tracking.session.table_writer import Packer
from tracking.trackers import StepResult
from tracking.tracks import Particles

FRAMES = (100, 164)
"""Of the pipeline's benchmark: fifteen people, 500 particles each."""
_TIMES = 5


def measure() -> dict[str, float]:
    """Bytes a particle, and milliseconds of processor time a frame.

    `gzip_`: their four columns written into a session as they are drawn, in 32 bits a value, by
    gzip's quickest level. `kept_`: put aside on the disk while a tracker works, in 16 bits a
    value, with what is put aside of detections, matches and signals. `saved_`: written into a
    session from there. `kept_vs_gzip`, `saved_vs_gzip`: their time over gzip's;
    `kept_size_vs_gzip`, `saved_size_vs_gzip`: the room they take over gzip's.
    """
    with open_recording(recording()) as opened:
        with track(opened, "stereo-direction", frames=FRAMES, keep=False) as tracking:
            steps = list(tracking)
        with tempfile.TemporaryDirectory(prefix="trackwright-benchmark-") as folder:
            kept = kept_on_disk(steps, Path(folder))
            spooled = kept.spooled_bytes
            particles = kept.run("benchmark", {}, 0, opened).particles
            return _figures(steps, particles, spooled, Path(folder))


def kept_on_disk(steps: Sequence[StepResult], folder: Path) -> KeptSteps:
    """The steps, their particles in a file from the first on."""
    kept = KeptSteps(folder, in_memory=0)
    kept.add(steps)
    return kept


def _figures(
    steps: Sequence[StepResult], kept: Particles, spooled: int, folder: Path
) -> dict[str, float]:
    rows = len(kept.columns["x"]) // CHUNK_ROWS * CHUNK_ROWS  # whole pieces, as of long footage
    drawn = {n: np.concatenate([step.particles[n] for step in steps]) for n in kept.columns}
    drawn = {name: column[:rows] for name, column in drawn.items()}
    coded = {name: column[0:rows] for name, column in kept.columns.items()}
    path, share = folder / "s.h5", rows / sum(len(step.particles["x"]) for step in steps)
    sizes = {
        "gzip": saved(drawn, path, noisy=False),
        "kept": spooled * share,
        "saved": saved(coded, path, noisy=True),
    }
    times = {
        "gzip": least_ms(lambda: saved(drawn, path, noisy=False), _TIMES),
        "kept": least_ms(lambda: kept_on_disk(steps, folder), _TIMES) * share,
        "saved": least_ms(lambda: saved(kept.columns, path, noisy=True), _TIMES) * share,
    }
    return {
        "particles": rows / len(steps) / share,
        **{f"{way}_bytes": size / rows for way, size in sizes.items()},
        **{f"{way}_ms": taken / len(steps) / share for way, taken in times.items()},
        **{f"{way}_vs_gzip": times[way] / times["gzip"] for way in ("kept", "saved")},
        **{f"{way}_size_vs_gzip": sizes[way] / sizes["gzip"] for way in ("kept", "saved")},
    }


def saved(columns: Mapping[str, Any], path: Path, *, noisy: bool) -> int:
    """Bytes of the columns in a session file."""
    image = ImageFile(path)
    with h5py.File(image, "w") as file:
        run = file.create_group("runs/0")
        table = Packer(image).table(run, "particles", columns, noisy=noisy)
        size = sum(table[name].id.get_storage_size() for name in table)
    image.finish()
    image.close()
    return int(size)
