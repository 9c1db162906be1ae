"""From one part failure to the next."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from app.features.parts.part_views import by_rule
from app.features.parts.scene import Failure
from tracking.tracks import Columns

Ids = Callable[[int], dict[int, int]]
"""For a frame, the ids that a run's tracks have there by now."""


class PartFailures:
    """Where parts of a run begin to fail, in the order of time.

    Asked for again and again while somebody walks them, they are looked up once a run.
    """

    def __init__(self, parts: Columns) -> None:
        self.parts = parts
        first = first_failures(parts)
        order = np.lexsort((parts["part"][first], parts["track"][first], parts["frame"][first]))
        self._rows = first[order]
        self._frames = parts["frame"][self._rows].astype(np.int64)

    def __len__(self) -> int:
        return len(self._rows)

    def walk(
        self, frame: int, step: int, ids: Ids, track: int = 0, last: Failure | None = None
    ) -> Failure | None:
        """The next (1) or previous (-1) one from a frame; None where there is no further one.

        Args:
            track: of one person alone; 0: of anybody.
            last: where the walk is, so that of several in one frame each is gone to.
        """
        if last is not None and last.frame == frame:
            start = last.place + step
        elif step > 0:
            start = int(np.searchsorted(self._frames, frame, "right"))
        else:
            start = int(np.searchsorted(self._frames, frame)) - 1
        places = range(start, len(self) if step > 0 else -1, step)
        return next(self._owned(places, ids, track), None)

    def _owned(self, places: range, ids: Ids, track: int) -> Iterator[Failure]:
        for place in places:
            row = int(self._rows[place])
            frame = int(self._frames[place])
            owner = ids(frame).get(int(self.parts["track"][row]), 0)
            if owner > 0 and track in (0, owner):
                rule = by_rule(True, float(self.parts["score"][row]))
                yield Failure(frame, owner, int(self.parts["part"][row]), place, rule)


def first_failures(parts: Columns) -> NDArray[np.int64]:
    """The rows at which a part fails that had not failed in the frame before."""
    failed = np.flatnonzero(parts["failed"])
    if not len(failed):
        return failed
    order = np.lexsort((parts["frame"][failed], parts["part"][failed], parts["track"][failed]))
    rows = failed[order]
    track, part, frame = (parts[name][rows].astype(np.int64) for name in ("track", "part", "frame"))
    begins = np.ones(len(rows), bool)
    begins[1:] = (np.diff(track) != 0) | (np.diff(part) != 0) | (np.diff(frame) != 1)
    return np.asarray(rows[begins])
