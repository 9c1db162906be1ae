"""A frame as the views show it: as it is, as an edit would make it, and compared."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from app.core.editing import PreviewedTracks, preview_trails, rows_replaced_by
from app.core.editing.correction import CorrectionPresenter
from app.core.projection.floor_projection import left_foot_points
from app.core.projection.trails import floor_points
from app.core.tracks.frame_state import FrameState
from app.core.tracks.selection import Selection
from app.core.tracks.track_reader import TrackReader
from app.core.tracks.track_source import TrackSource
from app.core.tracks.two_versions import TwoVersions
from tracking.editing import Change
from tracking.recording import Recording


class FrameStateBuilder:
    """Builds the frame states of one recording from what is shown, selected and being corrected."""

    def __init__(
        self,
        track_source: TrackSource,
        selection: Selection,
        correcting: CorrectionPresenter,
        recording: Recording,
    ) -> None:
        self._track_source, self._selection = track_source, selection
        self._correcting = correcting
        self._left_foot_points = partial(left_foot_points, recording)

    def build_corrected(self, frame: int) -> FrameState:
        """The tracks that are shown; with an edit that waits as they would be after it."""
        planned, flow = self._correcting.planned, self._correcting.flow
        change = planned.change if planned is not None else None
        shown = planned is not None and change is not None
        tracks: TrackReader = self._track_source.tracks
        in_picture, colours = self._left_foot_points, self._track_source.colours
        if change:
            tracks = PreviewedTracks(self._track_source.tracks, change)
            colours = self._track_source.colours_after(change, tracks)
        return FrameState(
            frame=frame,
            tracks=tracks,
            names=self._track_source.names,
            selected=self._selection.track,
            other=flow.other if flow is not None else 0,
            also=self._emphasised(change),
            run=self._track_source.made_by(frame),
            preview=preview_trails(planned, floor_points, colours.of) if planned and shown else (),
            picture_preview=preview_trails(planned, in_picture, colours.of)
            if planned and shown
            else (),
            replaced=rows_replaced_by(planned, frame),
            colours=colours,
            movable=self._correcting.can_place,
            waits=self._correcting.waits,
            drawing=flow.drawing if flow is not None else self._draws,
            says=self._words(frame) if flow is None and self._draws else "",
        )

    def build_compared(self, frame: int, comparison: TwoVersions | None) -> FrameState:
        """The same, with the ways of the people in question in both versions.

        Where two runs are compared, its people are those of the one that is drawn solid.
        """
        state, planned = self.build_corrected(frame), self._correcting.planned
        if comparison is None or (planned is not None and planned.change is not None):
            return state
        if comparison.solid is not None:
            asked = comparison.current
            state = FrameState(
                frame,
                comparison.solid,
                selected=asked.track if asked is not None else 0,
                other=asked.other if asked is not None else 0,
                run=comparison.base_run,
                colours=state.colours,
            )
        return replace(
            state,
            preview=comparison.trails(frame, floor_points),
            picture_preview=comparison.trails(frame, self._left_foot_points),
        )

    @property
    def _draws(self) -> bool:
        """Whether boxes are drawn one after the other."""
        return self._correcting.mode.drawing and self._correcting.can_place

    def _words(self, frame: int) -> str:
        """What the next drag over the picture does."""
        track, names = self._selection.track, self._track_source.names
        new = self._correcting.next_is_new(frame)
        name = "" if new else f"{track} {names.get(track, '')}".strip()
        guesses = len(self._correcting.ghosts_waiting(frame)) > 0
        return self._correcting.mode.words(name, guesses=guesses)

    def _emphasised(self, change: Change | None) -> tuple[int, ...]:
        """Who is drawn like the selected person: others selected too, and who is being drawn."""
        flow = self._correcting.flow
        shown = change is not None and flow is not None and (flow.drawing or not flow.track)
        new = change.tracks if change is not None and shown else ()
        return (*self._selection.also, *new)
