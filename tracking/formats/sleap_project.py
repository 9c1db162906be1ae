"""SLEAP's projects, `.slp`, read: instances of a skeleton that people drew or a model found.

`frames` say which of the `instances` lie in a frame (`frame_idx`, from 0) of a video; an instance
names its track and its points in `points` (drawn by a person) or `pred_points`. As in SLEAP, what a
person drew takes the place of what the model found: of the instance it was made from, and of the
same track in the same frame. Its rows are a person's. Track n of the file is id n + 1 and keeps its
name (`tracks_json`). Instances without a track are left out, which is told; where no instance has
one, those at one place of each frame's list are one track, as sleap-io has it.

Before format 1.1 (`format_id` of `metadata`) a pixel's corner was its place, since then it is its
centre. Videos are not in the file but for packages, whose pictures are not touched. Source:
sleap-io's io/slp.py (read_instances, write_lfs, read_tracks), SLEAP's io/format/hdf5.py.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.errors import FormatError
from tracking.formats.hdf5_tracks import number_of, opened, text_of
from tracking.formats.label_text import left_out
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.sleap_points import (
    AROUND_POINTS,
    NO_TRACKS,
    UNTRACKED,
    USUAL_NAME,
    boxes_around,
    labels_of,
    places_in,
)
from tracking.progress import Progress, no_progress
from tracking.tracks import Source
from tracking.translation import msg

PROJECT = "sleap-project"
"""The layout, as the program that looks HDF5 files over calls it."""

_TABLES = ("frames", "instances", "points", "pred_points")
_PREDICTED = 1
_CENTRED_SINCE = 1.1
_CORNER_TO_CENTRE_PX = -0.5
_MOST_NODES = 1000
_NODES_AT_ONCE = 1 << 20
_NO_TRACK = -1

Whole = NDArray[np.int64]


def import_sleap_project(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a project of one video. Raises FormatError where it is none, or is not safe."""
    with opened(path, PROJECT) as file:
        tables = {name: file[name][()] for name in _TABLES}
        names = _names_of(file)
        version = number_of(file["metadata"], "format_id") if "metadata" in file else None
    shift_px = _CORNER_TO_CENTRE_PX if version is not None and version < _CENTRED_SINCE else 0.0
    return _Project(Reading(path, report), tables, shift_px).imported(names)


def _names_of(file: h5py.File) -> list[str]:
    """The tracks' names; "" where one is told in no way that is known."""
    rows = file["tracks_json"][()] if "tracks_json" in file else ()
    return [_name_in(text_of(row)) for row in rows]


def _name_in(text: str) -> str:
    """Of a list of the frame a track begins in and its name."""
    try:
        said = json.loads(text)
    except (ValueError, RecursionError):
        return ""
    if isinstance(said, list) and len(said) > 1 and isinstance(said[1], str):
        return said[1]
    return ""


class _Project:
    """The tables of a file."""

    def __init__(self, reading: Reading, tables: dict[str, Any], shift_px: float) -> None:
        self._reading, self._shift_px = reading, shift_px
        self._frames, self._instances = tables["frames"], tables["instances"]
        self._points = (tables["points"], tables["pred_points"])
        self._predicted: NDArray[np.bool_] = self._instances["instance_type"] == _PREDICTED

    def imported(self, names: list[str]) -> Imported:
        """The tracks."""
        frame, at = self._by_frame()
        boxes, seen = self._boxes(at)
        frame, at, boxes = frame[seen], at[seen], boxes[seen]
        shown = ~self._is_replaced(at)
        frame, at, boxes = frame[shown], at[shown], boxes[shown]
        track, tracked = self._tracks(frame, at)
        frame, at, boxes, track = frame[tracked], at[tracked], boxes[tracked], track[tracked]
        kept = self._without_doubles(frame, at, track)
        frame, at, boxes, track = frame[kept], at[kept], boxes[kept], track[kept]
        self._reading.notes.append(AROUND_POINTS)
        predicted = self._predicted[at]
        score = np.asarray(self._instances["score"][at], np.float64)
        rows: dict[str, NDArray[Any]] = {
            "frame": frame,
            "track": track + 1,
            **dict(zip(("left", "top", "width", "height"), boxes.T, strict=True)),
            "confidence": np.where(predicted & np.isfinite(score), score, np.nan),
            "source": np.where(predicted, Source.TRACKER, Source.PERSON),
        }
        return self._reading.imported(
            rows,
            lambda row: msg("instance {at}", at=at[row]),
            labels=labels_of(names, USUAL_NAME, first=0),
            boxes_reach_feet=False,
        )

    def _by_frame(self) -> tuple[Whole, Whole]:
        """(n,) the frames of instances, and their places in the table, by the list of frames."""
        starts, stops = (_whole(self._frames[f"instance_id_{end}"]) for end in ("start", "end"))
        counts = stops - starts
        if np.any(counts < 0) or np.any(starts < 0) or np.any(stops > len(self._instances)):
            raise self._damaged(msg("its frames name instances that are not there"))
        if int(counts.sum()) > len(self._instances):
            raise self._damaged(msg("its frames share instances"))
        self._check_videos(counts > 0)
        before = np.repeat(np.arange(len(starts)), counts)
        at = starts[before] + np.arange(len(before)) - np.repeat(np.cumsum(counts) - counts, counts)
        return _whole(self._frames["frame_idx"])[before], at

    def _check_videos(self, filled: NDArray[np.bool_]) -> None:
        videos = len(np.unique(self._frames["video"][filled]))
        if videos > 1:
            raise FormatError(
                "{path} holds instances of {videos} videos; export one's analysis",
                path=self._reading.path,
                videos=videos,
            )

    def _boxes(self, at: Whole) -> tuple[Floats, NDArray[np.bool_]]:
        """(n, 4) the boxes around the points of instances, and (n,) whether any was seen."""
        starts, stops = (_whole(self._instances[f"point_id_{end}"][at]) for end in ("start", "end"))
        counts, predicted = stops - starts, self._predicted[at]
        lengths = np.where(predicted, len(self._points[1]), len(self._points[0]))
        if np.any(counts < 0) or np.any(starts < 0) or np.any(stops > lengths):
            raise self._damaged(msg("its instances name points that are not there"))
        if int(counts.sum()) > sum(map(len, self._points)) or counts.max(initial=0) > _MOST_NODES:
            raise self._damaged(msg("its instances share points, or have more than any skeleton"))
        boxes = np.full((len(at), 4), np.nan)
        for is_predicted in (False, True):
            for nodes in np.unique(counts[(predicted == is_predicted) & (counts > 0)]).tolist():
                rows = np.flatnonzero((predicted == is_predicted) & (counts == nodes))
                some = max(_NODES_AT_ONCE // nodes, 1)
                for first in range(0, len(rows), some):
                    part = rows[first : first + some]
                    points = self._xy(starts[part][:, None] + np.arange(nodes), is_predicted)
                    boxes[part] = boxes_around(points)
        seen = np.isfinite(boxes).all(axis=1)
        return boxes, seen

    def _xy(self, at: Whole, predicted: bool) -> Floats:
        """(n, k, 2) points in pixels; NaN where they are not visible."""
        points = self._points[predicted][at]
        xy = np.stack([points["x"], points["y"]], axis=2).astype(np.float64) + self._shift_px
        xy[~points["visible"].astype(bool)] = np.nan
        return xy

    def _is_replaced(self, at: Whole) -> NDArray[np.bool_]:
        """(n,) who was found by the model, and drawn by a person since."""
        drawn = at[~self._predicted[at]]
        made_from = _whole(self._instances["from_predicted"][drawn])
        ids = _whole(self._instances["instance_id"][at])
        return self._predicted[at] & np.isin(ids, made_from[made_from >= 0])

    def _tracks(self, frame: Whole, at: Whole) -> tuple[Whole, NDArray[np.bool_]]:
        """(n,) the numbers of tracks from 0, and which of the rows have one."""
        track = _whole(self._instances["track"][at])
        tracked = track > _NO_TRACK
        if len(track) and not tracked.any():
            self._reading.notes.append(NO_TRACKS)
            return places_in(frame), np.ones(len(track), bool)
        if not tracked.all():
            count = int(np.count_nonzero(~tracked))
            self._reading.notes.append(left_out(count, *UNTRACKED))
        return track, tracked

    def _without_doubles(self, frame: Whole, at: Whole, track: Whole) -> Whole:
        """The rows, but for what the model found of a track that a person drew in that frame."""
        predicted = self._predicted[at]
        drawn = set(zip(frame[~predicted].tolist(), track[~predicted].tolist(), strict=True))
        if not drawn:
            return np.arange(len(at))
        pairs = zip(frame.tolist(), track.tolist(), predicted.tolist(), strict=True)
        return np.array(
            [row for row, (f, t, p) in enumerate(pairs) if not (p and (f, t) in drawn)], np.int64
        )

    def _damaged(self, why: str) -> FormatError:
        return FormatError(
            "{path} is damaged: {why}; save the project again", path=self._reading.path, why=why
        )


def _whole(values: NDArray[Any]) -> Whole:
    """Whole numbers, whatever type a file keeps them in; -1 for what is none."""
    numbers = np.asarray(values, np.float64)
    fits = np.isfinite(numbers) & (np.abs(numbers) < 2.0**53)
    return np.where(fits, numbers, _NO_TRACK).astype(np.int64)
