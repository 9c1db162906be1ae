"""Track an hour of footage and watch the memory: `long_run.py [FRAMES] [--steps]`.

The recording is the benchmark's clip (about fifteen people in view) again and again, packets
copied, so that it takes no time to make. The `track` command runs over it as users run it, in a
process of its own, whose resident memory is looked at every second: it must stay below 1 GiB and
not grow with the frames beyond what tables and ids take. With `--steps` the clip is tracked once
and its steps are kept, finished and saved again and again in this process instead, under new ids:
quick, and all but decoding and tracking is the same. The exit status says whether it held.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass, fields, replace
from pathlib import Path

import av
import h5py
import numpy as np

from tests.benchmarks.pipeline import recording as benchmark_clip
from tracking.pipeline import KeptSteps, track
from tracking.recording import open_recording
from tracking.session import Session
from tracking.trackers import StepResult, best_tracker, settings_values, tracker_named

FRAMES = 100_000
MOST_MB = 1074  # 1 GiB
_LOOK_EVERY_S = 1.0


@dataclass(frozen=True, slots=True)
class Footage:
    """A recording as far as a session asks for one, longer than the footage it stands for."""

    folder: Path
    frame_count: int
    name: str
    fps: float
    size: tuple[int, int]
    view: object
    is_stereo: bool = True
    manifest_text: str = ""
    own_manifest: bool = False
    calibration_text: str = ""
    uneven_times_s: None = None

    def fingerprints(self) -> tuple[()]:
        """Of no files."""
        return ()


def main() -> int:
    """Run it; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("frames", type=int, nargs="?", default=FRAMES)
    parser.add_argument("--steps", action="store_true", help="keep, finish and save alone")
    parser.add_argument("--folder", type=Path, help="where the recording and the session go")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="trackwright-", dir=asked.folder) as folder:
        work = by_steps if asked.steps else by_command
        watched = work(Path(folder), asked.frames)
        report(Path(folder) / "long.h5", asked.frames)
    return watched.verdict()


class Watched:
    """The resident memory of a process, looked at while it works."""

    def __init__(self, pid: int) -> None:
        self._pid = pid
        self._seen: list[tuple[float, float]] = []
        self._ended = threading.Event()
        self._begun_s = time.monotonic()
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Look no more."""
        self._ended.set()
        self._thread.join()

    def verdict(self) -> int:
        """Say how it went over time; 0 where it stayed within bounds."""
        times, sizes = np.array(self._seen).T
        for share in np.linspace(0, 1, 11):
            at = min(int(share * len(times)), len(times) - 1)
            print(f"after {times[at]:6.0f} s {sizes[at]:7.0f} MB")
        print(f"at most {sizes.max():.0f} MB, {MOST_MB} MB are allowed")
        return int(sizes.max() > MOST_MB)

    def _watch(self) -> None:
        while not self._ended.wait(_LOOK_EVERY_S):
            size = resident_mb(self._pid)
            if size:
                self._seen.append((time.monotonic() - self._begun_s, size))


def resident_mb(pid: int | str) -> float:
    """Of a process, or of "self"; 0 once it is gone."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return 0.0
    sizes = [int(line.split()[1]) for line in lines if line.startswith("VmRSS:")]
    return sizes[0] * 1024 / 1e6 if sizes else 0.0


def by_command(folder: Path, frames: int) -> Watched:
    """The `track` command over footage of that many frames."""
    long = folder / "recording"
    repeat_clip(benchmark_clip(), long, frames)
    words = ["-m", "app", "track", str(long), "-o", str(folder / "long.h5")]
    with subprocess.Popen([sys.executable, *words, "--frames", f"0:{frames}"]) as process:
        watched = Watched(process.pid)
        status = process.wait()
        watched.end()
    if status:
        raise SystemExit(status)
    return watched


def repeat_clip(clip: Path, out: Path, frames: int) -> None:
    """A recording of at least so many frames: the clip's packets again and again."""
    out.mkdir()
    for name in ("recording.toml", "calibration.yaml"):
        (out / name).write_bytes((clip / name).read_bytes())
    for side in ("left.mp4", "right.mp4"):
        with av.open(str(clip / side)) as source, av.open(str(out / side), "w") as target:
            stream = source.streams.video[0]
            times = -(-frames // stream.frames)
            written = target.add_stream_from_template(stream)
            length = (stream.duration or 0) or 1
            for turn in range(times):
                source.seek(0)
                for packet in source.demux(stream):
                    if packet.dts is not None and packet.pts is not None:
                        packet.dts += turn * length
                        packet.pts += turn * length
                        packet.stream = written
                        target.mux(packet)


def by_steps(folder: Path, frames: int) -> Watched:
    """The clip's steps kept, finished and saved as if they were so many."""
    with open_recording(benchmark_clip()) as clip:
        name = best_tracker(clip)
        with track(clip, keep=False) as tracking:
            steps = list(tracking)
        footage = Footage(folder, frames, "long", clip.fps, clip.size, clip.view)
    watched = Watched(os.getpid())
    begun_s = time.monotonic()
    kept = KeptSteps(folder)
    for step in repeated(steps, frames):
        kept.add((step,))
    taken_ms = 1000 * (time.monotonic() - begun_s) / frames
    print(f"kept in {taken_ms:.3f} ms a frame; {resident_mb(os.getpid()):.0f} MB")
    settings = settings_values(tracker_named(name).settings_type())
    run = kept.run(name, settings, 0, footage)  # type: ignore[arg-type]  # a recording, as far as it is asked
    del kept
    print(f"finished after {time.monotonic() - begun_s:.0f} s")
    Session.create(footage, [run], folder / "long.h5").close()
    print(f"saved after {time.monotonic() - begun_s:.0f} s")
    watched.end()
    return watched


def repeated(steps: Sequence[StepResult], frames: int) -> Iterator[StepResult]:
    """The steps again and again, with frames and ids that go on."""
    most = max(int(step.tracks["track"].max(initial=0)) for step in steps)
    for frame in range(frames):
        turn, at = divmod(frame, len(steps))
        yield renamed(steps[at], frame, turn * most)


def renamed(step: StepResult, frame: int, more: int) -> StepResult:
    """The step at another frame with ids so much higher."""
    tables = {}
    for field in fields(step):
        if field.name != "frame":
            table = dict(getattr(step, field.name))
            if "frame" in table:
                table["frame"] = np.full_like(table["frame"], frame)
            table["track"] = table["track"] + more * (table["track"] > 0).astype(np.int32)
            tables[field.name] = table
    return replace(step, frame=frame, **tables)


def report(session: Path, frames: int) -> None:
    """What the session holds."""
    with closing(Session.look_into(session)) as read:
        rows = len(read.tracks)
        people = rows / frames
    with h5py.File(session, "r") as file:
        group = file["runs/0/particles"]
        stored = {name: group[name].id.get_storage_size() for name in group}
        particles = len(group["x"])
    print(f"{frames} frames, {rows} rows, {people:.1f} people a frame, {particles} particles")
    if particles:
        each = {name: f"{size / particles:.2f}" for name, size in stored.items()}
        print(f"bytes a particle: {sum(stored.values()) / particles:.2f} {each}")
    print(f"session of {session.stat().st_size / 1e6:.0f} MB")


if __name__ == "__main__":
    sys.exit(main())
