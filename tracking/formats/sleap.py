"""SLEAP's analysis HDF5, read: points of a skeleton for each track in each frame.

`tracks` holds x, y in pixels of every node; its axes stand in the attribute `dims`, or are those of
SLEAP's own export (track, xy, node, frame). A person's box is the smallest around the nodes that
were seen: a node alone is a box without size, which still tells where somebody is. Frames count
from 0 as in the video (an export without leading empty frames counts from its first one: SLEAP does
not say which); track n of the file is id n + 1 here and keeps its name; `instance_scores` are the
confidence. Places on the floor are not in the file. Source: SLEAP's write_tracking_h5, sleap-io.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.hdf5_tracks import has_layout, opened, text_of
from tracking.formats.label_text import label_of
from tracking.formats.reading import Filmed, Imported, Reading
from tracking.formats.track_format import TrackFormat
from tracking.progress import Progress, no_progress
from tracking.tracks import TrackLabel

_AXES = ("frame", "track", "node", "xy")
_AS_MATLAB = ("track", "xy", "node", "frame")
_OLD = ("frame", "node", "xy", "track")


def import_sleap(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of an analysis file. Raises FormatError where it is none, or is not safe."""
    reading = Reading(path, report)
    with opened(path, "sleap") as file:
        axes = _axes_of(path, file)
        stored: NDArray[np.float64] = np.asarray(file["tracks"][()], np.float64)
        points = stored.transpose([axes.index(axis) for axis in _AXES])
        scores = _scores_of(file, axes, points.shape[:2])
        names = [text_of(name) for name in file["track_names"][()]] if "track_names" in file else []
    reading.notes.append("boxes are around the points SLEAP found, not around whole people")
    seen: NDArray[np.bool_] = np.isfinite(points[..., 0]) & np.isfinite(points[..., 1])
    frame, track = np.nonzero(seen.any(axis=2))
    box = _boxes_around(points[frame, track])
    rows: dict[str, NDArray[Any]] = {
        "frame": frame,
        "track": track + 1,
        **dict(zip(("left", "top", "width", "height"), box.T, strict=True)),
        "confidence": scores[frame, track],
    }
    return reading.imported(
        rows,
        lambda row: f"track {track[row]}, frame {frame[row]}",
        labels=labels_of(names, "track_{}", first=0),
    )


def labels_of(names: list[str], usual: str, first: int) -> dict[int, TrackLabel]:
    """Labels of tracks 1 on by their names, where these say more than the usual numbering does.

    usual: what the tool calls a track itself; first: the number of the first.
    """
    return {
        number: label_of(name)
        for number, name in enumerate(names, start=1)
        if name and name != usual.format(number - 1 + first)
    }


def _axes_of(path: Path, file: h5py.File) -> tuple[str, ...]:
    """What the four axes of `tracks` are."""
    said = file["tracks"].attrs.get("dims")
    if said is not None:
        axes = tuple(map(str, json.loads(text_of(said))))
    else:
        axes = _AS_MATLAB if bool(file.attrs.get("transpose", True)) else _OLD
    if sorted(axes) != sorted(_AXES) or file["tracks"].shape[axes.index("xy")] != 2:
        raise FormatError(f"{path} does not have x and y of nodes, tracks and frames in its tracks")
    return axes


def _scores_of(
    file: h5py.File, axes: tuple[str, ...], shape: tuple[int, ...]
) -> NDArray[np.float64]:
    """(frames, tracks) the confidence of each person; NaN where there is none."""
    if "instance_scores" not in file:
        return np.full(shape, np.nan)
    scores = np.asarray(file["instance_scores"][()], np.float64)
    if axes.index("track") < axes.index("frame"):
        scores = scores.T
    if scores.shape != shape:
        return np.full(shape, np.nan)
    return np.where(np.isfinite(scores), scores, np.nan)


def _boxes_around(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 4) the smallest boxes around the nodes (n, k, 2) that were seen."""
    seen = np.isfinite(points).all(axis=2, keepdims=True)
    low = np.where(seen, points, np.inf).min(axis=1)
    high = np.where(seen, points, -np.inf).max(axis=1)
    return np.concatenate([low, high - low], axis=1)


SLEAP = TrackFormat(
    "sleap", "SLEAP analysis, HDF5", (".h5", ".hdf5"), has_layout("sleap"), import_sleap
)
