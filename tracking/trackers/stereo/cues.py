"""What tells people apart: the cues of the stereo trackers and their sum."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import bhattacharyya_distance
from tracking.people import Detections
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.settings import StereoFilterSettings, StereoTrackerSettings

Floats = NDArray[np.float64]


class Cues(Protocol):
    """The cues of one paper beyond distance."""

    def measure_colours(self, people: Detections) -> NDArray[np.float32]:
        """Colours of each detection: (detections, cues, bins) histograms."""

    def update_colours(
        self, model: NDArray[np.float32], seen: NDArray[np.float32], matches: NDArray[np.int32]
    ) -> NDArray[np.float32]:
        """Colour models (people, cues, bins) after one more match."""

    def is_complete(self, matches: NDArray[np.int32]) -> NDArray[np.bool_]:
        """Of whom, matched so often (people,), the colour model is what the paper compares with."""

    def direction(self, people: Population, measured: Floats) -> Floats:
        """Da of every pair (people, detections); NaN where a direction is missing."""

    def update_anchors(self, people: Population, elapsed_s: float) -> Population:
        """The people with the positions brought up to date that directions are taken between."""


@dataclass(frozen=True, slots=True)
class Costs:
    """What each pair of a person and a detection would cost; all (people, detections).

    Attributes:
        distance: Dd, m. colour: Dc, summed over the colour cues. direction: Da. Both NaN where
            left out. total: D, which association makes smallest. allowed: inside the gate.
    """

    distance: Floats
    colour: Floats
    direction: Floats
    total: Floats
    allowed: NDArray[np.bool_]


def costs_of(
    people: Population,
    measured: Floats,
    colours: NDArray[np.float32],
    cues: Cues,
    settings: StereoTrackerSettings,
    shown: Floats,
) -> Costs:
    """The costs of all pairs: `D = Dd + Dc + Da` ([Kawashita2014] section 3.3).

    Where we differ from the source:
        - the distance of somebody who was missed counts for less, the longer the less, and the
          gate widens alike (the papers name a wider search after long occlusion as what they
          lack);
        - both also widen with the distance from the camera, as the error of range does;
        - distance and colour have weights (the papers leave those open);
        - somebody expected to be hidden pays for a detection: what is seen is more likely the
          one in front.

    Args:
        people: predicted to this frame. measured: (detections, 2) m.
        colours: (detections, cues, bins).
        shown: (people,) share of each body, 0 to 1, that the others leave to be seen.
    """
    distance, colour, direction = cue_values(people, measured, colours, cues)
    wider = (1.0 + settings.gate_growth * people.missed_s)[:, None] * (
        likelihood_sigma(measured, settings) / settings.measurement_noise_m
    )
    total = (
        settings.distance_weight * distance / wider
        + settings.colour_weight * colour
        + np.nan_to_num(direction)
        + settings.occlusion_weight * (1.0 - shown)[:, None]
    )
    return Costs(distance, colour, direction, total, distance <= settings.gate_m * wider)


def cue_values(
    people: Population, measured: Floats, colours: NDArray[np.float32], cues: Cues
) -> tuple[Floats, Floats, Floats]:
    """Dd in metres, Dc and Da of all pairs, each (people, detections); as in `costs_of`."""
    offset = measured[None, :, :] - people.position[:, None, :]
    distance = np.hypot(offset[..., 0], offset[..., 1])
    colour = np.zeros_like(distance)
    for cue in range(people.colour.shape[1]):
        colour += bhattacharyya_distance(people.colour[:, cue], colours[:, cue])
    return distance, colour, cues.direction(people, measured)


def likelihood_sigma(measured: Floats, settings: StereoFilterSettings) -> Floats:
    """The likelihood's standard deviation at places (n, 2) on the floor: (n,) m.

    It grows with the square of the distance from the camera, as the error of range does.
    """
    squared = np.asarray(np.square(measured).sum(axis=1))
    return settings.measurement_noise_m + settings.measurement_noise_growth * squared
