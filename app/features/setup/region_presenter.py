"""The step of the region: what is drawn on the picture, to look at, leave out, count over."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import count

import cv2
import numpy as np

from app.core.i18n import count_text, joined, sentence, tr
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.floor_marks import with_floor
from app.features.setup.scene import (
    DrawnOutline,
    OutlineKind,
    SetupPicture,
    SetupScene,
    SetupState,
    ShownOutline,
)
from tracking.arrays import Floats
from tracking.errors import RecordingError
from tracking.recording.region_of_interest import Outline, RegionOfInterest
from tracking.tracks import CountingLine, Occluder

_KINDS: tuple[OutlineKind, ...] = ("look", "mask", "occluder", "line")
_FEWEST = 3
_AT_LINE_PX = 6.0
"""So near a line is chosen by a click."""
_ARROW_PX = (12.0, 40.0)
"""Shortest and longest arrow over a line."""


def outlines_of(state: SetupState) -> tuple[DrawnOutline, ...]:
    """All that is drawn: to look at, to leave out, occluders, counting lines."""
    region = state.plan.region if state.plan is not None else RegionOfInterest()
    return (
        *(DrawnOutline("look", outline) for outline in region.look),
        *(DrawnOutline("mask", outline) for outline in region.mask),
        *(DrawnOutline("occluder", one.polygon, one.name) for one in state.occluders),
        *(DrawnOutline("line", (one.start, one.end), one.name) for one in state.lines),
    )


def _with(state: SetupState, outlines: list[DrawnOutline]) -> SetupState:
    if state.plan is None:
        return state
    kinds = {kind: [one for one in outlines if one.kind == kind] for kind in _KINDS}
    look, mask = (tuple(one.corners for one in kinds[kind]) for kind in ("look", "mask"))
    return replace(
        state,
        plan=replace(state.plan, region=RegionOfInterest(look, mask)),
        occluders=tuple(Occluder(one.name, one.corners) for one in kinds["occluder"]),
        lines=tuple(
            CountingLine(one.name, one.corners[0], one.corners[-1], in_picture=True)
            for one in kinds["line"]
        ),
    )


def fewest_corners(kind: OutlineKind) -> int:
    """So many corners make one: of a line its two ends."""
    return 2 if kind == "line" else _FEWEST


def with_outline(state: SetupState, kind: OutlineKind, outline: Outline) -> SetupState:
    """The same with one more outline; too few corners make none, nor do two at one place."""
    rounded = tuple((round(x, 1), round(y, 1)) for x, y in outline)
    if len(set(rounded)) < fewest_corners(kind):
        return state
    outlines = outlines_of(state)
    name = _free_name(kind, outlines) if kind in ("occluder", "line") else ""
    return _with(state, [*outlines, DrawnOutline(kind, rounded, name)])


def _free_name(kind: OutlineKind, outlines: tuple[DrawnOutline, ...]) -> str:
    """As the window names what is drawn there."""
    taken = {one.name for one in outlines if one.kind == kind}
    return next(name for number in count(1) if (name := f"{kind} {number}") not in taken)


def number_of_last(state: SetupState, kind: OutlineKind) -> int:
    """The number of the outline of a kind that was added last; -1: there is none."""
    kinds = [one.kind for one in outlines_of(state)]
    return max((row for row, one in enumerate(kinds) if one == kind), default=-1)


def without_outline(state: SetupState, row: int) -> SetupState:
    """The same without an outline."""
    outlines = list(outlines_of(state))
    if not 0 <= row < len(outlines):
        return state
    return _with(state, [*outlines[:row], *outlines[row + 1 :]])


def with_corner(state: SetupState, row: int, corner: int, x: float, y: float) -> SetupState:
    """The same with a corner elsewhere."""

    def move(corners: list[tuple[float, float]]) -> None:
        corners[corner] = (round(x, 1), round(y, 1))

    return _changed(state, row, move)


def without_corner(state: SetupState, row: int, corner: int) -> SetupState:
    """The same without a corner; what has no more than it needs goes as a whole."""
    outlines = outlines_of(state)
    missing = not 0 <= row < len(outlines)
    if missing or len(outlines[row].corners) <= fewest_corners(outlines[row].kind):
        return without_outline(state, row)

    def take(corners: list[tuple[float, float]]) -> None:
        del corners[corner]

    return _changed(state, row, take)


def _changed(
    state: SetupState, row: int, change: Callable[[list[tuple[float, float]]], None]
) -> SetupState:
    outlines = list(outlines_of(state))
    if not 0 <= row < len(outlines):
        return state
    corners = list(outlines[row].corners)
    change(corners)
    if len(set(corners)) < fewest_corners(outlines[row].kind):
        return state  # two ends at one place are no line
    outlines[row] = replace(outlines[row], corners=tuple(corners))
    return _with(state, outlines)


def corner_of_handle(state: SetupState, handle: int) -> tuple[int, int]:
    """The outline and its corner that a handle is of; (-1, -1): none."""
    for row, outline in enumerate(outlines_of(state)):
        if 0 <= handle < len(outline.corners):
            return row, handle
        handle -= len(outline.corners)
    return -1, -1


def handle_of_corner(state: SetupState, row: int, corner: int) -> int:
    """The handle of a corner; -1: none."""
    outlines = outlines_of(state)
    if not 0 <= row < len(outlines):
        return -1
    return sum(len(outline.corners) for outline in outlines[:row]) + corner


def middle_outline(kind: OutlineKind, size: tuple[int, int]) -> Outline:
    """What is drawn by keys begins with it: a rectangle in the middle, or a line across it."""
    width, height = size
    left, right, top, bottom = 0.25 * width, 0.75 * width, 0.25 * height, 0.75 * height
    if kind == "line":
        return ((left, 0.5 * height), (right, 0.5 * height))
    return ((left, top), (right, top), (right, bottom), (left, bottom))


def titles_of(state: SetupState) -> list[str]:
    """A line for each outline in the list."""
    numbers = dict.fromkeys(_KINDS, 0)
    titles = []
    for one in outlines_of(state):
        numbers[one.kind] += 1
        words = {
            "look": tr("Look here {number}"),
            "mask": tr("Leave out {number}"),
            "occluder": tr("Occluder: {name}"),
            "line": tr("Counting line: {name}"),
        }[one.kind]
        titles.append(words.format(number=numbers[one.kind], name=one.name))
    return titles


def kept_told(state: SetupState) -> str:
    """What of the drawings goes into the session, in words; "" where nothing does."""
    drawn = []
    if state.occluders:
        drawn.append(count_text(len(state.occluders), "{n} occluder", "{n} occluders"))
    if state.lines:
        drawn.append(count_text(len(state.lines), "{n} counting line", "{n} counting lines"))
    return tr("Kept in the session: {drawn}.", drawn=joined(", ", drawn)) if drawn else ""


def region_told(scene: SetupScene) -> str:
    """What share of the image people are looked for in."""
    plan, images = scene.state.plan, scene.images
    if plan is None or images is None or not plan.region:
        return tr("People are looked for in the whole image.")
    size = images.left.shape[1], images.left.shape[0]
    if scene.checked.problem:
        return ""
    try:
        looked_at = plan.region.pixels(size)
    except RecordingError as error:  # the trial that says so is still at it
        return sentence(error.message)
    assert looked_at is not None, "there is a region"
    share = float((looked_at > 0).mean())
    return tr("People are looked for in {share:.0%} of the image.", share=share)


def region_picture(
    scene: SetupScene,
    chosen: int,
    handle: int,
    drawn: ShownOutline | None,
    pointer: tuple[float, float] | None = None,
) -> SetupPicture:
    """The left image over its floor with the outlines, and the one that is being drawn."""
    if scene.images is None:
        return cameras_picture(scene)
    shown = [
        ShownOutline(np.array(one.corners), one.kind, row == chosen, arrow=_arrow(one))
        for row, one in enumerate(outlines_of(scene.state))
    ]
    picture = SetupPicture(
        scene.images.left,
        outlines=(*shown, *([drawn] if drawn is not None else [])),
        handle=handle,
        said=tr("Left camera with the region"),
    )
    return with_floor(picture, scene, pointer)


def _arrow(one: DrawnOutline) -> Floats:
    """(2, 2) from the middle of a line to its right-hand side, as seen on the screen."""
    if one.kind != "line":
        return np.zeros((0, 2))
    start, end = np.array(one.corners, float)
    along = end - start
    length = float(np.hypot(*along))
    if length == 0:
        return np.zeros((0, 2))
    middle, right = (start + end) / 2, np.array([-along[1], along[0]]) / length
    shortest, longest = _ARROW_PX
    return np.stack([middle, middle + right * min(longest, max(shortest, length / 2))])


def outline_at(state: SetupState, x: float, y: float) -> int:
    """The last outline that a pixel lies in, or at; -1: none."""
    for row, one in reversed([*enumerate(outlines_of(state))]):
        corners = np.array(one.corners, np.float32).reshape(-1, 1, 2)
        inside = cv2.pointPolygonTest(corners, (x, y), measureDist=True)
        if inside >= (-_AT_LINE_PX if one.kind == "line" else 0.0):
            return row
    return -1
