"""Rows of a finished run in which nobody was seen: between rows of a track, before and after."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.pieces import Ends, find_ends
from tracking.trackers.flow.result import BODY_WIDTH_M
from tracking.trackers.flow.silhouettes import USUAL_HEIGHT_M
from tracking.trackers.flow.witnesses import Witnesses
from tracking.trackers.linking.gap_rows import missing_frames
from tracking.trackers.shared.result_columns import track_columns
from tracking.tracks.columns import (
    Columns,
    merged_rows,
    places_of,
)
from tracking.tracks.run import Run

Floats = NDArray[np.float64]
Rows = NDArray[np.intp]

_USUAL_LED_S = 1.5
"""Of runs made before there was a setting for it."""
_LEAST_LED_S = 1.0
_LEAST_M_S, _LEAST_WAY_M = 0.5, 0.8
"""Who was followed for less, or is slower, or has come less far, leads nowhere."""
_CHEST_M = 1.2


def fill_gaps(tracks: Columns, view: View, fps: float) -> Columns:
    """With rows in between for those who are out of sight within their track: they walk straight.

    Args:
        view: the camera. fps: frames a second.
    """
    order = np.lexsort((tracks["frame"], tracks["track"]))
    frame, track = tracks["frame"][order], tracks["track"][order]
    place = places_of(tracks, order)
    before, nth, steps = missing_frames(frame, track)
    way = place[before + 1] - place[before]
    there = place[before] + (nth / steps)[:, None] * way
    pace = way * fps / steps[:, None]
    return merged_rows(tracks, _rows(frame[before] + nth, track[before], there, pace, view))[0]


def extend_trajectories(run: Run, view: View, fps: float) -> Run:
    """The run with trajectories led back to before their beginning and on after their end.

    In a crowd people are found late and lost early, behind others; whoever walked on was there
    before and after, at the pace they had, as long as they are in the picture and the tracklets
    leave room for somebody there, see `Witnesses`.
    """
    led_s = float(run.settings.get("extrapolate_s", _USUAL_LED_S))
    return replace(run, tracks=_extend(run, view, fps, led_s))


def _extend(run: Run, view: View, fps: float, led_s: float) -> Columns:
    """The tracks with trajectories led so long back and on."""
    tracks, witnesses = run.tracks, Witnesses(run, Floor(view))
    order = np.lexsort((tracks["frame"], tracks["track"]))
    pieces = np.split(order, np.flatnonzero(np.diff(tracks["track"][order])) + 1)
    pieces = [rows for rows in pieces if len(rows) and _is_leading(tracks, rows, fps)]
    name = np.array([tracks["track"][rows[0]] for rows in pieces], np.int64)
    for last in (False, True):
        end = find_ends(tracks, pieces, fps, last=last)
        steps = np.arange(1, round(led_s * fps) + 1) * (1 if last else -1)
        added = _line(end, name, run.frames, fps, steps, witnesses)
        tracks, _ = merged_rows(tracks, added)
        pieces = _rows_by_track(tracks, name)
    return tracks


def _is_leading(tracks: Columns, rows: Rows, fps: float) -> bool:
    """Whether a track shows where somebody walks."""
    way = np.hypot(np.ptp(tracks["x"][rows]), np.ptp(tracks["y"][rows]))
    return bool(len(rows) >= _LEAST_LED_S * fps and way >= _LEAST_WAY_M)


def _rows_by_track(tracks: Columns, name: NDArray[np.int64]) -> list[Rows]:
    """The rows of each track, by time."""
    order = np.lexsort((tracks["frame"], tracks["track"]))
    first = np.searchsorted(tracks["track"][order], name)
    stop = np.searchsorted(tracks["track"][order], name, side="right")
    return [order[low:high] for low, high in zip(first, stop, strict=True)]


def _line(
    end: Ends,
    name: NDArray[np.int64],
    frames: tuple[int, int],
    fps: float,
    steps: NDArray[np.int64],
    witnesses: Witnesses,
) -> Columns:
    """Rows along straight lines, so many frames from ends.

    They end where they leave the picture, or come to where nobody can be.
    """
    view = witnesses.floor.view
    frame = np.rint(end.time_s * fps).astype(np.int64)[:, None] + steps
    place = end.place[:, None] + (steps / fps)[:, None] * end.pace[:, None]
    flat = place.reshape(-1, 2)
    chest = view.pixel_from_world(np.column_stack((flat, np.full(len(flat), _CHEST_M))))
    inside = ((chest > 0) & (chest < np.array(view.camera.size))).all(axis=1)
    inside = inside.reshape(frame.shape) & (frame >= frames[0]) & (frame < frames[1])
    inside &= (np.hypot(*end.pace.T) >= _LEAST_M_S)[:, None]
    inside &= witnesses.allow_for_a_while(place, frame)
    kept = np.logical_and.accumulate(inside, axis=1)
    track = np.broadcast_to(name[:, None], frame.shape)[kept]
    pace = np.broadcast_to(end.pace[:, None], place.shape)[kept]
    return _rows(frame[kept], track, place[kept], pace, view)


def _rows(
    frame: NDArray[np.int64], track: NDArray[np.int64], place: Floats, pace: Floats, view: View
) -> Columns:
    """Rows of people who are not seen."""
    box = view.box_of_person(place, USUAL_HEIGHT_M, BODY_WIDTH_M)
    return track_columns(
        frame, track, box, place, pace, confidence=0.0, visibility=0.0, predicted=True
    )
