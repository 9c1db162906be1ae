"""The people to go on with: as corrected, in the colours the footage shows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections, Observation
from tracking.people.parts import ycbcr
from tracking.trackers.shared.corrected_rows import LED_ON_S, is_seen, last_rows, only, slopes
from tracking.trackers.shared.resumption import CLEAR, Resume
from tracking.trackers.three_part.appearance import measure_levels
from tracking.trackers.three_part.initiation import (
    USUAL_PARTS,
    begin_people,
    parts_in_boxes,
    rectangles_in,
)
from tracking.trackers.three_part.people import Floats, Layout, PartPeople
from tracking.tracks.columns import Columns, boxes_of

_USUAL_WHOLE = ((0.5, 0.5, 0.5, 0.55),)
_FILLED = 0.15
"""Share of a corrected box that one region must fill to be its person."""
_MEMORY = 0.9
"""Of the colour models, a look."""


@dataclass(slots=True, eq=False)
class _Observed:
    """What was seen of the people; filled look by look.

    Attributes:
        shares: person -> (parts, 4) rectangles as shares of the box, a look each.
        model: (people, parts, 3, 256), running mean. seen: (people,) how many views it is of.
        picture: the last one. time_s: its time.
    """

    model: NDArray[np.float32]
    seen: NDArray[np.int64]
    shares: dict[int, list[Floats]] = field(default_factory=dict)
    picture: NDArray[np.uint8] = field(default_factory=lambda: np.zeros((1, 1, 3), np.uint8))
    time_s: float = 0.0


def resume_people(
    resume: Resume,
    observations: Iterable[Observation],
    layout: Layout,
    random: np.random.Generator,
) -> tuple[PartPeople, float]:
    """Everybody to be followed on, and the seconds at which they stand so.

    Boxes are those of the corrected rows; where parts lie in them, and their colours, is learnt
    from the regions seen there, from good views first. Somebody hidden is started where the rows
    lead, as one who was missed.

    Args:
        observations: of the frames `resume.colour_frames`, in order.
    """
    people = np.unique(resume.rows["track"])
    observed = _collect(resume.rows, people, observations, layout)
    box, pace, missed_s = _now(resume, people)
    usual = np.array(USUAL_PARTS if layout.parts > 1 else _USUAL_WHOLE)
    share = np.array(
        [np.median(observed.shares.get(k, [usual]), axis=0) for k in range(len(people))]
    )
    rectangles = parts_in_boxes(share.reshape(-1, layout.parts, 4), box)
    new = begin_people(people.astype(np.int32), rectangles, pace, observed.picture, layout, random)
    known = (observed.seen > 0)[:, None, None, None]
    model = np.where(known, observed.model, new.model)
    return new.replace(model=model, appearance=model, missed_s=missed_s), observed.time_s


def _collect(
    rows: Columns, people: NDArray[np.int32], observations: Iterable[Observation], layout: Layout
) -> _Observed:
    shape = (len(people), layout.parts, 3, 256)
    observed = _Observed(np.zeros(shape, np.float32), np.zeros(len(people), np.int64))
    for observation in observations:
        assert observation.picture is not None, "perception of one camera hands the picture on"
        observed.picture, observed.time_s = ycbcr(observation.picture), observation.time_s
        here = only(rows, (rows["frame"] == observation.frame) & is_seen(rows))
        for row, rectangles in _parts_of(here, observation.people, observed.picture, layout):
            person = int(np.searchsorted(people, here["track"][row]))
            _add(observed, person, rectangles, boxes_of(here)[row])
    return observed


def _add(observed: _Observed, person: int, rectangles: Floats, box: Floats) -> None:
    seen = measure_levels(observed.picture, rectangles[None])[0]
    count = observed.seen[person]
    share = np.float32(max(1.0 - _MEMORY, 1.0 / (count + 1)))
    observed.model[person] += share * (seen - observed.model[person])
    observed.seen[person] += 1
    share_of_box = rectangles.copy()
    share_of_box[:, :2] -= box[:2]
    observed.shares.setdefault(person, []).append(share_of_box / np.tile(box[2:], 2))


def _parts_of(
    rows: Columns, seen: Detections, picture: NDArray[np.uint8], layout: Layout
) -> Iterator[tuple[int, Floats]]:
    """The rows of a frame in which a person is well seen, with their rectangles (parts, 4)."""
    for row, box in enumerate(boxes_of(rows)):
        if rows["visibility"][row] < CLEAR:
            continue
        low = np.clip(np.rint(box[:2]), 0, picture.shape[1::-1]).astype(int)
        high = np.clip(np.rint(box[:2] + box[2:]), low, picture.shape[1::-1]).astype(int)
        inside = seen.regions[low[1] : high[1], low[0] : high[0]]
        count = np.bincount(inside.ravel(), minlength=2)
        region = int(count[1:].argmax()) + 1
        if count[region] < _FILLED * max(inside.size, 1):
            continue
        rectangles = rectangles_in(seen.regions, region, box, picture, layout)
        if np.isfinite(rectangles).all():
            yield row, rectangles


def _now(resume: Resume, people: NDArray[np.int32]) -> tuple[Floats, Floats, Floats]:
    """Box (people, 4), pace (people, 2) px/s and seconds missed in the frame before the first."""
    rows, now = resume.rows, resume.frame - 1
    last = last_rows(rows, people)
    gap_s = (now - rows["frame"][last]) / resume.fps
    box = boxes_of(rows)
    pace = slopes(rows, box[:, :2] + box[:, 2:] / 2, people, resume.frame, resume.fps)
    box = box[last]
    box[:, :2] += pace * np.minimum(gap_s, LED_ON_S)[:, None]
    return box, pace, gap_s
