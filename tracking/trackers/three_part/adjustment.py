"""Parts that were lost, put back where the other parts and the foreground say."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.people.parts import inner_rectangle, part_regions
from tracking.trackers.three_part.claims import Claims, may_be_theirs, seen_whole
from tracking.trackers.three_part.evidence import offsets
from tracking.trackers.three_part.part_filter import carry_along
from tracking.trackers.three_part.people import Flags, Floats, PartPeople
from tracking.trackers.three_part.poses import pose_faults
from tracking.tracks import HEAD, HIP_LEG, TORSO

_AROUND = 1.2
"""Where a person is looked for who lost several parts: their box, larger by this."""
_OFF = 0.65
"""Share of foreground under a part of somebody seen whole below which it is lost: an inner
rectangle lies within its part."""
_NOWHERE = 0.25
"""The same of anybody."""
_OUT_OF_PLACE = 0.12
"""How far a part of somebody who touches others goes astray, in heights, before it is lost."""
_LEAST_SEEN = 0.15
"""Share of foreground in that place below which there is nothing to begin anew from."""


@dataclass(frozen=True, slots=True, eq=False)
class AdjustmentInput:
    """What adjustment looks at.

    Attributes:
        seen: the frame's regions. claims: whose they are.
        picture: (height, width, 3) of `ycbcr`.
    """

    seen: Detections
    claims: Claims
    picture: NDArray[np.uint8]


def adjust(
    people: PartPeople,
    boxes: Floats,
    lost: Flags,
    several: Flags,
    scene: AdjustmentInput,
    *,
    by_body: bool,
) -> Floats:
    """(people, 3, 4) the rectangles where lost parts belong; NaN where nothing says so.

    [ZhaoLee2009] section 4.3.2. Where we differ: the caller begins all three anew, too, where
    more than one part is lost, whatever the fourth machine says, as that one seldom tells; and
    parts made anew go at their person's pace, not from rest.

    Args:
        boxes: (people, 4) left, top, width, height of the people as expected.
        lost: (people, 3) parts to put back. several: (people,) begin all three anew.
        by_body: beyond the paper, parts of people seen whole are cut out of their region, and
            where the foreground says nothing a part goes where the others take it.
    """
    found = np.full((len(people), 3, 4), np.nan)
    whole = np.zeros(len(people), bool)
    if by_body:
        found[lost] = carry_along(people.state, people.pose, lost)[..., :4][lost]
        whole = seen_whole(scene.claims, scene.seen, people.height)
    apart = ~people.hidden & (~people.touching | whole)
    for row in np.flatnonzero(lost.any(axis=1) & apart):
        mask = _own_foreground(int(row), scene)
        if several[row] or whole[row]:
            parts = _cut_out(mask, boxes[row], scene, int(row))
        else:
            parts = np.stack([_place_part(part, people.rectangles[row], mask) for part in range(3)])
        wanted = np.isfinite(parts) & (lost[row] | several[row])[:, None]
        found[row] = np.where(wanted, parts, found[row])
    return found


def clear_failures(people: PartPeople, scene: AdjustmentInput) -> Flags:
    """(people, 3) parts that are lost whatever the detector says.

    Where we go past [ZhaoLee2009]: a machine that learnt from failures near the body says nothing
    of parts far away, and nothing of colours and foreground. Of those seen alone and whole, a part
    off the foreground is lost; of those who touch others, the part that leaves its place in the
    body; of everybody, one where no part of a body can be, or nobody at all.
    """
    whole = seen_whole(scene.claims, scene.seen, people.height)
    fault = pose_faults(people.rectangles, people.height)
    limit = np.where(whole, _OFF, _NOWHERE)[:, None]
    fault |= (scene.claims.support < limit) & _inside(people.rectangles, scene.seen.regions.shape)
    fault |= (people.touching & ~whole)[:, None] & _out_of_place(people)
    return np.asarray(fault & ~people.occluded)


def is_new_in_picture(people: PartPeople) -> Flags:
    """(people, parts) in the picture for the first time: nothing is known of their colours."""
    unknown = people.model.sum(axis=(2, 3)) == 0
    return np.asarray(unknown & ~people.occluded)


def _inside(rectangles: Floats, shape: tuple[int, ...]) -> Flags:
    """(people, parts) whose rectangles lie whole in the picture."""
    reach = rectangles[..., 2:] / 2
    low, high = rectangles[..., :2] - reach, rectangles[..., :2] + reach
    return np.asarray((low >= 0).all(axis=-1) & (high < np.array(shape[::-1])).all(axis=-1))


def _out_of_place(people: PartPeople) -> Flags:
    """(people, 3) the part farthest from where the other two take it, where that is far."""
    away = offsets(people)
    farthest = away >= away.max(axis=1, keepdims=True)
    return np.asarray(farthest & (away > _OUT_OF_PLACE * people.height[:, None]))


def _own_foreground(row: int, scene: AdjustmentInput) -> Flags:
    """(height, width) foreground that is not somebody else's alone."""
    return np.concatenate(([False], may_be_theirs(scene.claims)[row]))[scene.seen.regions]


def _place_part(part: int, rectangles: Floats, mask: Flags) -> Floats:
    """(4,) the rectangle of a part alone, from the other two and the foreground.

    Only of people not seen alone and whole; the parts of those are cut out of their region. The
    torso is the mean of the others [ZhaoLee2009, eq. 4]. The head is the inner rectangle of
    the foreground within the torso's width to either side of it, from its upper edge up by twice
    the distance from torso to hip-leg; the hip-leg likewise below. Where we differ: both
    reach twice the torso's height at least, for people seen from above, whose parts stand close.
    """
    if part == TORSO:
        return np.asarray((rectangles[HEAD] + rectangles[HIP_LEG]) / 2)
    x, y, width, height = rectangles[TORSO]
    if part == HEAD:
        reach = 2.0 * max(rectangles[HIP_LEG, 1] - y, height)
        bottom = y - height / 2
        return inner_rectangle(mask, np.array((x - width, bottom - reach, 2 * width, reach)))
    reach = 2.0 * max(y - rectangles[HEAD, 1], height)
    top = y + height / 2
    return inner_rectangle(mask, np.array((x - width, top, 2 * width, reach)))


def _cut_out(mask: Flags, box: Floats, scene: AdjustmentInput, row: int) -> Floats:
    """(3, 4) all three parts from the foreground around the place expected."""
    region = scene.claims.region[row]
    if region >= 0 and scene.claims.alone[row]:
        own, where = scene.seen.regions == region + 1, scene.seen.box[region]
    else:
        own, where = mask, _foreground_box(mask, box)
    if where is None:
        return np.full((3, 4), np.nan)
    return part_regions(own, 1, scene.picture, where).rectangles


def _foreground_box(mask: Flags, box: Floats) -> Floats | None:
    """The box (4,) of the foreground around a place; None where there is hardly any."""
    middle, size = box[:2] + box[2:] / 2, box[2:] * _AROUND
    low = np.clip(np.rint(middle - size / 2), 0, mask.shape[::-1]).astype(int)
    high = np.clip(np.rint(middle + size / 2), 0, mask.shape[::-1]).astype(int)
    crop = mask[low[1] : high[1], low[0] : high[0]]
    if not crop.size or crop.mean() < _LEAST_SEEN:
        return None
    rows, columns = (np.flatnonzero(crop.any(axis=axis)) for axis in (1, 0))
    left, top = low[0] + columns[0], low[1] + rows[0]
    width, height = columns[-1] - columns[0] + 1, rows[-1] - rows[0] + 1
    return np.array((left - 0.5, top - 0.5, width, height), np.float64)
