"""Stretches of one label along the rows of a picture."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.silhouettes import AnyLabels

Places = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Runs:
    """Stretches of equal places, row after row; none goes over a row's end.

    Attributes:
        start: (n,) place of the first one, counted along the rows.
        length: (n,) places. label: (n,) what all of them bear. row: (n,) of the picture.
    """

    start: Places
    length: Places
    label: AnyLabels
    row: Places

    @classmethod
    def along(cls, labels: AnyLabels) -> Runs:
        """All runs of a picture (rows, columns), those that bear 0 among them."""
        places = labels.ravel()
        begins = np.empty(places.size, np.bool_)
        np.not_equal(places[1:], places[:-1], out=begins[1:])
        begins[:: labels.shape[1]] = True
        start = np.flatnonzero(begins)
        length = np.diff(start, append=places.size)
        return cls(start, length, places.take(start), start // labels.shape[1])

    @property
    def stop(self) -> Places:
        """(n,) the place behind the last one."""
        return self.start + self.length

    def chosen(self, kept: NDArray[np.bool_]) -> Runs:
        """Some of the runs."""
        rows = np.flatnonzero(kept)
        return Runs(*(getattr(self, name).take(rows) for name in self.__slots__))

    def beside(self) -> tuple[Places, Places]:
        """(n,) the runs next to the left and to the right in the same row; itself at its ends."""
        same = (self.row[1:] == self.row[:-1]).astype(np.intp)
        own = np.arange(len(self.row))
        left, right = own.copy(), own
        left[1:] -= same
        right[:-1] += same
        return left, right
