"""People begun, and parts begun anew: particles, colours and where they come from."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import restarted, scattered
from tracking.people import Detections
from tracking.people.parts import inner_rectangle, part_regions
from tracking.trackers.three_part.appearance import measure_levels
from tracking.trackers.three_part.bodies import outlined_boxes
from tracking.trackers.three_part.people import (
    Flags,
    Floats,
    Indices,
    Layout,
    PartPeople,
    unknown_people,
)
from tracking.tracks.boxes import share_inside

_START_PARTICLES = 400
_START_SPREAD = (0.1, 0.1, 0.08, 0.08, 1.0, 1.0)
"""Of X, Y, W, H in sizes of the part, and of dX, dY in sizes a second."""
_ALIKE_AT_FIRST = 0.95
USUAL_PARTS = ((0.5, 0.08, 0.25, 0.09), (0.5, 0.30, 0.45, 0.19), (0.5, 0.62, 0.40, 0.25))
"""Where head, torso and hip-leg are in a box nothing is known of: cx, cy, width, height as shares
of it."""
_INSIDE = 0.5
"""Share of a rectangle in the picture below which the picture cuts its part off."""


def regions_rectangles(
    seen: Detections, rows: Indices, picture: NDArray[np.uint8], layout: Layout
) -> Floats:
    """(n, parts, 4) the inner rectangles of some regions; NaN where a part is not seen.

    Args:
        picture: (height, width, 3) of `ycbcr`.
    """
    found = np.full((len(rows), layout.parts, 4), np.nan)
    for at, row in enumerate(rows):
        found[at] = rectangles_in(seen.regions, int(row) + 1, seen.box[row], picture, layout)
    return found


def complete_bodies(rectangles: Floats, seen: Detections, rows: Indices) -> Floats:
    """The rectangles (n, parts, 4) of some regions, with parts that the picture cuts off.

    Where the body's box is known whatever the picture shows of it, those parts are where they
    usually are in such a box. Nothing is added to somebody of whom all that should be in the
    picture is not seen.
    """
    if rectangles.shape[1] == 1:
        return rectangles
    usual = parts_in_boxes(np.array(USUAL_PARTS), seen.box[rows])
    cut = is_cut_off(usual, seen.regions.shape) & seen.from_detector[rows, None]
    cut &= ~cut.all(axis=1, keepdims=True)
    return np.where(cut[..., None], usual, rectangles)


def is_cut_off(rectangles: Floats, shape: tuple[int, ...]) -> Flags:
    """(people, parts) whose rectangles lie mostly out of a picture of this shape."""
    size = (shape[1], shape[0])
    boxes = rectangles.reshape(-1, 4).copy()
    boxes[:, :2] -= boxes[:, 2:] / 2
    return np.asarray((share_inside(boxes, size) < _INSIDE).reshape(rectangles.shape[:-1]))


def parts_in_boxes(share: Floats, box: Floats) -> Floats:
    """(people, parts, 4) rectangles that are shares (parts, 4) of boxes (people, 4)."""
    rectangles = share * np.tile(box[:, None, 2:], 2)
    rectangles[..., :2] += box[:, None, :2]
    return rectangles


def rectangles_in(
    regions: NDArray[np.integer],
    label: int,
    box: Floats,
    picture: NDArray[np.uint8],
    layout: Layout,
) -> Floats:
    """(parts, 4) the inner rectangles of the person whose pixels bear a label."""
    if layout.parts == 1:
        return inner_rectangle(regions == label, box)[None]
    return part_regions(regions, label, picture, box).rectangles


def begin_people(
    track: NDArray[np.int32],
    rectangles: Floats,
    pace: Floats,
    picture: NDArray[np.uint8],
    layout: Layout,
    random: np.random.Generator,
) -> PartPeople:
    """People followed from here on.

    Args:
        track: (n,) ids. rectangles: (n, parts, 4) of their parts. pace: (n, 2) px/s.
        picture: (height, width, 3) of `ycbcr`, where their colours are learnt.
    """
    people, parts = rectangles.shape[:2]
    state = np.empty((people, parts, 6))
    state[..., :4], state[..., 4:] = rectangles, pace[:, None]
    filters = group_by_filter(state, layout)
    count = np.full(len(filters), _START_PARTICLES, np.int64)
    clouds = scattered(filters, _start_spread(filters), count, random)
    model = measure_levels(picture, rectangles)
    alike = np.full((people, parts), _ALIKE_AT_FIRST)
    return unknown_people(track, parts, clouds).replace(
        state=state,
        pace=pace,
        model=model,
        appearance=model,
        similarity=alike,
        usual=alike,
        pose=pose_of(rectangles),
        height=outlined_boxes(rectangles, np.zeros((people, 4)))[:, 3],
    )


def begin_anew(
    people: PartPeople,
    rectangles: Floats,
    picture: NDArray[np.uint8],
    layout: Layout,
    random: np.random.Generator,
) -> PartPeople:
    """The people with some parts put elsewhere, particles and colour model re-made there.

    Args:
        rectangles: (people, parts, 4) where parts are put; NaN: left alone.
    """
    which = np.isfinite(rectangles).all(axis=2)
    if not which.any():
        return people
    state, model = people.state.copy(), people.model.copy()
    state[which, :4] = rectangles[which]
    state[which, 4:] = np.broadcast_to(people.pace[:, None], (*which.shape, 2))[which]
    model[which] = measure_levels(picture, rectangles[which][:, None])[:, 0]
    filters = group_by_filter(state, layout)
    chosen = which.reshape(-1, layout.together)
    spread = _start_spread(filters)
    clouds = restarted(people.clouds, chosen, filters, spread, random)
    return people.replace(state=state, model=model, clouds=clouds)


def reset_people(people: PartPeople, rows: Indices) -> PartPeople:
    """The people, of some of whom nothing counts but where their parts are now."""
    rectangles = people.rectangles[rows]
    changed = {
        "appearance": people.model[rows],
        "pose": pose_of(rectangles),
        "outline": np.zeros((len(rows), 4)),
        "height": outlined_boxes(rectangles, np.zeros((len(rows), 4)))[:, 3],
    }
    columns = {name: getattr(people, name).copy() for name in changed}
    for name, values in changed.items():
        columns[name][rows] = values
    return people.replace(**columns)


def pose_of(rectangles: Floats) -> Floats:
    """(people, parts, 4) `PartPeople.pose` of rectangles (people, parts, 4)."""
    middle = rectangles[..., :2]
    away = middle - middle.mean(axis=1, keepdims=True)
    return np.concatenate((away, rectangles[..., 2:]), axis=-1)


def group_by_filter(state: NDArray[Any], layout: Layout) -> NDArray[Any]:
    """States (people, parts, n) as (filters of all people, parts together, n)."""
    return state.reshape(-1, layout.together, state.shape[-1])


def part_sizes(state: Floats) -> Floats:
    """(...) px, the side of a square as large as the part; states (..., 6)."""
    return np.asarray(np.sqrt(np.maximum(state[..., 2] * state[..., 3], 1.0)))


def _start_spread(filters: Floats) -> Floats:
    return np.asarray(part_sizes(filters)[..., None] * np.array(_START_SPREAD))


def is_all_seen(rectangles: Floats) -> Flags:
    """(n,) of whom all parts (n, parts, 4) are known."""
    return np.asarray(np.isfinite(rectangles).all(axis=(1, 2)))
