"""People walking on a floor, as a run with everything that is noticed of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.editing import apply_change, plan_swap
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    CLOTHES,
    DETECTION_COLUMNS,
    PART_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    Labels,
    Particles,
    Run,
    TrackTable,
    empty,
)

FPS = 20.0
SIZE = (640, 480)


@dataclass(frozen=True)
class Walk:
    """One track.

    Attributes:
        path: (frames, 2) m. start: the first frame.
        looks: height in m, then CIELAB of the upper and of the lower body.
        predicted: frames in which nothing was matched.
        box: left and top of the boxes, px; the middle of the picture unless told otherwise.
    """

    path: NDArray[np.float64]
    start: int = 0
    looks: Sequence[float] = (1.7, 50.0, 0.0, 0.0, 50.0, 0.0, 0.0)
    predicted: Sequence[int] = ()
    box: tuple[float, float] = (300.0, 200.0)


def straight(start: Sequence[float], velocity: Sequence[float], frames: int) -> NDArray[np.float64]:
    """A path at constant velocity, m/s."""
    return np.asarray(start) + np.arange(frames)[:, None] / FPS * np.asarray(velocity)


RED = (1.75, 40.0, 50.0, 30.0, 20.0, 0.0, 0.0)
BLUE = (1.65, 40.0, 10.0, -50.0, 80.0, 0.0, 5.0)


def crossing(frames: int = 160) -> list[Walk]:
    """A red and a blue person who cross at right angles in the middle, 0.2 m from each other."""
    half = frames / 2 / FPS
    return [
        Walk(straight((-half, 6.0), (1.0, 0.0), frames), looks=RED),
        Walk(straight((0.2, 6.0 - half), (0.0, 1.0), frames), looks=BLUE),
    ]


def made_run(walks: Sequence[Walk], seed: int = 3101, noise_m: float = 0.005) -> Run:
    """The walks as tracks 1, 2, ... with signals and associations."""
    random = np.random.default_rng(seed)
    rows = [_rows(track, walk, random, noise_m) for track, walk in enumerate(walks, 1)]
    columns = {name: np.concatenate([each[name] for each in rows]) for name in rows[0]}
    order = np.lexsort((columns["track"], columns["frame"]))
    columns = {name: column[order] for name, column in columns.items()}
    seen = ~columns["predicted"].astype(bool)
    stop = int(columns["frame"][-1]) + 1 if len(order) else 0
    return Run(
        tracker="made up",
        settings={},
        seed=seed,
        frames=(0, stop),
        tracks=_typed(columns, TRACK_COLUMNS),
        detections=empty(DETECTION_COLUMNS),
        particles=Particles(np.zeros(stop + 1, np.int64), empty(PARTICLE_COLUMNS)),
        associations=_typed({n: c[seen] for n, c in columns.items()}, ASSOCIATION_COLUMNS),
        parts=empty(PART_COLUMNS),
        signals=_typed(columns, SIGNAL_COLUMNS),
    )


def _rows(
    track: int, walk: Walk, random: np.random.Generator, noise_m: float
) -> dict[str, NDArray[np.float64]]:
    count = len(walk.path)
    frame = walk.start + np.arange(count)
    place = walk.path + random.normal(0.0, noise_m, walk.path.shape)
    predicted = np.isin(frame, list(walk.predicted))
    looks = np.array(walk.looks) + random.normal(size=(count, 7)) * (0.01, 1, 1, 1, 1, 1, 1)
    looks[predicted] = np.nan
    values = {name: np.zeros(count) for name in {**TRACK_COLUMNS, **ASSOCIATION_COLUMNS}}
    values |= dict(zip(("height_m", *CLOTHES), looks.T, strict=True))
    values |= {"frame": frame, "track": np.full(count, track), "predicted": predicted}
    values |= {"x": place[:, 0], "y": place[:, 1], "visibility": np.ones(count)}
    values |= {"left": np.full(count, walk.box[0]), "top": np.full(count, walk.box[1])}
    values |= {"width": np.full(count, 40.0), "height": np.full(count, 120.0)}
    values |= {"spread_m": np.full(count, 0.1), "split": np.zeros(count)}
    return {**values, "margin": np.full(count, np.nan)}


def _typed(columns: dict, types: object) -> dict:
    return {name: columns[name].astype(dtype) for name, dtype in types.items()}


def with_column(run: Run, table: str, name: str, where: NDArray[np.bool_], value: float) -> None:
    """Write a value into a column of a run that was just made."""
    getattr(run, table)[name][where] = value


def swapped(run: Run, one: int, other: int, frame: int) -> TrackTable:
    """The run's tracks with two changed over from a frame on."""
    table = TrackTable(run.tracks)
    apply_change(table, Labels(), plan_swap(table, one, other, frame))
    return table
