"""SLEAP's analysis, read as HDF5 or CSV, and its projects: points of a skeleton of each track.

Analysis HDF5: `tracks` holds x, y in pixels of every node; its axes stand in the attribute `dims`,
or are those of SLEAP's own export (track, xy, node, frame). A person's box is the smallest around
the nodes that were seen: a node alone is a box without size, which still tells where somebody is.
Frames count from 0 as in the video (an export without leading empty frames counts from its first
one: SLEAP does not say which); track n of the file is id n + 1 here and keeps its name;
`instance_scores` are the confidence. Where a file names no tracks, those at one place of its list
are one track, which is told. Places on the floor are not in the file. Source: SLEAP's
write_tracking_h5, sleap-io's io/analysis_h5.py.

See `sleap_project` for `.slp` files and `sleap_csv` for the CSV.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError, explain_unreadable
from tracking.formats.hdf5_tracks import has_layout, opened, text_of
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.sleap_csv import import_sleap_csv, is_sleap_csv
from tracking.formats.sleap_points import AROUND_POINTS, NO_TRACKS, boxes_around, labels_of
from tracking.formats.sleap_project import PROJECT, import_sleap_project
from tracking.formats.track_format import HEAD_BYTES, TrackFormat
from tracking.progress import Progress, no_progress
from tracking.translation import msg

_ANALYSIS = "sleap"
_AXES = ("frame", "track", "node", "xy")
_AS_MATLAB = ("track", "xy", "node", "frame")
_OLD = ("frame", "node", "xy", "track")


_is_project = has_layout(PROJECT)


def looks_like_sleap(path: Path, head: bytes) -> bool:
    """Whether a file is SLEAP's analysis or one of its projects."""
    return is_sleap_csv(head) or has_layout(_ANALYSIS, PROJECT)(path, head)


def import_sleap(path: Path, filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a file. Raises FormatError where it is none of these, or is not safe."""
    with explain_unreadable(path), path.open("rb") as stream:
        head = stream.read(HEAD_BYTES)
    if is_sleap_csv(head):
        return import_sleap_csv(path, filmed, report)
    if _is_project(path, head):
        return import_sleap_project(path, filmed, report)
    return _import_analysis(path, report)


def _import_analysis(path: Path, report: Progress) -> Imported:
    reading = Reading(path, report)
    with opened(path, _ANALYSIS) as file:
        axes = _axes_of(path, file)
        stored: NDArray[np.float64] = np.asarray(file["tracks"][()], np.float64)
        points = stored.transpose([axes.index(axis) for axis in _AXES])
        scores = _scores_of(file, axes, points.shape[:2])
        names = [text_of(name) for name in file["track_names"][()]] if "track_names" in file else []
    reading.notes.append(AROUND_POINTS)
    if not names and points.shape[1] > 1:
        reading.notes.append(NO_TRACKS)
    seen: NDArray[np.bool_] = np.isfinite(points[..., 0]) & np.isfinite(points[..., 1])
    frame, track = np.nonzero(seen.any(axis=2))
    box = boxes_around(points[frame, track])
    rows: dict[str, NDArray[Any]] = {
        "frame": frame,
        "track": track + 1,
        **dict(zip(("left", "top", "width", "height"), box.T, strict=True)),
        "confidence": scores[frame, track],
    }
    return reading.imported(
        rows,
        lambda row: msg("track {track}, frame {frame}", track=track[row], frame=frame[row]),
        labels=labels_of(names, "track_{}", first=0),
        boxes_reach_feet=False,
    )


def _axes_of(path: Path, file: h5py.File) -> tuple[str, ...]:
    """What the four axes of `tracks` are."""
    said = file["tracks"].attrs.get("dims")
    if said is not None:
        axes = tuple(map(str, json.loads(text_of(said))))
    else:
        axes = _AS_MATLAB if bool(file.attrs.get("transpose", True)) else _OLD
    if sorted(axes) != sorted(_AXES) or file["tracks"].shape[axes.index("xy")] != 2:
        raise FormatError(
            "{path} does not have x and y of nodes, tracks and frames in its tracks", path=path
        )
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


SLEAP = TrackFormat(
    "sleap",
    "SLEAP analysis, HDF5 or CSV, and projects",
    (".h5", ".hdf5", ".slp", ".csv"),
    looks_like_sleap,
    import_sleap,
)
