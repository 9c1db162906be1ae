"""Labels of body parts and what a tracker saw of them, as samples of the failure detector."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.features import NUMBERS, part_features
from tracking.failure.core.samples import Samples, no_samples, samples_from_rows
from tracking.failure.past import states_before
from tracking.tracks import PART_EVIDENCE, PARTS, Columns, PartLabel, pairs_of, row_keys
from tracking.tracks.boxes import corners_of_boxes
from tracking.tracks.on_part import MOST_FOREIGN, corners_of, foreign_share

_SAME_PX = 1e-3
"""Corners and centres are not the same numbers, only the same rectangle."""
_STATE = ("cx", "cy", "width", "height", "vx", "vy")
_SOURCES = {"tracker": "label", "person": "correction", "truth": "truth"}
"""What a sample's source is called, by that of the label."""


@dataclass(frozen=True, slots=True, eq=False)
class PartStates:
    """The parts of a run by person and frame, where all three are known; n rows.

    Attributes:
        track, frame: (n,), sorted by both.
        states: (n, 3, 6), see `STATE_NAMES`: velocities in px/s.
        evidence: (n, 3, 8) `PART_EVIDENCE`; NaN where it was not measured.
    """

    track: NDArray[np.int64]
    frame: NDArray[np.int64]
    states: Floats
    evidence: Floats

    def rows_of(self, track: NDArray[np.int64], frame: NDArray[np.int64]) -> NDArray[np.int64]:
        """(k,) the row of each person and frame; -1 where there is none."""
        if not len(self.track):
            return np.full(len(track), -1)
        own, asked = row_keys(self.track, self.frame), row_keys(track, frame)
        at = np.minimum(np.searchsorted(own, asked), len(own) - 1)
        return np.where(own[at] == asked, at, -1)


def part_states(parts: Columns, fps: float) -> PartStates:
    """The states in `PART_COLUMNS` rows of any order, at a frame rate; incomplete ones left out."""
    known, row = np.unique(row_keys(parts["track"], parts["frame"]), return_inverse=True)
    states = np.full((len(known), PARTS, NUMBERS), np.nan)
    values = np.stack([parts[name].astype(float) for name in _STATE], axis=1)
    values[:, 4:] *= fps
    states[row.reshape(-1), parts["part"]] = values
    evidence = np.full((len(known), PARTS, len(PART_EVIDENCE)), np.nan)
    if all(name in parts for name in PART_EVIDENCE):
        measured = np.stack([parts[name].astype(float) for name in PART_EVIDENCE], axis=1)
        evidence[row.reshape(-1), parts["part"]] = measured
    whole = np.isfinite(states).all(axis=(1, 2))
    return PartStates(*pairs_of(known[whole]), states[whole], evidence[whole])


def were_hidden(
    track: NDArray[np.int64], frame: NDArray[np.int64], parts: Columns
) -> NDArray[np.bool_]:
    """(n,) where the tracker took a part of the person for occluded.

    Nobody looks for failures there.

    Args:
        parts: `PART_COLUMNS`.
    """
    if "occluded" not in parts:
        return np.zeros(len(track), bool)
    hidden = parts["occluded"]
    return np.isin(row_keys(track, frame), row_keys(parts["track"][hidden], parts["frame"][hidden]))


def samples_of(
    labels: Iterable[PartLabel],
    parts: Columns,
    fps: float,
    recording: str,
    people: Mapping[int, int] | None = None,
) -> Samples:
    """What labels teach the failure detector, each with the state its tracker was in.

    A label says of a rectangle whether it lies on its part; the sample is the tracker's state in
    that frame with this rectangle in place of its own. Unsure ones are dropped. A rectangle
    somebody put where the part is teaches twice: theirs lies on the part, and the tracker's off
    it, unless at least half of it lies within theirs. The state half a second before is as the
    tracker had it; for a rectangle put right, with what else was put right. What speaks for a
    rectangle that the tracker did not have was not measured. Labels of people whose three parts
    the tracker did not follow in that frame give no sample.

    Args:
        labels: of one recording. parts: `PART_COLUMNS` of the run they were given on, with its
            tracks under the ids that the labels use.
        fps: of the recording. recording: its name.
        people: who is who where truth says so: the true person, from 1 on, by track.

    Returns:
        Samples by frame, track and part; those of one instant and part: the tracker's first.
    """
    seen = part_states(parts, fps)
    told = _with_rows(labels, seen)
    right = _put_right(seen, told)
    drafts = [draft for label, row in told for draft in _drafts(label, row, seen, right)]
    if not drafts:
        return no_samples()
    now = np.stack([draft.state for draft in drafts])
    asked = np.array([draft.row for draft in drafts], np.int64)
    times = seen.frame / fps
    mended = np.array([draft.mended for draft in drafts])[:, None, None]
    tracked, corrected = (
        states_before(times, seen.track, states, asked, now) for states in (seen.states, right)
    )
    before = np.where(mended, corrected, tracked)
    named = [(recording, *draft.named) for draft in drafts]
    known = people or {}
    person = np.array([known.get(draft.named[0], 0) for draft in drafts], np.int32)
    features = part_features(now, before, _evidence(now, asked, seen))
    return samples_from_rows(named, features, person=person, time_s=times[asked])


def _evidence(now: Floats, asked: NDArray[np.int64], seen: PartStates) -> Floats:
    """(k, 3, 8) what was measured of rows; NaN of rectangles that are not the tracker's."""
    moved = np.abs(now[..., :4] - seen.states[asked, :, :4]).max(axis=2) > _SAME_PX
    return np.where(moved[..., None], np.nan, seen.evidence[asked])


def _with_rows(labels: Iterable[PartLabel], seen: PartStates) -> list[tuple[PartLabel, int]]:
    """The labels in order, each with its row of the run; those of people not seen are left out."""
    given = sorted(labels, key=lambda label: label.key)
    places = np.array([(label.track, label.frame) for label in given], np.int64).reshape(-1, 2)
    rows = seen.rows_of(places[:, 0], places[:, 1]).tolist()
    return [(label, row) for label, row in zip(given, rows, strict=True) if row >= 0]


@dataclass(frozen=True, slots=True, eq=False)
class _Draft:
    """A sample without its past.

    Attributes:
        row: of the run. state: (3, 6). mended: whether somebody put the part there.
        named: what `SAMPLE_COLUMNS` say after the recording.
    """

    row: int
    state: Floats
    mended: bool
    named: tuple[int, int, int, int, str, str, str]


def _drafts(label: PartLabel, row: int, seen: PartStates, right: Floats) -> list[_Draft]:
    """What one label teaches."""
    if label.on_part is None:
        return []
    tracked = seen.states[row]
    if label.source != "person":
        return [_draft(label, row, _with_box(tracked, label), label.on_part)]
    if not label.on_part:
        return [_draft(label, row, _with_box(tracked, label), False)]
    mended = _draft(label, row, right[row], True, mended=True)
    there = corners_of(tracked[label.part, :4])
    if foreign_share(there, corners_of_boxes(np.array(label.box))) <= MOST_FOREIGN:
        return [mended]
    return [_draft(label, row, tracked, False), mended]


def _draft(label: PartLabel, row: int, state: Floats, on: bool, *, mended: bool = False) -> _Draft:
    place = (label.track, label.frame, label.part, int(on))
    return _Draft(row, state, mended, (*place, label.author, label.reason, _SOURCES[label.source]))


def _put_right(seen: PartStates, told: Iterable[tuple[PartLabel, int]]) -> Floats:
    """The states with every rectangle in its place that somebody put there."""
    right = seen.states.copy()
    for label, row in told:
        if label.source == "person" and label.on_part:
            right[row] = _with_box(right[row], label)
    return right


def _with_box(state: Floats, label: PartLabel) -> Floats:
    """A person's state (3, 6) with the label's rectangle for its part.

    One that moved goes with the other two parts: how fast the lost one went says nothing of it.
    """
    left, top, width, height = label.box
    moved = state.copy()
    box = (left + width / 2, top + height / 2, width, height)
    there = state[label.part, :4].tolist()
    if max(abs(one - other) for one, other in zip(box, there, strict=True)) > _SAME_PX:
        moved[label.part, :4] = box
        moved[label.part, 4:] = np.delete(state[:, 4:], label.part, axis=0).mean(axis=0)
    return moved
