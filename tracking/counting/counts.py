"""Everything counted at once: lines and regions, step by step."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from tracking.arrays import Integers
from tracking.counting.occupancy import Occupancy, occupancy
from tracking.counting.passages import Passages, passages
from tracking.counting.steps import PAPER_STEP_S, Steps
from tracking.errors import CountingError
from tracking.setting import setting
from tracking.tracks.labels import CountingLine, Region


@dataclass(frozen=True, slots=True)
class CountSettings:
    """How people are counted; see `passages` for the jitter."""

    step_s: float = setting(
        PAPER_STEP_S, "s", (0.001, 3600.0), "Length of a time step; higher: fewer, longer steps"
    )
    jitter_m: float = setting(
        0.0,
        "m",
        (0.0, 5.0),
        "Ignore re-crossings within this distance of a line on the floor; higher: fewer passages",
    )
    jitter_px: float = setting(
        0.0,
        "px",
        (0.0, 500.0),
        "Ignore re-crossings within this distance of a line in the image; higher: fewer passages",
    )


class NotOnFloorError(CountingError):
    """What is to be counted lies on the floor, and nobody knows where people are there."""


@dataclass(frozen=True, slots=True, eq=False)
class LineCount:
    """One line through time.

    Attributes:
        line: which one.
        forward, backward: (k,) passages in each step.
    """

    line: CountingLine
    forward: Integers
    backward: Integers

    @property
    def totals(self) -> tuple[int, int]:
        """How many went forward in all, and how many backward."""
        return int(self.forward.sum()), int(self.backward.sum())


@dataclass(frozen=True, slots=True, eq=False)
class Counts:
    """What was counted.

    Attributes:
        steps: how time is cut. settings: in which way it was counted.
        lines, regions: in the order they were asked for.
        passages: each of them; `line` is the number in lines.
    """

    steps: Steps
    settings: CountSettings
    lines: tuple[LineCount, ...]
    regions: tuple[Occupancy, ...]
    passages: Passages


def count(
    columns: Mapping[str, ArrayLike],
    fps: float,
    frame_count: int,
    lines: Sequence[CountingLine] = (),
    regions: Sequence[Region] = (),
    settings: CountSettings | None = None,
) -> Counts:
    """Passages over lines and people inside regions, of any tracker's or corrected tracks.

    Args:
        columns: `frame, track`, `x, y` on the floor and boxes; what is unknown is NaN.
        fps: frames a second. frame_count: of the recording.

    Raises:
        CountingError: see `check_countable`, `passages` and `occupancy`.
    """
    settings = settings if settings is not None else CountSettings()
    check_countable(columns, lines, regions)
    frames = np.asarray(columns["frame"])
    stop = max(frame_count, int(frames.max(initial=-1)) + 1)
    steps = Steps.of(stop, fps, settings.step_s)
    found = passages(columns, fps, lines, jitter_m=settings.jitter_m, jitter_px=settings.jitter_px)
    of_lines = tuple(
        _by_step(line, found.of_line(number), steps) for number, line in enumerate(lines)
    )
    of_regions = occupancy(columns, fps, regions, stop, step_s=settings.step_s)
    return Counts(steps, settings, of_lines, of_regions, found)


def check_countable(
    columns: Mapping[str, ArrayLike], lines: Sequence[CountingLine], regions: Sequence[Region]
) -> None:
    """Refuse to count on the floor people of whom no place on the floor is known.

    Raises NotOnFloorError, which names what was drawn there.
    """
    drawn: tuple[CountingLine | Region, ...] = (*lines, *regions)
    on_floor = [item.name for item in drawn if not item.in_picture]
    if not on_floor or not len(np.asarray(columns["frame"])):
        return
    if "x" not in columns or not np.isfinite(np.asarray(columns["x"], np.float64)).any():
        raise NotOnFloorError(
            "{name!r} lies on the floor, where these tracks have no places",
            "name the recording's calibration and track again, or draw it in the image",
            name=on_floor[0],
        )


def _by_step(line: CountingLine, found: Passages, steps: Steps) -> LineCount:
    step = steps.of_time(found.time_s)
    forward = np.bincount(step[found.forward], minlength=len(steps))
    return LineCount(line, forward, np.bincount(step, minlength=len(steps)) - forward)
