"""Random sequences on which scorers are compared: what is likely, and what is awkward."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from tracking.scoring import ScoringTable

Sequence = tuple[np.ndarray, np.ndarray]
"""Truth and result, each (n, 9) by `sequences.COLUMNS`, sorted by frame."""

GHOSTS = 900
"""The first id of those that a made-up tracker imagines."""
_TIES = st.tuples(st.integers(0, 8), st.integers(0, 3), st.integers(3, 9), st.integers(3, 9))


def _rows(most: int, ids: int, confidences: list[float]) -> st.SearchStrategy[Any]:
    """Small whole boxes on a small picture: overlaps that are equal, or right on a threshold."""
    key = st.tuples(st.integers(0, 14), st.integers(1, ids))
    return st.dictionaries(key, st.tuples(_TIES, st.sampled_from(confidences)), max_size=most)


def _as_rows(found: dict[Any, Any], places: float) -> np.ndarray:
    rows = [
        (frame, track, *box, box[0] * places, box[1] * places, confidence)
        for (frame, track), (box, confidence) in sorted(found.items())
    ]
    return np.array(rows, np.float64).reshape(-1, 9)


@st.composite
def crowded(draw: st.DrawFn) -> Sequence:
    """Ties everywhere, don't-cares, gaps; often a side is empty."""
    truth = draw(_rows(50, 4, [1.0, 1.0, 1.0, 0.0]))
    result = draw(_rows(50, 4, [0.25, 0.5, 0.9]))
    return _as_rows(truth, 0.125), _as_rows(result, 0.125)


@st.composite
def single_frames(draw: st.DrawFn) -> Sequence:
    """One frame or two, somewhere."""
    first = draw(st.integers(0, 5))
    key = st.tuples(st.integers(first, first + draw(st.integers(0, 1))), st.integers(1, 7))
    value = st.tuples(_TIES, st.sampled_from([1.0, 1.0, 0.0]))
    rows = st.dictionaries(key, value, max_size=9)
    return _as_rows(draw(rows), 0.125), _as_rows(draw(rows), 0.125)


@st.composite
def walkers(draw: st.DrawFn) -> Sequence:
    """People who cross, and a tracker with noise, gaps, exchanged ids and ghosts."""
    generator = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    people, frames = draw(st.integers(2, 12)), draw(st.integers(20, 90))
    noise_px = draw(st.sampled_from([0.0, 2.0, 6.0, 12.0]))
    return walking(generator, people, frames, noise_px)


def walking(generator: np.random.Generator, people: int, frames: int, noise_px: float) -> Sequence:
    """Walkers on circles, as truth and as a tracker sees them."""
    frame = np.repeat(np.arange(frames), people)
    person = np.tile(np.arange(1, people + 1), frames)
    angle = frame * generator.uniform(0.02, 0.2, people)[person - 1] + person
    box = np.stack([150 + 90 * np.cos(angle), 60 + 40 * np.sin(angle)], axis=1)
    box = np.hstack([box, generator.uniform(25, 40, people)[person - 1, None], 0 * box[:, :1] + 70])
    truth = _stacked(frame, person, np.round(box, 1), generator.random(len(frame)) > 0.08)
    seen = generator.random(len(frame)) > 0.15
    named = person + people * (generator.random(len(frame)).cumsum() // 60).astype(int)
    exchanged = generator.random(frames)[frame] < 0.05
    named = np.where(exchanged, people + 1 - person, named)
    found = np.round(box + generator.normal(0, noise_px, box.shape), 1)
    found[:, 2:] = np.maximum(found[:, 2:], 1.0)
    result = _stacked(frame, named, found, generator.uniform(0.2, 1.0, len(frame)))[seen]
    ghosts = _stacked(
        generator.integers(0, frames, frames // 3),
        GHOSTS + np.arange(frames // 3),
        generator.uniform(5, 200, (frames // 3, 4)),
        generator.uniform(0.1, 0.6, frames // 3),
    )
    result = np.concatenate([result, ghosts])
    kept = np.unique(result[:, :2], axis=0, return_index=True)[1]
    return truth, result[np.sort(kept)][np.argsort(result[np.sort(kept), 0], kind="stable")]


def _stacked(frame: Any, track: Any, box: Any, confidence: Any) -> np.ndarray:
    places = np.asarray(box)[:, :2] / 40.0
    return np.column_stack([frame, track, box, places, np.asarray(confidence, np.float64)])


def drawn(count: int, number: int) -> dict[str, Sequence]:
    """So many sequences of hypothesis, named in order; the same number gives the same ones."""
    found: list[Sequence] = []

    @seed(number)
    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(st.one_of(crowded(), walkers(), single_frames(), walkers()))
    def collect(one: Sequence) -> None:
        found.append(one)

    collect()
    return {f"{place:05d}": one for place, one in enumerate(found)}


def tables(sequence: Sequence) -> tuple[ScoringTable, ScoringTable]:
    """A sequence as our tables."""
    truth, result = sequence
    return _table(truth, dont_cares=True), _table(result, dont_cares=False)


def _table(rows: np.ndarray, *, dont_cares: bool) -> ScoringTable:
    names = ("frame", "track", "left", "top", "width", "height", "x", "y", "confidence")
    columns = dict(zip(names, np.ascontiguousarray(rows.T), strict=True))
    columns["frame"] = columns["frame"].astype(np.int32)
    columns["track"] = columns["track"].astype(np.int32)
    return ScoringTable.from_columns(columns, dont_cares=dont_cares)
