"""Tracklets of few rows put in where they fit.

It is greedy association, after the optimal one of the long tracklets.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

import numpy as np

from tracking.trackers.linking.links import Links, Rows
from tracking.trackers.linking.tracklets import Tracklets


def insert_short(following: Rows, links: Links, pieces: Tracklets, short: Rows) -> Rows:
    """(t,) who follows whom, with the short tracklets in: (k,) those not linked yet.

    Each goes, in the order of frames, to the person and the place in it where it costs least, if
    that is clearly less than elsewhere and than nothing.
    """
    order = short[np.argsort(pieces.first.frame[short], kind="stable")]
    people = _People(following, links, order.tolist())
    for piece in order.tolist():
        people.put(piece)
    return people.following


_MARGIN = 2.0
"""Log-odds: who is doubtful in a few rows is nobody there."""


class _People:
    """Who follows whom, while tracklets are put in.

    Attributes:
        following: (t,) the tracklet after each; -1 for none.
    """

    def __init__(self, following: Rows, links: Links, loose: list[int]) -> None:
        self.following = following.copy()
        self._leading = np.full(len(following), -1)
        led = np.flatnonzero(following >= 0)
        self._leading[following[led]] = led
        self._loose = set(loose)
        self._cost: dict[tuple[int, int], float] = {}
        self._before: dict[int, list[int]] = defaultdict(list)
        self._after: dict[int, list[int]] = defaultdict(list)
        concerned = np.isin(links.end, loose) | np.isin(links.start, loose)
        concerned |= following[links.end] == links.start
        some = links.select(concerned)
        for end, start, cost in zip(
            some.end.tolist(), some.start.tolist(), some.cost.tolist(), strict=True
        ):
            self._cost[end, start] = cost
            self._before[start].append(end)
            self._after[end].append(start)

    def put(self, piece: int) -> None:
        """Put in a tracklet where it costs least, if anywhere."""
        self._loose.discard(piece)
        places = sorted(self._places(piece))
        nowhere = (0.0, -1, -1)
        (cost, end, start), (next_best, _, _) = [*places, nowhere, nowhere][:2]
        if cost > min(next_best, 0.0) - _MARGIN:
            return
        for one, other in ((end, piece), (piece, start)):
            if one >= 0 and other >= 0:
                self.following[one] = other
                self._leading[other] = one

    def _places(self, piece: int) -> Iterator[tuple[float, int, int]]:
        """What it costs to put it between two that follow each other; -1 where there is none."""
        for end in self._before[piece]:
            start = int(self.following[end])
            if end in self._loose:
                continue
            if start < 0:
                yield self._cost[end, piece], end, -1
            elif (piece, start) in self._cost:
                detour = self._cost[end, piece] + self._cost[piece, start]
                yield detour - self._cost.get((end, start), 0.0), end, start
        for start in self._after[piece]:
            if start not in self._loose and self._leading[start] < 0:
                yield self._cost[piece, start], -1, start
