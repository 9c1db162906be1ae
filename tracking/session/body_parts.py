"""What a session says of body parts: the samples it gives, and labels made elsewhere put in it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.failure import Samples
from tracking.formats import GivenLabel
from tracking.session.document import Session
from tracking.session.provenance import parts_by_now
from tracking.session.samples import samples_from
from tracking.tracks import PART_NAMES, Columns, PartKey, PartLabel, Run, TrackTable
from tracking.tracks.part_labels import Box

_RECTANGLE = ("frame", "track", "part", "cx", "cy", "width", "height")


def session_samples(session: Session) -> Samples:
    """The samples that a session's labels give with the run its tracks began as.

    Raises SessionError where that run cannot be read.
    """
    recording, run = session.recording, session.corrected_run
    return samples_from(session.labels, session.tracks, run, recording.fps, recording.name)


def corrected_parts(session: Session) -> Columns:
    """Where the parts of people are by now; empty where the run followed none.

    What the run saw, under the ids of now, without those who were deleted; a rectangle that
    somebody put on its part stands in place of the tracker's.

    Returns:
        `frame, track, part` and `cx, cy, width, height` px of the left picture as recorded; a row
        each part.

    Raises SessionError where the run cannot be read.
    """
    table = session.tracks
    rows = parts_by_now(table, session.corrected_run, table.track_ids)
    parts = {name: rows[name] for name in _RECTANGLE}
    labels = session.labels.parts.values()
    drawn = _as_columns([one for one in labels if one.source == "person" and one.on_part])
    if not len(drawn["frame"]) or not len(parts["frame"]):
        return parts
    people = table.by_track(("frame", "track"), np.unique(drawn["track"]).tolist())
    there = np.isin(_places({**drawn, "part": 0}), _places({**people, "part": 0}))
    kept = ~np.isin(_places(parts), _places(drawn)[there])
    return {
        name: np.concatenate((parts[name][kept], drawn[name][there])).astype(parts[name].dtype)
        for name in _RECTANGLE
    }


def _as_columns(labels: Sequence[PartLabel]) -> Columns:
    """The rectangles of labels, a row each."""
    boxes = np.array([one.box for one in labels], np.float64).reshape(-1, 4)
    middle = boxes[:, :2] + boxes[:, 2:] / 2
    whole = np.array([one.key for one in labels], np.int64).reshape(-1, 3)
    return dict(zip(_RECTANGLE, (*whole.T, *middle.T, *boxes[:, 2:].T), strict=True))


def _places(rows: Mapping[str, Any]) -> NDArray[np.int64]:
    """(n,) one number for each frame, track and part."""
    frame, track = (rows[name].astype(np.int64) for name in ("frame", "track"))
    return np.asarray(frame << 33 | track << 2 | rows["part"])


def place_labels(session: Session, given: Sequence[GivenLabel]) -> list[PartLabel]:
    """Labels made elsewhere, checked against a session; those without a box get the tracker's.

    Raises FormatError, with its line, for a label of a frame the recording does not have, of
    somebody who is not tracked there, or without a box where the tracker followed no parts.
    """
    people = {one.label.track for one in given}
    boxes = _tracked_boxes(session.tracks, people, session.corrected_run)
    return [_in_place(session, one, boxes) for one in given]


def _in_place(session: Session, given: GivenLabel, boxes: Mapping[PartKey, Box]) -> PartLabel:
    label = given.label
    if label.frame >= session.recording.frame_count:
        last = session.recording.frame_count - 1
        raise FormatError(
            "{place}: frame {frame}; the recording has 0 to {last}",
            place=given.place,
            frame=label.frame,
            last=last,
        )
    if label.frame not in session.tracks.frames_of_track(label.track):
        raise FormatError(
            "{place}: track {track} is not there in frame {frame}; correct or remove the row",
            place=given.place,
            track=label.track,
            frame=label.frame,
        )
    if given.has_box:
        return label
    box = boxes.get(label.key)
    if box is None:
        raise FormatError(
            "{place}: no {part_names} of track {track} was tracked in frame {frame}; give "
            "left, top, width and height",
            place=given.place,
            part_names=PART_NAMES[label.part],
            track=label.track,
            frame=label.frame,
        )
    return replace(label, box=box)


def _tracked_boxes(tracks: TrackTable, people: set[int], run: Run | None) -> dict[PartKey, Box]:
    """By frame, track and part: left, top, width, height in px where the run saw them."""
    if run is None or not len(run.parts["frame"]):
        return {}
    parts = parts_by_now(tracks, run, people)
    return {
        (frame, track, part): (x - width / 2, y - height / 2, width, height)
        for frame, track, part, x, y, width, height in zip(
            *(parts[name].tolist() for name in _RECTANGLE), strict=True
        )
    }
