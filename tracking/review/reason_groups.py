"""Reasons about the same people at the same time made one place to look at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.review.core.findings import FlaggedPlaces, peaks
from tracking.tracks import row_keys

Rows = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Reasons:
    """The reasons of all kinds put one below the other.

    Attributes:
        kinds: names. kind: (n,) number among them.
        first, second, frame, strength, figure: (n,) see `FlaggedPlaces`.
        pair: (n,) one number for both tracks, whichever is first.
        weight: (n,) what it counts for against reasons of other kinds.
    """

    kinds: tuple[str, ...]
    kind: Rows
    first: Rows
    second: Rows
    frame: Rows
    strength: Floats
    figure: Floats
    pair: Rows
    weight: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Places:
    """Places to look at, a row each.

    Attributes:
        leader: (k,) the reason that decides about frame and tracks.
        place, reason: (m,) which reasons speak for which place, the leader among them.
        strength: (k, kinds) of the strongest reason of each kind.
    """

    leader: Rows
    place: Rows
    reason: Rows
    strength: Floats


def stack_findings(found: Sequence[FlaggedPlaces], weights: Sequence[float]) -> Reasons:
    """All that was found; weights: of a reason of full strength, by kind."""
    number = np.repeat(np.arange(len(found)), [len(each) for each in found])
    first, second, frame, strength, figure = (
        np.concatenate([getattr(each, name) for each in found])
        for name in ("first", "second", "frame", "strength", "figure")
    )
    lower, higher = np.minimum(first, second), np.maximum(first, second)
    return Reasons(
        kinds=tuple(each.kind for each in found),
        kind=number,
        first=first,
        second=second,
        frame=frame,
        strength=strength,
        figure=figure,
        # Small numbers, so that they fit a key beside a frame.
        pair=np.unique(row_keys(higher, lower), return_inverse=True)[1],
        weight=np.asarray(weights, np.float64)[number] * strength,
    )


def join_places(reasons: Reasons, near: int) -> Places:
    """Join what is at most `near` frames apart and about the same people.

    Reasons about the same two people come together first, led by the weightiest. What speaks for
    one of them alone then joins the weightiest pair it suits in time, which explains it; what
    suits none stays on its own.
    """
    order = np.lexsort((reasons.frame, reasons.pair))
    two, one = order[reasons.second[order] > 0], order[reasons.second[order] == 0]
    pairs = _leaders(reasons, two, near)
    links = [
        _near(reasons, pairs, reasons.pair, (two, reasons.pair), near),
        *(
            _near(reasons, pairs, side, (one, reasons.first), near)
            for side in (reasons.first, reasons.second)
        ),
    ]
    taken = np.concatenate([rows for _, rows in links[1:]])
    left = one[~np.isin(one, taken)]
    alone = _leaders(reasons, left, near)
    place, row = _near(reasons, alone, reasons.first, (left, reasons.first), near)
    links.append((place + len(pairs), row))
    leader = np.concatenate((pairs, alone))
    place, row = _each_once(
        reasons, leader, *(np.concatenate(parts) for parts in zip(*links, strict=True))
    )
    strength = np.zeros((len(leader), len(reasons.kinds)))
    np.maximum.at(strength, (place, reasons.kind[row]), reasons.strength[row])
    return Places(leader, place, row, strength)


def _each_once(reasons: Reasons, leader: Rows, place: Rows, reason: Rows) -> tuple[Rows, Rows]:
    """The links, of reasons about one track only the one to the weightiest place."""
    order = np.lexsort((-reasons.weight[leader][place], reason))
    first = np.diff(reason[order], prepend=-1) != 0
    kept = order[first | (reasons.second[reason[order]] > 0)]
    return place[kept], reason[kept]


def _leaders(reasons: Reasons, rows: Rows, near: int) -> Rows:
    """The weightiest of what is near each other; rows by pair, then frame."""
    best = peaks(reasons.pair[rows], reasons.frame[rows], reasons.weight[rows], near)
    return rows[best]


def _near(
    reasons: Reasons, leaders: Rows, wanted: Rows, members: tuple[Rows, Rows], near: int
) -> tuple[Rows, Rows]:
    """Which members are near which leaders: numbers of leaders, and rows of the members.

    Args:
        wanted: (n,) of each leader, what a member must have in its column.
        members: rows, by pair and frame, and the column (n,) that tells them apart.
    """
    rows, column = members
    ordered = np.argsort(row_keys(column[rows], reasons.frame[rows]), kind="stable")
    rows = rows[ordered]
    known = row_keys(column[rows], reasons.frame[rows])
    low = np.searchsorted(known, row_keys(wanted[leaders], reasons.frame[leaders] - near))
    high = np.searchsorted(known, row_keys(wanted[leaders], reasons.frame[leaders] + near), "right")
    count = high - low
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    return np.repeat(np.arange(len(leaders)), count), rows[np.repeat(low, count) + within]
