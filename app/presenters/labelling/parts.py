"""Body parts of one person in one frame: what was said, else where they are likely to be."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from app.presenters.document.belonging import ids_after_edits
from app.presenters.parts.history import parts_behind
from tracking.tracks import PART_NAMES, Columns, Labels, PartLabel, Run, TrackTable

Box = tuple[float, float, float, float]

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
    guesses = (
        {}
        if not len(rows["frame"])
        else {
            **_from_box(rows, track, frame),
            **_from_run(run, table, track, frame),
        }
    )
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
    seen = _boxes_seen(parts_behind(rows, run), part)
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


def _boxes_seen(parts: Columns, part: int) -> list[PartLabel]:
    """One part's rectangles in `PART_COLUMNS`, where they are any."""
    numbers = np.column_stack([parts[name] for name in ("cx", "cy", "width", "height")])
    good = np.isfinite(numbers).all(axis=1) & (numbers[:, 2:] > 0).all(axis=1)
    return [
        PartLabel(
            int(parts["frame"][at]),
            int(parts["track"][at]),
            part,
            (u - width / 2, v - height / 2, width, height),
            source="tracker",
        )
        for at in np.flatnonzero(good & (parts["part"] == part)).tolist()
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


def _from_run(run: Run | None, table: TrackTable, track: int, frame: int) -> dict[int, PartLabel]:
    """Where the tracker saw the parts of whoever bears the id by now."""
    if run is None or not len(run.parts["frame"]):
        return {}
    low, high = np.searchsorted(run.parts["frame"], (frame, frame + 1))
    first, last = np.searchsorted(run.tracks["frame"], (frame, frame + 1))
    of_run = {name: column[first:last] for name, column in run.tracks.items()}
    now = ids_after_edits(of_run, table.of_frame(frame))
    seen = {}
    for at in range(int(low), int(high)):
        if now.get(int(run.parts["track"][at])) != track:
            continue
        centre_u, centre_v, width, height = (
            float(run.parts[name][at]) for name in ("cx", "cy", "width", "height")
        )
        part = int(run.parts["part"][at])
        if math.isfinite(centre_u + centre_v + width + height) and width > 0 and height > 0:
            box = (centre_u - width / 2, centre_v - height / 2, width, height)
            seen[part] = PartLabel(frame, track, part, box, source="tracker")
    return seen
