"""Decided review items that are open again, as an edit changed what they were about."""

from __future__ import annotations

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
    gone = [one for one in before[0] if not _is_among(one, now[0], fps)]
    new = [one for one in now[1] if not _is_among(one, before[1], fps)]
    count = 0
    for one in gone:
        place = next((at for at, other in enumerate(new) if _is_alike(other, one, fps)), None)
        if place is not None:
            del new[place]
            count += 1
    return count


def _is_among(item: ReviewItem, others: Sequence[ReviewItem], fps: float) -> bool:
    return any(
        (one.kind, one.tracks) == (item.kind, item.tracks) and _is_near(one, item, fps)
        for one in others
    )


def _is_alike(one: ReviewItem, other: ReviewItem, fps: float) -> bool:
    shared = one.kind == other.kind or bool(set(one.tracks) & set(other.tracks))
    return shared and _is_near(one, other, fps)


def _is_near(one: ReviewItem, other: ReviewItem, fps: float) -> bool:
    return abs(one.frame - other.frame) <= fps
