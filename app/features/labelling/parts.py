"""Body parts of one person in one frame: what was said, else where they are likely to be."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from tracking.session import parts_by_now
from tracking.tracks import PART_NAMES, Columns, Labels, PartLabel, Run, TrackTable

_BOX = ("left", "top", "width", "height")
_SHARES = ((0.00, 0.15, 0.50), (0.15, 0.52, 0.95), (0.52, 1.00, 0.85))
"""Top and bottom of head, torso and hip-leg as shares of a standing body's height from the top,
and their widths as shares of the box: chin at 0.87, hip at 0.53 and crotch at 0.47 of the height
from the floor [Drillis1966], each rectangle with a little around it."""


def parts_of(
    labels: Labels, table: TrackTable, run: Run | None, track: int, frame: int
) -> dict[int, tuple[PartLabel, bool]]:
    """By part, the label and whether somebody gave it.

    What nobody labelled is where the run's tracker saw it, else where the box of the person
    would have it. Empty where the person has no row in the frame and nothing was said.
    """
    given = {
        part: labels.parts[frame, track, part]
        for part in range(len(PART_NAMES))
        if (frame, track, part) in labels.parts
    }
    rows = table.of_track(track, frame, frame + 1)
    guesses = _from_box(rows, track, frame) if len(rows["frame"]) else {}
    seen = _boxes_seen(parts_by_now(table, run, [track], (frame, frame + 1)))
    guesses |= {label.part: label for label in seen}
    parts = sorted({*given, *guesses})
    return {
        part: (given[part], True) if part in given else (guesses[part], False) for part in parts
    }


def parts_over(
    labels: Labels,
    table: TrackTable,
    run: Run | None,
    person: tuple[int, int],
    frames: tuple[int, int],
) -> list[PartLabel]:
    """A track's part (both in `person`) in each of some frames, as `parts_of` gives it.

    Where the tracker saw the person's parts, frames in which it did not are left out: nobody can
    say of many frames at once whether a mere guess is right.
    """
    track, part = person
    rows = table.of_track(track, *frames)
    given = {one.frame: one for one in labels.parts.of_track(track, *frames) if one.part == part}
    boxes = _boxes_seen(parts_by_now(table, run, [track], frames))
    seen = [label for label in boxes if label.part == part]
    guessed = (
        {label.frame: label for label in seen}
        if seen
        else {
            frame: _from_box({name: rows[name][at : at + 1] for name in _BOX}, track, frame)[part]
            for at, frame in enumerate(rows["frame"].tolist())
            if all(math.isfinite(rows[name][at]) for name in _BOX)
        }
    )
    everything = {**guessed, **given}
    return [everything[frame] for frame in sorted(everything)]


def _boxes_seen(parts: Columns) -> list[PartLabel]:
    """The rectangles in `PART_COLUMNS`, where they are any."""
    numbers = np.column_stack([parts[name] for name in ("cx", "cy", "width", "height")])
    good = np.isfinite(numbers).all(axis=1) & (numbers[:, 2:] > 0).all(axis=1)
    return [
        PartLabel(
            int(parts["frame"][at]),
            int(parts["track"][at]),
            int(parts["part"][at]),
            (u - width / 2, v - height / 2, width, height),
            source="tracker",
        )
        for at in np.flatnonzero(good).tolist()
        for u, v, width, height in [numbers[at].tolist()]
    ]


def _from_box(rows: Mapping[str, np.ndarray], track: int, frame: int) -> dict[int, PartLabel]:
    left, top, width, height = (float(rows[name][0]) for name in _BOX)
    if not math.isfinite(left + top + width + height):
        return {}
    return {
        part: PartLabel(
            frame,
            track,
            part,
            (
                left + width * (1 - across) / 2,
                top + height * upper,
                width * across,
                height * (lower - upper),
            ),
        )
        for part, (upper, lower, across) in enumerate(_SHARES)
    }
