"""What the flow tracker looks at: the picture itself, and where something is in it."""

from __future__ import annotations

from collections.abc import Iterable

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground import BackgroundModel, ForegroundSettings, ShadowRemover, Subtraction
from tracking.people import Detections, Observation, Overlays
from tracking.recording.frame import Image, StereoFrame

Mask = NDArray[np.uint8]

SHADOW, SEEN = 127, 255
_HALVED = cv2.INTER_AREA
_SOLID = np.ones((3, 3), np.uint8)
_TOLD_SHADOW = 255


class FlowPerception:
    """Hands the picture on with the foreground, found at half resolution; finds no people itself.

    Pictures stay as recorded: kernels and floor places are worked out through the lens.

    Args:
        fps: frames a second of the recording.
        foreground: settings; None for the usual ones.
    """

    def __init__(self, fps: float, foreground: ForegroundSettings | None = None) -> None:
        self._background = BackgroundModel(fps, foreground)
        self._shadows = ShadowRemover(foreground)

    def learn(self, frames: Iterable[StereoFrame]) -> None:
        """Learn the background from frames spread over some time, before the first `observe`."""
        self._background.learn([_half(frame.left) for frame in frames])

    def observe(self, frame: StereoFrame) -> Observation:
        """The frame's picture and foreground. Frames come in order."""
        seen = self._background.subtract(_half(frame.left))
        overlays = self._overlays(seen, frame.left)
        self._background.update(seen)
        people = nobody_seen(frame.left.shape[:2])
        return Observation(frame.number, frame.time_s, people, overlays, frame.left)

    def overlays(self, frame: StereoFrame) -> Overlays:
        """What a view may lay over a frame; nothing is remembered, frames come in any order."""
        return self._overlays(self._background.subtract(_half(frame.left)), frame.left)

    def _overlays(self, seen: Subtraction, eye: Image) -> Overlays:
        shadow = self._shadows.shadows(seen)
        mask = np.asarray(cv2.morphologyEx(seen.mask, cv2.MORPH_CLOSE, _SOLID), np.uint8)
        mask[shadow == _TOLD_SHADOW] = SHADOW
        size = eye.shape[1], eye.shape[0]
        whole = cv2.resize(mask, size, interpolation=cv2.INTER_NEAREST)
        return Overlays(np.asarray(whole, np.uint8), None)


def nobody_seen(shape: tuple[int, ...]) -> Detections:
    """No people in a picture of that height and width."""
    none = np.zeros((0, 2))
    flags, histograms = np.zeros(0, bool), np.zeros((0, 1), np.float32)
    return Detections(
        box=np.zeros((0, 4)),
        position=np.zeros((0, 3)),
        size=none,
        merged=flags,
        truncated=flags,
        upper=histograms,
        lower=histograms,
        middle=histograms,
        regions=np.broadcast_to(np.int32(0), shape),
        clothes=np.zeros((0, 2, 3), np.float32),
    )


def _half(eye: Image) -> Image:
    size = (max(1, eye.shape[1] // 2), max(1, eye.shape[0] // 2))
    return np.asarray(cv2.resize(eye, size, interpolation=_HALVED), np.uint8)
