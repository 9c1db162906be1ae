"""What subtraction stereo makes of a frame, as soft colours to lay over the left picture."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from app.core.colours.colour_scales import VIRIDIS
from app.core.i18n import tr
from app.core.scenes import Colour, LegendEntry
from app.core.tracks.frame_state import Kinds
from app.core.tracks.made_by import MadeBy, overlay_of
from tracking.errors import CalibrationError
from tracking.geometry import Rectification
from tracking.people import DepthPerception, Overlays, StereoPerception
from tracking.pipeline import background_samples
from tracking.recording import Recording, StereoFrame

Rgba = NDArray[np.uint8]
Floats = NDArray[np.float64]

FOREGROUND: Colour = (0, 190, 230)
SHADOW: Colour = (240, 160, 40)
_FOREGROUND_OPACITY, _DISPARITY_OPACITY = 120, 185
_HEAD_M = 1.8
_REACH_PER_HEIGHT, _REACH_M = 4.5, (8.0, 20.0)


class OverlayPainter:
    """Paints overlays of single frames in any order, with backgrounds of its own.

    Its backgrounds are learnt once, from frames spread over the recording, as a tracker's are
    before its first step; unlike a tracker's they do not change from frame to frame.

    Args:
        recording: two calibrated cameras and a floor.
        run: whose settings of foreground and stereo are taken; the usual ones without.

    Raises:
        CalibrationError: the recording has no second camera, no calibration or no floor.
    """

    def __init__(self, recording: Recording, run: MadeBy | None = None) -> None:
        rectification, ground = recording.rectification, recording.ground
        if rectification is None or ground is None or recording.view is None:
            raise CalibrationError(
                "{name}: foreground and disparity need two calibrated cameras and the floor; "
                "add [calibration] and [ground] to recording.toml",
                name=recording.name,
            )
        _, settings = overlay_of(run, lambda overlays: overlays.subtraction or None)
        self._recording = recording
        self._rectification = rectification
        kind = DepthPerception if recording.has_depth else StereoPerception
        self._perception = kind(
            rectification, ground, recording.fps, settings.foreground, settings.stereo
        )
        self._scale = disparity_scale(recording, rectification)
        self._maps: tuple[NDArray[np.float32], NDArray[np.float32]] | None = None
        self._learnt = False

    def paint(self, frame: StereoFrame, kinds: Kinds) -> Rgba:
        """(height, width, 4) uint8 RGBA over the left picture as recorded.

        The first call learns the backgrounds, which takes a second or two.

        Raises:
            RecordingError: a frame cannot be read.
        """
        if not self._learnt:
            self._perception.learn(*background_samples(self._recording))
            self._learnt = True
        painted = paint_overlays(self._perception.overlays(frame), kinds, self._scale)
        return self._as_recorded(painted)

    def legend(self, kinds: Kinds) -> tuple[LegendEntry, ...]:
        """What the colours mean."""
        entries: list[LegendEntry] = []
        if kinds.foreground:
            entries.append(LegendEntry(FOREGROUND, tr("foreground")))
            entries.append(LegendEntry(SHADOW, tr("shadow")))
        if kinds.disparity:
            far, near = self._scale
            for share in (1.0, 0.5, 0.0):
                metres = self._depth_m(far + share * (near - far))
                colour = VIRIDIS.colour(share)
                entries.append(LegendEntry(colour, tr("{z:.1f} m away", z=metres)))
        return tuple(entries)

    def _depth_m(self, disparity: float) -> float:
        rig = self._rectification
        return rig.focal_px * rig.baseline_m / max(disparity - rig.disparity_offset_px, 1e-6)

    def _as_recorded(self, painted: Rgba) -> Rgba:
        """The rectified overlay where its pixels stand in the recorded picture."""
        if self._rectification.identity:
            return painted
        if self._maps is None:
            width, height = self._recording.size
            columns, rows = np.meshgrid(np.arange(width, dtype=float), np.arange(height))
            recorded = np.column_stack((columns.ravel(), rows.ravel()))
            places = self._rectification.rectified_from_recorded(recorded).astype(np.float32)
            x, y = places.T.reshape(2, height, width)
            self._maps = (np.ascontiguousarray(x), np.ascontiguousarray(y))
        x, y = self._maps
        return np.asarray(cv2.remap(painted, x, y, cv2.INTER_NEAREST), np.uint8)


def paint_overlays(overlays: Overlays, kinds: Kinds, scale: tuple[float, float]) -> Rgba:
    """RGBA in the pixels of the overlays: foreground below, disparity over it.

    Args:
        scale: the disparities (px) of the first and the last colour: far, near.
    """
    painted = np.zeros((*overlays.foreground.shape, 4), np.uint8)
    if kinds.foreground:
        painted[overlays.foreground == 255] = (*FOREGROUND, _FOREGROUND_OPACITY)
        painted[overlays.foreground == 127] = (*SHADOW, _FOREGROUND_OPACITY)
    if kinds.disparity and overlays.disparity is not None:
        known = np.isfinite(overlays.disparity)
        far, near = scale
        share = (overlays.disparity[known] - far) / max(near - far, 1e-6)
        levels = np.clip(255 * share, 0, 255).astype(np.uint8)
        painted[known, :3] = VIRIDIS.table[levels]
        painted[known, 3] = _DISPARITY_OPACITY
    return painted


def disparity_scale(recording: Recording, rectification: Rectification) -> tuple[float, float]:
    """Disparities (px) of the farthest floor and of the nearest head that can be seen."""
    assert recording.view is not None
    height_m = recording.view.ground.height_m
    reach_m = float(np.clip(_REACH_PER_HEIGHT * height_m, *_REACH_M))
    floor = recording.view.field_of_view(reach_m)
    low, high = np.zeros(len(floor)), np.full(len(floor), min(_HEAD_M, 0.7 * height_m))
    standing = np.concatenate((np.column_stack((floor, low)), np.column_stack((floor, high))))
    disparity = rectification.disparity_from_world(standing)
    usable = disparity[np.isfinite(disparity) & (disparity > rectification.disparity_offset_px)]
    return (float(usable.min()), float(usable.max())) if len(usable) else (0.0, 64.0)
