"""What SLEAP's files have in common: boxes around points, and the names of tracks."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tracking.formats.label_text import label_of
from tracking.tracks import LARGEST_NUMBER, TrackLabel
from tracking.translation import msg

AROUND_POINTS = msg("boxes are around the points SLEAP found, not around whole people")
NO_TRACKS = msg(
    "the file has no tracks: those at one place of its lists are taken as one track, look for swaps"
)
UNTRACKED = (msg("instance without a track"), msg("instances without a track"))
USUAL_NAME = "track_{}"
"""What SLEAP calls a track itself, by its number from 0."""
_USUAL = re.compile(r"track_(\d{1,9})")


def labels_of(names: list[str], usual: str, first: int) -> dict[int, TrackLabel]:
    """Labels of tracks 1 on by their names, where these say more than the usual numbering does.

    usual: what the tool calls a track itself; first: the number of the first.
    """
    return {
        number: label_of(name)
        for number, name in enumerate(names, start=1)
        if name and name != usual.format(number - 1 + first)
    }


def ids_of(names: Sequence[str]) -> dict[str, int]:
    """Ids of tracks by name: as SLEAP numbers them, or in this order where one is called otherwise.

    The same tracks have the same ids so, whichever of SLEAP's files they are read from.
    """
    usual = [_USUAL.fullmatch(name) for name in names]
    numbers = [int(found[1]) + 1 for found in usual if found is not None]
    if len(set(numbers)) == len(names) and max(numbers, default=0) <= LARGEST_NUMBER:
        return dict(zip(names, numbers, strict=True))
    return {name: number for number, name in enumerate(names, start=1)}


def boxes_around(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 4) the smallest boxes around the nodes (n, k, 2) that were seen."""
    seen = np.isfinite(points).all(axis=2, keepdims=True)
    low = np.where(seen, points, np.inf).min(axis=1)
    high = np.where(seen, points, -np.inf).max(axis=1)
    return np.concatenate([low, high - low], axis=1)


def places_in(frame: NDArray[np.int64]) -> NDArray[np.int64]:
    """(n,) how many rows of the same frame stand before each."""
    order = np.argsort(frame, kind="stable")
    _, first, counts = np.unique(frame[order], return_index=True, return_counts=True)
    places = np.empty(len(frame), np.int64)
    places[order] = np.arange(len(frame)) - np.repeat(first, counts)
    return places
