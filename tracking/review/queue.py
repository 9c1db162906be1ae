"""Review items in the order they are looked at, without those that are decided."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable
from heapq import heapify, heappop, heappush

import numpy as np

from tracking.review.review_item import ReviewItem
from tracking.tracks import Labels, TrackTable

SAME_S = 1.0
"""A verdict stays with a review item that is found again so near to where it was."""


_FREE = 1e-3
"""Frames a review item counts for that costs none."""


def rank(items: Iterable[ReviewItem], by: str = "yield") -> tuple[ReviewItem, ...]:
    """In order.

    Args:
        by: "yield", most mistakes found for the time watched; "worth" or "likelihood", the greatest
            first; or "time".
    """
    if by == "yield":
        return _by_yield(rank(items, "likelihood"))
    if by == "time":
        return tuple(sorted(items, key=lambda one: (one.frame, one.tracks, one.kind)))
    if by == "likelihood":
        return tuple(sorted(items, key=lambda one: (-one.likelihood, one.frame, one.tracks)))
    return tuple(sorted(items, key=lambda one: (-one.worth, one.frame, one.tracks, one.kind)))


def _by_yield(items: tuple[ReviewItem, ...]) -> tuple[ReviewItem, ...]:
    """Next always the one with the most likelihood for each frame not watched yet.

    What has been watched by then comes free. What a review item yields only grows as others are
    watched, by those that overlap it: only their figures are worked out again.
    """
    watched = np.zeros(max((one.end for one in items), default=0), np.bool_)
    order = sorted(range(len(items)), key=lambda row: items[row].start)
    starts = [items[row].start for row in order]
    longest = max((one.end - one.start for one in items), default=0)
    cost = [max(one.end - one.start, _FREE) for one in items]
    heap = [(-one.likelihood / cost[row], row) for row, one in enumerate(items)]
    heapify(heap)
    taken: dict[int, ReviewItem] = {}
    while heap:
        _, row = heappop(heap)
        if row in taken:
            continue
        one = taken[row] = items[row]
        watched[one.start : one.end] = True
        low, high = bisect_left(starts, one.start - longest), bisect_left(starts, one.end)
        for near in order[low:high]:
            other = items[near]
            if near in taken or other.end <= one.start:
                continue
            new = int(np.count_nonzero(~watched[other.start : other.end]))
            if new < cost[near]:
                cost[near] = max(new, _FREE)
                heappush(heap, (-other.likelihood / cost[near], near))
    return tuple(taken.values())


def filter_undecided(
    items: Iterable[ReviewItem],
    labels: Labels | None,
    fps: float,
    table: TrackTable | None = None,
) -> tuple[ReviewItem, ...]:
    """Those without a verdict that nobody has looked at yet, in the order they come in.

    A verdict is about review items of its kind and tracks up to a second from its frame: found
    again after edits elsewhere, they lie where they were, or nearly. Items in reviewed ranges
    (of all their tracks, at their frame) are left out.

    Args:
        labels: with verdicts and reviewed ranges; None for none. fps: frames a second.
        table: the tracks. A track without a row at the frame, as it was lost before, was looked
            at where its nearest row was; without a table, only where its range covers the frame.
    """
    if labels is None:
        return tuple(items)
    decided: defaultdict[tuple[str, tuple[int, ...]], list[int]] = defaultdict(list)
    for kind, tracks, frame in sorted(labels.verdicts):
        decided[kind, tracks].append(frame)
    reach = round(SAME_S * fps)
    return tuple(
        one
        for one in items
        if not _is_near(decided.get((one.kind, one.tracks), ()), one.frame, reach)
        and not all(_is_reviewed(labels, table, track, one.frame) for track in one.tracks)
    )


def _is_reviewed(labels: Labels, table: TrackTable | None, track: int, frame: int) -> bool:
    """Whether a track was looked at in a frame, or in its nearest one where it has no row there."""
    if labels.is_reviewed(track, frame):
        return True
    if table is None or not any(seen.track == track for seen in labels.reviewed):
        return False
    frames = table.frames_of_track(track)
    if not len(frames):
        return False
    return labels.is_reviewed(track, int(frames[np.abs(frames - frame).argmin()]))


def _is_near(frames: Iterable[int], frame: int, reach: int) -> bool:
    """Whether one of the ascending frames is within reach of another."""
    known = list(frames)
    at = bisect_left(known, frame - reach)
    return at < len(known) and known[at] <= frame + reach
