"""Frames of tracks that are covered, while tracks hand rows to each other."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable

import numpy as np

from tracking.editing.core.change import Stretches, no_stretches
from tracking.editing.log.traces import Handed

Spans = tuple[list[int], list[int]]
"""Starts and ends of half-open ranges, ascending and apart from each other."""


class Coverage:
    """Which frames of which tracks are covered; made for thousands of small steps."""

    def __init__(self) -> None:
        """Nothing is covered."""
        self._spans: dict[int, Spans] = {}

    @property
    def stretches(self) -> Stretches:
        """(k, 3) track, start, end of all that is covered, sorted by track, then start."""
        parts = [
            np.column_stack((np.full(len(starts), track), starts, ends))
            for track, (starts, ends) in sorted(self._spans.items())
            if starts
        ]
        return np.concatenate([no_stretches(), *parts])

    def add(self, track: int, start: int, end: int) -> None:
        """Cover a track's frames too."""
        starts, ends = self._of(track)
        # Those that overlap or touch it become one with it.
        first, stop = bisect_left(ends, start), bisect_right(starts, end)
        if first < stop:
            start, end = min(start, starts[first]), max(end, ends[stop - 1])
        starts[first:stop], ends[first:stop] = [start], [end]

    def hand(self, handed: Iterable[Handed]) -> None:
        """Move along with rows that tracks hand to each other, all at once."""
        moved = [(to, self._cut(track, start, end)) for track, to, start, end in handed]
        for to, parts in moved:
            self._put(to, parts)

    def _of(self, track: int) -> Spans:
        spans = self._spans.get(track)
        if spans is None:
            spans = self._spans[track] = ([], [])
        return spans

    def _put(self, track: int, parts: Spans) -> None:
        """Cover several ranges of a track too."""
        starts, ends = self._of(track)
        if not parts[0]:
            return
        place = bisect_right(ends, parts[0][0])
        if place == bisect_left(starts, parts[1][-1]):
            # Nothing is covered between them yet, which is what a swap leaves.
            starts[place:place], ends[place:place] = parts
            self._join(track, place + len(parts[0]))
            self._join(track, place)
            return
        for start, end in zip(*parts, strict=True):
            self.add(track, start, end)

    def _join(self, track: int, place: int) -> None:
        """Make a range and the one before it one, where they touch."""
        starts, ends = self._spans[track]
        if 0 < place < len(starts) and ends[place - 1] == starts[place]:
            del starts[place], ends[place - 1]

    def _cut(self, track: int, start: int, end: int) -> Spans:
        """Take a range out of a track; gives what was covered of it."""
        starts, ends = self._of(track)
        first, stop = bisect_right(ends, start), bisect_left(starts, end)
        if first >= stop:
            return [], []
        inner = starts[first:stop], ends[first:stop]
        before = [(inner[0][0], start)] if inner[0][0] < start else []
        after = [(end, inner[1][-1])] if inner[1][-1] > end else []
        starts[first:stop] = [low for low, _ in (*before, *after)]
        ends[first:stop] = [high for _, high in (*before, *after)]
        inner[0][0], inner[1][-1] = max(inner[0][0], start), min(inner[1][-1], end)
        return inner
