"""What a tracker offers to views: drawings of its work to lay over the left image.

A tracker declares them in its entry of the catalogue. A view draws what is declared and needs to
know no tracker.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Picture
from tracking.geometry import View
from tracking.recording.frame import StereoFrame

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class RegionOfEvaluation:
    """Where one person's hypotheses are evaluated.

    Attributes:
        outline: (points, 2) px of the left image as recorded; what lies inside counts.
        masked: (others, points, 2) px; what lies inside of these does not.
    """

    outline: Floats
    masked: Floats


@dataclass(frozen=True, slots=True)
class Bodies:
    """People, or hypotheses of where they are, on the floor.

    Attributes:
        xy: (n, 2) m. height_m: (n,) m; NaN: not estimated, the tracker takes what it starts with.
    """

    xy: Floats
    height_m: Floats


@dataclass(frozen=True, slots=True)
class EvaluationOverlay:
    """Regions in which hypotheses are evaluated.

    Attributes:
        setting: the name of a switch; runs without it have no such regions.
        draw: (camera over its floor, settings, the person, the others) -> the person's region.
    """

    setting: str
    draw: Callable[[View, Any, Bodies, Bodies], RegionOfEvaluation]


class RampSource(Protocol):
    """Makes ramp images of single frames, in any order, over a background of its own."""

    def learn(self, frames: Sequence[StereoFrame], later: Sequence[StereoFrame] = ()) -> None:
        """Learn the background from frames spread over some time, before the first image."""

    def ramp_picture(self, frame: StereoFrame) -> Picture:
        """(height, width) uint8: 255 surely differs from the background; px as recorded."""


@dataclass(frozen=True, slots=True)
class TrackerOverlays:
    """What can be drawn of a tracker's work; None or False: nothing of the kind.

    All take the settings that the tracker has or had, and draw in px of the left image as recorded.

    Attributes:
        subtraction: it finds foreground and disparity with two cameras, with the settings
            `foreground` and `stereo`.
        tracklets: its runs hold the points it follows.
        kernel: (camera over its floor, settings, (n, 2) m where people are) -> (n, 4, 2) corners of
            the rectangles in which tracklets belong to them; NaN: there is none.
        outlines: (camera over its floor, settings, hypotheses, points) -> (n, points, 2) closed
            outlines of their bodies; NaN: not wholly in front of the camera.
        evaluation: regions in which hypotheses are evaluated.
        ramp: (frames per second, camera over its floor, settings) -> ramp images: how surely each
            pixel differs from the background.
    """

    subtraction: bool = False
    tracklets: bool = False
    kernel: Callable[[View, Any, Floats], Floats] | None = None
    outlines: Callable[[View, Any, Bodies, int], Floats] | None = None
    evaluation: EvaluationOverlay | None = None
    ramp: Callable[[float, View, Any], RampSource] | None = None
