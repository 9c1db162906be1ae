"""The step of the region: outlines to look at and to leave out, drawn on the picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np

from app.core.i18n import tr
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.scene import (
    OutlineKind,
    SetupPicture,
    SetupScene,
    SetupState,
    ShownOutline,
)
from tracking.recording.region_of_interest import Outline, RegionOfInterest

_FEWEST = 3


def outlines_of_plan(state: SetupState) -> tuple[tuple[OutlineKind, Outline], ...]:
    """All outlines, those to look at first."""
    region = state.plan.region if state.plan is not None else RegionOfInterest()
    looks = [("look", outline) for outline in region.look]
    masks = [("mask", outline) for outline in region.mask]
    return tuple((kind, outline) for kind, outline in (*looks, *masks))  # type: ignore[misc]


def _with(state: SetupState, outlines: list[tuple[OutlineKind, Outline]]) -> SetupState:
    if state.plan is None:
        return state
    kinds: dict[OutlineKind, list[Outline]] = {"look": [], "mask": []}
    for kind, outline in outlines:
        kinds[kind].append(outline)
    region = RegionOfInterest(tuple(kinds["look"]), tuple(kinds["mask"]))
    return replace(state, plan=replace(state.plan, region=region))


def with_outline(state: SetupState, kind: OutlineKind, outline: Outline) -> SetupState:
    """The same with one more outline; too few corners make none."""
    if len(outline) < _FEWEST:
        return state
    rounded = tuple((round(x, 1), round(y, 1)) for x, y in outline)
    return _with(state, [*outlines_of_plan(state), (kind, rounded)])


def number_of_last(state: SetupState, kind: OutlineKind) -> int:
    """The number of the outline of a kind that was added last; -1: there is none."""
    kinds = [one for one, _ in outlines_of_plan(state)]
    return max((row for row, one in enumerate(kinds) if one == kind), default=-1)


def without_outline(state: SetupState, row: int) -> SetupState:
    """The same without an outline."""
    outlines = list(outlines_of_plan(state))
    if not 0 <= row < len(outlines):
        return state
    return _with(state, [*outlines[:row], *outlines[row + 1 :]])


def with_corner(state: SetupState, row: int, corner: int, x: float, y: float) -> SetupState:
    """The same with a corner elsewhere."""

    def move(corners: list[tuple[float, float]]) -> None:
        corners[corner] = (round(x, 1), round(y, 1))

    return _changed(state, row, move)


def without_corner(state: SetupState, row: int, corner: int) -> SetupState:
    """The same without a corner; an outline of three goes as a whole."""
    outlines = outlines_of_plan(state)
    if not 0 <= row < len(outlines) or len(outlines[row][1]) <= _FEWEST:
        return without_outline(state, row)

    def take(corners: list[tuple[float, float]]) -> None:
        del corners[corner]

    return _changed(state, row, take)


def _changed(
    state: SetupState, row: int, change: Callable[[list[tuple[float, float]]], None]
) -> SetupState:
    outlines = list(outlines_of_plan(state))
    if not 0 <= row < len(outlines):
        return state
    kind, outline = outlines[row]
    corners = list(outline)
    change(corners)
    outlines[row] = (kind, tuple(corners))
    return _with(state, outlines)


def corner_of_handle(state: SetupState, handle: int) -> tuple[int, int]:
    """The outline and its corner that a handle is of; (-1, -1): none."""
    for row, (_, outline) in enumerate(outlines_of_plan(state)):
        if 0 <= handle < len(outline):
            return row, handle
        handle -= len(outline)
    return -1, -1


def handle_of_corner(state: SetupState, row: int, corner: int) -> int:
    """The handle of a corner; -1: none."""
    outlines = outlines_of_plan(state)
    if not 0 <= row < len(outlines):
        return -1
    return sum(len(outline) for _, outline in outlines[:row]) + corner


def middle_rectangle(size: tuple[int, int]) -> Outline:
    """A rectangle in the middle of an image: what an outline drawn by keys begins with."""
    width, height = size
    left, right, top, bottom = 0.25 * width, 0.75 * width, 0.25 * height, 0.75 * height
    return ((left, top), (right, top), (right, bottom), (left, bottom))


def outline_title(kind: OutlineKind, number: int) -> str:
    """An outline's name in the list."""
    words = {"look": tr("Look here {number}"), "mask": tr("Leave out {number}")}
    return words[kind].format(number=number)


def region_told(scene: SetupScene) -> str:
    """What share of the image people are looked for in."""
    plan, images = scene.state.plan, scene.images
    if plan is None or images is None or not plan.region:
        return tr("People are looked for in the whole image.")
    size = images.left.shape[1], images.left.shape[0]
    if scene.checked.problem:
        return ""
    looked_at = plan.region.pixels(size)
    assert looked_at is not None, "there is a region"
    share = float((looked_at > 0).mean())
    return tr("People are looked for in {share:.0%} of the image.", share=share)


def region_picture(
    scene: SetupScene, chosen: int, handle: int, drawn: Outline, kind: OutlineKind
) -> SetupPicture:
    """The left image with the outlines, and the one that is being drawn."""
    if scene.images is None:
        return cameras_picture(scene)
    shown = [
        ShownOutline(np.array(outline), one, row == chosen)
        for row, (one, outline) in enumerate(outlines_of_plan(scene.state))
    ]
    if drawn:
        shown.append(ShownOutline(np.array(drawn), kind, True, closed=False))
    return SetupPicture(
        scene.images.left,
        outlines=tuple(shown),
        handle=handle,
        said=tr("Left camera with the region"),
    )


def outline_at(state: SetupState, x: float, y: float) -> int:
    """The last outline that a pixel lies in; -1: none."""
    for row, (_, outline) in reversed([*enumerate(outlines_of_plan(state))]):
        corners = np.array(outline, np.float32).reshape(-1, 1, 2)
        if cv2.pointPolygonTest(corners, (x, y), measureDist=False) >= 0:
            return row
    return -1
