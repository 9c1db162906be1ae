"""The tracks as they would be after an edit, looked at without making it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from app.core.tracks.track_reader import Spans, TrackReader
from tracking.editing import Change
from tracking.tracks import Columns, row_keys

Range = tuple[int, int]


class PreviewedTracks:
    """Shown tracks with a change laid over them; only the rows asked for are worked out.

    Whole tracks, lanes and counts stay those of before: they are shown beside the preview.
    """

    def __init__(self, tracks: TrackReader, change: Change) -> None:
        self._tracks = tracks
        self._change = change

    @property
    def frames(self) -> Range:
        """As before."""
        return self._tracks.frames

    @property
    def ids(self) -> Sequence[int]:
        """As before."""
        return self._tracks.ids

    def of_frame(self, frame: int) -> Columns:
        """The frame's rows as they would be."""
        return apply_to_rows(self._tracks.of_frame(frame), self._change, (frame, frame + 1))

    def recent(self, frame: int, back: int) -> Columns:
        """The rows of the frame's people and of `back` frames before as they would be."""
        window = max(0, frame - back), frame + 1
        return apply_to_rows(self._tracks.recent(frame, back), self._change, window)

    def of_track(self, track: int) -> Columns:
        """As before."""
        return self._tracks.of_track(track)

    def detections(self, frame: int) -> Columns:
        """As before: an edit changes nothing that was measured."""
        return self._tracks.detections(frame)

    def particles(self, frame: int) -> Columns:
        """The frame's particles in the hands of whom they would belong to."""
        return self._handed_over(self._tracks.particles(frame), frame)

    def parts(self, frame: int) -> Columns:
        """The frame's parts in the hands of whom they would belong to."""
        return self._handed_over(self._tracks.parts(frame), frame)

    def part_particles(self, frame: int) -> Columns:
        """Their particles, likewise."""
        return self._handed_over(self._tracks.part_particles(frame), frame)

    def tracklets(self, frame: int) -> Columns:
        """Likewise the tracklets; those of nobody stay so."""
        return self._handed_over(self._tracks.tracklets(frame), frame)

    def network_boxes(self, frame: int) -> Columns:
        """As before."""
        return self._tracks.network_boxes(frame)

    def signals(self, frame: int) -> Columns:
        """Likewise what was noticed of people."""
        return self._handed_over(self._tracks.signals(frame), frame)

    def parts_of_track(self, track: int) -> Columns:
        """As before."""
        return self._tracks.parts_of_track(track)

    def _handed_over(self, rows: Columns, frame: int) -> Columns:
        track = reassign_ids(rows["track"], np.int64(frame), self._change)
        return {**rows, "track": track}

    def spans(self, tracks: Iterable[int] | None = None) -> dict[int, Spans]:
        """As before."""
        return self._tracks.spans(tracks)

    def keyframes(self, tracks: Iterable[int] | None = None) -> dict[int, NDArray[np.int64]]:
        """As before."""
        return self._tracks.keyframes(tracks)

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """As before."""
        return self._tracks.activity(frame_count)


def apply_to_rows(rows: Columns, change: Change, window: Range) -> Columns:
    """Some rows with all their columns as a change would leave them, with those it adds.

    Args:
        rows: of frames in the window, at least those of the people of interest.
        window: half-open; rows that come are those in these frames.
    """
    kept = ~np.isin(_keys(rows), _keys(change.before.rows))
    come = within(change.after.rows, window)
    track = reassign_ids(rows["track"], rows["frame"], change)
    joined = {
        name: np.concatenate(((track if name == "track" else rows[name])[kept], come[name]))
        for name in rows
    }
    order = np.lexsort((joined["track"], joined["frame"]))
    return {name: column[order] for name, column in joined.items()}


def reassign_ids(
    tracks: NDArray[np.int32], frames: NDArray[np.int32] | np.int64, change: Change
) -> NDArray[np.int32]:
    """(n,) ids of rows in some frames (or all in one) after the change's stretches moved."""
    after = np.array(tracks, np.int32)
    if not len(after):
        return after
    first, last = int(np.min(frames)), int(np.max(frames))
    stretches = change.before.stretches
    near = (stretches[:, 1] <= last) & (stretches[:, 2] > first)
    targets = change.after.stretches[near, 0]
    for (track, start, end), target in zip(stretches[near].tolist(), targets, strict=True):
        after[(tracks == track) & (frames >= start) & (frames < end)] = target
    return after


def within(rows: Columns, window: Range) -> Columns:
    """The rows in a half-open range of frames."""
    inside = (rows["frame"] >= window[0]) & (rows["frame"] < window[1])
    return {name: column[inside] for name, column in rows.items()}


def _keys(rows: Columns) -> NDArray[np.int64]:
    """(n,) one number for each frame and track."""
    return row_keys(rows["frame"], rows["track"])
