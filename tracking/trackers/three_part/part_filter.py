"""People's parts from one frame to the next: moved, then weighed by what they look like."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import (
    Clouds,
    drifted,
    entropies,
    mean_states,
    particle_counts,
    redrawn,
    weighed_by,
)
from tracking.filtering.rectangles import DX
from tracking.trackers.three_part.appearance import log_likelihoods
from tracking.trackers.three_part.initiation import group_by_filter, part_sizes
from tracking.trackers.three_part.people import Flags, Floats, Layout, PartPeople
from tracking.trackers.three_part.poses import log_prior
from tracking.trackers.three_part.settings import WholeBodySettings

_PACE_MEMORY_S = 0.3


def move_parts(
    people: PartPeople,
    elapsed_s: float,
    settings: WholeBodySettings,
    layout: Layout,
    random: np.random.Generator,
) -> PartPeople:
    """Everybody resampled and predicted; estimates too, as far as the state says.

    Parts that were occluded move at the person's pace: their own velocity is not measured.
    """
    count = _next_counts(people, settings, layout)
    clouds = redrawn(people.clouds, count, random)
    clouds = _set_pace(clouds, people, layout)
    spread = _spread(people.state, elapsed_s, settings)
    clouds = drifted(clouds, elapsed_s, group_by_filter(spread, layout), random)
    state = people.state.copy()
    velocity = np.where(people.occluded[..., None], people.pace[:, None], state[..., DX:])
    state[..., :2] += velocity * elapsed_s
    return people.replace(clouds=clouds, state=state)


def weigh_parts(
    people: PartPeople,
    before: PartPeople,
    picture: NDArray[np.uint8],
    elapsed_s: float,
    settings: WholeBodySettings,
    layout: Layout,
    random: np.random.Generator,
) -> PartPeople:
    """Particles weighed by their colours, and what follows: estimates, entropy, pace.

    Parts that are occluded stay where motion put them.

    Args:
        people: as predicted, with this frame's `occluded`. before: in the last frame.
        picture: (height, width, 3) of `ycbcr`.
    """
    filtered = ~people.occluded
    log = log_likelihoods(picture, people.clouds, people.model, filtered, settings.similarity_sigma)
    if layout.together == 1:
        clouds = weighed_by(people.clouds, log[:, 0])
        entropy = entropies(clouds).reshape(filtered.shape)
    else:
        clouds, entropy = _weigh_together(people, log, random)
    estimate = mean_states(clouds).reshape(people.state.shape)
    state = np.where(filtered[..., None], estimate, people.state)
    people = people.replace(clouds=clouds, state=state, entropy=np.where(filtered, entropy, np.nan))
    return people.replace(pace=_update_pace(people, before, elapsed_s))


def _weigh_together(
    people: PartPeople, log: NDArray[np.float32], random: np.random.Generator
) -> tuple[Clouds, Floats]:
    """Particles of three parts each, and the entropy of each part's own weights.

    Drawn part by part by what each looks like, put together, and weighed by whether a body can
    stand so: a cloud of eighteen numbers drawn at once would need far more particles.

    Args:
        log: (particles, 3) of the likelihoods.
    """
    clouds, parts = people.clouds, range(log.shape[1])
    own = [
        weighed_by(Clouds(clouds.state[:, [k]], clouds.weight, clouds.start), log[:, k])
        for k in parts
    ]
    drawn = [redrawn(one, clouds.count, random) for one in own]
    state = np.concatenate([one.state for one in drawn], axis=1)
    owner = clouds.owner
    prior = log_prior(state[..., :4], people.pose[owner, :, :2], people.height[owner])
    joint = weighed_by(Clouds(state, drawn[0].weight, clouds.start), prior)
    return joint, np.stack([entropies(one) for one in own], axis=1)


def carry_along(state: Floats, pose: Floats, which: Flags) -> Floats:
    """States (people, parts, 6) with some parts where the person's other parts take them.

    Where we differ from [ZhaoLee2009]: an occluded part does not drift off by its last motion, but
    keeps its place in the body as long as any part is seen; of somebody hidden whole the motion
    counts.

    Args:
        pose: (people, parts, 4) px, see `PartPeople`. which: (people, parts) to be carried.
    """
    others = ~which
    known = np.asarray(others.any(axis=1) & which.any(axis=1))
    count = np.maximum(others.sum(axis=1), 1)[:, None]
    middle = ((state[..., :2] - pose[..., :2]) * others[..., None]).sum(axis=1) / count
    moved_state = state.copy()
    rows = which & known[:, None]
    place = middle[:, None] + pose[..., :2]
    moved_state[..., :2] = np.where(rows[..., None], place, state[..., :2])
    moved_state[..., 2:4] = np.where(rows[..., None], pose[..., 2:], state[..., 2:4])
    return moved_state


def _next_counts(
    people: PartPeople, settings: WholeBodySettings, layout: Layout
) -> NDArray[np.int64]:
    """(filters of all people,) as many as before where nothing was weighed."""
    entropy = _widest(people.entropy.reshape(-1, layout.together))
    next_ = particle_counts(
        people.clouds.count,
        np.nan_to_num(entropy, nan=1.0 / settings.particle_growth),
        settings.particle_growth,
        settings.min_particles,
        settings.max_particles,
    )
    return np.asarray(next_)


def _widest(entropy: Floats) -> Floats:
    """(filters,) the largest of the parts together that were filtered; NaN where none was."""
    known = np.isfinite(entropy)
    largest = np.where(known, entropy, -1.0).max(axis=1, initial=-1.0)
    return np.asarray(np.where(known.any(axis=1), largest, np.nan))


def _set_pace(clouds: Clouds, people: PartPeople, layout: Layout) -> Clouds:
    """The velocities of occluded parts' particles set to the person's pace."""
    if not people.occluded.any():
        return clouds
    owner = clouds.owner
    occluded = group_by_filter(people.occluded[..., None], layout)[owner, :, 0]
    pace = people.pace[owner // layout.filters].astype(np.float32)
    state = clouds.state.copy()
    state[..., DX:] = np.where(occluded[..., None], pace[:, None], state[..., DX:])
    return Clouds(state, clouds.weight, clouds.start)


def _spread(state: Floats, elapsed_s: float, settings: WholeBodySettings) -> Floats:
    """(people, parts, 6) random spread after this time."""
    root = np.sqrt(max(elapsed_s, 0.0))
    size = part_sizes(state)[..., None]
    place = np.repeat(settings.process_noise_position * size, 2, axis=-1)
    grown = settings.process_noise_size * state[..., 2:4]
    speed = np.repeat(settings.process_noise_velocity * size, 2, axis=-1)
    return np.asarray(root * np.concatenate((place, grown, speed), axis=-1))


def _update_pace(people: PartPeople, before: PartPeople, elapsed_s: float) -> Floats:
    """(people, 2) px/s smoothed; of those with no part filtered as it was."""
    pace = before.pace.copy()
    rows = np.flatnonzero(~people.occluded.all(axis=1))
    if elapsed_s <= 0.0 or not len(rows):
        return pace
    step = (people.state[rows, :, :2] - before.state[rows, :, :2]) / elapsed_s
    step[people.occluded[rows]] = np.nan
    share = 1.0 - np.exp(-elapsed_s / _PACE_MEMORY_S)
    pace[rows] += share * (np.nanmedian(step, axis=1) - pace[rows])
    return pace
