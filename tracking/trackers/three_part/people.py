"""Everybody followed in the picture, one row a person."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Clouds, joined_clouds, no_clouds
from tracking.tracks import PART_EVIDENCE

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Layout:
    """How parts are shared out among filters.

    Attributes:
        parts: of a person: 3, or 1 of a person followed whole.
        together: how many of them one particle holds: 1 for a filter a part, or all.
    """

    parts: int
    together: int

    @property
    def filters(self) -> int:
        """How many filters a person has."""
        return self.parts // self.together


@dataclass(frozen=True, slots=True, eq=False)
class PartPeople:
    """The people followed; nothing is changed in place.

    Attributes:
        track: (people,) int32 ids.
        clouds: particles; person p's filters are the targets p * filters to (p + 1) * filters.
        state: (people, parts, 6) the estimates: X, Y, W, H in px as recorded, dX, dY in px/s.
        pace: (people, 2) px/s, how the person as a whole moves, smoothed.
        model: (people, parts, 3, 256) float32 histograms of levels: H of [ZhaoLee2009] eq. 1.
        appearance: (people, parts, 3, 256) the same, learnt slowly and from good views only; who
            somebody is when re-identified.
        similarity: (people, parts) of the part to its model at the estimate, 0 to 1.
        usual: (people, parts) the same, smoothed.
        entropy: (people, parts) of the weights, 0 to 1; NaN where a part was not filtered.
        occluded: (people, parts) motion only in the last frame.
        cut: (people, parts) of those, the ones that were out of the picture.
        touching: (people,) whose parts touched somebody else's in the last frame.
        failed: (people, parts) the detector's verdict in the last frame.
        score: (people, parts) of it; NaN where nothing was judged.
        evidence: (people, parts, 8) `PART_EVIDENCE` in the last frame; NaN where not measured.
        outline: (people, 4) by how much left, top, right and bottom of the person's box differ
            from what the parts alone say, in heights of that box.
        pose: (people, parts, 4) px, where the parts' middles are from the mean of them all, and
            their sizes, when nothing is hidden.
        height: (people,) px, how high the person looks standing upright.
        place: (people, 2) m on the floor; NaN where that is not known.
        walk: (people, 2) m/s on the floor, smoothed.
        missed_s: (people,) since there was foreground under the parts; 0 while there is.
        hidden_s: (people,) for how long some part has been occluded; 0 while none is.
        age_s: (people,) since the track began.
    """

    track: NDArray[np.int32]
    clouds: Clouds
    state: Floats
    pace: Floats
    model: NDArray[np.float32]
    appearance: NDArray[np.float32]
    similarity: Floats
    usual: Floats
    entropy: Floats
    occluded: Flags
    cut: Flags
    touching: Flags
    failed: Flags
    score: Floats
    evidence: Floats
    outline: Floats
    pose: Floats
    height: Floats
    place: Floats
    walk: Floats
    missed_s: Floats
    hidden_s: Floats
    age_s: Floats

    def __len__(self) -> int:
        """The number of people followed."""
        return len(self.track)

    def replace(self, **columns: Any) -> PartPeople:
        """The same people with some columns replaced."""
        return dataclasses.replace(self, **columns)

    def select(self, rows: Indices, filters: int) -> PartPeople:
        """The people at these rows, each with so many filters."""
        targets = (rows[:, None] * filters + np.arange(filters)).ravel()
        columns = {name: getattr(self, name)[rows] for name in _COLUMNS}
        return PartPeople(clouds=self.clouds.select(targets), **columns)

    @property
    def hidden(self) -> Flags:
        """(people,) of whom something hides some part."""
        return np.asarray((self.occluded & ~self.cut).any(axis=1))

    @property
    def is_cut(self) -> Flags:
        """(people,) of whom some part is out of the picture."""
        return np.asarray(self.cut.any(axis=1))

    @property
    def rectangles(self) -> Floats:
        """(people, parts, 4) cx, cy, width, height px."""
        return self.state[..., :4]


_COLUMNS = tuple(field.name for field in dataclasses.fields(PartPeople) if field.name != "clouds")


def concatenate(one: PartPeople, other: PartPeople) -> PartPeople:
    """The people of one, then those of the other."""
    columns = {
        name: np.concatenate((getattr(one, name), getattr(other, name))) for name in _COLUMNS
    }
    return PartPeople(clouds=joined_clouds(one.clouds, other.clouds), **columns)


def no_people(layout: Layout) -> PartPeople:
    """Nobody yet, ready to be joined."""
    return unknown_people(np.zeros(0, np.int32), layout.parts, no_clouds(layout.together))


def unknown_people(track: NDArray[np.int32], parts: int, clouds: Clouds) -> PartPeople:
    """People (people,) of so many parts of whom nothing is known but their particles."""
    people = len(track)
    each = (people, parts)
    return PartPeople(
        track=track,
        clouds=clouds,
        state=np.zeros((*each, 6)),
        pace=np.zeros((people, 2)),
        model=np.zeros((*each, 3, 256), np.float32),
        appearance=np.zeros((*each, 3, 256), np.float32),
        similarity=np.zeros(each),
        usual=np.zeros(each),
        entropy=np.full(each, np.nan),
        occluded=np.zeros(each, bool),
        cut=np.zeros(each, bool),
        touching=np.zeros(people, bool),
        failed=np.zeros(each, bool),
        score=np.full(each, np.nan),
        evidence=np.full((*each, len(PART_EVIDENCE)), np.nan),
        outline=np.zeros((people, 4)),
        pose=np.zeros((*each, 4)),
        height=np.zeros(people),
        place=np.full((people, 2), np.nan),
        walk=np.zeros((people, 2)),
        missed_s=np.zeros(people),
        hidden_s=np.zeros(people),
        age_s=np.zeros(people),
    )
