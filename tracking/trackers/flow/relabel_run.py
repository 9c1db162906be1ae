"""Relabels a finished run by the trajectories that explain its tracklets over all their time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.flow.bundles import Trajectory
from tracking.trackers.flow.chains import TrackletChains, link_chains
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.pieces import join_pieces
from tracking.trackers.flow.predicted_rows import fill_gaps
from tracking.trackers.flow.result import BODY_WIDTH_M, CHEST_M, PLENTY, shown_share
from tracking.trackers.flow.silhouettes import USUAL_HEIGHT_M
from tracking.trackers.flow.trajectory_selection import TrajectorySelector, WalkerTrajectory
from tracking.trackers.shared.result_columns import track_columns
from tracking.tracks.columns import (
    DETECTION_COLUMNS,
    Columns,
    merged_rows,
    places_of,
    typed,
)
from tracking.tracks.row_keys import row_keys
from tracking.tracks.run import Particles, Run

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Rows = NDArray[np.intp]

_BREAK_S = 0.3
"""Who is out of sight for longer may be somebody else after it."""
_LEAST_S = 1.0
"""Pieces of tracks that no trajectory explains stay if they are as long: who stands, or has few
tracklets."""
_NEAR_ACROSS_M, _NEAR_ALONG = 0.5, 0.2
"""So near to a trajectory, across the sight and along it, as a share of the distance, is who walks
it."""


def link_walkers(
    run: Run,
    view: View,
    fps: float,
    given: Columns | None = None,  # noqa: ARG001 - of every relabelling; tracklets say who is who
) -> Run:
    """The run with one track for each person, who walks straight where a track has no rows.

    Beyond [Yoneji2013], which counts frame by frame: people are those whose trajectories explain
    the tracklets over all their time, see `relabel_run`, and pieces that lead from one to the other
    are one track. Rows that were added count as predicted.

    Args:
        view: the camera. fps: frames a second.
    """
    run = join_pieces(relabel_run(run, view, fps), fps)
    return replace(run, tracks=fill_gaps(run.tracks, view, fps))


def relabel_run(run: Run, view: View, fps: float) -> Run:
    """The run with the people whose trajectories explain its tracklets instead of those followed.

    Whoever is followed frame by frame is taken for somebody else now and then, who comes by; the
    tracklets, looked at over all their time, tell them apart (see `TrajectorySelector`). A
    trajectory has the track of whom most of its tracklets belonged to, or a new one. Pieces of
    tracks that lie off all trajectories stay as they were, unless what shows them shows others.
    """
    floor = Floor(view)
    chains = link_chains(run, floor, fps)
    if not len(chains):
        return run
    pieces = find_pieces(run.tracks, fps)
    selector = TrajectorySelector(chains, floor, fps)
    trajectories = selector.select(
        [_interpolate(run.tracks, rows) for rows in pieces if len(rows) > _LEAST_S * fps]
    )
    if not trajectories:
        return run
    names = _names(run, chains, trajectories)
    relabelled = _rows_of_trajectories(trajectories, names, chains, view, fps)
    off = _find_pieces_off_trajectories(relabelled, run.tracks, pieces, fps, selector)
    tracks = _concatenate(relabelled, run.tracks, off)
    return replace(
        run,
        tracks=tracks,
        detections=_detections(tracks),
        tracklets=_relabel_tracklets(run, chains, trajectories, names, off),
    )


def find_pieces(tracks: Columns, fps: float) -> list[Rows]:
    """The rows of each stretch of a track in which the person is seen, by time."""
    order = np.lexsort((tracks["frame"], tracks["track"]))
    return _split_at_gaps(tracks, order[~tracks["predicted"][order]], fps)


def _split_at_gaps(tracks: Columns, rows: Rows, fps: float) -> list[Rows]:
    """Rows, by track and time, cut where the track changes and where it has none for a while."""
    other = np.diff(tracks["track"][rows]) != 0
    gap = np.diff(tracks["frame"][rows]) > max(1, round(_BREAK_S * fps))
    return [piece for piece in np.split(rows, np.flatnonzero(other | gap) + 1) if len(piece)]


def _interpolate(tracks: Columns, rows: Rows) -> Trajectory:
    """The trajectory of a piece, a place a frame."""
    frame = tracks["frame"][rows]
    every = np.arange(frame[0], frame[-1] + 1)
    place = [np.interp(every, frame, tracks[name][rows]) for name in ("x", "y")]
    return Trajectory(int(frame[0]), np.stack(place, axis=1))


def _names(run: Run, chains: TrackletChains, trajectories: Sequence[WalkerTrajectory]) -> Integers:
    """(walks,) tracks: each that of its tracklets, most of them first; else new ones."""
    holder = np.asarray(run.tracklets.columns["track"])[chains.row]
    walker = _walk_of_chain(chains, trajectories)[chains.chain]
    known = (walker >= 0) & (holder > 0)
    pair, count = np.unique(np.stack((walker[known], holder[known])), axis=1, return_counts=True)
    names, taken = np.zeros(len(trajectories), np.int64), set[int]()
    for number in np.argsort(-count, kind="stable"):
        one, track = int(pair[0, number]), int(pair[1, number])
        if not names[one] and track not in taken:
            names[one] = track
            taken.add(track)
    highest = max(run.known_tracks, int(run.tracks["track"].max(initial=0)))
    unnamed = np.flatnonzero(names == 0)
    names[unnamed] = highest + 1 + np.arange(len(unnamed))
    return names


def _walk_of_chain(chains: TrackletChains, trajectories: Sequence[WalkerTrajectory]) -> Integers:
    """(chains,) who walks with each tracklet; -1: nobody."""
    walker = np.full(len(chains), -1)
    for number, one in enumerate(trajectories):
        walker[one.chain] = number
    return walker


def _rows_of_trajectories(
    trajectories: Sequence[WalkerTrajectory],
    names: Integers,
    chains: TrackletChains,
    view: View,
    fps: float,
) -> Columns:
    """A row for each frame of each trajectory."""
    lengths = [len(walker.trajectory.place) for walker in trajectories]
    frame = np.concatenate(
        [np.arange(walker.trajectory.first, walker.trajectory.stop) for walker in trajectories]
    )
    place = np.concatenate([walker.trajectory.place for walker in trajectories])
    pace = np.concatenate(
        [np.gradient(walker.trajectory.place, axis=0) * fps for walker in trajectories]
    )
    box = view.box_of_person(place, USUAL_HEIGHT_M, BODY_WIDTH_M)
    number = np.repeat(np.arange(len(trajectories)), lengths)
    held = _walk_of_chain(chains, trajectories)[chains.chain]
    frames = len(chains.start)
    count = np.bincount(
        (held * frames + chains.frame)[held >= 0], minlength=frames * len(trajectories)
    )
    return track_columns(
        frame,
        names[number],
        box,
        place,
        pace,
        confidence=np.minimum(count[number * frames + frame] / PLENTY, 1.0),
        visibility=shown_share(box, view),
        predicted=False,
    )


def _find_pieces_off_trajectories(
    relabelled: Columns,
    tracks: Columns,
    pieces: Sequence[Rows],
    fps: float,
    selector: TrajectorySelector,
) -> list[tuple[int, Rows]]:
    """The pieces of people's tracks off all trajectories, each with its track from now on."""
    highest = int(max(relabelled["track"].max(), tracks["track"].max(initial=0)))
    taken, found = set(relabelled["track"].tolist()), list[tuple[int, Rows]]()
    off = [np.zeros(0, np.intp), *(piece[_is_off(tracks, piece, relabelled)] for piece in pieces)]
    for rows in _split_at_gaps(tracks, np.concatenate(off), fps):
        if len(rows) < _LEAST_S * fps or not selector.is_person(_interpolate(tracks, rows)):
            continue
        name = int(tracks["track"][rows[0]])
        if name in taken:  # whether it is the same person is settled later
            highest += 1
            name = highest
        taken.add(name)
        found.append((name, rows))
    return found


def _concatenate(relabelled: Columns, tracks: Columns, off: Sequence[tuple[int, Rows]]) -> Columns:
    """Trajectories and the pieces off all of them, sorted by frame, then track."""
    parts = [relabelled]
    for name, rows in off:
        part = {column: values[rows] for column, values in tracks.items()}
        parts.append({**part, "track": np.full_like(part["track"], name)})
    return merged_rows(*parts)[0]


def _is_off(tracks: Columns, rows: Rows, relabelled: Columns) -> NDArray[np.bool_]:
    """(k,) whether rows of tracks, of different frames, are near no trajectory."""
    at = np.searchsorted(tracks["frame"][rows], relabelled["frame"])
    at = np.minimum(at, len(rows) - 1)
    both = np.flatnonzero(tracks["frame"][rows][at] == relabelled["frame"])
    own = places_of(tracks, rows)[at[both]]
    away = places_of(relabelled, both) - own
    along, across = np.einsum("kij,kj->ik", sight_axes(own), away)
    near = np.abs(across) < _NEAR_ACROSS_M
    near &= np.abs(along) < np.maximum(_NEAR_ALONG * np.hypot(*own.T), _NEAR_ACROSS_M)
    off = np.ones(len(rows), bool)
    off[at[both[near]]] = False
    return off


def _detections(tracks: Columns) -> Columns:
    """Whoever is seen, as detected there: nobody is detected apart from being followed."""
    values = {name: tracks[name] for name in DETECTION_COLUMNS if name in tracks}
    values["z"] = np.full(len(tracks["frame"]), CHEST_M)
    seen = ~tracks["predicted"]
    return {name: column[seen] for name, column in typed(values, DETECTION_COLUMNS).items()}


def _relabel_tracklets(
    run: Run,
    chains: TrackletChains,
    trajectories: Sequence[WalkerTrajectory],
    names: Integers,
    off: Sequence[tuple[int, Rows]],
) -> Particles:
    """The tracklets with the tracks of those who walk with them, grouped by them.

    Those of pieces off all trajectories stay with these.
    """
    columns = {name: np.asarray(column) for name, column in run.tracklets.columns.items()}
    frame = np.repeat(np.arange(len(run.tracklets.start) - 1), np.diff(run.tracklets.start))
    walker = np.full(len(frame), -1)
    walker[chains.row] = _walk_of_chain(chains, trajectories)[chains.chain]
    track = np.where(walker >= 0, names[walker], _kept_tracks(run, columns["track"], frame, off))
    order = np.lexsort((track, frame))
    columns["track"] = track.astype(np.int32)
    return Particles(run.tracklets.start, {name: column[order] for name, column in columns.items()})


def _kept_tracks(
    run: Run, holder: Integers, frame: Integers, off: Sequence[tuple[int, Rows]]
) -> Integers:
    """(tracklets,) the track of the piece off all trajectories that holds each; 0: none does."""
    key, name = np.zeros(0, np.int64), np.zeros(0, np.int64)
    if off:
        rows = np.concatenate([rows for _, rows in off])
        key = row_keys(run.tracks["track"][rows], run.tracks["frame"][rows])
        name = np.concatenate([np.full(len(rows), number) for number, rows in off])
    order = np.argsort(key)
    key, name = np.append(key[order], -1), np.append(name[order], 0)
    own = row_keys(holder, frame)
    at = np.searchsorted(key[:-1], own)
    return np.where((key[at] == own) & (holder > 0), name[at], 0)
