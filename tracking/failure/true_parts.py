"""Labels made from rendered truth: whether a tracker's rectangles hold the parts they should."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.failure.features import Floats
from tracking.tracks import LARGEST_NUMBER, Columns, PartLabel

TRUE_PARTS = "truth_parts.csv"
"""The name of the file beside a rendered recording."""

EVERY_S = 0.15
"""Labels closer together say the same."""
_CLEAR = 0.1
"""How far from half and half a share must be to be clear: what is neither is dropped."""
_LEAST_COVERED = 0.05
"""A dot inside a part holds nothing else and still is not on it."""
_BEGINNING_S = 1.0
_HEADER = ("frame", "id", "part", "left", "top", "width", "height", "visible_pixels")
_NAMES = {"head": 0, "torso": 1, "hip_leg": 2}
_MOST_BYTES = 1 << 30

Rows = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class TrueParts:
    """Where the parts of people really are; n rows, sorted by frame.

    Attributes:
        frame, person, part: (n,). box: (n, 4) left, top, width, height px, hidden or not.
        seen: (n,) pixels of it that are seen.
    """

    frame: Rows
    person: Rows
    part: Rows
    box: Floats
    seen: Rows


def read_true_parts(path: Path) -> TrueParts:
    """The parts of a rendered recording's people.

    Raises FormatError where the file is missing or no such table; names the line.
    """
    try:
        if path.stat().st_size > _MOST_BYTES:
            raise FormatError(f"{path} is larger than {_MOST_BYTES >> 20} MiB; give a shorter one")
        with path.open(encoding="utf-8-sig", newline="") as stream:
            rows = list(_rows(path, stream))
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error
    except (UnicodeDecodeError, csv.Error) as error:
        raise FormatError(f"{path} is no table of true parts ({error})") from error
    table = np.array(rows, float).reshape(-1, 8)
    table = table[np.argsort(table[:, 0], kind="stable")]
    whole = table[:, [0, 1, 2, 7]].astype(np.int64).T
    return TrueParts(whole[0], whole[1], whole[2], table[:, 3:7], whole[3])


def _rows(path: Path, stream: Iterable[str]) -> Iterator[tuple[float, ...]]:
    lines = csv.reader(stream)
    if tuple(next(lines, ())) != _HEADER:
        raise FormatError(f"{path}, line 1: the columns are not {','.join(_HEADER)}")
    for line in lines:
        try:
            frame, person, part, *box, seen = line
            row = (int(frame), int(person), _NAMES[part], *map(float, box), int(seen))
            if len(row) != len(_HEADER) or not all(map(math.isfinite, row)):
                raise ValueError("a number is missing")
            if not (0 <= row[0] <= LARGEST_NUMBER and 0 < row[1] <= LARGEST_NUMBER):
                raise ValueError("frame or id")
            if min(row[5], row[6]) < 0 or not 0 <= row[7] <= LARGEST_NUMBER:
                raise ValueError("less than nothing, or far too many pixels")
        except (ValueError, KeyError, OverflowError) as error:
            raise FormatError(
                f"{path}, line {lines.line_num}: {','.join(line)[:60]!r} is no true part ({error})"
            ) from error
        yield row


def labels_from_truth(
    truth: TrueParts, parts: Columns, fps: float, every_s: float = EVERY_S
) -> list[PartLabel]:
    """What truth says of a run's rectangles.

    A track is meant to follow the person on whom its rectangles lie in its first second, whoever
    it follows later. A rectangle is right while less than half of it lies outside of the box of
    that part of that person: it is labelled on its part where clearly less than half does, off it
    where clearly more, and not at all in between, where the part is hidden from the camera, and
    where the tracker says that it is occluded.

    Args:
        parts: `PART_COLUMNS` of a run. fps: of the recording.
        every_s: between labels of one person.

    [ZhaoLee2009] sections 4.2 and 5.2; their labels are made by eye, from "falling inside" and
    "not covering".
    """
    row, true = _pairs(truth, parts)
    if not len(row):
        return []
    outside, covered = _shares(_boxes(parts)[row], truth.box[true])
    track, frame = parts["track"][row].astype(np.int64), parts["frame"][row].astype(np.int64)
    first = dict(zip(*_first_frames(parts), strict=True))
    begun = np.array([first[one] for one in track.tolist()], np.int64)
    early = frame < begun + max(1, round(_BEGINNING_S * fps))
    followed = _followed(track[early], truth.person[true][early], 1.0 - outside[early])
    own = np.array([followed.get(one, 0) for one in track.tolist()]) == truth.person[true]
    chosen = own & ((frame - begun) % max(1, round(every_s * fps)) == 0) & (truth.seen[true] > 0)
    if "occluded" in parts:
        chosen &= ~parts["occluded"][row]
    on = (outside < 0.5 - _CLEAR) & (covered >= _LEAST_COVERED)
    off = outside > 0.5 + _CLEAR
    return [_label(parts, int(row[at]), bool(on[at])) for at in np.flatnonzero(chosen & (on | off))]


def _pairs(truth: TrueParts, parts: Columns) -> tuple[Rows, Rows]:
    """Every rectangle of the run with every true part of its kind in its frame, as rows of both."""
    ours, theirs = ((each << 2) for each in (parts["frame"].astype(np.int64), truth.frame))
    ours, theirs = ours | parts["part"], theirs | truth.part
    order = np.argsort(theirs, kind="stable")
    low, high = (np.searchsorted(theirs[order], ours, side) for side in ("left", "right"))
    count = high - low
    row = np.repeat(np.arange(len(ours)), count)
    turn = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    return row, order[np.repeat(low, count) + turn]


def _boxes(parts: Columns) -> Floats:
    size = np.column_stack((parts["width"], parts["height"]))
    return np.concatenate((np.column_stack((parts["cx"], parts["cy"])) - size / 2, size), axis=1)


def _shares(boxes: Floats, true: Floats) -> tuple[Floats, Floats]:
    """(k,) share of boxes outside of the true ones, and share of the true ones they cover."""
    low = np.maximum(boxes[:, :2], true[:, :2])
    high = np.minimum(boxes[:, :2] + boxes[:, 2:], true[:, :2] + true[:, 2:])
    common = np.maximum(high - low, 0.0).prod(axis=1)
    areas = [np.maximum(each[:, 2:].prod(axis=1), 1e-9) for each in (boxes, true)]
    return 1.0 - common / areas[0], common / areas[1]


def _first_frames(parts: Columns) -> tuple[list[int], list[int]]:
    """The tracks and the first frame of each."""
    tracks, inverse = np.unique(parts["track"], return_inverse=True)
    first = np.full(len(tracks), LARGEST_NUMBER + 1, np.int64)
    np.minimum.at(first, inverse.reshape(-1), parts["frame"])
    return tracks.tolist(), first.tolist()


def _followed(track: Rows, person: Rows, inside: Floats) -> dict[int, int]:
    """The person each track lies on most; none for one that lies on nobody."""
    best: dict[int, tuple[float, int]] = {}
    pairs, inverse = np.unique(np.column_stack((track, person)), axis=0, return_inverse=True)
    total = np.bincount(inverse.reshape(-1), inside, len(pairs))
    for (one, who), share in zip(pairs.tolist(), total.tolist(), strict=True):
        if share > best.get(one, (0.0, 0))[0]:
            best[one] = (share, who)
    return {one: who for one, (_, who) in best.items()}


def _label(parts: Columns, row: int, on: bool) -> PartLabel:
    x, y, width, height = (float(parts[name][row]) for name in ("cx", "cy", "width", "height"))
    box = (x - width / 2, y - height / 2, width, height)
    frame, track, part = (int(parts[name][row]) for name in ("frame", "track", "part"))
    return PartLabel(frame, track, part, box, on, "truth", "truth")
