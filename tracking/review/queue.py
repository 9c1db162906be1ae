"""Suspicions in the order they are looked at, without those that are decided."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable

from tracking.review.suspicion import Suspicion
from tracking.tracks import Labels

SAME_S = 1.0
"""A verdict stays with a suspicion that is found again so near to where it was."""


def ranked(suspicions: Iterable[Suspicion], by: str = "worth") -> tuple[Suspicion, ...]:
    """In order: by "worth", the greatest first; by "likelihood", likewise; or by "time"."""
    if by == "time":
        return tuple(sorted(suspicions, key=lambda one: (one.frame, one.tracks, one.kind)))
    if by == "likelihood":
        return tuple(sorted(suspicions, key=lambda one: (-one.likelihood, one.frame, one.tracks)))
    return tuple(sorted(suspicions, key=lambda one: (-one.worth, one.frame, one.tracks, one.kind)))


def open_suspicions(
    suspicions: Iterable[Suspicion], labels: Labels | None, fps: float
) -> tuple[Suspicion, ...]:
    """Those without a verdict that nobody has looked at yet, in the order they come in.

    A verdict is about suspicions of its kind and tracks up to a second from its frame: found again
    after edits elsewhere, they lie where they were, or nearly. What lies in reviewed ranges (of
    all its tracks, at its frame) was looked at.

    Args:
        labels: with verdicts and reviewed ranges; None for none. fps: frames a second.
    """
    if labels is None:
        return tuple(suspicions)
    decided: defaultdict[tuple[str, tuple[int, ...]], list[int]] = defaultdict(list)
    for kind, tracks, frame in sorted(labels.verdicts):
        decided[kind, tracks].append(frame)
    reach = round(SAME_S * fps)
    return tuple(
        one
        for one in suspicions
        if not _is_near(decided.get((one.kind, one.tracks), ()), one.frame, reach)
        and not all(labels.is_reviewed(track, one.frame) for track in one.tracks)
    )


def _is_near(frames: Iterable[int], frame: int, reach: int) -> bool:
    """Whether one of the ascending frames is within reach of another."""
    known = list(frames)
    at = bisect_left(known, frame - reach)
    return at < len(known) and known[at] <= frame + reach
