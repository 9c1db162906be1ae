"""The joint stereo tracker: a particle filter a person, one explanation for everybody."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, move, resample
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.births_and_ends import Newcomers, confirmed, newcomers
from tracking.trackers.joint.cues import JointCues
from tracking.trackers.joint.evidence import Evidence, arrivals, evidence_of, found_share
from tracking.trackers.joint.explaining import NAT, explained
from tracking.trackers.joint.finding import found_again
from tracking.trackers.joint.looks import Telling, differences, looks_of
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.staying import staying, told
from tracking.trackers.population import Population, joined, nobody
from tracking.trackers.protocol import StepResult
from tracking.trackers.resuming import Resume
from tracking.trackers.stereo_boxes import expected_visibility, outlined
from tracking.trackers.stereo_cues import Costs, likelihood_sigma
from tracking.trackers.stereo_result import step_result
from tracking.trackers.stereo_resuming import resumed
from tracking.trackers.stereo_sharing import shared_regions
from tracking.trackers.stereo_update import Match, aged, apart, guests_kept, matched, unseen

Floats = NDArray[np.float64]
Colours = NDArray[np.float32]


class JointTracker:
    """Follows people by the likeliest explanation of each frame for everybody at once."""

    def __init__(self, view: View, settings: JointSettings, seed: int) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        self._view = view
        self._settings = settings
        self._cues = JointCues(settings)
        self._random = np.random.default_rng(seed)
        self._people: Population | None = None
        self._telling = Telling.usual()
        self._last_id = 0
        self._time_s = 0.0

    @property
    def settings(self) -> JointSettings:
        """The settings in force."""
        return self._settings

    @property
    def notes(self) -> tuple[str, ...]:
        """Nothing is to be told."""
        return ()

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Go on with the people as corrected; those who are new get ids above all there were."""
        self._people, self._time_s = resumed(
            resume, observations, self._view, self._settings, self._cues, self._random
        )
        self._last_id = resume.highest_track

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further."""
        seen, settings, view = observation.people, self._settings, self._view
        colours, looks = self._cues.seen(seen), looks_of(seen)
        if self._people is None:
            self._people = nobody(settings.particles, *colours.shape[1:])
            self._time_s = observation.time_s
        elapsed_s = observation.time_s - self._time_s
        self._time_s = observation.time_s
        expected = self._predicted(self._people, elapsed_s)
        shown = expected_visibility(expected, view, expected.missed_s < settings.lost_after_s)
        new = arrivals(seen, settings, elapsed_s, view)
        difference = differences(expected, colours, looks)
        costs, evidence = self._judged(expected, seen, difference, new, shown)
        pairs, free = explained(expected, evidence, ~seen.merged, settings.least_margin / NAT)
        people = aged(expected, pairs.track, elapsed_s)
        since_s = expected.missed_s[pairs.track] + elapsed_s
        shared = shared_regions(expected, pairs, seen, view)
        alone = ~np.isin(np.arange(len(pairs.track)), shared.owner)
        match = Match(pairs, shared, seen, colours, since_s)
        people = matched(people, match, self._cues, settings, self._random)
        people = self._looked_at(people, expected, pairs, looks, difference)
        people = unseen(people, elapsed_s, view, settings)
        people = guests_kept(people, expected, shared, settings, self._random)
        people = outlined(people, pairs, alone, seen, elapsed_s, view)
        people = self._cues.walked(people, elapsed_s)
        people = self._named(people, pairs, new)
        result = step_result(
            observation, people, pairs, alone, costs, view, told(people, shown, settings, elapsed_s)
        )
        self._people = self._carried(people, Newcomers(seen, colours, free), elapsed_s)
        return result

    def _predicted(self, people: Population, elapsed_s: float) -> Population:
        """Everybody moved at their velocity; those missed slow down, and spread more and more."""
        settings = self._settings
        spread = settings.spread_m * np.sqrt(elapsed_s)
        spreads = spread * (1.0 + settings.spread_growth * people.missed_s)
        slower = np.where(people.missed_s > 0.0, np.exp(-elapsed_s / settings.slowing_s), 1.0)
        velocity = people.velocity * slower[:, None]
        step = velocity * elapsed_s
        return people.replace(
            particles=move(people.particles, step, spreads, self._random),
            position=people.position + step,
            velocity=velocity,
        )

    def _judged(
        self, people: Population, seen: Detections, difference: Floats, new: Floats, shown: Floats
    ) -> tuple[Costs, Evidence]:
        """The evidence of all pairs, and as costs to tell of."""
        measured = seen.position[:, :2]
        likeness = self._settings.looks_weight * self._telling.likeness(difference)
        turn = self._cues.direction(people, measured)
        found = found_share(people, shown, self._settings)
        sigma = likelihood_sigma(measured, self._settings)
        evidence = evidence_of(people, seen, sigma, new, likeness, turn, found)
        colour = np.sqrt(difference[..., :3]).sum(axis=2)
        total = NAT * (evidence.match - evidence.missed[:, None])
        return Costs(evidence.distance, colour, NAT * turn, total, evidence.allowed), evidence

    def _looked_at(
        self,
        people: Population,
        expected: Population,
        pairs: Association,
        looks: NDArray[np.float32],
        difference: Floats,
    ) -> Population:
        """The looks of those matched brought up to date, and what looks tell learnt from them."""
        rows, chosen = pairs.track, pairs.detection
        clear = apart(people, rows, self._settings.colour_distance_m)
        rows, chosen = rows[clear], chosen[clear]
        known = expected.confirmed[rows]
        others = np.broadcast_to(expected.confirmed[:, None], difference.shape[:2]).copy()
        others[pairs.track, pairs.detection] = False
        unclear = np.ones(difference.shape[1], bool)
        unclear[chosen] = False
        others[:, unclear] = False
        self._telling = self._telling.learnt(difference[rows, chosen][known], difference[others])
        old, new = people.looks[rows], looks[chosen]
        share = np.maximum(1.0 / people.matches[rows], 1.0 - self._settings.colour_memory)
        mean = old + share.astype(np.float32)[:, None] * (new - old)
        mean = np.where(np.isfinite(old), np.where(np.isfinite(new), mean, old), new)
        return people.changed(rows, looks=mean)

    def _named(self, people: Population, pairs: Association, new: Floats) -> Population:
        """Newcomers seen often enough have the id of somebody lost, or the next one."""
        settings = self._settings
        fresh = people.track[pairs.track] == 0
        fresh &= people.matches[pairs.track] >= settings.confirm_matches
        ready, begun = pairs.track[fresh], new[pairs.detection[fresh]]
        people = found_again(people, ready, begun, self._telling, settings)
        people, self._last_id = confirmed(people, settings.confirm_matches, self._last_id)
        return people

    def _carried(self, people: Population, spots: Newcomers, elapsed_s: float) -> Population:
        """Who goes into the next frame: resampled, those gone left behind, newcomers joined."""
        people = people.select(staying(people, self._settings, self._view, elapsed_s))
        particles = resample(people.particles, people.weight, self._random)
        people = people.replace(particles=particles)
        new = newcomers(people, spots, self._settings, self._random, self._view)
        return joined((people, new))
