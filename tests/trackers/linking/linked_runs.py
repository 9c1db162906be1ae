"""Runs written by hand: who walks where, and which ids a tracker gave them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, View
from tracking.trackers.linking import Finisher, link_tracks
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    CLOTHES,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    Particles,
    Run,
)
from tracking.tracks.columns import typed

FPS = 20.0
SIDES = ("left", "top", "width", "height")
RED, BLUE = (45.0, 40.0, 25.0, 30.0, 5.0, -10.0), (30.0, 5.0, -30.0, 55.0, 0.0, 5.0)
VIEW = View(
    Camera(
        np.array([[520.0, 0.0, 319.5], [0.0, 520.0, 239.5], [0.0, 0.0, 1.0]]), np.zeros(5), 640, 480
    ),
    Ground(4.0, 40.0),
)

link_run = Finisher(relabel=link_tracks).finish
"""What trackers that link do with a finished run."""


def straight(start: Sequence[float], end: Sequence[float], frames: int) -> NDArray[np.float64]:
    """A way at constant speed: (frames, 2) m."""
    share = np.linspace(0.0, 1.0, frames)[:, None]
    return np.asarray(start) * (1 - share) + np.asarray(end) * share


@dataclass(frozen=True)
class Stretch:
    """Somebody on the way under one id of a tracker.

    Attributes:
        track: the tracker's id. first: frame. way: (frames, 2) m. clothes: CIELAB, upper and lower.
        lost: frames of the way in which nothing was seen, and the place was only predicted.
    """

    track: int
    first: int
    way: NDArray[np.float64]
    clothes: Sequence[float] = RED
    height_m: float = 1.7
    lost: range = range(0)


def run_of(*stretches: Stretch, frames: int = 200, known_tracks: int = 0, seed: int = 1) -> Run:
    """The run of a tracker that measured places within a few centimetres."""
    random = np.random.default_rng(seed)
    parts = [_rows(stretch, random) for stretch in stretches]
    joined = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
    order = np.lexsort((joined["track"], joined["frame"]))
    rows = {name: column[order] for name, column in joined.items()}
    seen = {name: column[~rows["predicted"]] for name, column in rows.items()}
    return Run(
        tracker="stereo-direction",
        settings={"smooth": True},
        seed=0,
        frames=(0, frames),
        tracks=typed(rows, TRACK_COLUMNS),
        detections=typed({**seen, "z": np.full(len(seen["frame"]), 0.9)}, DETECTION_COLUMNS),
        particles=_particles(rows, frames),
        associations=typed(seen, ASSOCIATION_COLUMNS),
        signals=typed(rows, SIGNAL_COLUMNS),
        known_tracks=known_tracks,
    )


def corrected(run: Run, first: int, stop: int) -> Columns:
    """Rows of a run as those that people corrected."""
    rows = (run.tracks["frame"] >= first) & (run.tracks["frame"] < stop)
    return {name: column[rows] for name, column in run.tracks.items()}


def ids_at(run: Run, frame: int) -> dict[int, tuple[float, float]]:
    """Everybody in a frame: place by id."""
    rows = run.tracks["frame"] == frame
    tracks, xs, ys = (run.tracks[name][rows].tolist() for name in ("track", "x", "y"))
    return {track: (x, y) for track, x, y in zip(tracks, xs, ys, strict=True)}


def id_near(run: Run, frame: int, place: Sequence[float]) -> int:
    """Who stands nearest to a place in a frame."""
    there = ids_at(run, frame)
    return min(there, key=lambda track: np.hypot(*np.subtract(there[track], place)))


def _rows(stretch: Stretch, random: np.random.Generator) -> dict[str, NDArray[Any]]:
    count = len(stretch.way)
    place = stretch.way + random.normal(0.0, 0.03, (count, 2))
    box = _in_picture(VIEW.box_of_person(place, stretch.height_m, 0.5))
    frame = stretch.first + np.arange(count)
    lost = np.isin(np.arange(count), stretch.lost)
    speed = np.gradient(stretch.way, axis=0) * FPS
    colours = np.asarray(stretch.clothes) + random.normal(0.0, 2.0, (count, 6))
    colours[lost] = np.nan
    height_m = np.where(lost, np.nan, stretch.height_m + random.normal(0.0, 0.02, count))
    blank = dict.fromkeys(("distance", "colour", "direction", "total", "margin"), np.ones(count))
    return {
        **blank,
        "frame": frame,
        "track": np.full(count, stretch.track),
        **dict(zip(SIDES, box.T, strict=True)),
        "x": place[:, 0],
        "y": place[:, 1],
        "vx": speed[:, 0],
        "vy": speed[:, 1],
        "confidence": np.ones(count),
        "visibility": np.ones(count),
        "predicted": lost,
        **dict(zip(CLOTHES, colours.T, strict=True)),
        "height_m": height_m,
        "spread_m": np.full(count, 0.1),
        "split": np.zeros(count),
    }


def _in_picture(box: NDArray[np.float64]) -> NDArray[np.float64]:
    low = np.clip(box[:, :2], 0, VIEW.camera.size)
    high = np.clip(box[:, :2] + box[:, 2:], 0, VIEW.camera.size)
    return np.concatenate((low, high - low), axis=1)


def _particles(rows: Columns, frames: int) -> Particles:
    """Two for each row."""
    start = np.concatenate(([0], np.cumsum(2 * np.bincount(rows["frame"], minlength=frames))))
    twice = {name: np.repeat(rows[name], 2) for name in ("track", "x", "y")}
    columns = {**twice, "weight": np.full(len(twice["x"]), 0.5)}
    return Particles(start, typed(columns, PARTICLE_COLUMNS))
