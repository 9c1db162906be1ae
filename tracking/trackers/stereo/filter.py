"""What all trackers over stereo observations are: people carried from frame to frame."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, resample
from tracking.geometry import View
from tracking.people import Observation
from tracking.trackers.shared.gating import nearest_others_m
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.tracker_base import TrackerBase
from tracking.trackers.stereo.boxes import Bodies, expected_visibility, update_outlines
from tracking.trackers.stereo.cues import Cues
from tracking.trackers.stereo.initiation import initiate_tracks
from tracking.trackers.stereo.population import Population, concatenate, empty_population
from tracking.trackers.stereo.resumed_people import resume_people
from tracking.trackers.stereo.settings import StereoFilterSettings
from tracking.trackers.stereo.shared_detections import SharedRegions, find_shared_regions
from tracking.trackers.stereo.stage_values import (
    AssociatedPeople,
    ExpectedPeople,
    MeasuredFrame,
)
from tracking.trackers.stereo.update import update_missed, update_occluded

SettingsT = TypeVar("SettingsT", bound=StereoFilterSettings)
CuesT = TypeVar("CuesT", bound=Cues)
Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


class StereoFilter(TrackerBase[SettingsT], Generic[SettingsT, CuesT]):
    """The people a stereo tracker follows, and what its stages share; trackers add the step."""

    def __init__(self, view: View, settings: SettingsT, cues: CuesT, seed: int) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        super().__init__(settings)
        self._view = view
        self._cues = cues
        self._random = np.random.default_rng(seed)
        self._people: Population | None = None

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected; those who are new get ids above all there were."""
        people, time_s = resume_people(
            resume, observations, self._view, self._settings, self._cues, self._random
        )
        self._people = self._resume_people(people)
        self._clock.set(time_s)
        self._ids.last = resume.highest_track

    def _resume_people(self, people: Population) -> Population:
        """The people to go on with, of those resumed."""
        return people

    def _measure(self, observation: Observation) -> MeasuredFrame:
        """What the frame shows."""
        seen = observation.people
        elapsed_s = self._clock.elapsed_s(observation.time_s)
        return MeasuredFrame(seen, self._cues.measure_colours(seen), elapsed_s)

    def _followed(self, frame: MeasuredFrame) -> Population:
        """The people as the frame before left them; nobody at first."""
        if self._people is None:
            return empty_population(self._settings.particles, *frame.colours.shape[1:])
        return self._people

    def _expect(self, people: Population, covering: Flags | None = None) -> ExpectedPeople:
        """The people predicted, with how much of them should be in sight.

        Args:
            covering: (people,) whose place is known well enough to cover others; None: everybody's.
        """
        bodies, size = Bodies.at(people.position, self._view), self._view.camera.size
        shown = expected_visibility(people, bodies.boxes(people.outline), size, covering)
        return ExpectedPeople(people, bodies, shown)

    def _share(
        self, expected: ExpectedPeople, pairs: Association, frame: MeasuredFrame
    ) -> tuple[SharedRegions, Flags, Floats]:
        """`AssociatedPeople`'s shared, isolated and since_s of these pairs."""
        people = expected.people
        shared = find_shared_regions(people, expected.bodies, pairs, frame.seen, self._view)
        near_m = nearest_others_m(people.position)[pairs.track]
        isolated = near_m >= self._settings.colour_update_distance_m
        return shared, isolated, people.missed_s[pairs.track] + frame.elapsed_s

    def _update_unmatched(
        self,
        people: Population,
        expected: ExpectedPeople,
        associated: AssociatedPeople,
        frame: MeasuredFrame,
        sought: Flags | None = None,
    ) -> Population:
        """The people, those without a detection weighed by where they are not, or by whose region.

        Args:
            people: those matched are updated. sought: as in `update_missed`.
        """
        settings, random = self._settings, self._random
        people = update_missed(people, frame.elapsed_s, self._view, settings, sought)
        return update_occluded(people, expected.people, associated.shared, settings, random)

    def _update_outlines(
        self,
        people: Population,
        associated: AssociatedPeople,
        frame: MeasuredFrame,
        bodies: Bodies,
    ) -> Population:
        """The people with the outlines of those matched, and where directions are taken from."""
        pairs, elapsed_s = associated.pairs, frame.elapsed_s
        people = update_outlines(people, pairs, associated.alone, frame.seen, elapsed_s, bodies)
        return self._cues.update_anchors(people, elapsed_s)

    def _resample(self, people: Population) -> Population:
        """The people with heavy particles multiplied and light ones dropped."""
        return people.replace(particles=resample(people.particles, people.weight, self._random))

    def _initiate(
        self, people: Population, free: NDArray[np.intp], frame: MeasuredFrame
    ) -> Population:
        """The people with tentative tracks at the free detections."""
        new = initiate_tracks(people, frame, free, self._settings, self._random, self._view)
        return concatenate((people, new))
