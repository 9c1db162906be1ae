"""The steps of the filters, for all people at once: predict, weigh, estimate, resample."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import cloud_shapes, resample
from tracking.trackers.spheroid.hypotheses import Floats, SpheroidPeople
from tracking.trackers.spheroid.settings import SpheroidSettings

_FASTEST_M_PER_S = 3.5
_KNOWN_SD_M = 0.03
"""Body heights are never held for surer than this."""
_HEADS_KEPT = 0.3
"""Share of the hypotheses whose heads stay in the image when their heights change; 0.15 to 0.5 do
alike."""
_LEAST_OVER_M = 0.25
"""A camera that is less above a head sees it at any distance at about the same place."""


def predict(
    people: SpheroidPeople,
    elapsed_s: float,
    settings: SpheroidSettings,
    random: np.random.Generator,
    camera_position: Floats,
) -> SpheroidPeople:
    """Everybody's hypotheses one frame on: constant velocity, disturbed ([Waechter2013] 3.1).

    Where we differ: each hypothesis has a body height of its own, drawn from what is thought of
    the person's.
    """
    if elapsed_s <= 0.0 or len(people) == 0:
        return people
    noise = random.standard_normal(people.state.shape, dtype=np.float32)
    root = float(np.sqrt(elapsed_s))
    spreads = np.repeat((settings.process_noise_m, settings.process_noise_velocity), 2) * root
    state = people.state + noise * spreads.astype(np.float32)
    state[..., :2] += people.state[..., 2:] * np.float32(elapsed_s)
    speed = np.hypot(state[..., 2], state[..., 3])
    slower = np.minimum(1.0, _FASTEST_M_PER_S / np.maximum(speed, 1e-6))
    state[..., 2:] *= slower[..., None]
    mean = people.mean.copy()
    mean[:, :2] += mean[:, 2:] * elapsed_s
    tall = _heights(people, settings, random)
    if not settings.paper:
        state[..., :2] = _keep_heads(state[..., :2], people.tall, tall, camera_position, random)
    return people.replace(state=state, mean=mean, tall=tall)


def _keep_heads(
    xy: NDArray[np.float32],
    before: NDArray[np.float32],
    tall: NDArray[np.float32],
    camera_position: Floats,
    random: np.random.Generator,
) -> NDArray[np.float32]:
    """(people, N, 2) m the places, some moved along their lines of sight so that heads stay.

    Seen from low above, tall and near looks like short and far away: a height of its own alone
    would take a hypothesis' head out of the foreground. The less is known of a body height, the
    farther this reaches; others keep their feet, and the image decides.

    Args:
        xy: (people, N, 2) m. before, tall: (people, N) m, the body heights they had and have now.
    """
    over = (camera_position[2] - before, camera_position[2] - tall)
    moved = (random.random(tall.shape) < _HEADS_KEPT) & (np.minimum(*over) > _LEAST_OVER_M)
    factor = np.where(moved, over[1] / np.where(moved, over[0], 1.0), 1.0)
    foot = camera_position[:2]
    return np.asarray(foot + (xy - foot) * factor[..., None], np.float32)


def _heights(
    people: SpheroidPeople, settings: SpheroidSettings, random: np.random.Generator
) -> NDArray[np.float32]:
    """(people, N) m."""
    shape = people.weight.shape
    if settings.paper:
        return np.repeat(people.height[:, None], shape[1], axis=1).astype(np.float32)
    noise = random.standard_normal(shape, dtype=np.float32)
    tall = people.height[:, None] + people.height_sd[:, None] * noise
    low, high = settings.min_height_m, settings.max_height_m
    return np.asarray(np.clip(tall, low, high), np.float32)


def weigh_hypotheses(people: SpheroidPeople, log_weight: Floats) -> SpheroidPeople:
    """The people with their hypotheses weighed and the estimates taken from them.

    Args:
        log_weight: (people, N) logarithms of weights, -inf for what cannot be; where nothing can
            be the weights stay as they are.
    """
    best = log_weight.max(axis=1, keepdims=True)
    possible = np.isfinite(best)
    relative = np.where(possible, log_weight - np.where(possible, best, 0.0), 0.0)
    weight = np.exp(relative)
    weight /= weight.sum(axis=1, keepdims=True)
    mean = np.einsum("pnk,pn->pk", people.state, weight)
    spread, _ = cloud_shapes(people.state[..., :2], weight.astype(np.float32))
    return people.replace(
        weight=weight.astype(np.float32), mean=mean, spread=spread.astype(np.float64)
    )


def learn_heights(
    people: SpheroidPeople, seen: NDArray[np.bool_], elapsed_s: float
) -> SpheroidPeople:
    """The people with what their hypotheses tell of body heights.

    Args:
        seen: (people,) whose head and feet are in sight: only then is there something to learn.
    """
    mean = np.einsum("pn,pn->p", people.tall, people.weight)
    apart = people.tall - mean[:, None]
    variance = np.einsum("pn,pn,pn->p", apart, apart, people.weight)
    # Frames follow each other too closely to be looks of their own: so many of them are one.
    share = np.clip(elapsed_s / 0.35, 0.0, 1.0) * seen
    height = people.height + share * (mean - people.height)
    narrower = people.height_sd + share * (np.sqrt(variance) - people.height_sd)
    sd = np.maximum(np.minimum(people.height_sd, narrower), _KNOWN_SD_M)
    return people.replace(height=height, height_sd=sd)


def resample_people(people: SpheroidPeople, random: np.random.Generator) -> SpheroidPeople:
    """Heavy hypotheses multiplied, light ones dropped."""
    return people.replace(state=resample(people.state, people.weight, random))
