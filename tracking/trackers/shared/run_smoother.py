"""A finished run looked over once more, from both ends."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Chains, robust_levels, robust_paths, slopes, trust
from tracking.geometry import View
from tracking.trackers.shared.clear_sides import clear_sides
from tracking.tracks.columns import SIDES, Columns, boxes_of, places_of
from tracking.tracks.run import Run

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Rows = NDArray[np.intp]

PATH_MEMORY_S = 0.14
"""Constant velocity disturbed by 0.5 m²/s³, measured 20 times a second."""
_OUTLINE_MEMORY_S = 0.45
"""About a step: longer, and a turning body is followed late; shorter, and two seen as one are."""
_NEAR_M, _FAR_M = 0.06, 0.001
"""How much a measured place errs: close by, and times the square of the range."""
_PATH_OUTLIER = 2.0
"""In errors of a measured place."""
_OUTLINE_OUTLIER_M = (0.14, 0.07, 0.14, 0.07)
"""Arms and legs swing sideways; head and feet do not."""
_BODY = ((0.1, 0.2), (1.35, 0.25), (1.7, 0.08))
"""Feet, shoulders and head as level discs: height over the floor and radius, in metres."""
_OWN_BOX = 0.85
"""Weight of the box seen, where it suits the outline."""
_CLEAR_OUTLIER_M = 0.2
"""So far off its outline a side is still believed where nobody else is near it."""
_LEAST_SHOWN = 0.05
_MATCHED = ("frame", "track", "x", "y", "left", "width")
_BATCH_ROWS = 100_000
"""Smoothed at a time; longer tracks are batches by themselves."""


@dataclass(frozen=True, slots=True)
class _Paths:
    """The rows of a run's tracks that stand on the floor, one track behind the other.

    Attributes:
        rows: (n,) of the run's tracks. chains: their frames and tracks.
        columns: of these rows. measured: (n,) a detection was matched.
        enclosed: (n,) between a track's first and last measured row, these included.
        clear: (n, 2) nobody else is near the left, the right side of the box.
    """

    rows: Rows
    chains: Chains
    columns: Columns
    measured: Flags
    enclosed: Flags
    clear: Flags

    @property
    def position(self) -> Floats:
        """(n, 2) m on the floor."""
        return places_of(self.columns)

    @property
    def box(self) -> Floats:
        """(n, 4) px."""
        return boxes_of(self.columns)

    @property
    def weight(self) -> Floats:
        """(n,) how much each row tells: what was measured, by how much of the person showed."""
        shown = np.maximum(self.columns["visibility"].astype(np.float64), _LEAST_SHOWN)
        return np.where(self.measured, shown, 0.0)


def smooth_run(
    run: Run,
    view: View,
    fps: float,
    given: Columns | None = None,
    *,
    memory_s: float = PATH_MEMORY_S,
) -> Run:
    """The run with what was seen later taken into account; particles and matches stay.

    The sources estimate each frame from what came before. Footage that is recorded knows what
    came after, too. Where we differ from them:
        - paths on the floor are smoothed in both directions, from the places measured; where
          somebody was only predicted, the path leads from where they were lost to where they
          were found;
        - boxes follow each person's outline over time: one that suddenly differs, as that of two
          people seen as one does, is drawn to it, and a predicted person has it where the path
          leads.

    Ids, frames and what counts as predicted stay as they are, and so do rows after a last match
    and people without a place on the floor.

    Args:
        view: the camera the boxes were seen by. fps: frames a second.
        given: rows of frames before the run's that stand fast, as corrected by people: its paths
            and outlines begin there, without a jump.
        memory_s: how long a path on the floor is led by what was seen.
    """
    tracks, first = _joined(given, run.tracks)
    clear = clear_sides(tracks)
    for rows, detections in _batches(tracks, run.detections):
        paths = _paths(tracks, rows, clear)
        if paths.measured.any():
            _smooth(tracks, paths, detections, view, fps, memory_s)
    return replace(run, tracks={name: column[first:] for name, column in tracks.items()})


def _smooth(
    tracks: Columns, paths: _Paths, detections: Columns, view: View, fps: float, memory_s: float
) -> None:
    """Put paths and boxes as they were, from each track's first to its last measured row."""
    seen = _matches(paths, detections)
    position, velocity = _walked(paths, _measured_places(paths, detections, seen), fps, memory_s)
    box = _drawn(paths, _sides(paths, detections, seen), position, view, fps)
    new = np.concatenate((position, velocity, box), axis=1)
    changed = paths.enclosed
    for name, column in zip(("x", "y", "vx", "vy", *SIDES), new.T, strict=True):
        tracks[name][paths.rows[changed]] = column[changed]


def _batches(tracks: Columns, detections: Columns) -> Iterator[tuple[Rows, Columns]]:
    """Rows of whole tracks, by track and frame, with their detections: some at a time.

    Tracks are smoothed each by itself; all at once would take many times the memory of the run.
    """
    order = np.lexsort((tracks["frame"], tracks["track"]))
    known = [np.isfinite(tracks[name]) for name in ("x", "y", *SIDES)]
    order = order[np.logical_and.reduce(known)[order]]
    track = tracks["track"][order]
    seen = np.argsort(detections["track"], kind="stable")
    for batch in _whole_tracks(track):
        ends = track[batch.start], track[batch.stop - 1] + 1
        low, high = np.searchsorted(detections["track"], ends, sorter=seen)
        theirs = np.sort(seen[low:high])
        yield order[batch], {name: detections[name][theirs] for name in _MATCHED}


def _whole_tracks(track: NDArray[np.int32]) -> Iterator[slice]:
    """Stretches of rows (n,) sorted by track, none of which cuts a track."""
    start = 0
    while start < len(track):
        wanted = min(start + _BATCH_ROWS, len(track))
        before = int(np.searchsorted(track, track[wanted - 1]))
        whole = wanted == len(track) or track[wanted] != track[wanted - 1]
        stop = wanted if whole else before
        if stop <= start:
            stop = int(np.searchsorted(track, track[start], side="right"))
        yield slice(start, stop)
        start = stop


def _joined(given: Columns | None, tracks: Columns) -> tuple[dict[str, NDArray[Any]], int]:
    """A copy of the tracks behind the rows given, which count as measured, and where it begins."""
    if given is None:
        return {name: column.copy() for name, column in tracks.items()}, 0
    sure = {**given, "predicted": np.zeros_like(given["predicted"])}
    sure["visibility"] = np.ones_like(given["visibility"])
    joined = {name: np.concatenate((sure[name], column)) for name, column in tracks.items()}
    return joined, len(given["frame"])


def _paths(tracks: Columns, rows: Rows, clear: Flags) -> _Paths:
    """Rows with a place and a box, ordered by track and frame."""
    columns = {name: column[rows] for name, column in tracks.items()}
    measured = ~columns["predicted"]
    first, last = _ends_of_measured(columns["track"], measured)
    place = np.arange(len(rows))
    enclosed = (place >= first) & (place <= last)
    chains = Chains(columns["frame"], columns["track"])
    return _Paths(rows, chains, columns, measured, enclosed, clear[rows])


def _ends_of_measured(track: NDArray[np.int32], measured: Flags) -> tuple[Rows, Rows]:
    """(n,) for each row its track's first and last measured row; n and -1 where there is none."""
    names, number = np.unique(track, return_inverse=True)
    first = np.full(len(names), len(track))
    last = np.full(len(names), -1)
    seen = np.flatnonzero(measured)
    np.minimum.at(first, number[seen], seen)
    np.maximum.at(last, number[seen], seen)
    return first[number], last[number]


def _walked(paths: _Paths, measured: Floats, fps: float, memory_s: float) -> tuple[Floats, Floats]:
    """Where people were, (n, 2) m, and their velocity, (n, 2) m/s."""
    error_m = _NEAR_M + _FAR_M * (measured**2).sum(axis=1)
    weight = paths.weight * (_NEAR_M / error_m) ** 2
    path = robust_paths(measured, weight, paths.chains, memory_s * fps, _PATH_OUTLIER * error_m)
    velocity = slopes(path, paths.chains) * fps
    before = np.stack((paths.columns["vx"], paths.columns["vy"]), axis=1)
    return path, np.where(np.isfinite(velocity), velocity, before)


def _matches(paths: _Paths, detections: Columns) -> tuple[Rows, Rows]:
    """Measured rows and the detections, with a place on the floor, that they were matched with."""
    frames = 1 + int(max(paths.chains.frame.max(), detections["frame"].max(initial=0)))
    found = np.isfinite(detections["x"]) & np.isfinite(detections["y"]) & (detections["track"] > 0)
    matched = np.flatnonzero(found)
    own = paths.columns["track"].astype(np.int64) * frames + paths.columns["frame"]
    theirs = detections["track"][matched].astype(np.int64) * frames + detections["frame"][matched]
    row = np.minimum(np.searchsorted(own, theirs), len(own) - 1)
    hit = (own[row] == theirs) & paths.measured[row]
    return row[hit], matched[hit]


def _measured_places(paths: _Paths, detections: Columns, seen: tuple[Rows, Rows]) -> Floats:
    """(n, 2) m: the place of the detection matched, else the row's own.

    The detections' places are taken because the filter's are smoothed forwards already.
    """
    places, (row, matched) = paths.position, seen
    places[row] = places_of(detections, matched)
    return places


def _sides(paths: _Paths, detections: Columns, seen: tuple[Rows, Rows]) -> Floats:
    """Left, top, right, bottom (n, 4) px of the boxes; where nobody else is near, as seen."""
    (low, size), (row, matched) = np.split(paths.box, 2, axis=1), seen
    sides = np.concatenate((low, low + size), axis=1).astype(np.float64)
    left, width = (detections[name][matched] for name in ("left", "width"))
    for side, (place, clear) in enumerate(zip((left, left + width), paths.clear.T, strict=True)):
        sides[row, 2 * side] = np.where(clear[row], place, sides[row, 2 * side])
    return sides


def _drawn(paths: _Paths, sides: Floats, position: Floats, view: View, fps: float) -> Floats:
    """The boxes (n, 4) px of people at these positions; the old one where none can be drawn.

    Args:
        sides: (n, 4) px of `_sides`.
    """
    usual, px_per_m = _usual_sides(position, view)
    own = (sides - usual) / px_per_m
    drawable = np.asarray(np.isfinite(own).all(axis=1))
    own = np.where(drawable[:, None], own, 0.0)
    outline = _outlines(own, paths.weight * drawable, paths, _OUTLINE_MEMORY_S * fps)
    low, high = np.split(usual + outline * px_per_m, 2, axis=1)
    good = drawable & (high > low).all(axis=1)
    return np.where(good[:, None], np.concatenate((low, high - low), axis=1), paths.box)


def _usual_sides(position: Floats, view: View) -> tuple[Floats, Floats]:
    """Left, top, right, bottom (n, 4) px of usual bodies and how large a metre looks, (n, 1).

    Outlines are what a person differs by: passing the camera, bodies lean and grow in the picture.
    """
    discs = np.zeros((len(_BODY), len(position), 3))
    discs[..., :2] = position
    discs[..., 2] = np.array(_BODY)[:, :1]
    centre = view.pixel_from_world(discs.reshape(-1, 3)).reshape(len(_BODY), -1, 2)
    rotation, camera_position = view.world_from_camera
    depth = (discs - camera_position) @ rotation[:, 2:]
    px_per_m = view.camera.matrix[0, 0] / np.where(depth > 0, depth, np.nan)
    radius = px_per_m * np.array(_BODY)[:, 1:, None]
    low, high = (centre - radius).min(axis=0), (centre + radius).max(axis=0)
    return np.concatenate((low, high), axis=1), px_per_m[1]


def _outlines(own: Floats, weight: Floats, paths: _Paths, memory: float) -> Floats:
    """Each person's outline over time, (n, 4) m; the own one counts where it suits the others.

    The left and the right side, where nobody else is near, count all of it: limbs are followed.
    """
    outline = np.empty_like(own)
    for side, scale in enumerate(_OUTLINE_OUTLIER_M):
        usual = robust_levels(own[:, side], weight, paths.chains, memory, scale)
        off = own[:, side] - usual
        share = _OWN_BOX * trust(off, scale)
        if side in (0, 2):
            share = np.where(paths.clear[:, side // 2], trust(off, _CLEAR_OUTLIER_M), share)
        outline[:, side] = usual + share * (weight > 0) * off
    return outline
