"""The particle filter over people that both stereo trackers are."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.errors import CalibrationError
from tracking.filtering import Association, resample
from tracking.geometry import View
from tracking.people import Detections, Observation, StereoPerception
from tracking.recording import Recording
from tracking.trackers.shared.gating import nearest_others_m
from tracking.trackers.shared.protocol import StepResult
from tracking.trackers.stereo.assignment import match_people
from tracking.trackers.stereo.births_and_ends import (
    BirthCandidates,
    confirm_tracks,
    initiate_tracks,
    should_keep,
)
from tracking.trackers.stereo.boxes import Bodies, expected_visibility, update_outlines
from tracking.trackers.stereo.cues import Cues, costs_of
from tracking.trackers.stereo.filter import StereoFilter, predict
from tracking.trackers.stereo.population import Population, concatenate
from tracking.trackers.stereo.result import step_result
from tracking.trackers.stereo.settings import StereoFilterSettings, StereoTrackerSettings
from tracking.trackers.stereo.shared_detections import find_shared_regions
from tracking.trackers.stereo.update import (
    Match,
    age_tracks,
    update_matched,
    update_missed,
    update_occluded,
)

Colours = NDArray[np.float32]
Floats = NDArray[np.float64]


def perception_and_view(
    recording: Recording, settings: StereoFilterSettings
) -> tuple[StereoPerception, View]:
    """Stereo perception at its start, and the camera that people are seen by.

    Raises `CalibrationError`: the recording has not what metres on the floor need.
    """
    rectification, ground, view = recording.rectification, recording.ground, recording.view
    if rectification is None or ground is None or view is None:
        raise CalibrationError(
            "recording {name}: stereo trackers need two calibrated cameras and the floor; add "
            "[calibration] and [ground] to recording.toml",
            name=recording.name,
        )
    perception = StereoPerception(
        rectification,
        ground,
        recording.fps,
        foreground=settings.foreground,
        stereo=settings.stereo,
        people=settings.people,
    )
    return perception, view


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
        """Take one frame further."""
        seen = observation.people
        colours = self._cues.measure_colours(seen)
        before, elapsed_s = self._begin_frame(observation, colours)
        measured = seen.position[:, :2]
        way = before.velocity * elapsed_s
        expected = predict(before, way, self._settings, elapsed_s, self._random)
        bodies, size = Bodies.at(expected.position, self._view), self._view.camera.size
        shown = expected_visibility(expected, bodies.boxes(expected.outline), size)
        costs = costs_of(expected, measured, colours, self._cues, self._settings, shown)
        pairs = match_people(expected, costs, ~seen.merged, self._settings)
        people = age_tracks(expected, pairs.track, elapsed_s)
        since_s = expected.missed_s[pairs.track] + elapsed_s
        shared = find_shared_regions(expected, bodies, pairs, seen, self._view)
        alone = shared.alone_of(pairs)
        clear = (
            nearest_others_m(expected.position)[pairs.track]
            >= self._settings.colour_update_distance_m
        )
        match = Match(pairs, shared, clear, seen, colours, since_s)
        people = update_matched(people, match, self._cues, self._settings, self._random)
        people = update_missed(people, elapsed_s, self._view, self._settings)
        people = update_occluded(people, expected, shared, self._settings, self._random)
        bodies = Bodies.at(people.position, self._view)
        people = update_outlines(people, pairs, alone, seen, elapsed_s, bodies)
        box = bodies.boxes(people.outline)
        people = self._cues.update_anchors(people, elapsed_s)
        people, self._last_id = confirm_tracks(
            people, self._settings.confirm_matches, self._last_id
        )
        result = step_result(observation, people, box, pairs, alone, costs, self._view)
        self._people = self._carry_over(people, box, pairs, seen, colours)
        return result

    def _carry_over(
        self,
        people: Population,
        box: Floats,
        pairs: Association,
        seen: Detections,
        colours: Colours,
    ) -> Population:
        """Who goes into the next frame: resampled, the lost deleted, tentative tracks joined.

        Args:
            box: (people, 4) px of their bodies.
        """
        resampled = resample(people.particles, people.weight, self._random)
        people = people.replace(particles=resampled)
        free = ~seen.merged
        free[pairs.detection] = False
        spots = BirthCandidates(seen, colours, np.flatnonzero(free))
        new = initiate_tracks(people, spots, self._settings, self._random, self._view)
        there = should_keep(people, box, self._settings, self._view.camera.size)
        return concatenate((people.select(there), new))
