"""What the stages of the joint tracker's step give each other beside what stereo trackers do."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.appearance_source import Embeddings
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.stage_values import (
    AssociatedPeople,
    MeasuredFrame,
    UpdatedPeople,
)

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class JointFrame(MeasuredFrame):
    """What a frame shows, and how far its measurements are to be trusted.

    Attributes:
        appearance: (detections, k) as `Population.appearance`.
        embeddings: (detections, d) of an appearance network; None: there is none.
        sigma: (detections,) m, the error of their places.
        births: (detections,) the log of the birth intensity there, see `log_birth_intensity`.
        interval_s: between two frames, as they usually come.
    """

    appearance: NDArray[np.float32]
    embeddings: Embeddings | None
    sigma: Floats
    births: Floats
    interval_s: float


@dataclass(frozen=True, slots=True)
class AssociatedTracks(AssociatedPeople):
    """Associate gives: who is which detection, and whose nobody's are.

    Attributes:
        difference: (people, detections, cues) as `appearance_differences`.
        free: detections that nobody has but somebody new may have.
    """

    difference: Floats
    free: NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class UpdatedTracks(UpdatedPeople):
    """Update gives: everybody where they are now.

    Attributes:
        around: the bodies a step off, see `here_and_a_step_off`.
    """

    around: Bodies
