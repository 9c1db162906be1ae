"""Occluders, counting lines and regions as outlines in the pictures and on the floor."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from app.presenters.labelling.labelling_scene import (
    LINE_COLOUR,
    OCCLUDER_COLOUR,
    REGION_COLOUR,
    FloorLabels,
    Outline,
    Tool,
)
from app.presenters.pictures.projection import project_outline
from app.presenters.scenes import Eye
from tracking.recording import Recording
from tracking.tracks import CountingLine, Labels

Floats = NDArray[np.float64]
Drawn = tuple[Tool, int]
"""What is picked: the tool that draws it and its number; -1 for nothing."""

_NO_ARROW: Floats = np.zeros((0, 2))
_ARROW_M = 0.6


class DrawnLabels:
    """Makes the outlines; they are made anew only where something was drawn or picked."""

    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        self._made: dict[Eye | None, tuple[tuple[object, ...], tuple[Outline, ...]]] = {}

    def floor(self, labels: Labels, picked: Drawn) -> FloorLabels:
        """Lines and regions in metres."""
        return FloorLabels(self._outlines(None, labels, picked))

    def picture(self, eye: Eye, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        """Occluders (of the left eye), and lines and regions as an eye sees the floor."""
        return self._outlines(eye, labels, picked)

    def _outlines(self, eye: Eye | None, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        key = (labels.occluders, labels.lines, labels.regions, picked)
        made = self._made.get(eye)
        if made is None or made[0] != key:
            made = key, self._make(eye, labels, picked)
            self._made[eye] = made
        return made[1]

    def _make(self, eye: Eye | None, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        on_floor = [
            Outline(
                region.name,
                self._seen(eye, np.asarray(region.polygon), closed=True),
                True,
                REGION_COLOUR,
                picked=picked == (Tool.REGIONS, number),
            )
            for number, region in enumerate(labels.regions)
        ] + [
            Outline(
                line.name,
                self._seen(eye, np.array([line.start, line.end])),
                False,
                LINE_COLOUR,
                self._seen(eye, forward_arrow(line), dense=False),
                picked == (Tool.LINES, number),
            )
            for number, line in enumerate(labels.lines)
        ]
        if eye in (None, Eye.RIGHT):
            return tuple(on_floor)
        occluders = [
            Outline(
                occluder.name,
                np.asarray(occluder.polygon, np.float64),
                True,
                OCCLUDER_COLOUR,
                picked=picked == (Tool.OCCLUDERS, number),
            )
            for number, occluder in enumerate(labels.occluders)
        ]
        return (*on_floor, *occluders)

    def _seen(
        self, eye: Eye | None, corners: Floats, closed: bool = False, dense: bool = True
    ) -> Floats:
        """The corners as they are on the floor, or the line through them as an eye sees it."""
        if eye is None:
            return corners.astype(np.float64)
        if closed:
            corners = np.concatenate((corners, corners[:1]))
        pixels = project_outline(self._recording, eye, corners)
        if dense:
            return pixels
        ends = pixels[[0, -1]]
        return ends if np.isfinite(ends).all() else _NO_ARROW


def forward_arrow(line: CountingLine) -> Floats:
    """(2, 2) from the middle of a line to its right-hand side, looking from start to end."""
    start, end = np.array(line.start, np.float64), np.array(line.end, np.float64)
    along = end - start
    length = float(np.hypot(*along))
    if length == 0:
        return _NO_ARROW
    right = np.array([along[1], -along[0]]) / length
    middle = (start + end) / 2
    return np.stack([middle, middle + right * min(_ARROW_M, max(0.25, length / 2))])
