"""The papers' own method over stereo observations, without anything added."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import nearest_first, weigh, weighted_mean
from tracking.geometry import View
from tracking.people import Observation
from tracking.trackers.shared.gating import GatedPairs, gate_pairs
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.stereo.boxes import Bodies
from tracking.trackers.stereo.cues import Costs, Cues, cue_values
from tracking.trackers.stereo.filter import StereoFilter
from tracking.trackers.stereo.initiation import confirm_tracks, start_tracks
from tracking.trackers.stereo.motion import predict
from tracking.trackers.stereo.population import Population, concatenate
from tracking.trackers.stereo.result import step_result
from tracking.trackers.stereo.settings import StereoTrackerSettings
from tracking.trackers.stereo.shared_detections import NONE_SHARED
from tracking.trackers.stereo.stage_values import AssociatedPeople, MeasuredFrame
from tracking.trackers.stereo.update import age_tracks

Floats = NDArray[np.float64]


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
        """Take one frame further: predict, gate, associate, update, initiate, terminate."""
        frame = self._measure(observation)
        expected = self._predict(frame)
        gated = gate_pairs(expected.position, frame.places, self._settings.gate_m)
        associated = self._associate(expected, gated, frame)
        people, moved = self._update(expected, associated, frame)
        free = frame.free(associated.pairs)
        people = self._initiate(people, free, frame)
        moved = np.concatenate((moved, people.velocity[len(moved) :]))
        self._people, self._moved = self._terminate(people, moved)
        return _report(observation, people, associated, free, self._view)

    def _predict(self, frame: MeasuredFrame) -> Population:
        """Everybody moved on by the last movement, or while missed by the velocity."""
        people = self._followed(frame)
        missed = people.missed_s[:, None] > 0.0
        step = np.where(missed, people.velocity, self._moved) * frame.elapsed_s
        return predict(people, step, self._settings, frame.elapsed_s, self._random)

    def _associate(
        self, people: Population, gated: GatedPairs, frame: MeasuredFrame
    ) -> AssociatedPeople:
        """Each person with the detection that costs least."""
        costs = paper_costs(people, gated, frame, self._cues, self._settings)
        pairs = nearest_first(costs.total, gated.allowed & frame.usable)
        since_s = people.missed_s[pairs.track] + frame.elapsed_s
        everybody = np.ones(len(pairs.track), bool)
        return AssociatedPeople(pairs, costs, NONE_SHARED, everybody, since_s)

    def _update(
        self, people: Population, associated: AssociatedPeople, frame: MeasuredFrame
    ) -> tuple[Population, Floats]:
        """Those matched weighed with their detections; the others as predicted.

        Returns the people and the last movement of each, (people, 2) m/s.
        """
        rows, chosen = associated.pairs.track, associated.pairs.detection
        mine, settings = people.select(rows), self._settings
        sigma = np.full(len(rows), settings.measurement_noise_m)
        weight = weigh(mine.particles, frame.places[chosen], sigma)
        position = weighted_mean(mine.particles, weight)
        since_s = associated.since_s[:, None]
        movement = self._moved[rows]
        np.divide(position - mine.seen_at, since_s, out=movement, where=since_s > 0.0)
        kept = np.exp(-frame.elapsed_s / settings.velocity_average_s)
        share = np.maximum(1.0 / mine.matches, 1.0 - kept)[:, None]
        moved = self._moved.copy()
        moved[rows] = movement
        people = age_tracks(people, rows, frame.elapsed_s).with_rows(
            rows,
            weight=weight,
            position=position,
            velocity=mine.velocity + share * (movement - mine.velocity),
            matches=mine.matches + 1,
            seen_at=position,
            colour=self._cues.update_colours(mine.colour, frame.colours[chosen], mine.matches),
            outline=Bodies.at(position, self._view).outlines(frame.seen.box[chosen]),
        )
        return self._cues.update_anchors(people, frame.elapsed_s), moved

    def _initiate(
        self, people: Population, free: NDArray[np.intp], frame: MeasuredFrame
    ) -> Population:
        """The people with one at each free detection, who has an id from the first sighting on."""
        new = start_tracks(frame, free, self._settings, self._random, self._view)
        return concatenate((people, confirm_tracks(new, 1, self._ids)))

    def _terminate(self, people: Population, moved: Floats) -> tuple[Population, Floats]:
        """Who goes into the next frame, resampled; those missed for too long have ended."""
        there = people.missed_s <= self._settings.delete_after_s
        return self._resample(people.select(there)), moved[there]


def paper_costs(
    people: Population,
    gated: GatedPairs,
    frame: MeasuredFrame,
    cues: Cues,
    settings: StereoTrackerSettings,
) -> Costs:
    """`D = Dd + Dc + Da`, the distance in metres; Dc by `colour_weight`, which is 1 in the papers.

    Dc counts once somebody's colour model is complete, Da once there are directions.

    Args:
        people: predicted to this frame. gated: all pairs.
    """
    colour, direction = cue_values(people, frame.places, frame.colours, cues)
    colour[~cues.is_complete(people.matches)] = np.nan
    cues_cost = settings.colour_weight * np.nan_to_num(colour) + np.nan_to_num(direction)
    total = gated.distance + cues_cost
    return Costs(gated.distance, colour, direction, total, gated.allowed)


def _report(
    observation: Observation,
    people: Population,
    associated: AssociatedPeople,
    free: NDArray[np.intp],
    view: View,
) -> StepResult:
    """The frame's result; the last of the people are new, at the free detections."""
    box = Bodies.at(people.position, view).boxes(people.outline)
    result = step_result(observation, people, box, associated, view)
    track = result.detections["track"].copy()
    track[free] = people.track[len(people) - len(free) :]
    return replace(result, detections={**result.detections, "track": track})
