"""A recording that is one small file, runs over it, and states of sessions to compare."""

from __future__ import annotations

import hashlib
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tracking.editing import plan_swap
from tracking.recording import Fingerprint
from tracking.session import Session
from tracking.session.session_writer import companions
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Particles,
    Run,
)

FRAMES = 40


@dataclass(frozen=True)
class OneFile:
    """A recording as far as a session asks for one."""

    folder: Path
    name: str = "Lobby, camera 3"
    fps: float = 20.0
    frame_count: int = FRAMES
    size: tuple[int, int] = (640, 480)
    is_stereo: bool = True
    manifest_text: str = 'format = 1\nname = "Lobby, camera 3"\n'
    own_manifest: bool = True
    calibration_text: str = "M1: ä\n"

    def fingerprints(self) -> Sequence[Fingerprint]:
        data = (self.folder / "left.mp4").read_bytes()
        return (Fingerprint("left.mp4", len(data), hashlib.sha256(data).hexdigest()),)


def make_recording(folder: Path, data: bytes = b"pictures") -> OneFile:
    folder.mkdir(parents=True)
    (folder / "left.mp4").write_bytes(data)
    return OneFile(folder)


def make_run(seed: int = 0, tracks: int = 4, frames: int = FRAMES, particles: int = 10) -> Run:
    """Tracks that stand in most frames, with everything a tracker gives."""
    random = np.random.default_rng(seed)
    frame, track = np.repeat(np.arange(frames), tracks), np.tile(np.arange(1, tracks + 1), frames)
    stands = random.random(len(frame)) < 0.8
    stands[track == 1] = True
    places = {"frame": frame[stands], "track": track[stands]}

    def table(types: dict[str, np.dtype], rows: int) -> dict[str, np.ndarray]:
        values = {name: random.random(rows).astype(dtype) for name, dtype in types.items()}
        return {**values, **{n: places[n].astype(np.int32) for n in places if n in types}}

    rows = int(stands.sum())
    columns = table(dict(TRACK_COLUMNS), rows)
    columns["x"][random.random(rows) < 0.3] = np.nan
    start = np.arange(frames + 1, dtype=np.int64) * tracks * particles
    cloud = {
        name: random.random(int(start[-1])).astype(dtype)
        for name, dtype in PARTICLE_COLUMNS.items()
    }
    return Run(
        tracker="stereo-direction",
        settings={"particles": particles, "eta": 0.25},
        seed=seed,
        frames=(0, frames),
        tracks=columns,
        detections=table(dict(DETECTION_COLUMNS), rows),
        particles=Particles(start, cloud),
        associations=table(dict(ASSOCIATION_COLUMNS), rows),
        software="trackwright test",
    )


def make_session(folder: Path, name: str = "s.h5") -> Session:
    """A saved session beside its recording."""
    return Session.create(
        make_recording(folder / "recording"), [make_run()], folder / name, author="ada"
    )


def state_of(session: Session) -> tuple[object, ...]:
    """Everything edits can change, to compare."""
    columns = {name: column.tobytes() for name, column in session.tracks.columns().items()}
    log = [(e.id, e.text, e.author, e.undone, e.abandoned) for e in session.history]
    return columns, session.labels, log


def crashed(session: Session, folder: Path) -> Path:
    """What a crash at this moment leaves on the disk, elsewhere."""
    assert session.path is not None
    folder.mkdir(parents=True)
    shutil.copy(session.path, folder)
    shutil.copytree(companions(session.path), folder / companions(session.path).name)
    return folder / session.path.name


def edit(session: Session, *, swaps: int = 1) -> None:
    """Make swaps, each from a frame later on."""
    for frame in range(10, 10 + swaps):
        session.apply(plan_swap(session.tracks, 1, 2, frame))
