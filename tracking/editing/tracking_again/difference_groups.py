"""Small differences folded, so that a list of them is one that people read."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from tracking.editing.tracking_again.counterparts import HERE_M
from tracking.editing.tracking_again.difference_text import Stretch

_SMALL_S, _SMALL_FRAMES = 0.2, 4
"""What is shorter says little by itself."""
_REACH_S, _REACH_FRAMES = 1.0, 20
"""So far apart, what is small joins its neighbour."""


def merge_small(stretches: Iterable[Stretch], fps: float | None) -> Iterator[Stretch]:
    """The stretches with small ones joined to their neighbours of the same track and kind.

    Identities stay as they are. A step aside that is both short and no farther than where the
    same person may stand is left out: nobody would look at it.

    Args:
        fps: frames a second; without it durations are counted as at 20.
    """
    small = _SMALL_FRAMES if fps is None else round(_SMALL_S * fps)
    reach = _REACH_FRAMES if fps is None else round(_REACH_S * fps)
    last: dict[tuple[object, ...], Stretch] = {}
    for one in sorted(stretches, key=lambda each: each.start):
        if one.kind == "identity":
            yield one
            continue
        key = (one.kind, one.track, one.other, one.protected)
        before = last.get(key)
        if before is not None and _is_near(before, one, small, reach):
            one = _joined(before, one)
        elif before is not None and not _is_trifle(before, small):
            yield before
        last[key] = one
    yield from (one for one in last.values() if not _is_trifle(one, small))


def _is_near(one: Stretch, other: Stretch, small: int, reach: int) -> bool:
    """Whether one of the two is small and the other one next to it."""
    return min(one.rows, other.rows) < small and other.start - one.end <= reach


def _joined(one: Stretch, other: Stretch) -> Stretch:
    return replace(
        one,
        end=max(one.end, other.end),
        rows=one.rows + other.rows,
        metres=max(one.metres, other.metres),
    )


def _is_trifle(one: Stretch, small: int) -> bool:
    return one.kind == "moved" and one.rows < small and 0.0 < one.metres < HERE_M
