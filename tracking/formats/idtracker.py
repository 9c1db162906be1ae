"""idtracker.ai's trajectories, read: HDF5 or CSV, a centre in pixels for each identity and frame.

A centre is a box without size: it tells where somebody is, and nothing of how large they are.
Frames count from 0, identity n is id n; a gap is where a centre is not a number. Names are from
`identities_labels`, the confidence from `id_probabilities`. The `.npy` and `.pickle` files are not
read: to read them is to run what is in them; idtracker.ai makes the others of them
(idtrackerai_format).
Places on the floor are not in the file. Source: idtracker.ai's trajectories_io.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError, explain_unreadable
from tracking.formats.delimited_text import NumberRows, Piece, RowShape, pieces_of
from tracking.formats.hdf5_tracks import has_layout, number_of, opened, text_of
from tracking.formats.read_result import Filmed, Imported, Reading
from tracking.formats.sleap_points import labels_of
from tracking.formats.track_format import TrackFormat
from tracking.progress import Progress, no_progress
from tracking.translation import msg

_HEADER = re.compile(rb"(\xef\xbb\xbf)?seconds,x1,y1((,x\d+,y\d+)*)\r?\n")
_MOST_PEOPLE = 1000
_is_hdf5 = has_layout("idtracker")


def looks_like_idtracker(path: Path, head: bytes) -> bool:
    """Whether a file is one of idtracker.ai's tables."""
    return _HEADER.match(head) is not None or _is_hdf5(path, head)


def import_idtracker(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a file. Raises FormatError where it is none of these, or is not safe."""
    reading = Reading(path, report)
    with explain_unreadable(path), path.open("rb") as stream:
        as_text = _HEADER.match(stream.read(1 << 16))
    if as_text:
        points, seconds = _points_of_text(reading)
        fps = _fps_of(seconds)
        return _imported(reading, points, np.full(points.shape[:2], np.nan), [], fps)
    with opened(path, "idtracker") as file:
        points = np.asarray(file["trajectories"][()], np.float64)
        names = _names_of(file)
        fps = number_of(file, "frames_per_second")
        scores = _scores_of(file, points.shape[:2])
    return _imported(reading, points, scores, names, fps)


def _imported(
    reading: Reading,
    points: NDArray[np.float64],
    scores: NDArray[np.float64],
    names: list[str],
    fps: float | None,
) -> Imported:
    """The rows of points (frames, people, 2)."""
    reading.notes.append(msg("boxes have no size: idtracker.ai tells the centres of bodies alone"))
    frame, person = np.nonzero(np.isfinite(points).all(axis=2))
    centre = points[frame, person]
    rows: dict[str, NDArray[Any]] = {
        "frame": frame,
        "track": person + 1,
        "left": centre[:, 0],
        "top": centre[:, 1],
        "width": np.zeros(len(frame)),
        "height": np.zeros(len(frame)),
        "confidence": scores[frame, person],
    }
    return reading.imported(
        rows,
        lambda row: msg(
            "identity {person}, frame {frame}", person=person[row] + 1, frame=frame[row]
        ),
        labels=labels_of(names, "{}", first=1),
        fps=fps,
        frames=len(points) or None,
        boxes_reach_feet=False,
    )


def _names_of(file: h5py.File) -> list[str]:
    said = file.attrs.get("identities_labels")
    return [] if said is None else [text_of(name) for name in np.atleast_1d(said).tolist()]


def _scores_of(file: h5py.File, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """(frames, people) how sure each identity is; NaN where that is not told."""
    if "id_probabilities" not in file or file["id_probabilities"].size != np.prod(shape):
        return np.full(shape, np.nan)
    scores = np.asarray(file["id_probabilities"][()], np.float64).reshape(shape)
    return np.where(np.isfinite(scores), scores, np.nan)


def _points_of_text(reading: Reading) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """(frames, people, 2) the centres, and (frames,) their seconds."""
    pieces = pieces_of(reading.path, reading.report)
    first = next(pieces)
    width = first.lines[0].count(",") + 1
    people = width // 2
    if people > _MOST_PEOPLE or width != 2 * people + 1:
        raise FormatError(
            "{path} has {width} columns; two a person and the time belong",
            path=reading.path,
            width=width,
        )
    shape = RowShape("idtracker.ai's table", width, width)
    table, lines = NumberRows(reading, shape).read(_without_header(first, pieces))
    if reading.bad_count:
        # A row is a frame by where it stands: without one, all that follow would be earlier.
        bad = reading.bad_rows[0]
        raise FormatError(
            "{path}, {place}: {reason}; export the table again",
            path=reading.path,
            place=bad.place,
            reason=bad.reason,
        )
    if len(lines) and not np.array_equal(lines, np.arange(len(lines)) + 2):
        raise FormatError(
            "{path} has empty lines between its frames; export it again", path=reading.path
        )
    return table[:, 1:].reshape(len(table), people, 2), table[:, 0]


def _without_header(first: Piece, rest: Iterator[Piece]) -> Iterator[Piece]:
    yield replace(first, lines=["", *first.lines[1:]])
    yield from rest


def _fps_of(seconds: NDArray[np.float64]) -> float | None:
    """Frames a second of times that are written with three decimals."""
    known = seconds[np.isfinite(seconds)]
    length = float(known[-1] - known[0]) if len(known) > 1 else 0.0
    if length <= 0:
        return None
    fps = (len(known) - 1) / length
    whole = round(fps)
    # Off by half a thousandth at both ends at most.
    return float(whole) if abs(fps - whole) <= fps * 0.001 / length else round(fps, 3)


IDTRACKER = TrackFormat(
    "idtracker",
    "idtracker.ai trajectories, HDF5 or CSV",
    (".h5", ".csv"),
    looks_like_idtracker,
    import_idtracker,
)
