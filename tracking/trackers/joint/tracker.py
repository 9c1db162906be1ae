"""The joint stereo tracker: a particle filter per person, one association for all of them."""

from __future__ import annotations

from collections import deque
from statistics import median

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, resample
from tracking.geometry import View
from tracking.people import Detections, Observation
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
    log_birth_intensity,
    score_pairs,
)
from tracking.trackers.joint.cues import JointCues
from tracking.trackers.joint.edges import here_and_a_step_off
from tracking.trackers.joint.motion import predict
from tracking.trackers.joint.noise import MeasurementNoise
from tracking.trackers.joint.reidentification import reidentify
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.track_management import is_reported, may_be_occluded, should_keep
from tracking.trackers.joint.track_update import update_matched
from tracking.trackers.shared.gating import nearest_others_m
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.stereo.births_and_ends import (
    BirthCandidates,
    confirm_tracks,
    initiate_tracks,
)
from tracking.trackers.stereo.boxes import Bodies, expected_visibility, update_outlines
from tracking.trackers.stereo.cues import Costs
from tracking.trackers.stereo.filter import StereoFilter
from tracking.trackers.stereo.population import Population, concatenate
from tracking.trackers.stereo.result import step_result
from tracking.trackers.stereo.shared_detections import find_shared_regions
from tracking.trackers.stereo.update import (
    Match,
    age_tracks,
    update_missed,
    update_occluded,
)

Floats = NDArray[np.float64]
Colours = NDArray[np.float32]

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
        self._intervals_s: deque[float] = deque(maxlen=_FRAMES_TIMED)

    def _resume_people(self, people: Population) -> Population:
        """The people to go on with: who was corrected and seen is sure to be somebody."""
        known = np.where(people.matches > 1, np.maximum(people.matches, _SURE), people.matches)
        return people.replace(matches=known)

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further."""
        seen, settings, view = observation.people, self._settings, self._view
        colours, appearance = self._cues.measure_colours(seen), measure_appearance(seen)
        before, elapsed_s = self._begin_frame(observation, colours)
        interval_s = self._usual_interval_s(elapsed_s)
        expected = predict(before, settings, elapsed_s, self._random)
        bodies, size = Bodies.at(expected.position, view), view.camera.size
        known = expected.missed_s < settings.report_s
        shown = expected_visibility(expected, bodies.boxes(expected.outline), size, known)
        new = log_birth_intensity(seen, settings, elapsed_s, view)
        difference = appearance_differences(expected, colours, appearance)
        sigma = self._noise.sigma(seen.position[:, :2], settings)
        costs, likelihoods = self._score_pairs(expected, seen, sigma, difference, new, shown)
        pairs, free = associate_people(
            expected, likelihoods, ~seen.merged, settings.association_margin / NAT
        )
        people = age_tracks(expected, pairs.track, elapsed_s)
        since_s = expected.missed_s[pairs.track] + elapsed_s
        shared = find_shared_regions(expected, bodies, pairs, seen, view)
        alone = shared.alone_of(pairs)
        clear = (
            nearest_others_m(expected.position)[pairs.track] >= settings.colour_update_distance_m
        )
        match = Match(pairs, shared, clear, seen, colours, since_s)
        people = update_matched(people, match, appearance, sigma, self._cues, self._random)
        self._learn(expected, match, difference)
        people = update_missed(people, elapsed_s, view, settings, may_be_occluded(people, shown))
        people = update_occluded(people, expected, shared, settings, self._random)
        bodies, around = here_and_a_step_off(people.position, view)
        people = update_outlines(people, pairs, alone, seen, elapsed_s, bodies)
        people = self._cues.update_anchors(people, elapsed_s)
        people = self._confirm(people, pairs, new, interval_s)
        box = bodies.boxes(people.outline)
        there = is_reported(people, shown, settings, interval_s)
        result = step_result(observation, people, box, pairs, alone, costs, view, there)
        stay = should_keep(people, box, around, settings, size, interval_s)
        self._people = self._carry_over(people.select(stay), BirthCandidates(seen, colours, free))
        return result

    def _usual_interval_s(self, elapsed_s: float) -> float:
        """Seconds that one match stands for: since the frame before, unless that is unusual.

        Frames that were not recorded, or two that follow each other at once, do not change for
        how long somebody matched in so many frames has been seen.
        """
        usual_s = median(self._intervals_s or (elapsed_s,))
        if elapsed_s > 0.0:
            self._intervals_s.append(elapsed_s)
        return elapsed_s if usual_s / _FAR_OFF <= elapsed_s <= usual_s * _FAR_OFF else usual_s

    def _score_pairs(
        self,
        people: Population,
        seen: Detections,
        sigma: Floats,
        difference: Floats,
        new: Floats,
        shown: Floats,
    ) -> tuple[Costs, AssociationLikelihoods]:
        """The association likelihoods of all pairs, and the costs to report."""
        measured = seen.position[:, :2]
        appearance = self._settings.appearance_weight * self._appearance.log_likelihood_ratio(
            difference
        )
        appearance *= appearance_trust(people)[:, None]
        turn = self._cues.direction(people, measured)
        detected = detection_probability(people, shown, self._settings)
        likelihoods = score_pairs(people, seen, sigma, new, appearance, turn, detected)
        colour = np.sqrt(difference[..., :3]).sum(axis=2)
        total = NAT * (likelihoods.match - likelihoods.missed[:, None])
        return Costs(
            likelihoods.distance, colour, NAT * turn, total, likelihoods.allowed
        ), likelihoods

    def _learn(self, people: Population, match: Match, difference: Floats) -> None:
        """Learn measurement noise and appearance from people matched with nobody close.

        Args:
            people: predicted to this frame.
        """
        pairs, known = match.pairs, people.confirmed
        clear = match.isolated & known[pairs.track]
        rows, chosen = pairs.track[clear], pairs.detection[clear]
        others = np.zeros(difference.shape[:2], bool)
        others[:, chosen] = known[:, None]
        others[rows, chosen] = False
        self._appearance = self._appearance.update(difference[rows, chosen], difference[others])
        measured = match.seen.position[chosen, :2]
        offset, place = measured - people.position[rows], people.motion[rows, 0]
        self._noise = self._noise.update(offset, place, measured, self._settings)

    def _confirm(
        self, people: Population, pairs: Association, new: Floats, interval_s: float
    ) -> Population:
        """Tentative tracks seen for long enough get the id of a coasting track, or the next one."""
        settings = self._settings
        enough = round(settings.confirm_s / max(interval_s, _SHORTEST_S))
        enough = max(settings.confirm_matches, enough)
        fresh = people.track[pairs.track] == 0
        fresh &= people.matches[pairs.track] >= enough
        ready, begun = pairs.track[fresh], new[pairs.detection[fresh]]
        people = reidentify(people, ready, begun, self._appearance, settings)
        people, self._last_id = confirm_tracks(people, enough, self._last_id)
        return people

    def _carry_over(self, people: Population, spots: BirthCandidates) -> Population:
        """Who goes into the next frame: the tracks kept, resampled, and tentative ones."""
        particles = resample(people.particles, people.weight, self._random)
        people = people.replace(particles=particles)
        if len(spots.free) == 0:
            return people
        new = initiate_tracks(people, spots, self._settings, self._random, self._view)
        return concatenate((people, new))
