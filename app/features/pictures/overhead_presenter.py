"""The floor from above with its people and particles."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from app.core.i18n import tr
from app.core.projection.extent import (
    MARGIN_M,
    Bounds,
    extent,
    full_extent,
    not_far_beyond,
    reach_m,
    unite,
)
from app.core.projection.trails import TRAIL_S, floor_points, trails_by_track
from app.core.scenes import FloorPerson, OverheadScene
from app.core.tracks.frame_state import FrameState
from app.core.tracks.particle_weights import relative_weights
from tracking.recording import Recording
from tracking.tracks import Columns

Floats = NDArray[np.float64]

_LOOKS_DOWN_DEG = 75.0
_CAMERA = (0.0, 0.0)
_NO_TRAIL: Floats = np.zeros((0, 2))


class OverheadPresenter:
    """Makes overhead scenes of one recording."""

    def __init__(self, recording: Recording) -> None:
        self._trail_frames = max(1, round(TRAIL_S * recording.fps))
        self._field_of_view: Floats = np.zeros((0, 2))
        self._message = tr(
            "The position of the floor is unknown, so people cannot be placed on it. Set up "
            "calibration and floor here, or later: File, Set up this recording."
        )
        self._looks_down = False
        calibration = recording.calibration
        self._rough = calibration is not None and calibration.rough
        self._reach_m = reach_m(recording)
        self._seen: Bounds = (-5.0, -1.0, 5.0, 9.0)
        if recording.view is not None:
            self._field_of_view = recording.view.field_of_view(self._reach_m)
            self._seen = _bounds(np.vstack((self._field_of_view, _CAMERA)))
            self._message = ""
            self._looks_down = recording.view.ground.tilt_deg > _LOOKS_DOWN_DEG
        self._bounds = self._all = self._seen

    def take(self, rows: Columns) -> None:
        """Reach to where other tracks are, rows with `x` and `y`, instead of earlier ones."""
        self._bounds = unite(self._seen, extent(rows, self._reach_m))
        self._all = unite(self._bounds, full_extent(rows, self._reach_m))

    def take_more(self, rows: Columns) -> None:
        """Reach to these places, too, as far as they lie where nobody was before."""
        every = unite(self._all, full_extent(rows, self._reach_m))
        if every != self._all:
            near = not_far_beyond(rows, self._bounds)  # as `take` will have it in the end
            self._bounds = unite(self._bounds, full_extent(near, self._reach_m))
            self._all = every

    @property
    def bounds(self) -> Bounds:
        """Left, bottom, right and top of the floor worth showing, m."""
        return self._bounds

    def scene(self, state: FrameState) -> OverheadScene:
        """The floor in the frame."""
        particles = state.tracks.particles(state.frame)
        measured = state.tracks.detections(state.frame)
        return OverheadScene(
            frame=state.frame,
            particles=np.column_stack((particles["x"], particles["y"])).astype(np.float32),
            particle_colours=state.colours.of_all(particles["track"]),
            particle_weights=relative_weights(particles),
            measured=floor_points(measured),
            people=self._people(state),
            field_of_view=self._field_of_view,
            camera=_CAMERA,
            bounds=self._bounds,
            all_bounds=self._all,
            preview=state.preview,
            message=self._message,
            looks_down=self._looks_down,
            ghosts=_ghosts(state),
            movable=state.movable and not state.waits,
            rough=self._rough,
        )

    def _people(self, state: FrameState) -> tuple[FloorPerson, ...]:
        recent = state.tracks.recent(state.frame, self._trail_frames)
        trails = trails_by_track(recent, floor_points(recent))
        people = _floor_people(state.tracks.of_frame(state.frame), state, trails)
        return tuple(sorted(people, key=lambda person: person.selected))


def _ghosts(state: FrameState) -> tuple[FloorPerson, ...]:
    """People where they are before an edit that waits, as far as it moves or takes them out."""
    rows = state.replaced
    return () if rows is None else tuple(_floor_people(rows, state, {}))


def _floor_people(
    rows: Columns, state: FrameState, trails: Mapping[int, Floats]
) -> Iterator[FloorPerson]:
    """Whoever of the rows has a known place."""
    names = ("track", "x", "y", "vx", "vy", "predicted")
    for track, x, y, vx, vy, lost in zip(*(rows[name].tolist() for name in names), strict=True):
        if np.isfinite(x + y):
            yield FloorPerson(
                track=track,
                label=state.label(track),
                position=(x, y),
                velocity=(vx, vy) if np.isfinite(vx + vy) else (0.0, 0.0),
                colour=state.colours.of(track),
                selected=state.is_chosen(track),
                predicted=lost,
                trail=trails.get(track, _NO_TRAIL),
            )


def _bounds(polygon: Floats) -> Bounds:
    low, high = polygon.min(axis=0) - MARGIN_M, polygon.max(axis=0) + MARGIN_M
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])
