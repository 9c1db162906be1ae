"""The papers' own method beside a plain one with loops over people and particles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
import pytest
from people_on_a_floor import FPS, Errors, Walker, observations, straight, view

from tracking.filtering import nearest_first
from tracking.trackers import Observation, StepResult
from tracking.trackers.stereo.colour import HalvesOfFirstFrames, StereoColourSettings
from tracking.trackers.stereo.direction import MiddleUpdated, StereoDirectionSettings
from tracking.trackers.stereo.paper import PaperTracker

SETTINGS = {"particles": 60, "paper": True}
COLOUR = StereoColourSettings(**SETTINGS)
DIRECTION = StereoDirectionSettings(**SETTINGS)


@dataclass
class Person:
    """One person of the plain method, as lists of numbers."""

    track: int
    particles: list[list[float]]
    place: list[float]
    colours: list[np.ndarray]
    ways: list[list[float]]
    velocity: list[float] = field(default_factory=lambda: [0.0, 0.0])
    movement: list[float] = field(default_factory=lambda: [0.0, 0.0])
    seen: list[float] = field(default_factory=list)
    matches: int = 1
    missed_s: float = 0.0
    way_age_s: float = 0.0


class PlainMethod:
    """What the papers say, word for word, one person and one particle after the other."""

    def __init__(self, settings: StereoColourSettings | StereoDirectionSettings, seed: int) -> None:
        self.settings = settings
        self.directed = isinstance(settings, StereoDirectionSettings)
        self.random = np.random.default_rng(seed)
        self.people: list[Person] = []
        self.last_id = 0

    def step(self, seen: Observation) -> list[Person]:
        elapsed_s = 0.0 if seen.frame == 0 else 1 / FPS
        self.predict(elapsed_s)
        places = [list(place[:2]) for place in seen.people.position]
        pairs = self.pairs(places, seen)
        weights = self.weigh(pairs, places, seen, elapsed_s)
        started = [k for k in range(len(places)) if k not in pairs and not seen.people.merged[k]]
        new = self.start(started, places, seen)
        reported = self.people + new
        weights += [[1 / self.settings.particles] * self.settings.particles] * len(new)
        kept = [n for n, p in enumerate(reported) if p.missed_s <= self.settings.delete_after_s]
        offsets = self.random.random((len(kept), 1))
        for offset, n in zip(offsets[:, 0], kept, strict=True):
            reported[n].particles = drawn(reported[n].particles, weights[n], offset)
        self.people = [reported[n] for n in kept]
        return reported

    def predict(self, elapsed_s: float) -> None:
        settings = self.settings
        noise = self.random.standard_normal(
            (len(self.people), settings.particles, 2), dtype=np.float32
        )
        for person, own in zip(self.people, noise.tolist(), strict=True):
            spread = settings.process_noise_m * math.sqrt(elapsed_s)
            spread *= 1 + settings.process_noise_growth * person.missed_s
            moving = person.velocity if person.missed_s > 0 else person.movement
            for particle, jitter in zip(person.particles, own, strict=True):
                for axis in (0, 1):
                    particle[axis] += moving[axis] * elapsed_s + spread * jitter[axis]
            person.place = [person.place[axis] + moving[axis] * elapsed_s for axis in (0, 1)]

    def colours(self, seen: Observation, k: int) -> list[np.ndarray]:
        people = seen.people
        return [people.middle[k]] if self.directed else [people.upper[k], people.lower[k]]

    def cost(self, person: Person, place: list[float], seen: Observation, k: int) -> float:
        """`D = Dd + Dc + Da`."""
        total = math.dist(person.place, place)
        if total > self.settings.gate_m:
            return math.inf
        known = self.directed or person.matches >= self.settings.model_frames
        colours = self.colours(seen, k) if known else []
        for model, own in zip(person.colours, colours, strict=known):
            rho = sum(math.sqrt(float(p) * float(q)) for p, q in zip(model, own, strict=True))
            total += self.settings.colour_weight * math.sqrt(max(0.0, 1 - rho))
        return total + (self.turn(person, place) if self.directed else 0.0)

    def turn(self, person: Person, place: list[float]) -> float:
        settings = self.settings
        if len(person.ways) < 2 or person.way_age_s > settings.direction_timeout_s:
            return 0.0
        older, newer = person.ways[-2:]
        base = older if math.dist(newer, place) < settings.direction_step_m else newer
        walked = math.atan2(newer[1] - older[1], newer[0] - older[0])
        going = math.atan2(place[1] - base[1], place[0] - base[0])
        angle = abs(math.remainder(going - walked, 2 * math.pi))
        return settings.direction_weight * min(angle / settings.direction_threshold_rad, 1.0)

    def pairs(self, places: Sequence[list[float]], seen: Observation) -> dict[int, int]:
        """Detection to person: each takes the nearest, who has the smallest `D` of all first."""
        alone = [k for k in range(len(places)) if not seen.people.merged[k]]
        choices = sorted(
            (self.cost(person, places[k], seen, k), n, k)
            for n, person in enumerate(self.people)
            for k in alone
        )
        pairs: dict[int, int] = {}
        for total, n, k in choices:
            if total < math.inf and k not in pairs and n not in pairs.values():
                pairs[k] = n
        return pairs

    def weigh(
        self, pairs: dict[int, int], places: list[list[float]], seen: Observation, elapsed_s: float
    ) -> list[list[float]]:
        count = self.settings.particles
        weights = [[1 / count] * count for _ in self.people]
        for person in self.people:
            person.missed_s += elapsed_s
            person.way_age_s += elapsed_s
        for k, n in pairs.items():
            person, sigma = self.people[n], self.settings.measurement_noise_m
            likely = [
                math.exp(-(math.dist(each, places[k]) ** 2) / (2 * sigma**2))
                for each in person.particles
            ]
            weights[n] = [each / sum(likely) for each in likely]
            self.learn(person, weights[n], seen, k)
        return weights

    def learn(self, person: Person, weight: list[float], seen: Observation, k: int) -> None:
        settings = self.settings
        together = list(zip(weight, person.particles, strict=True))
        person.place = [sum(w * p[axis] for w, p in together) for axis in (0, 1)]
        person.movement = [(person.place[a] - person.seen[a]) / person.missed_s for a in (0, 1)]
        share = max(1 / person.matches, 1 - math.exp(-1 / FPS / settings.velocity_average_s))
        for axis in (0, 1):
            change = person.movement[axis] - person.velocity[axis]
            person.velocity[axis] += share * change
        fresh = 1 / (person.matches + 1)
        if self.directed:
            fresh = max(fresh, 1 - settings.colour_forgetting_factor)
        elif person.matches >= settings.model_frames:
            fresh = 0.0
        for cue, own in enumerate(self.colours(seen, k)):
            person.colours[cue] = person.colours[cue] + fresh * (own - person.colours[cue])
        person.matches, person.missed_s, person.seen = person.matches + 1, 0.0, person.place
        if self.directed and math.dist(person.ways[-1], person.place) >= settings.direction_step_m:
            person.ways.append(person.place)
            person.way_age_s = 0.0

    def start(self, which: list[int], places: list[list[float]], seen: Observation) -> list[Person]:
        settings, new = self.settings, []
        shape = (len(which), settings.particles, 2)
        noise = self.random.standard_normal(shape, dtype=np.float32).tolist()
        for k, own in zip(which, noise, strict=True):
            self.last_id += 1
            x, y = places[k]
            around = [
                [x + settings.initial_spread_m * a, y + settings.initial_spread_m * b]
                for a, b in own
            ]
            person = Person(self.last_id, around, [x, y], self.colours(seen, k), [[x, y]])
            person.seen = [x, y]
            new.append(person)
        return new


def drawn(particles: list[list[float]], weight: list[float], offset: float) -> list[list[float]]:
    """One particle a step of 1 / N through the running sum of the weights."""
    chosen, running, count = [], 0.0, len(particles)
    for particle, own in zip(particles, weight, strict=True):
        running += own * count / sum(weight)
        while len(chosen) + offset < running - 1e-9 and len(chosen) < count:
            chosen.append(list(particle))
    while len(chosen) < count:
        chosen.append(list(particles[-1]))
    return chosen


def crossing() -> list[Walker]:
    """Three people; two cross, one is not seen for a while and one goes for good."""
    hidden = straight((-1.5, 6.5), (0.8, -0.2), 70)
    hidden[25:33] = np.nan
    gone = straight((1.5, 7.5), (-0.9, -0.3), 70)
    gone[35:] = np.nan
    return [Walker(straight((1.2, 5.2), (-0.8, 0.1), 70), 2), Walker(hidden, 5), Walker(gone, 9)]


def reported(
    settings: StereoColourSettings | StereoDirectionSettings, seed: int
) -> list[StepResult]:
    directed = isinstance(settings, StereoDirectionSettings)
    cues = MiddleUpdated(settings) if directed else HalvesOfFirstFrames(settings)
    tracker = PaperTracker(view(), settings, cues, seed)
    return [tracker.step(each) for each in observations(crossing(), 3, MISTAKES)]


MISTAKES = Errors(noise_m=0.04, merged_below_m=0.4)


@pytest.mark.parametrize("settings", [COLOUR, DIRECTION], ids=["colour", "direction"])
def test_the_batched_steps_are_those_of_the_plain_method(settings):
    plain = PlainMethod(settings, 1)
    for result, seen in zip(
        reported(settings, 1), observations(crossing(), 3, MISTAKES), strict=True
    ):
        expected = plain.step(seen)
        assert result.tracks["track"].tolist() == [person.track for person in expected]
        places = np.array([person.place for person in expected]).reshape(-1, 2)
        own = np.column_stack((result.tracks["x"], result.tracks["y"]))
        np.testing.assert_allclose(own, places, atol=2e-3)


def test_whom_a_detection_costs_least_has_it_though_the_total_be_larger():
    cost = np.array([[0.03, 0.7], [0.56, 1.29]])
    nearest = nearest_first(cost, np.ones((2, 2), bool))
    assert list(zip(nearest.track, nearest.detection, strict=True)) == [(0, 0), (1, 1)]
    np.testing.assert_allclose(nearest.margin, [0.0, 0.0])
    gated = nearest_first(cost, cost < 0.6)
    assert list(zip(gated.track, gated.detection, strict=True)) == [(0, 0)]
    np.testing.assert_allclose(gated.margin, [0.53])
    for shape in ((0, 0), (0, 2), (2, 0)):
        assert len(nearest_first(np.zeros(shape), np.ones(shape, bool)).track) == 0


def test_colours_count_once_the_model_is_made_of_the_first_frames():
    results = reported(replace(COLOUR, model_frames=5), 0)
    colour = [np.isfinite(result.associations["colour"]) for result in results[:8]]
    assert [bool(each.any()) for each in colour] == [False] * 5 + [True] * 3
    early = results[3].associations
    np.testing.assert_allclose(early["total"], early["distance"], rtol=1e-6)


def test_two_frames_of_one_time_move_nobody():
    seen = list(observations(crossing(), 3, MISTAKES))[:30]
    twice = [*seen[:20], *(replace(each, frame=each.frame + 1) for each in seen[19:])]
    twice[20] = replace(twice[20], time_s=twice[19].time_s)
    twice[21] = replace(twice[21], time_s=twice[19].time_s - 0.01)
    tracker = PaperTracker(view(), COLOUR, HalvesOfFirstFrames(COLOUR), 0)
    places = [np.column_stack([tracker.step(each).tracks[n] for n in "xy"]) for each in twice]
    assert all(np.isfinite(each).all() for each in places)
    assert max(np.hypot(*(new - old).T).max() for old, new in pairwise(places)) < 0.3


def test_an_id_is_given_at_the_first_sighting_and_ends_after_a_set_time():
    results = reported(replace(DIRECTION, delete_after_s=1.48), 0)
    assert results[0].tracks["track"].tolist() == [1, 2, 3]
    assert results[0].detections["track"].tolist() == [1, 2, 3]
    last = max(result.frame for result in results if 3 in result.tracks["track"])
    assert last == 34 + 1.5 * FPS


def test_a_cue_without_weight_costs_nothing():
    blind = StereoDirectionSettings(**SETTINGS, colour_weight=0.0, direction_weight=0.0)
    for result in reported(blind, 0)[20:]:
        cues = result.associations
        np.testing.assert_allclose(cues["total"], cues["distance"], rtol=1e-6)
