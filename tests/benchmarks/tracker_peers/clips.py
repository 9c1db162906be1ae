"""Detections that every tracker gets, with the truth they are judged by."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.people.observation import Observation
from tracking.scoring import ScoringTable


@dataclass(frozen=True, slots=True)
class Clip:
    """What is seen of a recording, frame by frame.

    Attributes:
        name: of the clip, told with its figures.
        recording: folder of the recording whose camera and floor trackers are built on.
        observations: one for each frame from 0 on, without pictures.
        fps: frames a second.
        truth: who is where; rows that may be missed are don't-cares.
    """

    name: str
    recording: Path
    observations: tuple[Observation, ...]
    fps: float
    truth: ScoringTable

    @property
    def seen(self) -> NDArray[np.float64]:
        """(n, 8) detections as the trackers of others get them; see `tests.peers.peer_runs`."""
        return np.concatenate([_rows(one) for one in self.observations])

    @property
    def without_colours(self) -> Clip:
        """The same, everybody's clothes alike and unknown."""
        bare = tuple(replace(one, people=_grey(one.people)) for one in self.observations)
        return replace(self, observations=bare)


def _rows(observation: Observation) -> NDArray[np.float64]:
    people = observation.people
    frame = np.full(len(people), observation.frame)
    return np.column_stack((frame, people.box, people.position[:, :2], people.merged))


def _grey(people: Detections) -> Detections:
    """Equal histograms, no colour of clothes: nothing that tells one from another."""
    return replace(
        people,
        upper=_even(people.upper),
        lower=_even(people.lower),
        middle=_even(people.middle),
        clothes=np.full_like(people.clothes, np.nan),
    )


def _even(histograms: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.full_like(histograms, 1.0 / max(histograms.shape[-1], 1))
