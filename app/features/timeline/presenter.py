"""The timeline's lanes, made again only where something changed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.core.document.document_listener import Marks
from app.core.scenes import Lane, TimelineMark, TimelineScene
from app.core.scenes.part_curve import LaneScore
from app.core.tracks.frame_state import FrameState
from app.core.tracks.track_reader import Spans, TrackReader
from tracking.tracks import ReviewedRange

_NO_KEYFRAMES: NDArray[np.int64] = np.zeros(0, np.int64)
_MOST_PEOPLE = np.iinfo(np.uint16).max


class TimelinePresenter:
    """Makes timeline scenes of one recording.

    `lanes`, `activity`, `review_items` and `reviewed` of the scene stay the same objects until what
    they show changes, so that a view repaints the playhead alone while playing; of a thousand lanes
    an edit makes only those anew that it touched.
    """

    def __init__(self, frame_count: int, fps: float) -> None:
        self._frame_count = frame_count
        self._fps = fps
        self._spans: dict[int, Spans] = {}
        self._keyframes: dict[int, NDArray[np.int64]] = {}
        self._edits: Marks = {}
        self._review_items: Marks = {}
        self._all_review_items: tuple[TimelineMark, ...] = ()
        self._reviewed_of: dict[int, tuple[tuple[int, int], ...]] = {}
        self._reviewed: tuple[ReviewedRange, ...] = ()
        self._names: Mapping[int, str] = {}
        self._activity: NDArray[np.uint16] = np.zeros(frame_count, np.uint16)
        self._plain: dict[int, Lane] = {}
        self._stale: set[int] = set()
        self._order: tuple[Lane, ...] = ()
        self._row: dict[int, int] = {}
        self._lanes: tuple[Lane, ...] = ()
        self._chosen: tuple[int, ...] | None = None
        self._score: LaneScore | None = None

    def take(self, tracks: TrackReader, marks: Marks) -> None:
        """Take all lanes anew."""
        before, self._spans = self._spans, tracks.spans()
        self._keyframes = tracks.keyframes()
        self._activity = tracks.activity(self._frame_count)
        either = before.keys() | self._spans.keys()
        self._stale |= {one for one in either if before.get(one) is not self._spans.get(one)}
        self._take_edits(marks)

    def take_changed(
        self,
        changed: Iterable[int],
        tracks: TrackReader,
        frames: tuple[NDArray[np.int32], NDArray[np.int32]],
        marks: Marks,
    ) -> None:
        """Take the lanes of some tracks anew; those without rows go.

        `frames` are the frames of the rows that went and of those that came: with ten million
        rows nobody counts them all again for one edit.
        """
        touched = set(changed)
        for known, now in (
            (self._spans, tracks.spans(touched)),
            (self._keyframes, tracks.keyframes(touched)),
        ):
            for track in touched:
                known.pop(track, None)
            known.update(now)
        self._stale |= touched
        self._count(*frames)
        self._take_edits(marks)

    def take_review_items(self, review_items: Sequence[TimelineMark]) -> None:
        """Mark what may be wrong; a review item of two tracks is given once for each of them."""
        by_track: dict[int, list[TimelineMark]] = {}
        for mark in review_items:
            by_track.setdefault(mark.track, []).append(mark)
        before = self._review_items
        self._review_items = {track: tuple(marks) for track, marks in by_track.items()}
        self._all_review_items = tuple(review_items)
        self._stale |= _differing(before, self._review_items)

    def take_reviewed(self, reviewed: tuple[ReviewedRange, ...]) -> None:
        """Shade what a person has looked at."""
        if reviewed is self._reviewed:
            return
        self._reviewed = reviewed
        before = self._reviewed_of
        by_track: dict[int, list[tuple[int, int]]] = {}
        for seen in reviewed:
            by_track.setdefault(seen.track, []).append((seen.start, seen.end))
        self._reviewed_of = {track: tuple(ranges) for track, ranges in by_track.items()}
        self._stale |= _differing(before, self._reviewed_of)

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self._stale |= self._spans.keys()

    def take_score(self, score: LaneScore | None) -> None:
        """Draw over a selected lane how a part of its person went."""
        if score is not self._score:
            self._score, self._chosen = score, None

    def scene(
        self,
        playhead: int,
        state: FrameState,
        loaded: tuple[tuple[int, int], ...],
        cut: int | None,
        message: str = "",
        marked: tuple[int, int] | None = None,
    ) -> TimelineScene:
        """The timeline with its playhead."""
        if state.names != self._names:
            self._stale |= _differing(self._names, state.names)
            self._names = state.names
        if self._stale:
            self._make_stale(state)
        chosen = state.chosen
        if chosen != self._chosen:
            self._chosen = chosen
            self._lanes = self._with_chosen(chosen)
        return TimelineScene(
            frame_count=self._frame_count,
            fps=self._fps,
            frame=playhead,
            lanes=self._lanes,
            activity=self._activity,
            tracked=state.tracks.frames,
            loaded=loaded,
            cut=cut,
            marked=marked,
            message=message,
            review_items=self._all_review_items,
            reviewed=self._reviewed_of.get(0, ()),
        )

    def _take_edits(self, marks: Marks) -> None:
        before, self._edits = self._edits, dict(marks)
        self._stale |= _differing(before, self._edits)

    def _count(self, gone: NDArray[np.int32], come: NDArray[np.int32]) -> None:
        """Count the people anew in the frames between the first and the last that changed."""
        changed = np.concatenate([gone, come])
        if not len(changed):
            return
        first, stop = int(changed.min()), min(int(changed.max()) + 1, self._frame_count)
        if stop <= first:
            return
        inside = (rows[rows < stop] - first for rows in (come, gone))
        more, less = (np.bincount(rows, minlength=stop - first) for rows in inside)
        activity = self._activity.copy()
        people = activity[first:stop] + (more - less)
        activity[first:stop] = np.clip(people, 0, _MOST_PEOPLE)
        self._activity = activity

    def _make_stale(self, state: FrameState) -> None:
        """Make the lanes anew that show something else by now, and put all in order."""
        for track in self._stale:
            self._plain.pop(track, None)
            if track in self._spans:
                self._plain[track] = self._make_lane(track, state)
        self._stale = set()
        by_start = sorted((int(self._spans[track][0, 0]), track) for track in self._plain)
        self._order = tuple(self._plain[track] for _, track in by_start)
        self._row = {lane.track: row for row, lane in enumerate(self._order)}
        self._chosen = None

    def _make_lane(self, track: int, state: FrameState) -> Lane:
        first, end = int(self._spans[track][0, 0]), int(self._spans[track][-1, 1])
        # Where a track no longer reaches, an older edit of it is not on its lane either.
        edits = [mark for mark in self._edits.get(track, ()) if first <= mark.frame <= end]
        marks = (*edits, *self._review_items.get(track, ()))
        return Lane(
            track=track,
            label=state.label(track),
            colour=state.colours.of(track),
            selected=False,
            spans=self._spans[track],
            marks=tuple(sorted(marks, key=lambda mark: mark.frame)),
            keyframes=self._keyframes.get(track, _NO_KEYFRAMES),
            reviewed=self._reviewed_of.get(track, ()),
        )

    def _with_chosen(self, chosen: tuple[int, ...]) -> tuple[Lane, ...]:
        """The lanes with some selected; with ten thousand of them a click stays quick."""
        lanes = list(self._order)
        for track in chosen:
            if track in self._row:
                row = self._row[track]
                score = self._score if self._score and self._score.track == track else None
                lanes[row] = replace(lanes[row], selected=True, score=score)
        return tuple(lanes)


def _differing(before: Mapping[int, object], after: Mapping[int, object]) -> set[int]:
    """The keys whose value is another one, or that are only on one side."""
    keys = before.keys() | after.keys()
    return {key for key in keys if before.get(key) != after.get(key)}
