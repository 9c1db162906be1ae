"""What tells people apart: the cues of the stereo trackers and their sum."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import bhattacharyya_distance
from tracking.people import Detections
from tracking.trackers.shared.gating import GatedPairs, gate_pairs
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


def gate_people(
    people: Population, measured: Floats, settings: StereoTrackerSettings
) -> GatedPairs:
    """The pairs within the gate, which widens for who is missed and with the range.

    The papers name a wider search after long occlusion as what they lack.

    Args:
        people: predicted to this frame. measured: (detections, 2) m.
    """
    wider = _widening(people, measured, settings)
    return gate_pairs(people.position, measured, settings.gate_m * wider)


def _widening(people: Population, measured: Floats, settings: StereoTrackerSettings) -> Floats:
    """(people, detections) how many times wider than usual the gate is.

    The error of range grows with the distance from the camera.
    """
    range_errors = likelihood_sigma(measured, settings) / settings.measurement_noise_m
    return (1.0 + settings.gate_growth * people.missed_s)[:, None] * range_errors


def costs_of(
    people: Population,
    gated: GatedPairs,
    measured: Floats,
    colours: NDArray[np.float32],
    cues: Cues,
    settings: StereoTrackerSettings,
    shown: Floats,
) -> Costs:
    """The costs of all pairs: `D = Dd + Dc + Da` ([Kawashita2014] section 3.3).

    Where we differ from the source:
        - distance counts for less as the gate widens: of somebody missed the longer the less, and
          far from the camera;
        - distance and colour have weights (the papers leave those open);
        - somebody expected to be hidden pays for a detection: what is seen is more likely the
          one in front.

    Args:
        people: predicted to this frame. gated: all pairs. measured: (detections, 2) m.
        colours: (detections, cues, bins).
        shown: (people,) share of each body, 0 to 1, that the others leave to be seen.
    """
    colour, direction = cue_values(people, measured, colours, cues)
    wider = _widening(people, measured, settings)
    total = (
        settings.distance_weight * gated.distance / wider
        + settings.colour_weight * colour
        + np.nan_to_num(direction)
        + settings.occlusion_weight * (1.0 - shown)[:, None]
    )
    return Costs(gated.distance, colour, direction, total, gated.allowed)


def cue_values(
    people: Population, measured: Floats, colours: NDArray[np.float32], cues: Cues
) -> tuple[Floats, Floats]:
    """Dc and Da of all pairs, each (people, detections); as in `costs_of`."""
    colour = np.zeros((len(people), len(measured)))
    for cue in range(people.colour.shape[1]):
        colour += bhattacharyya_distance(people.colour[:, cue], colours[:, cue])
    return colour, cues.direction(people, measured)


def likelihood_sigma(measured: Floats, settings: StereoFilterSettings) -> Floats:
    """The likelihood's standard deviation at places (n, 2) on the floor: (n,) m.

    It grows with the square of the distance from the camera, as the error of range does.
    """
    squared = np.asarray(np.square(measured).sum(axis=1))
    return settings.measurement_noise_m + settings.measurement_noise_growth * squared
