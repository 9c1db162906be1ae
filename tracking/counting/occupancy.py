"""People inside regions: how many, how dense, how fast, step by step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from tracking.arrays import Floats, Integers
from tracking.counting.paths import Paths
from tracking.counting.polygons import area, inside
from tracking.counting.speeds import Velocities, lengths
from tracking.counting.steps import PAPER_STEP_S, Steps
from tracking.tracks.labels import Region


@dataclass(frozen=True, slots=True, eq=False)
class Occupancy:
    """One region through time.

    Attributes:
        region: which one.
        people: (k,) how many are inside in the frame at which each step begins.
        density: (k,) people a square metre then; NaN for a region in the picture.
        mean_speed: (k,) of these people, metres a second on the floor; NaN where nobody is inside
            or no speed is known.
    """

    region: Region
    people: Integers
    density: Floats
    mean_speed: Floats

    @property
    def person_steps(self) -> int:
        """The sum of the people inside over all steps, as [Yoneji2013] compares its counts.

        A person who stands inside when three steps begin counts three times.
        """
        return int(self.people.sum())


def occupancy(
    columns: Mapping[str, ArrayLike],
    fps: float,
    regions: Sequence[Region],
    frame_count: int = 0,
    *,
    step_s: float = PAPER_STEP_S,
    frame_step: int | None = None,
) -> tuple[Occupancy, ...]:
    """People inside each region in steps of step_s.

    Only places of a frame itself count: nobody is put inside in a gap of their track.

    Args:
        columns: `frame, track` and `x, y` (floor) or the box (regions in the picture).
        frame_count: of the recording; 0: up to the last row.
        frame_step: of speeds; None: a quarter of a second.

    Raises:
        CountingError: a step shorter than a frame, a track twice in one frame.
    """
    frames = np.asarray(columns["frame"])
    stop = max(frame_count, int(frames.max(initial=-1)) + 1)
    steps = Steps.of(stop, fps, step_s)
    if not regions:
        return ()
    floor = Paths.on_floor(columns)
    some_in_picture = any(region.in_picture for region in regions)
    feet = Paths.in_picture(columns) if some_in_picture else floor
    walking = Velocities(floor, fps, frame_step)
    return tuple(
        _through_time(region, feet if region.in_picture else floor, floor, walking, steps)
        for region in regions
    )


def density_of(region: Region, people: Floats | Integers) -> Floats:
    """People a square metre; NaN for a region in the picture, as nobody knows its size."""
    if region.in_picture:
        return np.full(np.shape(people), np.nan)
    found: Floats = np.asarray(people, np.float64) / area(region.polygon)
    return found


def _through_time(
    region: Region, paths: Paths, floor: Paths, walking: Velocities, steps: Steps
) -> Occupancy:
    """One region, of paths in its own frame of reference; speeds are those on the floor."""
    at_steps = np.flatnonzero(steps.begins_at(paths.frame))
    within = at_steps[inside(region.polygon, paths.place[at_steps])]
    step = np.searchsorted(steps.frame, paths.frame[within])
    people = np.bincount(step, minlength=len(steps))
    speed = np.full(len(within), np.nan)
    rows = within if paths is floor else _same_rows(paths, within, floor)
    speed[rows >= 0] = lengths(walking.at(rows[rows >= 0]))
    return Occupancy(region, people, density_of(region, people), _mean(speed, step, len(steps)))


def _mean(values: Floats, step: Integers, count: int) -> Floats:
    """(count,) the mean of the finite values of each step; NaN where there are none."""
    known = np.isfinite(values)
    total = np.bincount(step[known], values[known], minlength=count)
    number = np.bincount(step[known], minlength=count)
    mean: Floats = np.divide(total, number, out=np.full(count, np.nan), where=number > 0)
    return mean


def _same_rows(feet: Paths, rows: Integers, floor: Paths) -> Integers:
    """(k,) where rows in the picture stand among those on the floor; -1: nowhere."""
    stride = int(max(feet.frame.max(initial=0), floor.frame.max(initial=0))) + 1
    asked = feet.track[rows] * stride + feet.frame[rows]
    known = floor.track * stride + floor.frame
    if not len(known):
        return np.full(len(rows), -1)
    at = np.minimum(np.searchsorted(known, asked), len(known) - 1)
    return np.where(known[at] == asked, at, -1)
