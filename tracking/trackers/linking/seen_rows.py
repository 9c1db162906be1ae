"""The rows of a run in which people were seen, one track behind the other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.embeddings import embeddings_of_rows
from tracking.trackers.linking.encounters import Encounters, find_encounters
from tracking.tracks.columns import CLOTHES, SIDES, Columns, boxes_of, places_of
from tracking.tracks.run import Run

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]

APPEARANCE = (*CLOTHES, "height_m")
BODY_M = (1.7, 0.5)
"""Height and width of a usual body."""
EDGE_SHARE = 0.006
"""Of the picture's size: boxes that come so close to its edge are cut off by it."""
_NEAR_M, _FAR_M = 0.08, 0.001
"""How much a measured place errs: close by, and times the square of the range."""
_FASTEST_M_S, _STEP_ERRORS = 4.0, 5.0
"""A step longer than this, beyond so many errors of a place, is nobody's."""
_WHOLE = 0.85
"""Share of a body in the picture from which on its clothes are seen."""
_WELL_SEEN = 0.5
"""Visibility from which on what is measured of somebody is theirs."""
_IN_FRONT = 0.8
"""Visibility from which on clothes are this person's even close to others: those are behind."""
_GLIMPSED = 0.2
"""Visibility from which on what shows of somebody's clothes tells a little."""
_TALL = 0.7
"""Of a usual body's height in the picture: the halves of a lower box are not those of a body."""
_NEAR_ROWS = 3
"""So long a box flickers at the edge."""


@dataclass(frozen=True, slots=True)
class SeenRows:
    """Rows with a detection and a place, ordered by track and frame.

    Attributes:
        frame, track: (n,) with the ids of the tracker. row: (n,) of the run's tracks.
        place: (n, 2) m, where the detection stood.
        appearance: (n, 7) `APPEARANCE`, NaN where not known, or not of this person's whole body.
        glimpsed: (n, 6) `CLOTHES` of people half hidden by others, NaN elsewhere.
        embedding: (n, k) of an appearance network, in the axes of this run; NaN where not known,
            or not of this person; k = 0 without such a network.
        at_edge: (n,) the box is cut off by the picture's edge.
        alone: (n,) nobody else is near or in front.
    """

    frame: Integers
    track: Integers
    row: NDArray[np.intp]
    place: Floats
    appearance: Floats
    glimpsed: Floats
    embedding: Floats
    at_edge: Flags
    alone: Flags

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.frame)


def find_seen_rows(run: Run, view: View) -> tuple[SeenRows, Encounters]:
    """The rows of a run that were seen, and who came near whom."""
    tracks = run.tracks
    place = places_of(tracks)
    box = boxes_of(tracks)
    known = np.isfinite(place).all(axis=1) & np.isfinite(box).all(axis=1)
    order = np.lexsort((tracks["frame"], tracks["track"]))
    row = order[(known & ~tracks["predicted"])[order]]
    meetings = find_encounters(tracks["frame"], tracks["track"], place, box, known)
    _measure(place, box, run.detections, tracks, row)
    shown = tracks["visibility"][row]
    alone = ~meetings.met[row] & (shown >= _WELL_SEEN)
    edge = _at_edge(box[row], view)
    whole = ~_near(_cut_off(box[row], view)) & _tall(box[row], place[row], view)
    clear = alone | (shown >= _IN_FRONT)
    noticed = _appearance(run.signals, tracks)[row]
    appearance = _where(whole & clear, noticed)
    glimpsed = _where(whole & ~clear & (shown >= _GLIMPSED), noticed[:, : len(CLOTHES)])
    frame, track = tracks["frame"][row].astype(np.int64), tracks["track"][row].astype(np.int64)
    embedding = embeddings_of_rows(run.embeddings, frame, track, whole & clear)
    looks = appearance, glimpsed, embedding
    return SeenRows(frame, track, row, place[row], *looks, edge, alone), meetings


def is_track_start(seen: SeenRows) -> Flags:
    """(n,) rows where tracks begin."""
    return np.append(True, np.diff(seen.track) != 0)[: len(seen)]


def is_after_gap(seen: SeenRows, gap_s: float, fps: float) -> Flags:
    """(n,) rows after a gap, or a step too long."""
    elapsed_s = np.diff(seen.frame, prepend=seen.frame[:1]) / fps
    step = np.diff(seen.place, axis=0, prepend=seen.place[:1])
    return np.asarray((elapsed_s > gap_s) | ~may_have_walked(step, seen.place, elapsed_s))


def may_have_walked(step: Floats, place: Floats, elapsed_s: Floats | float) -> Flags:
    """(n,) whether steps (n, 2) m to measured places (n, 2) in this time are somebody's."""
    error_m = _STEP_ERRORS * place_errors(place)
    return np.asarray(np.hypot(*step.T) <= _FASTEST_M_S * elapsed_s + error_m)


def keys(frame: NDArray[np.integer], track: NDArray[np.integer]) -> Integers:
    """One number for each frame and track."""
    return np.asarray(frame.astype(np.int64) * 2**32 + track.astype(np.int64))


def place_errors(place: Floats) -> Floats:
    """(n,) m, how much measured places err."""
    return np.asarray(_NEAR_M + _FAR_M * np.square(place).sum(axis=1))


def _measure(
    place: Floats, box: Floats, detections: Columns, tracks: Columns, row: NDArray[np.intp]
) -> None:
    """Put the detections' places and boxes in the rows that were matched with one.

    The filter's own are smoothed forwards, the boxes drawn to an outline remembered.
    """
    own = keys(tracks["frame"][row], tracks["track"][row])
    order = np.argsort(own)
    own, row = own[order], row[order]
    known = [np.isfinite(detections[name]) for name in ("x", "y", *SIDES)]
    matched = np.flatnonzero(np.logical_and.reduce(known) & (detections["track"] > 0))
    theirs = keys(detections["frame"][matched], detections["track"][matched])
    at = np.minimum(np.searchsorted(own, theirs), max(len(own) - 1, 0))
    hit = own[at] == theirs if len(own) else np.zeros(len(theirs), bool)
    at, matched = row[at[hit]], matched[hit]
    place[at] = places_of(detections, matched)
    box[at] = boxes_of(detections, matched)


def _appearance(signals: Columns, tracks: Columns) -> Floats:
    """(rows of the tracks, 7) what the run noticed of each; NaN where it noticed nothing."""
    if len(signals["frame"]) != len(tracks["frame"]):
        return np.full((len(tracks["frame"]), len(APPEARANCE)), np.nan)
    return np.stack([signals[name].astype(np.float64) for name in APPEARANCE], axis=1)


def _where(rows: Flags, values: Floats) -> Floats:
    """The values (n, k) of some rows, NaN in the others."""
    return np.where(rows[:, None], values, np.nan)


def _near(edge: Flags) -> Flags:
    """(n,) whether a row within a few is cut off by the edge: the box flickers there."""
    width = 2 * _NEAR_ROWS + 1
    upto = np.cumsum(np.pad(edge, (_NEAR_ROWS + 1, _NEAR_ROWS)))
    return np.asarray(upto[width:] > upto[:-width])


def _cut_off(box: Floats, view: View) -> Flags:
    """(n,) whether a box is cut off by the picture's edge, otherwise than at the head."""
    size = np.array(view.camera.size, float)
    margin = EDGE_SHARE * size.max()
    low, high = np.clip(box[:, :2], 0.0, size), np.clip(box[:, :2] + box[:, 2:], 0.0, size)
    share = np.prod(high - low, axis=1) / np.prod(box[:, 2:], axis=1)
    beside = (low[:, 0] <= margin) | (high >= size - 1 - margin).any(axis=1)
    return np.asarray(beside | (share < _WHOLE))


def _tall(box: Floats, place: Floats, view: View) -> Flags:
    """(n,) whether a box is high enough to be of somebody's whole body, and no part of it."""
    return np.asarray(box[:, 3] >= _TALL * view.box_of_person(place, *BODY_M)[:, 3])


def _at_edge(box: Floats, view: View) -> Flags:
    """(n,) whether a box touches the picture's edge."""
    size = np.array(view.camera.size, float)
    margin = EDGE_SHARE * size.max()
    high = box[:, :2] + box[:, 2:]
    return np.asarray((box[:, :2] <= margin).any(axis=1) | (high >= size - 1 - margin).any(axis=1))
