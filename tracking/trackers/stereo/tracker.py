"""The particle filter over people that both stereo trackers are."""

from __future__ import annotations

from dataclasses import replace

from tracking.people import Observation
from tracking.trackers.shared.gating import GatedPairs
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.stereo.association import associate_people
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.cues import Cues, costs_of, gate_people
from tracking.trackers.stereo.filter import StereoFilter
from tracking.trackers.stereo.initiation import confirm_tracks
from tracking.trackers.stereo.motion import predict
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.result import step_result
from tracking.trackers.stereo.settings import StereoTrackerSettings
from tracking.trackers.stereo.stage_values import (
    AssociatedPeople,
    ExpectedPeople,
    MeasuredFrame,
    UpdatedPeople,
)
from tracking.trackers.stereo.termination import should_keep
from tracking.trackers.stereo.update import age_tracks, update_matched


class StereoTracker(StereoFilter[StereoTrackerSettings, Cues]):
    """Follows people over stereo observations with one particle set each.

    The five steps of [Kawashita2012] and [Kawashita2014], for all people at once: predict,
    cost of all pairs, associate, weigh with the matched detection, resample; new people are
    initialised at what is left. What the two papers do differently is in their `Cues`.

    Where we differ from the sources and why:
        - a track is tentative until it was seen in several frames: noise is not a person;
        - people seen a moment ago choose their detections before those missed for long, who
          search wider: an old track does not take what belongs to a present one; nor does a
          present one take what suits somebody missed better;
        - a person expected to be hidden by others pays for a detection: what is seen is more
          likely the one in front;
        - a detection that suits two people nearly alike is nobody's, as a merged region is;
        - those not seen are weighed by where they could not be seen (see `update_missed`);
        - a match far from all particles scatters them anew around it: the cloud had lost its
          person, and resampling would leave it as one point;
        - velocity is smoothed over several matches: one frame's movement is mostly noise;
        - colours are learnt only while nobody else is close;
        - people who leave the picture end at once, those at its edge soon, the hidden late.
    """

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further: predict, gate, associate, update, terminate, initiate.

        Tentative tracks get ids before the frame is reported; new ones begin behind it.
        """
        frame = self._measure(observation)
        expected = self._predict(frame)
        gated = gate_people(expected.people, frame.places, self._settings)
        associated = self._associate(expected, gated, frame)
        updated = self._confirm(self._update(expected, associated, frame))
        result = step_result(observation, updated.people, updated.box, associated, self._view)
        people = self._terminate(replace(updated, people=self._resample(updated.people)))
        self._people = self._initiate(people, frame.free(associated.pairs), frame)
        return result

    def _predict(self, frame: MeasuredFrame) -> ExpectedPeople:
        """Everybody moved on at their velocity."""
        before = self._followed(frame)
        way = before.velocity * frame.elapsed_s
        return self._expect(predict(before, way, self._settings, frame.elapsed_s, self._random))

    def _associate(
        self, expected: ExpectedPeople, gated: GatedPairs, frame: MeasuredFrame
    ) -> AssociatedPeople:
        """Who is which detection, at the smallest cost."""
        settings = self._settings
        costs = costs_of(
            expected.people,
            gated,
            frame.places,
            frame.colours,
            self._cues,
            settings,
            expected.shown,
        )
        pairs = associate_people(expected.people, costs, frame.usable, settings)
        return AssociatedPeople(pairs, costs, *self._share(expected, pairs, frame))

    def _update(
        self, expected: ExpectedPeople, associated: AssociatedPeople, frame: MeasuredFrame
    ) -> UpdatedPeople:
        """Those matched weighed with their detections, the others by where they are not."""
        settings, random = self._settings, self._random
        people = age_tracks(expected.people, associated.pairs.track, frame.elapsed_s)
        people = update_matched(people, associated, frame, self._cues, settings, random)
        people = self._update_unmatched(people, expected, associated, frame)
        bodies = Bodies.at(people.position, self._view)
        return UpdatedPeople(self._update_outlines(people, associated, frame, bodies), bodies)

    def _confirm(self, updated: UpdatedPeople) -> UpdatedPeople:
        """Tentative tracks matched often enough get an id."""
        matches = self._settings.confirm_matches
        return replace(updated, people=confirm_tracks(updated.people, matches, self._ids))

    def _terminate(self, updated: UpdatedPeople) -> Population:
        """The people without those missed for too long, or out of the picture."""
        size = self._view.camera.size
        return updated.people.select(should_keep(updated.people, updated.box, self._settings, size))
