"""The people being followed, each with hypotheses of where they stand."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class SpheroidPeople:
    """Everybody followed, a row each, sorted by track.

    Attributes:
        track: (people,) ids.
        state: (people, N, 4) float32, hypotheses: x, y in m and their velocity in m/s.
        weight: (people, N) float32, each row sums to 1.
        tall: (people, N) float32, m, the hypotheses' body heights.
        mean: (people, 4) the estimate of the state.
        height, height_sd: (people,) m, what is thought of the body height, and how surely.
        spread: (people,) m, of the hypotheses along their longest direction.
        coverage: (people,) share of the estimate's silhouette, as far as it can be seen, that is
            foreground.
        shown: (people,) share of it that can be seen: in the picture and behind nobody.
        inside: (people,) share of it in the picture.
        missed_s: (people,) seconds without foreground where they should be; 0 while seen.
        age_s: (people,) since they were found. quiet_s: (people,) how long they have hardly moved.
        outline: (people, 4) by what the sides of their boxes differ from usual ones.
        appearance: (people, cells, 3) float32 the colours they are known by; counts: (people,
            cells)
            how much is known of each.
    """

    track: NDArray[np.int32]
    state: NDArray[np.float32]
    weight: NDArray[np.float32]
    tall: NDArray[np.float32]
    mean: Floats
    height: Floats
    height_sd: Floats
    spread: Floats
    coverage: Floats
    shown: Floats
    inside: Floats
    missed_s: Floats
    age_s: Floats
    quiet_s: Floats
    outline: Floats
    appearance: NDArray[np.float32]
    counts: NDArray[np.float32]

    def __len__(self) -> int:
        """The number of people followed."""
        return len(self.track)

    @property
    def xy(self) -> Floats:
        """(people, 2) m where they stand."""
        return self.mean[:, :2]

    def select(self, rows: NDArray[Any]) -> SpheroidPeople:
        """The people at these rows (indices or a mask)."""
        return SpheroidPeople(*(getattr(self, name)[rows] for name in _NAMES))

    def replace(self, **columns: NDArray[Any]) -> SpheroidPeople:
        """The same people with some columns replaced."""
        return dataclasses.replace(self, **columns)

    def with_rows(self, rows: NDArray[Any], **values: NDArray[Any]) -> SpheroidPeople:
        """The same people with new values at some rows of some columns."""
        columns = {name: getattr(self, name).copy() for name in values}
        for name, value in values.items():
            columns[name][rows] = value
        return self.replace(**columns)


_NAMES = tuple(field.name for field in dataclasses.fields(SpheroidPeople))
APPEARANCE_CELLS = 8
"""Places on a body at which its colours are known, from head to foot."""


def no_people(count: int) -> SpheroidPeople:
    """Nobody, with so many hypotheses each."""
    none = np.zeros(0)
    no_random = np.random.default_rng(0)
    return begin_people(
        np.zeros(0, np.int32), np.zeros((0, 4)), none, 0.0, count, (0.0, 0.0), no_random
    )


def concatenate(groups: Sequence[SpheroidPeople]) -> SpheroidPeople:
    """The people of all groups, in order."""
    return SpheroidPeople(
        *(np.concatenate([getattr(each, name) for each in groups]) for name in _NAMES)
    )


def begin_people(
    track: NDArray[np.int32],
    mean: Floats,
    height: Floats,
    height_sd: float,
    count: int,
    spreads: tuple[float, float],
    random: np.random.Generator,
    places: Floats | None = None,
) -> SpheroidPeople:
    """People at their start.

    Args:
        mean: (people, 4) m and m/s. height: (people,) m, and how surely it is known.
        count: hypotheses of each. spreads: m and m/s of them. random: where the noise comes from.
        places: (people, count, 2) m about which the hypotheses spread; None: about the mean.
    """
    people = len(track)
    noise = random.standard_normal((people, count, 4), dtype=np.float32)
    noise *= np.repeat(np.array(spreads, np.float32), 2)
    if places is not None:
        noise[..., :2] += (places - mean[:, None, :2]).astype(np.float32)
    zero = np.zeros(people)
    return SpheroidPeople(
        track=track,
        state=noise + mean[:, None].astype(np.float32),
        weight=np.full((people, count), 1.0 / count, np.float32),
        tall=np.repeat(height[:, None], count, axis=1).astype(np.float32),
        mean=mean,
        height=height,
        height_sd=np.full(people, height_sd),
        spread=np.full(people, spreads[0]),
        coverage=np.ones(people),
        shown=np.ones(people),
        inside=np.ones(people),
        missed_s=zero,
        age_s=zero,
        quiet_s=zero,
        outline=np.zeros((people, 4)),
        appearance=np.zeros((people, APPEARANCE_CELLS, 3), np.float32),
        counts=np.zeros((people, APPEARANCE_CELLS), np.float32),
    )
