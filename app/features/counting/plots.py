"""The plots of one line or region, with a value for every frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.core.i18n import tr
from app.features.counting.scene import (
    BACKWARD_COLOUR,
    FORWARD_COLOUR,
    PEOPLE_COLOUR,
    SPEED_COLOUR,
    CountCurve,
    CountPlot,
    Floats,
)
from tracking.counting import Counts, Occupancy, Passages, Steps

Flags = NDArray[np.bool_]


def plots_of(
    counts: Counts, number: int, frame_count: int, tracked: tuple[int, int]
) -> tuple[CountPlot, ...]:
    """Those of the line, or behind the lines the region, with this number; none for another.

    Args:
        tracked: the half-open range of frames anything is known of; beyond it nothing is drawn.
    """
    place = number - len(counts.lines)
    if 0 <= number < len(counts.lines):
        plots = _of_line(counts, number, frame_count)
    elif 0 <= place < len(counts.regions):
        plots = _of_region(counts.regions[place], counts.steps, frame_count)
    else:
        plots = ()
    return tuple(
        replace(plot, curves=tuple(_within(curve, tracked) for curve in plot.curves))
        for plot in plots
    )


def _within(curve: CountCurve, tracked: tuple[int, int]) -> CountCurve:
    """The curve without what lies outside the frames that were tracked."""
    frame = np.arange(len(curve.values))
    known = (frame >= tracked[0]) & (frame < tracked[1])
    return replace(curve, values=np.where(known, curve.values, np.nan))


def _of_line(counts: Counts, number: int, frame_count: int) -> tuple[CountPlot, ...]:
    line, steps = counts.lines[number], counts.steps
    found = counts.passages.of_line(number)
    ahead, back = (_so_far(found, way, frame_count) for way in (found.forward, ~found.forward))
    per_step = tr("Per {step:g} s", step=steps.step_s)
    forward, backward = (
        _each_frame(part.astype(np.float64), steps, frame_count)
        for part in (line.forward, line.backward)
    )
    return (
        CountPlot(tr("So far"), "", _both_ways(ahead, back), 1.0),
        CountPlot(per_step, "", _both_ways(forward, backward), 1.0),
    )


def _of_region(region: Occupancy, steps: Steps, frame_count: int) -> tuple[CountPlot, ...]:
    people = _each_frame(region.people.astype(np.float64), steps, frame_count)
    speed = _each_frame(region.mean_speed, steps, frame_count)
    plots = [
        CountPlot(tr("People"), "", (CountCurve(tr("inside"), people, PEOPLE_COLOUR),), 1.0),
    ]
    if not region.region.in_picture:
        density = _each_frame(region.density, steps, frame_count)
        curve = CountCurve(tr("density"), density, PEOPLE_COLOUR)
        plots.append(CountPlot(tr("Density"), "1/m²", (curve,), 0.1))
    curve = CountCurve(tr("mean speed"), speed, SPEED_COLOUR)
    return (*plots, CountPlot(tr("Mean speed"), "m/s", (curve,), 1.0))


def _both_ways(ahead: Floats, back: Floats) -> tuple[CountCurve, CountCurve]:
    return (
        CountCurve(tr("forward"), ahead, FORWARD_COLOUR),
        CountCurve(tr("backward"), back, BACKWARD_COLOUR, dashed=True),
    )


def _so_far(found: Passages, chosen: Flags, frame_count: int) -> Floats:
    """(frames,) how many of some passages had happened in each frame."""
    frames = np.minimum(found.frame[chosen], frame_count - 1)
    each = np.bincount(frames, minlength=frame_count)
    total: Floats = np.cumsum(each).astype(np.float64)
    return total


def _each_frame(values: Floats, steps: Steps, frame_count: int) -> Floats:
    """(frames,) each step's value in all frames of it."""
    if not len(steps):
        return np.full(frame_count, np.nan)
    step = steps.of_time(np.arange(frame_count) / steps.fps)
    spread: Floats = values[step]
    return spread
