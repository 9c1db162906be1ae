"""The pictures of both cameras with the people in them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.core.i18n import tr
from app.core.projection.floor_projection import left_foot_points, project_floor
from app.core.projection.right_image import boxes_in_right_image
from app.core.projection.trails import TRAIL_S, floor_points, trails_by_track
from app.core.scenes import LegendEntry, PersonMark, PictureScene, PreviewTrail, Side
from app.core.tracks.frame_state import NO_OVERLAY, FrameState, PictureOverlay, ViewOptions
from app.features.pictures.anaglyph import Anaglyph
from app.features.pictures.bodies import BodyPainter, legend_of
from tracking.recording import Image, Recording, StereoFrame
from tracking.tracks import Columns, Source

Floats = NDArray[np.float64]

_GRID_REACH_M = 20
_DIM = (0, 0, 0, 110)
"""What lies over the picture where nobody is looked for."""
_NO_TRAIL: Floats = np.zeros((0, 2))


class PicturePresenter:
    """Makes picture scenes of one recording."""

    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        self._trail_frames = max(1, round(TRAIL_S * recording.fps))
        self._grid: dict[Side, Floats] = {}
        self._outside = _outside(recording.looked_at)
        self._anaglyph = Anaglyph(recording)
        self._bodies = BodyPainter(recording.view)

    def scene(
        self,
        side: Side,
        frame: StereoFrame | None,
        state: FrameState,
        view_options: ViewOptions,
        laid: PictureOverlay = NO_OVERLAY,
    ) -> PictureScene:
        """One camera in the frame; without a frame, a scene that says it is being read.

        `laid` is what lies over the picture below the particles.
        """
        image = None if frame is None else (frame.left if side is Side.LEFT else frame.right)
        if side is Side.RIGHT and not self._recording.is_stereo:
            return PictureScene(side, state.frame, None, message=tr("Recorded with one camera"))
        if image is None:
            return PictureScene(side, state.frame, None, message=tr("Reading..."))
        return PictureScene(
            side,
            state.frame,
            image,
            people=self._people(side, state, view_options),
            overlay=self._overlay(side, state, view_options, image, laid.image),
            grid=self._floor_grid(side) if view_options.grid else np.zeros((0, 2, 2)),
            message=(state.says or laid.message) if side is Side.LEFT else _late_camera(frame),
            preview=self._preview(side, state),
            ghosts=self._ghosts(side, state),
            drawing=state.drawing and side is Side.LEFT,
            movable=state.movable and not state.waits and side is Side.LEFT,
            legend=self._legend(side, state, view_options, laid),
        )

    def anaglyph(
        self,
        frame: StereoFrame | None,
        state: FrameState,
        view_options: ViewOptions,
        laid: PictureOverlay = NO_OVERLAY,
    ) -> PictureScene:
        """Both cameras in one picture for red and cyan glasses, with the left camera's people."""
        scene = self.scene(Side.LEFT, frame, state, view_options, laid)
        return scene if frame is None else self._anaglyph.scene(frame, scene)

    def _legend(
        self, side: Side, state: FrameState, view_options: ViewOptions, laid: PictureOverlay
    ) -> tuple[LegendEntry, ...]:
        if not view_options.bodies or side is not Side.LEFT:
            return laid.legend
        return (*legend_of(state, view_options), *laid.legend)

    def _preview(self, side: Side, state: FrameState) -> tuple[PreviewTrail, ...]:
        """The trails of an edit that waits; for the right camera from their places on the floor."""
        if side is Side.LEFT:
            return state.picture_preview
        found = []
        for trail in state.preview:
            points = project_floor(self._recording, side, trail.points)
            found.append(replace(trail, points=points[np.isfinite(points).all(axis=1)]))
        return tuple(found)

    def _people(
        self, side: Side, state: FrameState, view_options: ViewOptions
    ) -> tuple[PersonMark, ...]:
        rows = state.tracks.of_frame(state.frame)
        trails = self._trails(side, state) if view_options.trails else {}
        marks = self._marks(side, rows, state, trails)
        return tuple(sorted(marks, key=lambda mark: mark.selected))

    def _ghosts(self, side: Side, state: FrameState) -> tuple[PersonMark, ...]:
        """People where they are before an edit that waits, as far as it moves or takes them out."""
        rows = state.replaced
        return () if rows is None else tuple(self._marks(side, rows, state, {}))

    def _marks(
        self, side: Side, rows: Columns, state: FrameState, trails: Mapping[int, Floats]
    ) -> Iterator[PersonMark]:
        boxes = np.column_stack([rows[name] for name in ("left", "top", "width", "height")])
        if side is Side.RIGHT:
            boxes = self._right_boxes(boxes, rows)
        movable = state.selected if state.movable and side is Side.LEFT else 0
        hidden = rows["visibility"] == 0
        by_person = rows["source"] == Source.PERSON if "source" in rows else np.zeros_like(hidden)
        columns = rows["track"], rows["predicted"], hidden, by_person
        for box, track, lost, behind, key in zip(
            boxes, *(one.tolist() for one in columns), strict=True
        ):
            if np.isfinite(box).all():
                yield PersonMark(
                    track=track,
                    box=(float(box[0]), float(box[1]), float(box[2]), float(box[3])),
                    label=state.label(track),
                    colour=state.colours.of(track),
                    selected=state.is_chosen(track),
                    predicted=lost,
                    trail=trails.get(track, _NO_TRAIL),
                    occluded=behind,
                    keyframe=key,
                    movable=track == movable,
                )

    def _trails(self, side: Side, state: FrameState) -> dict[int, Floats]:
        rows = state.tracks.recent(state.frame, self._trail_frames)
        if side is Side.LEFT:
            return trails_by_track(rows, left_foot_points(self._recording, rows))
        return trails_by_track(rows, project_floor(self._recording, side, floor_points(rows)))

    def _right_boxes(self, boxes: Floats, rows: Columns) -> Floats:
        rectification = self._recording.rectification
        if rectification is None or self._recording.ground is None or not len(boxes):
            return np.full_like(boxes, np.nan)
        return boxes_in_right_image(rectification, boxes, floor_points(rows))

    def _overlay(
        self,
        side: Side,
        state: FrameState,
        view_options: ViewOptions,
        image: Image,
        laid: NDArray[np.uint8] | None,
    ) -> NDArray[np.uint8] | None:
        """All that lies over a picture: the very same as was laid where there is nothing more."""
        if view_options.region and side is Side.LEFT and self._outside is not None:
            laid = self._outside if laid is None else _below(laid, self._outside)
        if view_options.bodies and side is Side.LEFT:
            laid = self._bodies.over(state, view_options, laid, image.shape)
        return self._particles(side, state, image, laid) if view_options.particles else laid

    def _particles(
        self, side: Side, state: FrameState, image: Image, below: NDArray[np.uint8] | None
    ) -> NDArray[np.uint8]:
        """The particles as dots of their person's colour in a picture to lay over."""
        particles = state.tracks.particles(state.frame)
        overlay = np.zeros((*image.shape[:2], 4), np.uint8) if below is None else below.copy()
        floor = np.column_stack((particles["x"], particles["y"])).astype(np.float64)
        pixels = project_floor(self._recording, side, floor)
        height, width = image.shape[:2]
        with np.errstate(invalid="ignore"):
            inside = (pixels >= 0).all(axis=1) & (pixels < (width - 1, height - 1)).all(axis=1)
        column, row = pixels[inside].astype(np.intp).T
        colours = state.colours.of_all(particles["track"][inside])
        for down, right in ((0, 0), (0, 1), (1, 0), (1, 1)):
            overlay[row + down, column + right, :3] = colours
            overlay[row + down, column + right, 3] = 220
        return overlay

    def _floor_grid(self, side: Side) -> Floats:
        if side not in self._grid:
            lines = _grid_lines(_GRID_REACH_M)
            pixels = project_floor(self._recording, side, lines.reshape(-1, 2)).reshape(-1, 2, 2)
            width, height = self._recording.size
            with np.errstate(invalid="ignore"):
                near = (np.abs(pixels) < 4 * max(width, height)).all(axis=(1, 2))
            self._grid[side] = pixels[near & np.isfinite(pixels).all(axis=(1, 2))]
        return self._grid[side]


def _late_camera(frame: StereoFrame | None) -> str:
    """Which picture the right camera shows, where it is not the one recorded with the left one."""
    if frame is None or frame.right_lag == 0:
        return ""
    if frame.right_lag is None:
        return tr("Nothing was recorded at this instant: another frame is shown")
    number = frame.number + frame.right_lag
    return tr("Frame {number} of this camera: the same instant", number=number)


def _grid_lines(reach_m: int) -> Floats:
    """Segments (n, 2, 2) of half a metre along lines a metre apart, ahead of and around."""
    whole = np.arange(-reach_m, reach_m + 1, dtype=np.float64)
    half = np.arange(-reach_m, reach_m, 0.5)
    along, across = np.meshgrid(half, whole, indexing="ij")
    begin = np.stack((along.ravel(), across.ravel()), axis=1)
    forward = np.stack((begin, begin + np.array([0.5, 0.0])), axis=1)
    return np.concatenate((forward, forward[..., ::-1]))


def _outside(looked_at: NDArray[np.uint8] | None) -> NDArray[np.uint8] | None:
    """(height, width, 4) RGBA that dims what is outside of the region of interest."""
    if looked_at is None:
        return None
    dim = np.zeros((*looked_at.shape, 4), np.uint8)
    dim[looked_at == 0] = _DIM
    return dim


def _below(laid: NDArray[np.uint8], dim: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What is laid over a picture, and the dimming where that is nothing."""
    return np.where(laid[..., 3:] > 0, laid, dim)
