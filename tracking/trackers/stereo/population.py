"""Everybody a stereo tracker follows, one row a person."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_WALK_M_PER_S = 1.0
"""Spread of people's velocities along each axis, before anything is known of them."""
APPEARANCE_SIZE = 7
"""Numbers that `Population.appearance` has."""


@dataclass(frozen=True, slots=True)
class Population:
    """The people being followed, as arrays with one row a person; nothing is changed in place.

    Attributes:
        track: (people,) int32 id; 0 while the track is tentative.
        particles: (people, N, 2) float32 m on the floor.
        weight: (people, N) float32, rows sum to 1.
        position: (people, 2) m, the filter's estimate.
        velocity: (people, 2) m/s.
        matches: (people,) int32 frames matched so far.
        missed_s: (people,) seconds since the last match; 0 while matched.
        seen_at: (people, 2) m, the estimate at the last match.
        colour: (people, cues, bins) float32 colour models, square roots not taken.
        anchors: (people, 2, 2) m, the older and the newer past position that a direction is
            taken between; NaN where there is none yet.
        anchor_age_s: (people,) seconds since the newer anchor was set.
        outline: (people, 4) m, left, top, right, bottom of the body's box from the body's middle,
            in metres at its distance.
        confidence: (people,) share of the recent past in which the person was matched.
        appearance: (people, 7) float32 mean CIELAB of the upper and of the lower body and the
            height in m, of those who ask for them; NaN where not known.
        motion: (people, 3) variance of the position in m², covariance with the velocity in m²/s
            and variance of that in m²/s², along each axis, of those who ask for them.
    """

    track: NDArray[np.int32]
    particles: NDArray[np.float32]
    weight: NDArray[np.float32]
    position: Floats
    velocity: Floats
    matches: NDArray[np.int32]
    missed_s: Floats
    seen_at: Floats
    colour: NDArray[np.float32]
    anchors: Floats
    anchor_age_s: Floats
    outline: Floats
    confidence: Floats
    appearance: NDArray[np.float32]
    motion: Floats

    def __len__(self) -> int:
        """The number of people followed, with tentative tracks."""
        return len(self.track)

    @property
    def confirmed(self) -> NDArray[np.bool_]:
        """(people,) whose track has an id."""
        return self.track > 0

    def select(self, rows: NDArray[Any]) -> Population:
        """The people at these rows (indices or a mask)."""
        if rows.dtype == np.bool_ and rows.all():
            return self
        return Population(*[column[rows] for column in _columns_of(self)])

    def replace(self, **columns: NDArray[Any]) -> Population:
        """The same people with some columns replaced."""
        # Several times as fast as `dataclasses.replace`, and called for every step of a frame.
        kept = [columns.pop(name) if name in columns else getattr(self, name) for name in _NAMES]
        if columns:
            raise TypeError(f"no columns of people: {', '.join(columns)}")
        return Population(*kept)

    def with_rows(self, rows: NDArray[np.intp], **values: NDArray[Any]) -> Population:
        """The same people with new values at some rows of some columns."""
        columns: dict[str, NDArray[Any]] = {}
        for name, value in values.items():
            column = getattr(self, name).copy()
            column[rows] = value
            columns[name] = column
        return self.replace(**columns)


_NAMES = tuple(field.name for field in dataclasses.fields(Population))
_columns_of = attrgetter(*_NAMES)


def unknown_appearance(people: int) -> NDArray[np.float32]:
    """`Population.appearance` of whom nothing is known."""
    return np.full((people, APPEARANCE_SIZE), np.nan, np.float32)


def unknown_motion(position_m: Floats) -> Floats:
    """`Population.motion` of people whose place errs so much (people,) and who may walk anyhow."""
    none = np.zeros(len(position_m))
    return np.stack((position_m**2, none, none + _WALK_M_PER_S**2), axis=1)


def concatenate(populations: Sequence[Population]) -> Population:
    """The people of all populations, in order."""
    populations = [each for each in populations if len(each)] or populations[:1]
    if len(populations) == 1:
        return populations[0]
    return Population(
        *(np.concatenate([getattr(each, name) for each in populations]) for name in _NAMES)
    )


def empty_population(particles: int, cues: int, bins: int) -> Population:
    """A population without people, ready to be joined with."""
    shapes: dict[str, tuple[tuple[int, ...], type]] = {
        "track": ((), np.int32),
        "particles": ((particles, 2), np.float32),
        "weight": ((particles,), np.float32),
        "position": ((2,), np.float64),
        "velocity": ((2,), np.float64),
        "matches": ((), np.int32),
        "missed_s": ((), np.float64),
        "seen_at": ((2,), np.float64),
        "colour": ((cues, bins), np.float32),
        "anchors": ((2, 2), np.float64),
        "anchor_age_s": ((), np.float64),
        "outline": ((4,), np.float64),
        "confidence": ((), np.float64),
        "appearance": ((APPEARANCE_SIZE,), np.float32),
        "motion": ((3,), np.float64),
    }
    return Population(*(np.zeros((0, *shapes[name][0]), shapes[name][1]) for name in _NAMES))
