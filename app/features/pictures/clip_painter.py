"""The pictures of a clip, painted off the GUI thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, QSizeF
from PySide6.QtGui import QFont, QFontMetricsF, QImage, QPainter

from app.core.drawing.name_plates import draw_note, note_size
from app.core.drawing.viewport import Viewport
from app.core.i18n import time_text, tr
from app.core.projection.right_image import boxes_in_right_image
from app.core.projection.trails import floor_points
from app.core.scenes import Side
from app.core.scenes.floor_marks import FloorMarks
from app.core.scenes.picture_marks import PictureMarks
from app.core.tracks.frame_state import NO_OVERLAY, FrameState, PictureOverlay
from app.features.pictures.clip import ClipChoice, ClipSource
from app.features.pictures.clip_crop import follow
from app.features.pictures.floor_painter import FloorInput, FloorPainter
from app.features.pictures.overhead_presenter import OverheadPresenter
from app.features.pictures.overlays import OverlayPainter
from app.features.pictures.picture_painter import (
    PictureInput,
    PicturePainter,
    image_from_bgr,
    image_from_rgba,
)
from app.features.pictures.presenter import PicturePresenter
from app.features.pictures.ramp_overlay import RampPainter
from tracking.errors import EditError
from tracking.recording import StereoFrame
from tracking.tracks import Columns
from tracking.tracks.columns import box_columns, boxes_of

Bgr = NDArray[np.uint8]

_LINES = 34
"""So many lines of text are as high as the clip: names can be read and hide little."""
_LEAST_FONT_PX, _EDGE_PX = 9, 6.0
_FLOOR_ASPECT = (0.6, 1.4)
"""The floor is at least, and at most, so much wider than high."""


@dataclass(frozen=True, slots=True)
class _Pane:
    """A part of the clip: where it stands, what draws it."""

    rect: QRectF
    draw: Callable[[QPainter, QRectF, StereoFrame, FrameState], None]


class ClipPainter:
    """Paints one picture after the other, of frames in order.

    Attributes:
        size: width and height of the pictures in px; both even, as videos want them.

    Raises:
        EditError: the person to be followed is not in the range.
        CalibrationError: what is laid over the pictures cannot be made of this recording.
    """

    def __init__(self, source: ClipSource, choice: ClipChoice) -> None:
        self._source, self._choice = source, choice
        self._options = choice.view_options(source.view_options)
        self._pictures = PicturePresenter(source.recording)
        self._painters = {side: PicturePainter() for side in (Side.LEFT, Side.RIGHT)}
        self._floor, self._overhead = FloorPainter(), OverheadPresenter(source.recording)
        self._overlay = self._begin_overlay()
        self._parts = {side: self._followed(side) for side in self._sides}
        self._font = QFont(source.font)
        self._font.setPixelSize(max(_LEAST_FONT_PX, round(choice.height_px / _LINES)))
        self._panes, width = self._lay_out()
        self.size = (_even(width), _even(choice.height_px))

    def paint(self, frame: StereoFrame) -> Bgr:
        """(height, width, 3) the frame with everything over it."""
        image = QImage(QSize(*self.size), QImage.Format.Format_RGB32)
        image.fill(self._source.theme.sunken)
        state = self._source.state_at(frame.number)
        painter = QPainter(image)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for pane in self._panes:
            painter.save()
            painter.translate(pane.rect.topLeft())
            area = QRectF(QPointF(), pane.rect.size())
            painter.setClipRect(area)
            pane.draw(painter, area, frame, state)
            painter.restore()
        if self._choice.stamp:
            painter.setFont(self._font)
            text = _stamp_text(frame)
            draw_note(painter, self._stamp_place(text), text, self._source.theme)
        painter.end()
        return _as_bgr(image)

    @property
    def _sides(self) -> tuple[Side, ...]:
        both = self._choice.right and self._source.recording.is_stereo
        return (Side.LEFT, Side.RIGHT) if both else (Side.LEFT,)

    # where everything stands

    def _lay_out(self) -> tuple[list[_Pane], float]:
        """The panes side by side, all as high as the clip; how wide they are together."""
        panes, x, high = [], 0.0, float(_even(self._choice.height_px))
        for side in self._sides:
            size = QSizeF(high * self._aspect(side), high)
            panes.append(_Pane(QRectF(QPointF(x, 0), size), self._drawn_picture(side)))
            x += size.width()
        if self._choice.floor and self._source.recording.view is not None:
            left, bottom, right, top = self._source.bounds
            aspect = float(np.clip((right - left) / max(top - bottom, 1e-6), *_FLOOR_ASPECT))
            panes.append(_Pane(QRectF(x, 0, round(high * aspect), high), self._draw_floor))
            x += round(high * aspect)
        return panes, x

    def _aspect(self, side: Side) -> float:
        parts = self._parts[side]
        width, height = self._source.recording.size if parts is None else parts[0, 2:].tolist()
        return float(width / height)

    def _followed(self, side: Side) -> NDArray[np.float64] | None:
        """The part of a camera's picture in each frame; None: all of it."""
        choice, recording = self._choice, self._source.recording
        if not choice.follow:
            return None
        rows = self._source.tracks.of_track(choice.follow)
        if side is Side.RIGHT:
            rows = self._seen_right(rows)
        parts = follow(rows, (choice.start, choice.stop), recording.size, recording.fps)
        if parts is None and side is Side.LEFT:
            raise EditError("Person {track} is not in these frames", track=choice.follow)
        return parts

    def _seen_right(self, rows: Columns) -> Columns:
        """The rows with boxes of the right camera; as they are where that cannot be known."""
        rig = self._source.recording.rectification
        if rig is None or self._source.recording.ground is None:
            return rows
        every = np.ones(len(rows["frame"]), bool)
        boxes = boxes_in_right_image(rig, boxes_of(rows, every), floor_points(rows))
        return {**rows, **box_columns(boxes)}

    # drawing

    def _drawn_picture(
        self, side: Side
    ) -> Callable[[QPainter, QRectF, StereoFrame, FrameState], None]:
        def draw(painter: QPainter, area: QRectF, frame: StereoFrame, state: FrameState) -> None:
            self._draw_picture(side, painter, area, frame, state)

        return draw

    def _draw_picture(
        self, side: Side, painter: QPainter, area: QRectF, frame: StereoFrame, state: FrameState
    ) -> None:
        laid = self._laid(frame) if side is Side.LEFT else NO_OVERLAY
        scene = self._pictures.scene(side, frame, state, self._options, laid)
        scene = replace(scene, people=scene.people if self._choice.people else ())
        image = image_from_bgr(scene.image)
        content, parts = QRectF(-0.5, -0.5, image.width(), image.height()), self._parts[side]
        if parts is not None:
            content = QRectF(*parts[frame.number - self._choice.start].tolist())
        given = PictureInput(
            scene,
            self._source.marks(side, state) if self._choice.marks else PictureMarks(),
            image,
            image_from_rgba(scene.overlay),
            Viewport.fitting(content, area),
            area,
            self._font,
            QFontMetricsF(self._font).lineSpacing(),
            self._camera_name(side),
            captions=self._choice.legends,
            reserved=self._reserved(side, area, frame),
        )
        self._painters[side].paint(painter, given, self._source.theme)

    def _draw_floor(
        self,
        painter: QPainter,
        area: QRectF,
        frame: StereoFrame,  # noqa: ARG002 - as all panes
        state: FrameState,
    ) -> None:
        bounds = self._source.bounds
        scene = replace(self._overhead.scene(state), bounds=bounds)
        scene = replace(scene, people=scene.people if self._choice.people else ())
        marks = self._source.floor_marks(state) if self._choice.marks else FloorMarks()
        left, bottom, right, top = bounds
        viewport = Viewport.fitting(
            QRectF(left, bottom, right - left, top - bottom), area, upward=True
        )
        given = FloorInput(
            scene,
            marks,
            viewport,
            area.size().toSize(),
            1.0,
            self._font,
            explained=self._choice.legends,
        )
        self._floor.paint(painter, given, self._source.theme)

    def _camera_name(self, side: Side) -> str:
        """Which camera it is, where there are two to be told apart."""
        if not self._choice.legends or len(self._sides) < 2:
            return ""
        return tr("Left camera") if side is Side.LEFT else tr("Right camera")

    def _stamp_place(self, text: str) -> QRectF:
        """At the upper left, where captions of recordings stand too."""
        size = note_size(QFontMetricsF(self._font), text, self.size[0])
        return QRectF(QPointF(_EDGE_PX, _EDGE_PX), size)

    def _reserved(self, side: Side, area: QRectF, frame: StereoFrame) -> tuple[QRectF, ...]:
        """Where frame number and time lie on a camera's picture: on the first one alone."""
        if not self._choice.stamp or side is not Side.LEFT:
            return ()
        return (self._stamp_place(_stamp_text(frame)).intersected(area),)

    def _begin_overlay(self) -> OverlayPainter | RampPainter | None:
        """What paints foreground, distances or the ramp; None where they are not shown."""
        kinds, recording, run = self._options.kinds, self._source.recording, self._source.state.run
        if not kinds:
            return None
        return RampPainter(recording, run) if kinds.ramp else OverlayPainter(recording, run)

    def _laid(self, frame: StereoFrame) -> PictureOverlay:
        if self._overlay is None:
            return NO_OVERLAY
        kinds = self._options.kinds
        painted = self._overlay.paint(frame, kinds)  # which learns how far what is seen is
        return PictureOverlay(painted, self._overlay.legend(kinds))


def _stamp_text(frame: StereoFrame) -> str:
    return tr("frame {0}, {1}").format(frame.number, time_text(frame.time_s))


def _even(length: float) -> int:
    return max(2, 2 * round(length / 2))


def _as_bgr(image: QImage) -> Bgr:
    bits = np.frombuffer(image.constBits(), np.uint8)
    rows = bits.reshape(image.height(), image.bytesPerLine() // 4, 4)
    return np.ascontiguousarray(rows[:, : image.width(), :3])
