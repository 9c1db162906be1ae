"""The joint stereo tracker: a particle filter a person, one explanation for everybody."""

from __future__ import annotations

from collections import deque
from statistics import median

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, resample
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.births_and_ends import Newcomers, confirmed, newcomers
from tracking.trackers.joint.appearance import Telling, differences, looks_of, trust
from tracking.trackers.joint.association import NAT, explained
from tracking.trackers.joint.cues import JointCues
from tracking.trackers.joint.edges import here_and_a_step_off
from tracking.trackers.joint.evidence import Evidence, arrivals, evidence_of, found_share
from tracking.trackers.joint.motion import predicted
from tracking.trackers.joint.noise import Noise
from tracking.trackers.joint.reidentification import found_again
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.track_management import hiding, staying, told
from tracking.trackers.joint.track_update import matched
from tracking.trackers.population import Population, joined
from tracking.trackers.protocol import StepResult
from tracking.trackers.stereo_boxes import Bodies, expected_visibility, outlined
from tracking.trackers.stereo_cues import Costs
from tracking.trackers.stereo_filter import StereoFilter
from tracking.trackers.stereo_result import step_result
from tracking.trackers.stereo_sharing import shared_regions
from tracking.trackers.stereo_update import Match, aged, apart, guests_kept, unseen

Floats = NDArray[np.float64]
Colours = NDArray[np.float32]

_SURE = 20
"""Matches that somebody counts as who was corrected by people and is in view."""
_SHORTEST_S = 1e-3
"""Between two frames."""
_FRAMES_TIMED = 9
"""The last frames of which the usual time between two is told."""
_FAR_OFF = 2.0
"""A time so many times as long or short as the usual one says nothing of the others."""


class JointTracker(StereoFilter[JointSettings, JointCues]):
    """Follows people by the likeliest explanation of each frame for everybody at once.

    The five steps of [Kawashita2012] and [Kawashita2014] with their cues, where we differ:
        - costs are log-likelihood ratios, in one assignment of people and detections in which
          somebody may be missed, cheaply where others hide them, and a detection may be of
          somebody new, dearly within the picture;
        - particles spread as a Kalman filter's covariance grows, so that somebody is sought the
          wider the longer they are missed;
        - how far off places are, and how much colours, clothes and height tell people apart, is
          learnt from the footage (see `Noise` and `Telling`);
        - who should be seen and is not is remembered without being told of, and found again by
          walk and looks; nobody is remembered for much longer than they were seen;
        - who was last seen at the picture's edge soon ends.
    """

    def __init__(self, view: View, settings: JointSettings, seed: int) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        super().__init__(view, settings, JointCues(settings), seed)
        self._telling = Telling.usual()
        self._noise = Noise.usual(settings)
        self._intervals_s: deque[float] = deque(maxlen=_FRAMES_TIMED)

    def _gone_on(self, people: Population) -> Population:
        """The people to go on with: who was corrected and seen is sure to be somebody."""
        known = np.where(people.matches > 1, np.maximum(people.matches, _SURE), people.matches)
        return people.replace(matches=known)

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further."""
        seen, settings, view = observation.people, self._settings, self._view
        colours, looks = self._cues.seen(seen), looks_of(seen)
        before, elapsed_s = self._begun(observation, colours)
        interval_s = self._usual_interval_s(elapsed_s)
        expected = predicted(before, settings, elapsed_s, self._random)
        bodies, size = Bodies.at(expected.position, view), view.camera.size
        known = expected.missed_s < settings.lost_after_s
        shown = expected_visibility(expected, bodies.boxes(expected.outline), size, known)
        new = arrivals(seen, settings, elapsed_s, view)
        difference = differences(expected, colours, looks)
        sigma = self._noise.sigma(seen.position[:, :2], settings)
        costs, evidence = self._judged(expected, seen, sigma, difference, new, shown)
        pairs, free = explained(expected, evidence, ~seen.merged, settings.least_margin / NAT)
        people = aged(expected, pairs.track, elapsed_s)
        since_s = expected.missed_s[pairs.track] + elapsed_s
        shared = shared_regions(expected, bodies, pairs, seen, view)
        alone = shared.alone_of(pairs)
        clear = apart(expected, pairs.track, settings.colour_distance_m)
        match = Match(pairs, shared, clear, seen, colours, since_s)
        people = matched(people, match, looks, sigma, self._cues, self._random)
        self._learn(expected, match, difference)
        people = unseen(people, elapsed_s, view, settings, hiding(people, shown))
        people = guests_kept(people, expected, shared, settings, self._random)
        bodies, around = here_and_a_step_off(people.position, view)
        people = outlined(people, pairs, alone, seen, elapsed_s, bodies)
        people = self._cues.walked(people, elapsed_s)
        people = self._named(people, pairs, new, interval_s)
        box = bodies.boxes(people.outline)
        there = told(people, shown, settings, interval_s)
        result = step_result(observation, people, box, pairs, alone, costs, view, there)
        stay = staying(people, box, around, settings, size, interval_s)
        self._people = self._carried(people.select(stay), Newcomers(seen, colours, free))
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

    def _judged(
        self,
        people: Population,
        seen: Detections,
        sigma: Floats,
        difference: Floats,
        new: Floats,
        shown: Floats,
    ) -> tuple[Costs, Evidence]:
        """The evidence of all pairs, and as costs to tell of."""
        measured = seen.position[:, :2]
        likeness = self._settings.looks_weight * self._telling.likeness(difference)
        likeness *= trust(people)[:, None]
        turn = self._cues.direction(people, measured)
        found = found_share(people, shown, self._settings)
        evidence = evidence_of(people, seen, sigma, new, likeness, turn, found)
        colour = np.sqrt(difference[..., :3]).sum(axis=2)
        total = NAT * (evidence.match - evidence.missed[:, None])
        return Costs(evidence.distance, colour, NAT * turn, total, evidence.allowed), evidence

    def _learn(self, people: Population, match: Match, difference: Floats) -> None:
        """How far off places are and what looks tell, from those matched with nobody close.

        Args:
            people: predicted to this frame.
        """
        pairs, known = match.pairs, people.confirmed
        clear = match.apart & known[pairs.track]
        rows, chosen = pairs.track[clear], pairs.detection[clear]
        others = np.zeros(difference.shape[:2], bool)
        others[:, chosen] = known[:, None]
        others[rows, chosen] = False
        self._telling = self._telling.learnt(difference[rows, chosen], difference[others])
        measured = match.seen.position[chosen, :2]
        offset, place = measured - people.position[rows], people.motion[rows, 0]
        self._noise = self._noise.learnt(offset, place, measured, self._settings)

    def _named(
        self, people: Population, pairs: Association, new: Floats, interval_s: float
    ) -> Population:
        """Newcomers seen for long enough have the id of somebody lost, or the next one."""
        settings = self._settings
        enough = round(settings.confirm_s / max(interval_s, _SHORTEST_S))
        enough = max(settings.confirm_matches, enough)
        fresh = people.track[pairs.track] == 0
        fresh &= people.matches[pairs.track] >= enough
        ready, begun = pairs.track[fresh], new[pairs.detection[fresh]]
        people = found_again(people, ready, begun, self._telling, settings)
        people, self._last_id = confirmed(people, enough, self._last_id)
        return people

    def _carried(self, people: Population, spots: Newcomers) -> Population:
        """Who goes into the next frame: those who stay, resampled, and newcomers."""
        particles = resample(people.particles, people.weight, self._random)
        people = people.replace(particles=particles)
        if len(spots.free) == 0:
            return people
        new = newcomers(people, spots, self._settings, self._random, self._view)
        return joined((people, new))
