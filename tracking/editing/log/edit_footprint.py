"""What edits touch, in whole numbers: two edits that touch nothing in common may change places.

A box is (kind, of, start, end): numbers start to end, half-open, of one thing of one kind. For
rows and part labels these are a track and frames; names and other words are numbers made of them,
which at worst lets two edits seem to touch the same that do not.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.change import Change, State
from tracking.editing.core.label_state import LabelState
from tracking.tracks import LARGEST_NUMBER, PARTS, PartLabel, Source, TrackLabel, pairs_of, row_keys

Boxes = NDArray[np.int64]

ROWS = 0
_PARTS = tuple(range(1, 1 + PARTS))
"""One kind for each body part."""
_TRACK, _VERDICT, _OCCLUDER, _LINE, _REGION, _REVIEWED, _SCHEMA = range(4, 11)
KINDS = 11
_APART = np.int64(1) << 33
"""More than any number in a box."""


def footprint_of(change: Change) -> Boxes:
    """(k, 4) the boxes a change touches: sorted, none overlapping another."""
    before, after = change.before, change.after
    boxes: list[Boxes] = []
    if len(before.stretches):
        boxes += [*_stretches(before), *_stretches(after)]
    if len(before.rows["frame"]) or len(after.rows["frame"]):
        boxes += _rows(before, after)
    labels = [*_track_labels(before, after), *_other_labels(before.labels, after.labels)]
    if labels or not boxes:
        boxes.append(np.array(labels, np.int64).reshape(-1, 4))
    return _united(np.concatenate(boxes))


def overlaps(boxes: Boxes, kinds: Boxes, of: Boxes, start: Boxes, end: Boxes) -> NDArray[np.bool_]:
    """(n,) which of many other boxes, given by columns, overlap one of an edit's own (k, 4)."""
    own = row_keys(boxes[:, 0], boxes[:, 1])
    groups = np.unique(own)
    others = row_keys(kinds, of)
    group = np.searchsorted(groups, others)
    there = group < len(groups)
    there[there] = groups[group[there]] == others[there]
    hit = np.zeros(len(others), np.bool_)
    if there.any():
        shift = group[there] * _APART
        own_shift = np.searchsorted(groups, own) * _APART
        # Of the own boxes that begin before the other one ends, the last reaches farthest.
        last = np.searchsorted(boxes[:, 2] + own_shift, end[there] + shift, "left") - 1
        reach = (boxes[:, 3] + own_shift)[np.maximum(last, 0)]
        hit[there] = (last >= 0) & (reach > start[there] + shift)
    return hit


def _stretches(state: State) -> Iterator[Boxes]:
    """Who stands there, and whose the part labels are."""
    for kind in (ROWS, *_PARTS):
        boxes = np.empty((len(state.stretches), 4), np.int64)
        boxes[:, 0], boxes[:, 1:] = kind, state.stretches
        yield boxes


def _rows(before: State, after: State) -> Iterator[Boxes]:
    """Rows that leave, come or change; a part label may stand on one that comes.

    What is interpolated stands on the rows it was made from, on either side of it.
    """
    yield _with_neighbours(_boxes_of(ROWS, _cells(after, Source.INTERPOLATED)))
    old, new = _cells(before), _cells(after)
    if np.array_equal(old, new):
        yield _boxes_of(ROWS, old)
        return
    coming = np.setdiff1d(new, old, assume_unique=True)
    yield _boxes_of(ROWS, np.sort(np.concatenate([old, coming]), kind="stable"))
    for kind in _PARTS:
        yield _boxes_of(kind, coming)


def _cells(state: State, source: int | None = None) -> NDArray[np.int64]:
    """(n,) track and frame of every row, or those of one source, in one number, ascending."""
    cells = row_keys(state.rows["track"], state.rows["frame"])
    return np.sort(cells if source is None else cells[state.rows["source"] == source])


def _with_neighbours(boxes: Boxes) -> Boxes:
    """Each box with the frame before and the frame after it."""
    wider: Boxes = boxes + np.array([0, 0, -1, 1])
    return wider


def _boxes_of(kind: int, cells: NDArray[np.int64]) -> Boxes:
    """Cells that follow each other as one box."""
    if not len(cells):
        return np.zeros((0, 4), np.int64)
    first = np.flatnonzero(np.concatenate([[True], np.diff(cells) != 1]))
    last = np.concatenate([first[1:], [len(cells)]]) - 1
    tracks, frames = pairs_of(cells)
    kinds = np.full(len(first), kind)
    return np.column_stack([kinds, tracks[first], frames[first], frames[last] + 1])


def _track_labels(before: State, after: State) -> Iterator[tuple[int, int, int, int]]:
    old = before.labels.tracks
    for track, label in after.labels.tracks.items():
        for field in differing_fields(old.get(track, TrackLabel()), label):
            yield _word(_TRACK, track, field)


def differing_fields(old: TrackLabel, new: TrackLabel) -> Iterator[str]:
    """The fields in which two labels of a track differ: "name", "notes", "attribute KEY"."""
    if old.name != new.name:
        yield "name"
    if old.notes != new.notes:
        yield "notes"
    for key in {*old.attributes, *new.attributes}:
        if old.attributes.get(key) != new.attributes.get(key):
            yield f"attribute {key}"


def _other_labels(old: LabelState, new: LabelState) -> Iterator[tuple[int, int, int, int]]:
    if old == new:
        return
    for kind, drawn in (
        (_OCCLUDER, {*old.occluders} ^ {*new.occluders}),
        (_LINE, {*old.lines} ^ {*new.lines}),
        (_REGION, {*old.regions} ^ {*new.regions}),
    ):
        for item in drawn:
            yield _word(kind, 0, item.name)
    for verdict in {*old.verdicts} ^ {*new.verdicts}:
        yield _word(_VERDICT, 0, repr(verdict.key))
    # Ranges that touch are joined into one: they have a frame in common here.
    for seen in {*old.reviewed} ^ {*new.reviewed}:
        yield _REVIEWED, seen.track, seen.start, seen.end + 1
    if old.schema != new.schema:
        yield _SCHEMA, 0, 0, 1
    yield from _parts((*old.parts, *new.parts))


def _parts(labels: Iterable[PartLabel]) -> Iterator[tuple[int, int, int, int]]:
    for label in labels:
        yield _PARTS[label.part], label.track, label.frame, label.frame + 1


def _word(kind: int, of: int, word: str) -> tuple[int, int, int, int]:
    number = zlib.crc32(word.encode("utf-8", "surrogatepass")) & 0x7FFFFFFF
    return kind, of, number, number + 1


def _united(boxes: Boxes) -> Boxes:
    """Sorted, within what a file holds, with boxes of one thing that meet made one."""
    boxes = boxes.clip(0, LARGEST_NUMBER + 1)
    boxes = boxes[boxes[:, 2] < boxes[:, 3]]
    boxes[:, 1] = boxes[:, 1].clip(0, LARGEST_NUMBER)
    if len(boxes) < 2:
        return boxes
    boxes = boxes[np.lexsort((boxes[:, 2], boxes[:, 1], boxes[:, 0]))]
    other = np.any(boxes[1:, :2] != boxes[:-1, :2], axis=1)
    shift = np.concatenate([[0], np.cumsum(other)]) * _APART
    reach = np.maximum.accumulate(boxes[:, 3] + shift)
    first = np.concatenate([[True], (boxes[1:, 2] + shift[1:]) > reach[:-1]])
    starts = np.flatnonzero(first)
    last = np.concatenate([starts[1:], [len(boxes)]]) - 1
    return np.column_stack([boxes[starts, :3], (reach - shift)[last]])
