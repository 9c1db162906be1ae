"""Changes colours of people who look alike and are seen together in a finished run."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.core.colours.co_occurrence import FAR, CoOccurrences
from tracking.tracks import Columns

Floats = NDArray[np.float64]
Choose = Callable[[int, Floats], int]
"""A place of the palette for an id, from how much each colour (colours,) is taken."""


class ColourConflicts:
    """Finds who looks like somebody seen together with, and has the one with fewer rows change.

    Args:
        given: place of the palette of each id. rows: of the run, by frame. co_occurrences: in it.
        alike: (colours, colours) how much alike every two look. limit: from here on too much.
        soon: so many frames after somebody was seen last their colour still counts.
        choose: see `Choose`.
    """

    def __init__(
        self,
        given: Mapping[int, int],
        rows: Columns,
        co_occurrences: CoOccurrences,
        *,
        alike: Floats,
        limit: float,
        soon: int,
        choose: Choose,
    ) -> None:
        stays = [one for one in co_occurrences.stays if one[2] in given]
        self._first, self._last, self._ids = np.array(stays, np.int64).reshape(-1, 3).T
        self._places = np.array([given[one] for one in self._ids.tolist()], np.intp)
        self._at = {one: at for at, one in enumerate(self._ids.tolist())}
        self._frames = _frames_by_track(rows)
        self._co_occurrences, self._choose = co_occurrences, choose
        self._alike, self._limit, self._soon = alike, limit, soon

    def places(self) -> dict[int, int]:
        """Place of the palette of each id of the run that had one; most as they were."""
        for at, last in enumerate(self._last.tolist()):
            stop = int(np.searchsorted(self._first, last, "right"))
            looks = self._alike[self._places[at], self._places[at + 1 : stop]]
            for other in (at + 1 + np.flatnonzero(looks > self._limit)).tolist():
                if self._clash(at, other):
                    self._change(max(at, other, key=self._yields))
        return dict(zip(self._ids.tolist(), self._places.tolist(), strict=True))

    def _clash(self, one: int, other: int) -> bool:
        """Whether two look alike who are seen in the same frame."""
        looks = self._alike[self._places[one], self._places[other]]
        if looks * self._nearness(one)[other] <= self._limit:
            return False
        ours, theirs = (self._frames[int(self._ids[at])] for at in (one, other))
        return bool(np.isin(ours, theirs, assume_unique=True).any())

    def _yields(self, at: int) -> tuple[int, int]:
        """Who has fewer rows comes last, of equals the later id."""
        track = int(self._ids[at])
        return -len(self._frames[track]), track

    def _change(self, at: int) -> None:
        """Choose anew in view of all who are there; what is no better leaves it as it was."""
        there = self._first <= self._last[at] + self._soon
        there &= self._last >= self._first[at] - self._soon
        there[at] = False
        much = self._nearness(at)[there]
        taken: Floats = np.bincount(self._places[there], much, len(self._alike)).astype(float)
        new, old = self._choose(int(self._ids[at]), taken), self._places[at]
        if (self._alike[new] * taken).max() < (self._alike[old] * taken).max():
            self._places[at] = new

    def _nearness(self, at: int) -> Floats:
        """How near everybody (n,) comes, from `FAR` to 1."""
        near = np.full(len(self._ids), FAR)
        others, much = self._co_occurrences.near_of(int(self._ids[at]))
        for other, how in zip(others.tolist(), much.tolist(), strict=True):
            if other in self._at:
                near[self._at[other]] = how
        return near


def _frames_by_track(rows: Columns) -> dict[int, NDArray[np.int32]]:
    order = np.argsort(rows["track"], kind="stable")
    ids, first = np.unique(rows["track"][order], return_index=True)
    ends = pairwise([*first.tolist(), len(order)])
    frames = rows["frame"][order]
    return {one: frames[slice(*end)] for one, end in zip(ids.tolist(), ends, strict=True)}
