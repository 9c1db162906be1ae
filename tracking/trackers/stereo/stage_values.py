"""What the stages of a stereo tracker's step give each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association
from tracking.people import Detections
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.cues import Costs
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.shared_detections import SharedRegions

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Rows = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class MeasuredFrame:
    """What a frame shows.

    Attributes:
        seen: all detections. colours: (detections, cues, bins) of them.
        elapsed_s: since the frame before.
    """

    seen: Detections
    colours: NDArray[np.float32]
    elapsed_s: float

    @property
    def places(self) -> Floats:
        """(detections, 2) m on the floor."""
        return self.seen.position[:, :2]

    @property
    def usable(self) -> Flags:
        """(detections,) False: merged regions, nobody's detection ([Kawashita2014] 3.4)."""
        return ~self.seen.merged

    def free(self, pairs: Association) -> Rows:
        """The usable detections that are in no pair."""
        free = self.usable
        free[pairs.detection] = False
        return np.flatnonzero(free)


@dataclass(frozen=True, slots=True)
class ExpectedPeople:
    """Predict gives: everybody where they are expected in this frame.

    Attributes:
        people: predicted. bodies: theirs in the picture.
        shown: (people,) share of each body that is expected to be in sight.
    """

    people: Population
    bodies: Bodies
    shown: Floats


@dataclass(frozen=True, slots=True)
class AssociatedPeople:
    """Associate gives: who is which detection.

    Attributes:
        pairs: rows of the population and of the detections. costs: of all pairs.
        shared: which of their regions hold somebody else too.
        isolated: (pairs,) who has nobody close, so that a region's colours are theirs.
        since_s: (pairs,) seconds since each matched person's last match.
    """

    pairs: Association
    costs: Costs
    shared: SharedRegions
    isolated: Flags
    since_s: Floats

    def measured(self, frame: MeasuredFrame) -> Floats:
        """(pairs, 2) m where each matched person was seen: in a shared region on their side."""
        place = frame.places[self.pairs.detection]
        place[self.shared.owner] = self.shared.owner_at
        return place

    @property
    def alone(self) -> Flags:
        """(pairs,) whose region holds nobody else."""
        return self.shared.alone_of(self.pairs)


@dataclass(frozen=True, slots=True)
class UpdatedPeople:
    """Update gives: everybody where they are now.

    Attributes:
        people: with what was learnt of them. bodies: theirs in the picture.
    """

    people: Population
    bodies: Bodies

    @property
    def box(self) -> Floats:
        """(people, 4) px of the bodies, hidden or not."""
        return self.bodies.boxes(self.people.outline)
