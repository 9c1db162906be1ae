"""What all trackers over stereo observations are: people carried from frame to frame."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import move
from tracking.geometry import View
from tracking.people import Observation
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.stereo.cues import Cues
from tracking.trackers.stereo.population import Population, empty_population
from tracking.trackers.stereo.resumed_people import resume_people
from tracking.trackers.stereo.settings import StereoFilterSettings, StereoTrackerSettings

SettingsT = TypeVar("SettingsT", bound=StereoFilterSettings)
CuesT = TypeVar("CuesT", bound=Cues)


class StereoFilter(Generic[SettingsT, CuesT]):
    """The people a stereo tracker follows, its randomness and its clock; trackers add the step."""

    def __init__(self, view: View, settings: SettingsT, cues: CuesT, seed: int) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        self._view = view
        self._settings = settings
        self._cues = cues
        self._random = np.random.default_rng(seed)
        self._people: Population | None = None
        self._last_id = 0
        self._time_s = 0.0

    @property
    def settings(self) -> SettingsT:
        """The settings in force."""
        return self._settings

    @property
    def notes(self) -> tuple[str, ...]:
        """There are no notes."""
        return ()

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected; those who are new get ids above all there were."""
        people, self._time_s = resume_people(
            resume, observations, self._view, self._settings, self._cues, self._random
        )
        self._people = self._resume_people(people)
        self._last_id = resume.highest_track

    def _resume_people(self, people: Population) -> Population:
        """The people to go on with, of those resumed."""
        return people

    def _begin_frame(
        self, observation: Observation, colours: NDArray[np.float32]
    ) -> tuple[Population, float]:
        """The people as the frame before left them, and the seconds since; nobody at first.

        No time has passed where a frame bears the time of one before it, or an earlier one.

        Args:
            colours: (detections, cues, bins), which say how colour models look.
        """
        if self._people is None:
            self._people = empty_population(self._settings.particles, *colours.shape[1:])
            self._time_s = observation.time_s
        elapsed_s = max(observation.time_s - self._time_s, 0.0)
        self._time_s = max(observation.time_s, self._time_s)
        return self._people, elapsed_s


def predict(
    people: Population,
    step: NDArray[np.float64],
    settings: StereoTrackerSettings,
    elapsed_s: float,
    random: np.random.Generator,
) -> Population:
    """Everybody moved on, with a spread that grows while they are missed.

    Args:
        step: (people, 2) m, how far each is thought to have gone.
    """
    spread = settings.process_noise_m * np.sqrt(elapsed_s)
    spreads = spread * (1.0 + settings.process_noise_growth * people.missed_s)
    return people.replace(
        particles=move(people.particles, step, spreads, random),
        position=people.position + step,
    )
