"""Pieces of tracks that are one person's way, joined once a run is finished."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from tracking.trackers.flow.floor import sight_axes
from tracking.tracks.columns import Columns, places_of
from tracking.tracks.run import Particles, Run

Floats = NDArray[np.float64]
Rows = NDArray[np.intp]

USUAL_M_S = 1.2
_LED_BY_S = 1.5
"""How much of a piece says where it comes from and goes to."""
_USUAL_WEIGHT = 1.5
"""How much the usual pace counts beside the one seen, in square seconds times frames."""
_SET_OFF_M = 0.3
"""Who has gone less far has no direction."""
_LONGEST_GAP_S, _LONGEST_BOTH_S = 3.0, 0.6
"""Between the end of a piece and the next one's beginning, and how long both may be there."""
_ALONG_SHARE, _ALONG_M_S = 0.08, 0.25
_ACROSS_M, _ACROSS_M_S = 0.15, 0.15
"""How far a piece may begin from where another leads: along the sight, of the distance, and across
it, and the more the longer the gap."""
_PACE_M_S = 0.6
_GAP_COST_S = 0.5
_COSTLIEST = 9.0
_FEWEST = 3
_NEVER = 1e6


@dataclass(frozen=True, slots=True, eq=False)
class Ends:
    """Where pieces begin, or where they end.

    Attributes:
        time_s: (k,). place: (k, 2) m. pace: (k, 2) m/s.
    """

    time_s: Floats
    place: Floats
    pace: Floats


def join_pieces(run: Run, fps: float) -> Run:
    """The run with pieces of one person's way under the earliest one's track.

    Each piece is led on, and led back, at the pace it had; which continues which is settled for
    all at once, as cheaply as can be. What is counted as seen of two in one frame is the later's.
    """
    tracks = run.tracks
    order = np.lexsort((tracks["frame"], tracks["track"]))
    rows = order[~tracks["predicted"][order]]
    names, first, count = np.unique(tracks["track"][rows], return_index=True, return_counts=True)
    whole = count >= _FEWEST
    if whole.sum() < 2:
        return run
    pieces = [rows[at : at + n] for at, n in zip(first[whole], count[whole], strict=True)]
    heir = dict(zip(names[whole].tolist(), names[whole].tolist(), strict=True))
    follows = _match_ends(
        find_ends(tracks, pieces, fps, last=True), find_ends(tracks, pieces, fps, last=False)
    )
    for one, other in follows:  # the later pieces' names lead to the earlier ones'
        heir[int(names[whole][other])] = int(names[whole][one])
    return _rename_tracks(run, {name: _first_of(heir, name) for name in heir})


def find_ends(tracks: Columns, pieces: list[Rows], fps: float, *, last: bool) -> Ends:
    """Where pieces, rows by time, end or begin: straight lines through what is seen next to it.

    People walk at a usual pace: the shorter the piece, the more that counts.
    """
    time_s, place, pace = np.zeros(len(pieces)), *np.zeros((2, len(pieces), 2))
    for number, rows in enumerate(pieces):
        seconds = tracks["frame"][rows] / fps
        where = places_of(tracks, rows)
        time_s[number] = seconds[-1 if last else 0]
        near = np.abs(seconds - time_s[number]) <= _LED_BY_S
        way = where[-1] - where[0]
        length = np.hypot(*way)
        usual = way / length * USUAL_M_S if length > _SET_OFF_M else np.zeros(2)
        off = seconds[near] - seconds[near].mean()
        middle = where[near].mean(axis=0)
        slope = off @ (where[near] - middle) + _USUAL_WEIGHT * usual
        pace[number] = slope / (off @ off + _USUAL_WEIGHT)
        place[number] = middle + pace[number] * (time_s[number] - seconds[near].mean())
    return Ends(time_s, place, pace)


def _match_ends(end: Ends, begin: Ends) -> list[tuple[int, int]]:
    """Which piece is followed by which, cheapest in all."""
    pieces = len(end.time_s)
    cost = _costs(end, begin)
    square = np.full((2 * pieces, 2 * pieces), _NEVER)
    square[:pieces, :pieces] = cost
    alone = np.arange(pieces)
    square[alone, pieces + alone] = square[pieces + alone, alone] = _COSTLIEST / 2
    square[pieces:, pieces:] = 0.0
    return [
        (int(one), int(other))
        for one, other in zip(*linear_sum_assignment(square), strict=True)
        if one < pieces and other < pieces and cost[one, other] < _COSTLIEST
    ]


def _costs(end: Ends, begin: Ends) -> Floats:
    """(k, k) squared distances of what follows a piece from where the piece leads."""
    gap_s = begin.time_s[None] - end.time_s[:, None]
    half = (gap_s / 2)[..., None]
    miss = begin.place[None] - half * begin.pace[None] - end.place[:, None]
    miss = miss - half * end.pace[:, None]
    off = np.einsum("kij,knj->kni", sight_axes(end.place), miss)
    away = np.hypot(*end.place.T)[:, None]
    long_s = np.abs(gap_s)
    cost = (off[..., 0] / (_ALONG_SHARE * away + _ALONG_M_S * long_s + 1e-3)) ** 2
    cost += (off[..., 1] / (_ACROSS_M + _ACROSS_M_S * long_s)) ** 2
    other_pace = ((begin.pace[None] - end.pace[:, None]) ** 2).sum(axis=-1)
    cost += other_pace / _PACE_M_S**2 + _GAP_COST_S * np.maximum(gap_s, 0.0)
    later = (begin.time_s[None] > begin.time_s[:, None]) & (end.time_s[None] > end.time_s[:, None])
    possible = later & (gap_s >= -_LONGEST_BOTH_S) & (gap_s <= _LONGEST_GAP_S)
    return np.where(possible, cost, _NEVER)


def _first_of(heir: dict[int, int], name: int) -> int:
    while heir[name] != name:
        name = heir[name]
    return name


def _rename_tracks(run: Run, names: dict[int, int]) -> Run:
    """With tracks under other names; of two rows of one track and frame the later piece's stays."""
    old = run.tracks["track"]
    tracks = dict(run.tracks, track=_rename(old, names))
    order = np.lexsort((old, ~tracks["predicted"], tracks["track"], tracks["frame"]))
    name, frame = tracks["track"][order], tracks["frame"][order]
    kept = np.append((name[1:] != name[:-1]) | (frame[1:] != frame[:-1]), True)
    detections = dict(run.detections, track=_rename(run.detections["track"], names))
    return replace(
        run,
        tracks={column: values[order[kept]] for column, values in tracks.items()},
        detections=detections,
        tracklets=_rename_tracklets(run.tracklets, names),
    )


def _rename_tracklets(tracklets: Particles, names: dict[int, int]) -> Particles:
    """The tracklets under their tracks' names, grouped by them frame by frame."""
    columns = {name: np.asarray(column) for name, column in tracklets.columns.items()}
    columns["track"] = _rename(columns["track"], names)
    frame = np.repeat(np.arange(len(tracklets.start) - 1), np.diff(tracklets.start))
    order = np.lexsort((columns["track"], frame))
    return Particles(tracklets.start, {name: column[order] for name, column in columns.items()})


def _rename(track: NDArray[np.int32], names: dict[int, int]) -> NDArray[np.int32]:
    known, place = np.unique(track, return_inverse=True)
    new = np.array([names.get(int(name), int(name)) for name in known], np.int32)
    return np.asarray(new[place] if len(known) else track, np.int32)
