"""How fast trackers are on one core: decoded frames in, stored particles out."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import cv2
import numpy as np

from tests.benchmarks.clips import Clip, folder_of
from tests.benchmarks.peers import Obvious, OneCamera, Primitives, Timed
from tracking.pipeline import Tracking, track
from tracking.recording import Recording, StereoFrame, open_recording

PARTICLES = 500
"""Of each person: what the default tracker has, too."""


@dataclass(frozen=True, slots=True)
class Speed:
    """What is timed.

    Attributes:
        clip: a rendered scene.
        tracker: None: the default one.
        people: only frames in which so many are followed count.
        peers: what others would do for a frame, by name; made for a recording.
    """

    clip: Clip
    tracker: str | None
    people: range
    peers: Mapping[str, Callable[[Recording], Timed]]


_ONE_CAMERA = {"primitives": partial(OneCamera, corners=False)}
PIPELINE = Speed(
    Clip("square", 1, 12.0, 16),
    None,
    range(14, 17),
    {"primitives": Primitives, "obvious": partial(Obvious, particles=PARTICLES)},
)
"""Sixteen people, of whom fifteen or all are in view in the frames that count."""
PIPELINE_720P = replace(PIPELINE, clip=replace(PIPELINE.clip, size=(1280, 720)))
SPHEROID = Speed(Clip("plaza", 5101, 12.0, 11, cameras=1), "spheroid", range(8, 13), _ONE_CAMERA)
PARTS = Speed(Clip("walkway", 4101, cameras=1), "three-part", range(5, 6), _ONE_CAMERA)
FLOW = Speed(
    Clip("lane", 5101, 20.0, 18),
    "flow",
    range(4, 30),
    {"primitives": partial(OneCamera, corners=True)},
)


def recording() -> Path:
    """The recording of the stereo pipeline's benchmark, kept in the user's cache."""
    return folder_of(PIPELINE.clip)


@dataclass(slots=True)
class _Spent:
    """Milliseconds of processor time a frame, by part; the whole of a frame is "frame"."""

    ms: dict[str, list[float]] = field(default_factory=dict)

    def add(self, **seconds: float) -> None:
        """One frame more."""
        for part, each in seconds.items():
            self.ms.setdefault(part, []).append(1000.0 * each)

    def mean(self, part: str, counted: list[int]) -> float:
        """The mean of a part over the frames that count."""
        return float(np.mean(np.array(self.ms[part])[counted]))


def measure(what: Speed = PIPELINE) -> dict[str, float | None]:
    """Frames a second of processor time, and milliseconds of it a frame and a part.

    Only frames with about so many tracked people count: fifteen with two cameras, ten with
    spheroids, five with body parts. The time is the whole process's, with one thread in OpenCV, so
    that other work on the machine does not count; ours is shared out among the stages by their
    share of the clock. `vs_primitives` and `vs_obvious` are our time over theirs (see `peers`):
    below 1 we are quicker. All take turns at each frame, so that a machine that is now faster, now
    slower, is so for all of them.
    """
    cv2.setNumThreads(1)
    ours, people = _Spent(), []
    with (
        open_recording(folder_of(what.clip)) as opened,
        track(opened, what.tracker) as tracking,
    ):
        peers = {
            name: (make(opened), opened.frames(), _Spent()) for name, make in what.peers.items()
        }
        for seen in _steps(tracking, ours):
            people.append(seen)
            for peer in peers.values():
                _look(*peer, seen)
    counted = [k for k, seen in enumerate(people) if k and seen in what.people]
    if not counted:
        raise RuntimeError(f"never were {what.people} people followed in {what.clip.name}")
    return _figures(ours, {name: spent for name, (_, _, spent) in peers.items()}, counted, people)


def pipeline_720p() -> dict[str, float | None]:
    """The same as `pipeline` on images of 1280 x 720; see there."""
    return measure(PIPELINE_720P)


def spheroid() -> dict[str, float | None]:
    """Frames a second and `vs_primitives` of `spheroid`, ten people in view; see `pipeline`."""
    return measure(SPHEROID)


def flow() -> dict[str, float | None]:
    """Frames a second and `vs_primitives` of `flow` in a crowded passage; see `pipeline`."""
    return measure(FLOW)


def parts() -> dict[str, float | None]:
    """Frames a second and `vs_primitives` of `three-part`, five people in view; see `pipeline`."""
    return measure(PARTS)


def _steps(tracking: Tracking, spent: _Spent) -> Iterator[int]:
    """Track frame by frame; gives how many people are followed in each."""
    while True:
        before, begun = tracking.stage_s, time.process_time()
        result = next(tracking, None)
        taken = time.process_time() - begun
        if result is None:
            return
        clock = {name: tracking.stage_s[name] - before.get(name, 0.0) for name in before}
        stages = ("decode", "perception", "tracker")
        scale = taken / max(sum(clock[name] for name in stages), 1e-9)
        spent.add(frame=taken, **{name: scale * clock[name] for name in stages})
        yield len(result.tracks["track"])


def _look(work: Timed, frames: Iterator[StereoFrame], spent: _Spent, people: int) -> None:
    """A peer's turn at the next frame, decoded by its own decoder."""
    begun = time.process_time()
    frame = next(frames)
    decoded = time.process_time() - begun
    work(frame, people)
    spent.add(frame=time.process_time() - begun, decode=decoded, **work.spent_s)


def _figures(
    ours: _Spent, peers: Mapping[str, _Spent], counted: list[int], people: list[int]
) -> dict[str, float | None]:
    """The table: ours, the ratios, and what the peers' parts took."""
    frame_ms = ours.mean("frame", counted)
    told: dict[str, float | None] = {
        "fps": 1000.0 / frame_ms,
        "people": float(np.mean(np.array(people)[counted])),
        "cpu_ms": frame_ms,
        **{f"{part}_ms": ours.mean(part, counted) for part in ours.ms if part != "frame"},
    }
    for name, spent in peers.items():
        told[f"vs_{name}"] = frame_ms / spent.mean("frame", counted)
        told |= {f"{name}_{part}_ms": spent.mean(part, counted) for part in spent.ms}
    return told
