"""Decided review items that are open again, as an edit changed what they were about."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from tracking.review import ReviewItem

DecidedAndOpen = tuple[Sequence[ReviewItem], Sequence[ReviewItem]]


def count_reopened(before: DecidedAndOpen, now: DecidedAndOpen, fps: float) -> int:
    """How many decided items are found no more, with a new open one in their place.

    What was decided was said of the tracks as they were: an edit that gives people other ids, or
    moves them, makes another item of the old one.

    Args:
        before, now: the decided and the open items of two searches. fps: frames a second.
    """
    gone = _not_among(before[0], now[0], fps)
    new = _not_among(now[1], before[1], fps) if gone else []
    count = 0
    for one in gone:
        place = next((at for at, other in enumerate(new) if _is_alike(other, one, fps)), None)
        if place is not None:
            del new[place]
            count += 1
    return count


def _not_among(
    items: Sequence[ReviewItem], others: Sequence[ReviewItem], fps: float
) -> list[ReviewItem]:
    by_who: defaultdict[tuple[str, tuple[int, ...]], list[ReviewItem]] = defaultdict(list)
    for one in others:
        by_who[one.kind, one.tracks].append(one)
    return [
        one
        for one in items
        if not any(_is_near(one, other, fps) for other in by_who.get((one.kind, one.tracks), ()))
    ]


def _is_alike(one: ReviewItem, other: ReviewItem, fps: float) -> bool:
    shared = one.kind == other.kind or bool(set(one.tracks) & set(other.tracks))
    return shared and _is_near(one, other, fps)


def _is_near(one: ReviewItem, other: ReviewItem, fps: float) -> bool:
    return abs(one.frame - other.frame) <= fps
