"""The timeline's lanes, made again only where something changed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.presenters.palette import colour_of_track
from app.presenters.scenes import Lane, TimelineScene
from app.presenters.setting import Instant
from app.presenters.shown import ShownTracks, Spans


class TimelinePresenter:
    """Makes timeline scenes of one recording.

    `lanes` and `activity` of the scene stay the same objects until the tracks, their names, the
    marks or the selection change, so that a view repaints the playhead alone while playing.
    """

    def __init__(self, frame_count: int, fps: float) -> None:
        self._frame_count = frame_count
        self._fps = fps
        self._spans: dict[int, Spans] = {}
        self._marks: dict[int, tuple[int, ...]] = {}
        self._activity: NDArray[np.uint16] = np.zeros(frame_count, np.uint16)
        self._lanes: tuple[Lane, ...] = ()
        self._plain: tuple[Lane, ...] = ()
        self._row: dict[int, int] = {}
        self._known: tuple[object, ...] = ()
        self._chosen: tuple[int, ...] | None = None
        self._version = 0

    def take(self, tracks: ShownTracks, marks: Mapping[int, tuple[int, ...]]) -> None:
        """Take all lanes anew."""
        self._spans = tracks.spans()
        self._marks = dict(marks)
        self._activity = tracks.activity(self._frame_count)
        self._version += 1

    def take_changed(
        self,
        changed: Iterable[int],
        spans: Mapping[int, Spans],
        frames: tuple[NDArray[np.int32], NDArray[np.int32]],
        marks: Mapping[int, tuple[int, ...]],
    ) -> None:
        """Take the lanes of some tracks anew; those without spans go.

        `frames` are the frames of the rows that went and of those that came: with ten million
        rows nobody counts them all again for one edit.
        """
        for track in changed:
            if track in spans:
                self._spans[track] = spans[track]
            else:
                self._spans.pop(track, None)
        gone, come = (np.bincount(rows, minlength=self._frame_count) for rows in frames)
        change = (come - gone)[: self._frame_count]
        if change.any():
            self._activity = (self._activity + change).astype(np.uint16)
        self._marks = dict(marks)
        self._version += 1

    def scene(
        self,
        playhead: int,
        instant: Instant,
        loaded: tuple[tuple[int, int], ...],
        cut: int | None,
        message: str = "",
    ) -> TimelineScene:
        """The timeline with its playhead."""
        known = (self._version, instant.names)
        if known != self._known:
            self._known, self._chosen = known, None
            self._plain = self._make_lanes(instant)
            self._row = {lane.track: row for row, lane in enumerate(self._plain)}
        chosen = (instant.selected, instant.other)
        if chosen != self._chosen:
            self._chosen = chosen
            self._lanes = self._with_chosen(chosen)
        return TimelineScene(
            frame_count=self._frame_count,
            fps=self._fps,
            frame=playhead,
            lanes=self._lanes,
            activity=self._activity,
            tracked=instant.tracks.frames,
            loaded=loaded,
            cut=cut,
            message=message,
        )

    def _make_lanes(self, instant: Instant) -> tuple[Lane, ...]:
        """All lanes, none of them selected."""
        by_start = sorted(self._spans, key=lambda track: (int(self._spans[track][0, 0]), track))
        return tuple(
            Lane(
                track=track,
                label=instant.label(track),
                colour=colour_of_track(track),
                selected=False,
                spans=self._spans[track],
                marks=self._marks.get(track, ()),
            )
            for track in by_start
        )

    def _with_chosen(self, chosen: tuple[int, ...]) -> tuple[Lane, ...]:
        """The lanes with some selected; with ten thousand of them a click stays quick."""
        lanes = list(self._plain)
        for track in chosen:
            if track in self._row:
                row = self._row[track]
                lanes[row] = replace(lanes[row], selected=True)
        return tuple(lanes)
