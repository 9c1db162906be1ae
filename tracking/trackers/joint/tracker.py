"""The joint stereo tracker: a particle filter per person, one association for all of them."""

from __future__ import annotations

from collections import deque
from dataclasses import replace
from statistics import median

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.people import Observation
from tracking.trackers.joint.appearance import (
    AppearanceModel,
    appearance_differences,
    appearance_trust,
    measure_appearance,
)
from tracking.trackers.joint.association import NAT, associate_people
from tracking.trackers.joint.association_likelihoods import (
    AssociationLikelihoods,
    detection_probability,
    gate_people,
    log_birth_intensity,
    score_pairs,
)
from tracking.trackers.joint.cues import JointCues
from tracking.trackers.joint.edges import here_and_a_step_off
from tracking.trackers.joint.motion import predict
from tracking.trackers.joint.noise import MeasurementNoise
from tracking.trackers.joint.reidentification import reidentify
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.stage_values import (
    AssociatedTracks,
    JointFrame,
    UpdatedTracks,
)
from tracking.trackers.joint.track_management import is_reported, may_be_occluded, should_keep
from tracking.trackers.joint.track_update import update_matched
from tracking.trackers.shared.gating import GatedPairs
from tracking.trackers.shared.known_embeddings import KnownEmbeddings
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.stereo.cues import Costs
from tracking.trackers.stereo.filter import StereoFilter
from tracking.trackers.stereo.initiation import confirm_tracks
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.result import step_result
from tracking.trackers.stereo.stage_values import ExpectedPeople
from tracking.trackers.stereo.update import age_tracks

Floats = NDArray[np.float64]

_SURE = 20
"""Matches that somebody counts as who was corrected by people and is in view."""
_SHORTEST_S = 1e-3
"""Between two frames."""
_FRAMES_TIMED = 9
"""Frames from which the usual interval is taken."""
_FAR_OFF = 2.0
"""A time so many times as long or short as the usual one says nothing of the others."""


class JointTracker(StereoFilter[JointSettings, JointCues]):
    """Follows people by the likeliest association of each frame, over all people at once.

    The five steps of [Kawashita2012] and [Kawashita2014] with their cues, where we differ:
        - costs are log-likelihood ratios, in one assignment of people and detections in which
          somebody may be missed, cheaply where others hide them, and a detection may be of
          somebody new, dearly within the picture;
        - particles spread as a Kalman filter's covariance grows, so that somebody is sought the
          wider the longer they are missed;
        - how far off places are, and how much colours, clothes and height tell people apart, is
          learnt from the footage (see `MeasurementNoise` and `AppearanceModel`);
        - the track of somebody who should be seen and is not coasts without being reported, and is
          re-identified by motion and appearance; no track coasts for much longer than it was seen;
        - a track last seen at the picture's edge is soon deleted.
    """

    def __init__(self, view: View, settings: JointSettings, seed: int) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        super().__init__(view, settings, JointCues(settings), seed)
        self._appearance = AppearanceModel.prior()
        self._noise = MeasurementNoise.prior(settings)
        self._known = KnownEmbeddings()
        self._intervals_s: deque[float] = deque(maxlen=_FRAMES_TIMED)

    def _resume_people(self, people: Population) -> Population:
        """The people to go on with: who was corrected and seen is sure to be somebody."""
        known = np.where(people.matches > 1, np.maximum(people.matches, _SURE), people.matches)
        return people.replace(matches=known)

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further, in the stages of `docs/stereo-joint.md`.

        Initiation has two halves: tentative tracks get ids before the frame is reported, and new
        ones begin where tracks have been terminated already.
        """
        frame = self._measure(observation)
        expected = self._predict(frame)
        gated = gate_people(expected.people, frame.places)
        associated = self._associate(expected, gated, frame)
        updated = self._update(expected, associated, frame)
        updated = self._confirm(updated, associated, frame)
        result = self._report(observation, expected, updated, associated, frame)
        people = self._resample(self._terminate(updated, frame))
        self._people = self._initiate(people, associated.free, frame)
        return result

    def _measure(self, observation: Observation) -> JointFrame:
        """What the frame shows, with what is learnt of measurements so far."""
        frame, settings = super()._measure(observation), self._settings
        return JointFrame(
            frame.seen,
            frame.colours,
            frame.elapsed_s,
            measure_appearance(frame.seen),
            None if observation.embed is None else observation.embed(frame.seen.box),
            self._noise.sigma(frame.places, settings),
            log_birth_intensity(frame.seen, settings, frame.elapsed_s, self._view),
            self._usual_interval_s(frame.elapsed_s),
        )

    def _usual_interval_s(self, elapsed_s: float) -> float:
        """Seconds that one match stands for: since the frame before, unless that is unusual.

        Frames that were not recorded, or two that follow each other at once, do not change for
        how long somebody matched in so many frames has been seen.
        """
        usual_s = median(self._intervals_s or (elapsed_s,))
        if elapsed_s > 0.0:
            self._intervals_s.append(elapsed_s)
        return elapsed_s if usual_s / _FAR_OFF <= elapsed_s <= usual_s * _FAR_OFF else usual_s

    def _predict(self, frame: JointFrame) -> ExpectedPeople:
        """Everybody moved on; who has not been seen for long covers nobody."""
        before, settings = self._followed(frame), self._settings
        people = predict(before, settings, frame.elapsed_s, self._random)
        return self._expect(people, people.missed_s < settings.report_s)

    def _associate(
        self, expected: ExpectedPeople, gated: GatedPairs, frame: JointFrame
    ) -> AssociatedTracks:
        """The likeliest association of the frame."""
        people, settings = expected.people, self._settings
        difference = appearance_differences(people, frame.colours, frame.appearance)
        costs, likelihoods = self._score_pairs(expected, gated, difference, frame)
        pairs, free = associate_people(
            people, likelihoods, gated, frame.usable, settings.association_margin / NAT
        )
        shared = self._share(expected, pairs, frame)
        return AssociatedTracks(pairs, costs, *shared, difference, free)

    def _score_pairs(
        self, expected: ExpectedPeople, gated: GatedPairs, difference: Floats, frame: JointFrame
    ) -> tuple[Costs, AssociationLikelihoods]:
        """The association likelihoods of all pairs, and the costs to report.

        Args:
            difference: as `appearance_differences`.
        """
        people, settings = expected.people, self._settings
        appearance = settings.appearance_weight * self._appearance.log_likelihood_ratio(difference)
        appearance *= appearance_trust(people)[:, None]
        if frame.embeddings is not None:
            embedded = self._known.log_likelihood_ratio(people.track, frame.embeddings)
            appearance += settings.appearance_weight * embedded
        turn = self._cues.direction(people, frame.places)
        detected = detection_probability(people, expected.shown, settings)
        likelihoods = score_pairs(people, gated, frame, appearance, turn, detected)
        colour = np.sqrt(difference[..., :3]).sum(axis=2)
        total = NAT * (likelihoods.match - likelihoods.missed[:, None])
        return Costs(gated.distance, colour, NAT * turn, total, gated.allowed), likelihoods

    def _update(
        self, expected: ExpectedPeople, associated: AssociatedTracks, frame: JointFrame
    ) -> UpdatedTracks:
        """Those matched weighed with their detections, the others by where they are not."""
        people = age_tracks(expected.people, associated.pairs.track, frame.elapsed_s)
        people = update_matched(people, associated, frame, self._cues, self._random)
        self._learn(expected.people, associated, frame)
        sought = may_be_occluded(people, expected.shown)
        people = self._update_unmatched(people, expected, associated, frame, sought)
        bodies, around = here_and_a_step_off(people.position, self._view)
        people = self._update_outlines(people, associated, frame, bodies)
        return UpdatedTracks(people, bodies, around)

    def _learn(self, people: Population, associated: AssociatedTracks, frame: JointFrame) -> None:
        """Learn measurement noise and appearance from people matched with nobody close.

        Args:
            people: predicted to this frame.
        """
        pairs, known, difference = associated.pairs, people.confirmed, associated.difference
        clear = associated.isolated & known[pairs.track]
        rows, chosen = pairs.track[clear], pairs.detection[clear]
        others = np.zeros(difference.shape[:2], bool)
        others[:, chosen] = known[:, None]
        others[rows, chosen] = False
        self._appearance = self._appearance.update(difference[rows, chosen], difference[others])
        if frame.embeddings is not None:
            seen = np.ones(len(rows), bool)
            self._known.learn(people.track[rows], frame.embeddings[chosen], seen)
        measured = frame.places[chosen]
        offset, place = measured - people.position[rows], people.motion[rows, 0]
        self._noise = self._noise.update(offset, place, measured, self._settings)

    def _confirm(
        self, updated: UpdatedTracks, associated: AssociatedTracks, frame: JointFrame
    ) -> UpdatedTracks:
        """Tentative tracks seen for long enough get the id of a coasting track, or the next one."""
        people, pairs, settings = updated.people, associated.pairs, self._settings
        enough = round(settings.confirm_s / max(frame.interval_s, _SHORTEST_S))
        enough = max(settings.confirm_matches, enough)
        fresh = people.track[pairs.track] == 0
        fresh &= people.matches[pairs.track] >= enough
        ready, births = pairs.track[fresh], frame.births[pairs.detection[fresh]]
        embedded = np.zeros((len(people), len(ready)))
        if frame.embeddings is not None:
            given = frame.embeddings[pairs.detection[fresh]]
            embedded = self._known.log_likelihood_ratio(people.track, given)
        people = reidentify(people, ready, births, self._appearance, embedded, settings)
        return replace(updated, people=confirm_tracks(people, enough, self._ids))

    def _report(
        self,
        observation: Observation,
        expected: ExpectedPeople,
        updated: UpdatedTracks,
        associated: AssociatedTracks,
        frame: JointFrame,
    ) -> StepResult:
        """The frame's result: who is thought to be where they are predicted."""
        people, box = updated.people, updated.box
        there = is_reported(people, expected.shown, self._settings, frame.interval_s)
        return step_result(observation, people, box, associated, self._view, there)

    def _terminate(self, updated: UpdatedTracks, frame: JointFrame) -> Population:
        """The people whose tracks are kept, reported or coasting."""
        size = self._view.camera.size
        return updated.people.select(should_keep(updated, self._settings, size, frame.interval_s))
