"""The papers' own method over stereo observations, without anything added."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, nearest_first, resample, weigh, weighted_mean
from tracking.geometry import View
from tracking.people import Detections, Observation
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.stereo.births_and_ends import (
    BirthCandidates,
    confirm_tracks,
    start_tracks,
)
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.cues import Costs, Cues, cue_values
from tracking.trackers.stereo.filter import StereoFilter, predict
from tracking.trackers.stereo.population import Population, concatenate
from tracking.trackers.stereo.result import step_result
from tracking.trackers.stereo.settings import StereoTrackerSettings
from tracking.trackers.stereo.update import age_tracks

Floats = NDArray[np.float64]
Colours = NDArray[np.float32]


class PaperTracker(StereoFilter[StereoTrackerSettings, Cues]):
    """Follows people as [Kawashita2012] and [Kawashita2014] do, with the `Cues` of either.

    Predict by the last movement, or while somebody is missed by the velocity of the last frames
    they were matched in, with a spread that grows then; each person takes the detection with the
    smallest `D = Dd + Dc + Da`; weigh by the likelihood; resample. Everybody has an id from the
    first sighting, and ends once missed for a set time. Regions of several people are nobody's
    observation ([Kawashita2014] section 3.4).

    What the papers leave open: a detection farther than `gate_m` from where a person is expected
    is not theirs, and one that is the nearest of several people goes to whom it is nearest. Two
    frames of the same time say nothing of movement.
    """

    def __init__(self, view: View, settings: StereoTrackerSettings, cues: Cues, seed: int) -> None:
        """Nobody is followed yet; all randomness comes from the seed."""
        super().__init__(view, settings, cues, seed)
        self._moved = np.zeros((0, 2))

    def _resume_people(self, people: Population) -> Population:
        """The people to go on with; the corrected rows' velocity is their last movement."""
        self._moved = people.velocity
        return people

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further."""
        seen = observation.people
        colours = self._cues.measure_colours(seen)
        before, elapsed_s = self._begin_frame(observation, colours)
        expected = self._predict(before, elapsed_s)
        costs = paper_costs(expected, seen.position[:, :2], colours, self._cues, self._settings)
        allowed = costs.allowed & ~seen.merged
        pairs = nearest_first(costs.total, allowed)
        people, moved = self._update_matched(expected, pairs, seen, colours, elapsed_s)
        people = self._cues.update_anchors(people, elapsed_s)
        free = ~seen.merged
        free[pairs.detection] = False
        spots = BirthCandidates(seen, colours, np.flatnonzero(free))
        new = start_tracks(spots, self._settings, self._random, self._view)
        new, self._last_id = confirm_tracks(new, 1, self._last_id)
        everybody = concatenate((people, new))
        self._people, self._moved = self._carry_over(
            everybody, np.concatenate((moved, new.velocity))
        )
        return _report(observation, everybody, pairs, spots, costs, self._view)

    def _predict(self, people: Population, elapsed_s: float) -> Population:
        """Everybody moved on by the last movement, or while missed by the velocity."""
        missed = people.missed_s[:, None] > 0.0
        step = np.where(missed, people.velocity, self._moved) * elapsed_s
        return predict(people, step, self._settings, elapsed_s, self._random)

    def _update_matched(
        self,
        people: Population,
        pairs: Association,
        seen: Detections,
        colours: Colours,
        elapsed_s: float,
    ) -> tuple[Population, Floats]:
        """Those matched weighed with their detections; the others as predicted.

        Returns the people and the last movement of each, (people, 2) m/s.
        """
        rows, chosen = pairs.track, pairs.detection
        mine, measured = people.select(rows), seen.position[chosen, :2]
        weight = weigh(
            mine.particles, measured, np.full(len(rows), self._settings.measurement_noise_m)
        )
        position = weighted_mean(mine.particles, weight)
        since_s = (mine.missed_s + elapsed_s)[:, None]
        movement = self._moved[rows]
        np.divide(position - mine.seen_at, since_s, out=movement, where=since_s > 0.0)
        kept = np.exp(-elapsed_s / self._settings.velocity_average_s)
        share = np.maximum(1.0 / mine.matches, 1.0 - kept)[:, None]
        moved = self._moved.copy()
        moved[rows] = movement
        return age_tracks(people, rows, elapsed_s).with_rows(
            rows,
            weight=weight,
            position=position,
            velocity=mine.velocity + share * (movement - mine.velocity),
            matches=mine.matches + 1,
            seen_at=position,
            colour=self._cues.update_colours(mine.colour, colours[chosen], mine.matches),
            outline=Bodies.at(position, self._view).outlines(seen.box[chosen]),
        ), moved

    def _carry_over(self, people: Population, moved: Floats) -> tuple[Population, Floats]:
        """Who goes into the next frame, resampled; those missed for too long have ended."""
        there = people.missed_s <= self._settings.delete_after_s
        kept = people.select(there)
        particles = resample(kept.particles, kept.weight, self._random)
        return kept.replace(particles=particles), moved[there]


def paper_costs(
    people: Population,
    measured: Floats,
    colours: Colours,
    cues: Cues,
    settings: StereoTrackerSettings,
) -> Costs:
    """`D = Dd + Dc + Da`, the distance in metres; Dc by `colour_weight`, which is 1 in the papers.

    Dc counts once somebody's colour model is complete, Da once there are directions.

    Args:
        people: predicted to this frame. measured: (detections, 2) m.
        colours: (detections, cues, bins).
    """
    distance, colour, direction = cue_values(people, measured, colours, cues)
    colour[~cues.is_complete(people.matches)] = np.nan
    cues_cost = settings.colour_weight * np.nan_to_num(colour) + np.nan_to_num(direction)
    total = distance + cues_cost
    return Costs(distance, colour, direction, total, distance <= settings.gate_m)


def _report(
    observation: Observation,
    people: Population,
    pairs: Association,
    spots: BirthCandidates,
    costs: Costs,
    view: View,
) -> StepResult:
    """The frame's result; the last of the people are new, at the free detections."""
    box = Bodies.at(people.position, view).boxes(people.outline)
    alone = np.ones(len(pairs.track), bool)
    result = step_result(observation, people, box, pairs, alone, costs, view)
    track = result.detections["track"].copy()
    track[spots.free] = people.track[len(people) - len(spots.free) :]
    return replace(result, detections={**result.detections, "track": track})
