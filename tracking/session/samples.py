"""A session's part labels with what the tracker saw: samples of the failure detector."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.failure import Samples, no_samples, samples_of
from tracking.formats import GivenLabel
from tracking.review.run_rows import rows_in_run
from tracking.tracks import PART_NAMES, Columns, Labels, PartLabel, Run, TrackTable
from tracking.tracks.part_labels import Box

if TYPE_CHECKING:
    from tracking.session.document import Session

_TELLING = ("frame", "track", "left", "top", "x", "y")
"""Columns by which a row of the corrected table is found in the run it came from."""


def session_samples(session: Session) -> Samples:
    """The samples that a session's labels give with the run its tracks began as.

    Raises SessionError where that run cannot be read.
    """
    adopted = session.adopted_run
    run = session.runs[adopted] if adopted is not None else None
    recording = session.recording
    return samples_from(session.labels, session.tracks, run, recording.fps, recording.name)


def samples_from(
    labels: Labels, tracks: TrackTable, run: Run | None, fps: float, recording: str
) -> Samples:
    """The same of the pieces; none without labels, or where the run followed no parts."""
    if run is None or not len(labels.parts) or not len(run.parts.get("frame", ())):
        return no_samples()
    people = {label.track for label in labels.parts.values()}
    parts = parts_as_corrected(tracks, people, run)
    return samples_of(labels.parts.values(), parts, fps, recording)


def parts_as_corrected(tracks: TrackTable, people: set[int], run: Run) -> Columns:
    """The run's parts of some people, under the ids these have by now.

    A row that went from track to track keeps its box and is found by it; one whose box somebody
    moved is taken for the run's row of its own id and frame, unless another of them has that.

    Returns:
        `PART_COLUMNS` of the rows whose person is among `people`.
    """
    rows = tracks.by_track(_TELLING, people)
    key = rows_in_run(rows, run).key
    own = _keys(rows["track"], rows["frame"])
    key = np.where((key < 0) & ~np.isin(own, key), own, key)
    known = np.flatnonzero(key >= 0)
    known = known[np.argsort(key[known], kind="stable")]
    asked = _keys(run.parts["track"], run.parts["frame"])
    at = np.minimum(np.searchsorted(key[known], asked), max(len(known) - 1, 0))
    found = (key[known][at] == asked) if len(known) else np.zeros(len(asked), bool)
    parts = {name: column[found] for name, column in run.parts.items()}
    parts["track"] = rows["track"][known[at[found]]].astype(np.int32)
    return parts


def _keys(track: NDArray[np.integer], frame: NDArray[np.integer]) -> NDArray[np.int64]:
    return (track.astype(np.int64) << 32) + frame


def labels_in_place(session: Session, given: Sequence[GivenLabel]) -> list[PartLabel]:
    """Labels made elsewhere, checked against a session; those without a box get the tracker's.

    Raises FormatError, with its line, for a label of a frame the recording does not have, of
    somebody who is not tracked there, or without a box where the tracker followed no parts.
    """
    adopted = session.adopted_run
    run = session.runs[adopted] if adopted is not None else None
    boxes = _tracked_boxes(session.tracks, {one.label.track for one in given}, run)
    return [_in_place(session, one, boxes) for one in given]


def _in_place(
    session: Session, given: GivenLabel, boxes: Mapping[tuple[int, int, int], Box]
) -> PartLabel:
    label = given.label
    if label.frame >= session.recording.frame_count:
        last = session.recording.frame_count - 1
        raise FormatError(f"{given.place}: frame {label.frame}; the recording has 0 to {last}")
    if label.frame not in session.tracks.frames_of_track(label.track):
        raise FormatError(
            f"{given.place}: track {label.track} is not there in frame {label.frame}; "
            "correct or remove the row"
        )
    if given.has_box:
        return label
    box = boxes.get(label.key)
    if box is None:
        raise FormatError(
            f"{given.place}: no {PART_NAMES[label.part]} of track {label.track} was tracked in "
            f"frame {label.frame}; give left, top, width and height"
        )
    return replace(label, box=box)


def _tracked_boxes(
    tracks: TrackTable, people: set[int], run: Run | None
) -> dict[tuple[int, int, int], Box]:
    """By frame, track and part: where the run saw them."""
    if run is None or not len(run.parts.get("frame", ())):
        return {}
    parts = parts_as_corrected(tracks, people, run)
    names = ("frame", "track", "part", "cx", "cy", "width", "height")
    return {
        (frame, track, part): (x - width / 2, y - height / 2, width, height)
        for frame, track, part, x, y, width, height in zip(
            *(parts[name].tolist() for name in names), strict=True
        )
    }
