"""Occluders, counting lines and regions as outlines in the pictures and on the floor."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.core.projection.extent import reach_m
from app.core.projection.floor_projection import project_outline
from app.core.scenes import Side
from app.core.scenes.labels import LINE_COLOUR, OCCLUDER_COLOUR, REGION_COLOUR, Outline, Tool
from tracking.recording import Recording
from tracking.tracks import CountingLine, Labels, Region

Floats = NDArray[np.float64]
Drawn = tuple[Tool, int]
"""What is picked: the tool that draws it and its number; -1 for nothing."""

_NO_ARROW: Floats = np.zeros((0, 2))
_ARROW_M = 0.6
_ARROW_PX = (12.0, 40.0)
_POINTS_A_SIDE = 24
"""A straight line in the picture bends on the floor, as the lens does."""
_TIMES_REACH = 2.0
"""Farther than so many times as far as the floor is shown a pixel is many metres."""


class DrawnLabels:
    """Makes the outlines; they are made anew only where something was drawn or picked."""

    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        self._made: dict[Side | None, tuple[tuple[object, ...], tuple[Outline, ...]]] = {}

    def floor(self, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        """Lines and regions in metres; of those in the picture, where the floor is seen there."""
        return self._outlines(None, labels, picked)

    def picture(self, side: Side, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        """What was drawn in the left camera, and what lies on the floor as a camera sees it."""
        return self._outlines(side, labels, picked)

    def _outlines(self, side: Side | None, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        key = (labels.occluders, labels.lines, labels.regions, picked)
        made = self._made.get(side)
        if made is None or made[0] != key:
            made = key, self._make(side, labels, picked)
            self._made[side] = made
        return made[1]

    def _make(self, side: Side | None, labels: Labels, picked: Drawn) -> tuple[Outline, ...]:
        counted = (
            *(self._region(side, region, number) for number, region in enumerate(labels.regions)),
            *(self._line(side, line, number) for number, line in enumerate(labels.lines)),
        )
        seen = (one for one in counted if one is not None)
        lying = [replace(one, picked=picked == one.key) for one in seen]
        if side in (None, Side.RIGHT):
            return tuple(lying)
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
        return (*lying, *occluders)

    def _region(self, side: Side | None, region: Region, number: int) -> Outline | None:
        """None where it lies in the picture, and the right camera's is drawn."""
        corners, key = np.asarray(region.polygon, np.float64), (Tool.REGIONS, number)
        if not self._lies_in(side, region):
            return None
        if region.in_picture and side is None:
            corners = self._floor_below(np.concatenate((corners, corners[:1])))
        elif not region.in_picture:
            corners = self._seen(side, corners, closed=True)
        return Outline(region.name, corners, True, REGION_COLOUR, key=key)

    def _line(self, side: Side | None, line: CountingLine, number: int) -> Outline | None:
        ends, key = np.array([line.start, line.end], np.float64), (Tool.LINES, number)
        if not self._lies_in(side, line):
            return None
        if line.in_picture and side is None:
            return self._line_below(line, ends, key)
        if line.in_picture:
            return Outline(line.name, ends, False, LINE_COLOUR, picture_arrow(line), key=key)
        arrow = self._seen(side, forward_arrow(line), dense=False)
        return Outline(line.name, self._seen(side, ends), False, LINE_COLOUR, arrow, key=key)

    def _line_below(self, line: CountingLine, ends: Floats, key: Drawn) -> Outline:
        """The floor under a line in the picture: feet cross the one where they cross the other."""
        floor, arrow = self._floor_below(ends), _NO_ARROW
        if np.isfinite(floor).all():
            (x, y), (to_x, to_y) = floor[[0, -1]].tolist()
            arrow = forward_arrow(CountingLine(line.name, (x, y), (to_x, to_y)))
        return Outline(line.name, floor, False, LINE_COLOUR, arrow, key=key)

    def _lies_in(self, side: Side | None, item: CountingLine | Region) -> bool:
        """Whether something can be seen in a camera, or on the floor where that is None."""
        if item.in_picture and side is not None:
            return side in (Side.LEFT, Side.BOTH)
        if item.in_picture:
            return self._recording.view is not None
        return side is None or self._recording.view is not None

    def _floor_below(self, pixels: Floats) -> Floats:
        """(n, 2) m, the floor along a line in the left picture; NaN where it is not seen there."""
        view = self._recording.view
        assert view is not None
        parts = [np.linspace(*ends, _POINTS_A_SIDE) for ends in pairwise(pixels)]
        places = np.asarray(view.floor_from_pixel(np.concatenate(parts)), np.float64)
        with np.errstate(invalid="ignore"):
            far = np.hypot(places[:, 0], places[:, 1]) > _TIMES_REACH * reach_m(self._recording)
        return np.where(far[:, None], np.nan, places)

    def _seen(
        self, side: Side | None, corners: Floats, closed: bool = False, dense: bool = True
    ) -> Floats:
        """The corners as they are on the floor, or the line through them as a camera sees it."""
        if side is None:
            return corners.astype(np.float64)
        if closed:
            corners = np.concatenate((corners, corners[:1]))
        pixels = project_outline(self._recording, side, corners)
        if dense:
            return pixels
        ends = pixels[[0, -1]]
        return ends if np.isfinite(ends).all() else _NO_ARROW


def forward_arrow(line: CountingLine) -> Floats:
    """(2, 2) from the middle of a line to its right-hand side, looking from start to end; m."""
    return _arrow(line, (0.25, _ARROW_M), downward=False)


def picture_arrow(line: CountingLine) -> Floats:
    """The same of a line in the picture, whose v grows downward; px."""
    return _arrow(line, _ARROW_PX, downward=True)


def _arrow(line: CountingLine, shortest_longest: tuple[float, float], *, downward: bool) -> Floats:
    start, end = np.array(line.start, np.float64), np.array(line.end, np.float64)
    along = end - start
    length = float(np.hypot(*along))
    if length == 0:
        return _NO_ARROW
    right = np.array([along[1], -along[0]]) / length * (-1 if downward else 1)
    middle = (start + end) / 2
    shortest, longest = shortest_longest
    return np.stack([middle, middle + right * min(longest, max(shortest, length / 2))])
