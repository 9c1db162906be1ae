"""Labels made from rendered truth: whether a tracker's rectangles hold the parts they should."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats
from tracking.failure.labelled_samples import were_hidden
from tracking.tracks import LARGEST_NUMBER, PARTS, Columns, PartLabel, row_keys
from tracking.tracks.boxes import corners_of_boxes
from tracking.tracks.on_part import (
    LEAST_COVERED,
    MOST_FOREIGN,
    corners_of,
    covered_share,
    foreign_share,
)
from tracking.truth import TrueParts
from tracking.truth.table import Rows

EVERY_S = 0.15
"""Labels closer together say the same."""
_CLEAR = 0.1
"""How far from half and half a share must be to be clear: what is neither is dropped."""
_BEGINNING_S = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class _Pairs:
    """Every rectangle of a run with every true part of its kind in its frame; k rows.

    Attributes:
        row: of the run. track, frame: (k,) of the rectangle. person: (k,) of the true part.
        outside: (k,) share of the rectangle outside of the part. covered: share of the part.
        seen: (k,) whether the camera sees anything of the part.
    """

    row: Rows
    track: Rows
    frame: Rows
    person: Rows
    outside: Floats
    covered: Floats
    seen: Flags


def labels_from_truth(
    truth: TrueParts, parts: Columns, fps: float, every_s: float = EVERY_S
) -> list[PartLabel]:
    """What truth says of a run's rectangles.

    A track is meant to follow the person on whom its rectangles lie in its first second, whoever
    it follows later. A rectangle is right while less than half of it lies outside of the box of
    that part of that person: it is labelled on its part where clearly less than half does, off it
    where clearly more, and not at all in between or where the part is hidden from the camera.

    Nothing is said of two kinds of moments. While the tracker says that a part is occluded nobody
    asks the detector about that person. And where all three rectangles lie on somebody else, the
    track has changed hands: how the parts stand to each other cannot tell that.

    Args:
        parts: `PART_COLUMNS` of a run. fps: of the recording.
        every_s: between labels of one person.

    [ZhaoLee2009] sections 4.2 and 5.2; their labels are made by eye, from "falling inside" and
    "not covering".
    """
    pairs = _pairs(truth, parts)
    if not len(pairs.row):
        return []
    followed = _followed(pairs, parts, fps)
    own = np.array([followed.get(one, 0) for one in pairs.track.tolist()]) == pairs.person
    begun = _begun(pairs, parts)
    due = (pairs.frame - begun) % max(1, round(every_s * fps)) == 0
    on, off = _on(pairs), pairs.outside > MOST_FOREIGN + _CLEAR
    judged = ~were_hidden(pairs.track, pairs.frame, parts) & ~_elsewhere(pairs, own)
    kept = own & due & pairs.seen & judged
    return [
        _label(parts, int(pairs.row[at]), bool(on[at])) for at in np.flatnonzero(kept & (on | off))
    ]


def people_followed(truth: TrueParts, parts: Columns, fps: float) -> dict[int, int]:
    """The true person each track follows, as `labels_from_truth` takes it; by track."""
    return _followed(_pairs(truth, parts), parts, fps)


def _followed(pairs: _Pairs, parts: Columns, fps: float) -> dict[int, int]:
    """The person each track lies on most in its first second; none for one that lies on nobody."""
    early = pairs.frame < _begun(pairs, parts) + max(1, round(_BEGINNING_S * fps))
    followed = np.column_stack((pairs.track, pairs.person))[early]
    each, inverse = np.unique(followed, axis=0, return_inverse=True)
    inside = np.bincount(inverse.reshape(-1), 1.0 - pairs.outside[early], len(each))
    best: dict[int, tuple[float, int]] = {}
    for (track, who), share in zip(each.tolist(), inside.tolist(), strict=True):
        if share > best.get(track, (0.0, 0))[0]:
            best[track] = (share, who)
    return {track: who for track, (_, who) in best.items()}


def _pairs(truth: TrueParts, parts: Columns) -> _Pairs:
    ours, theirs = ((each << 2) for each in (parts["frame"].astype(np.int64), truth.frame))
    ours, theirs = ours | parts["part"], theirs | truth.part
    order = np.argsort(theirs, kind="stable")
    low, high = (np.searchsorted(theirs[order], ours, side) for side in ("left", "right"))
    count = high - low
    row = np.repeat(np.arange(len(ours)), count)
    turn = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
    true = order[np.repeat(low, count) + turn]
    ours_at, theirs_at = _corners(parts)[row], corners_of_boxes(truth.box[true])
    outside, covered = foreign_share(ours_at, theirs_at), covered_share(ours_at, theirs_at)
    track, frame = (parts[name][row].astype(np.int64) for name in ("track", "frame"))
    return _Pairs(row, track, frame, truth.person[true], outside, covered, truth.seen[true] > 0)


def _corners(parts: Columns) -> Floats:
    return corners_of(np.column_stack([parts[name] for name in ("cx", "cy", "width", "height")]))


def _begun(pairs: _Pairs, parts: Columns) -> Rows:
    """(k,) the first frame of each pair's track."""
    tracks, inverse = np.unique(parts["track"], return_inverse=True)
    first = np.full(len(tracks), LARGEST_NUMBER + 1, np.int64)
    np.minimum.at(first, inverse.reshape(-1), parts["frame"])
    return np.asarray(first[inverse.reshape(-1)[pairs.row]])


def _on(pairs: _Pairs) -> Flags:
    """(k,) rectangles clearly on the part."""
    return (pairs.outside < MOST_FOREIGN - _CLEAR) & (pairs.covered >= LEAST_COVERED)


def _elsewhere(pairs: _Pairs, own: Flags) -> Flags:
    """(k,) moments in which all rectangles of the track lie on the parts of somebody else."""
    strange = _on(pairs) & ~own
    moment = row_keys(pairs.track, pairs.frame)
    each = np.column_stack((moment, pairs.person))[strange]
    who, count = np.unique(each, axis=0, return_counts=True)
    return np.isin(moment, who[count == PARTS, 0])


def _label(parts: Columns, row: int, on: bool) -> PartLabel:
    x, y, width, height = (float(parts[name][row]) for name in ("cx", "cy", "width", "height"))
    box = (x - width / 2, y - height / 2, width, height)
    frame, track, part = (int(parts[name][row]) for name in ("frame", "track", "part"))
    return PartLabel(frame, track, part, box, on, "truth", "truth")
