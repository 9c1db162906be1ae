"""Track an hour of footage and watch the memory: `long_run.py [--frames 100000]`.

The recording is the benchmark's clip (about fifteen people in view) again and again, packets
copied, so that it takes no time to make. The `track` command runs over it as users run it, in a
process of its own, whose resident memory is looked at every second: it must stay below 1 GiB and
not grow with the frames beyond what tables and ids take, which the printed sizes tell.
"""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import av
import h5py
import numpy as np

from tests.benchmarks.pipeline import recording as benchmark_clip
from tests.sweeps.command import resident_bytes
from tests.sweeps.runner import Worker, sweep
from tracking.session import Session

FRAMES = 100_000
MOST_MIB = 1024
_LOOK_EVERY_S = 1.0


def attack(worker: Worker) -> Iterator[str]:
    """One long recording a run."""
    for _ in worker.numbers:
        frames, session = worker.asked.frames, worker.folder / "long.h5"
        repeat_clip(worker.asked.clip, worker.folder / "recording", frames)
        status, sizes = tracked(worker.folder / "recording", session, frames)
        for share in np.linspace(0, 1, 11):
            at = min(int(share * len(sizes)), len(sizes) - 1)
            print(f"after {at * _LOOK_EVERY_S:6.0f} s {sizes[at]:7.0f} MiB", flush=True)
        worker.count("frames", frames)
        worker.count("MiB at most", round(max(sizes)))
        if max(sizes) > MOST_MIB:
            yield f"took {max(sizes):.0f} MiB; {MOST_MIB} are allowed"
        if status:
            yield f"the command ended with {status}"
        else:
            report(worker, session)


def tracked(recording: Path, session: Path, frames: int) -> tuple[int, list[float]]:
    """Track so many frames by the command: its exit status, and its MiB second by second."""
    words = ["-m", "app", "track", str(recording), "-o", str(session), "--frames", f"0:{frames}"]
    sizes = [0.0]
    with subprocess.Popen([sys.executable, *words]) as process:
        while process.poll() is None:
            sizes.append(resident_bytes(process.pid) / 2**20)
            time.sleep(_LOOK_EVERY_S)
    return process.returncode, sizes


def repeat_clip(clip: Path, out: Path, frames: int) -> None:
    """A recording of at least so many frames: the clip's packets again and again."""
    out.mkdir()
    for name in ("recording.toml", "calibration.yaml"):
        (out / name).write_bytes((clip / name).read_bytes())
    for side in ("left.mp4", "right.mp4"):
        with av.open(str(clip / side)) as source, av.open(str(out / side), "w") as target:
            stream = source.streams.video[0]
            written = target.add_stream_from_template(stream)
            length = (stream.duration or 0) or 1
            for turn in range(-(-frames // stream.frames)):
                source.seek(0)
                for packet in source.demux(stream):
                    if packet.dts is not None and packet.pts is not None:
                        packet.dts += turn * length
                        packet.pts += turn * length
                        packet.stream = written
                        target.mux(packet)


def report(worker: Worker, session: Path) -> None:
    """Count what the session holds, and what a particle takes."""
    with closing(Session.look_into(session)) as read:
        worker.count("rows", len(read.tracks))
    worker.count("MB of session", round(session.stat().st_size / 1e6))
    with h5py.File(session, "r") as file:
        group = file["runs/0/particles"]
        particles = len(group["x"])
        worker.count("particles", particles)
        each = {name: group[name].id.get_storage_size() / max(1, particles) for name in group}
    told = ", ".join(f"{name} {size:.2f}" for name, size in each.items())
    print(f"bytes a particle: {sum(each.values()):.2f} ({told})")


if __name__ == "__main__":
    options = {
        "--frames": {"type": int, "default": FRAMES, "help": "how long the recording is"},
        # Rendered once, into the cache of whoever runs this.
        "--clip": {"type": Path, "default": benchmark_clip(), "help": "what it repeats"},
    }
    sys.exit(sweep(attack, 1, workers=1, options=options))
