"""Body parts of one person in one frame: what was said, else where they are likely to be."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from tracking.session import parts_by_now
from tracking.tracks import PART_NAMES, Box, Columns, Labels, PartLabel, Run, TrackTable

_BOX = ("left", "top", "width", "height")
_SHARES = ((0.00, 0.15, 0.50), (0.15, 0.52, 0.95), (0.52, 1.00, 0.85))
"""Top and bottom of head, torso and hip-leg as shares of a standing body's height from the top,
and their widths as shares of the box: chin at 0.87, hip at 0.53 and crotch at 0.47 of the height
from the floor [Drillis1966], each rectangle with a little around it."""

_CARRIED_FRAMES = 250
"""A rectangle that was drawn longer ago says nothing of how somebody holds themselves by now."""


def parts_of(
    labels: Labels, table: TrackTable, run: Run | None, track: int, frame: int
) -> dict[int, tuple[PartLabel, bool]]:
    """By part, the label and whether somebody gave it.

    What nobody labelled is where the run's tracker saw it, else in the box of the person where it
    was in theirs when it was labelled last, else where a box usually has it. Empty where the person
    has no row in the frame and nothing was said.
    """
    given = {
        part: labels.parts[frame, track, part]
        for part in range(len(PART_NAMES))
        if (frame, track, part) in labels.parts
    }
    rows = table.of_track(track, frame, frame + 1)
    guesses = _from_box(rows, track, frame) if len(rows["frame"]) else {}
    guesses = {
        part: replace(guess, box=_carried(labels, table, guess)) for part, guess in guesses.items()
    }
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
            frame: replace(guess, box=_carried(labels, table, guess))
            for at, frame in enumerate(rows["frame"].tolist())
            if all(math.isfinite(rows[name][at]) for name in _BOX)
            for guess in [
                _from_box({name: rows[name][at : at + 1] for name in _BOX}, track, frame)[part]
            ]
        }
    )
    everything = {**guessed, **given}
    return [everything[frame] for frame in sorted(everything)]


def _carried(labels: Labels, table: TrackTable, guess: PartLabel) -> Box:
    """Where a part is that was drawn in an earlier frame: it lies in the person's box as there."""
    frame, track = guess.frame, guess.track
    before = labels.parts.of_track(track, max(0, frame - _CARRIED_FRAMES), frame)
    drawn = [one for one in before if one.part == guess.part and one.source == "person"]
    if not drawn:
        return guess.box
    then, now = _person_box(table, track, drawn[-1].frame), _person_box(table, track, frame)
    if then is None or now is None:
        return guess.box
    left, top, width, height = drawn[-1].box
    wider, higher = now[2] / then[2], now[3] / then[3]
    return (
        now[0] + (left - then[0]) * wider,
        now[1] + (top - then[1]) * higher,
        width * wider,
        height * higher,
    )


def _person_box(table: TrackTable, track: int, frame: int) -> Box | None:
    """A person's box; None where they have none with a size."""
    rows = table.of_track(track, frame, frame + 1)
    if not len(rows["frame"]):
        return None
    left, top, width, height = (float(rows[name][0]) for name in _BOX)
    if not (math.isfinite(left + top) and 0 < width < math.inf and 0 < height < math.inf):
        return None
    return left, top, width, height


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
