"""How the camera sees people, and what is made of it: masks that teach shadows, balances."""

from __future__ import annotations

import numpy as np
from people_of_one_colour import view

from tracking.geometry import FlatView
from tracking.trackers.spheroid import SpheroidSettings
from tracking.trackers.spheroid.hypotheses import SpheroidPeople, begin_people
from tracking.trackers.spheroid.perception_hints import body_masks
from tracking.trackers.spheroid.view_model import headless, near_side_hidden, seen_steeply
from tracking.trackers.spheroid.weights import axes_of, hypotheses_of, silhouettes

DOWN = FlatView(view())
SLOPING = FlatView(view(4.0, 40.0))


def _people(*states: tuple[float, ...], spread: float = 0.0) -> SpheroidPeople:
    mean = np.array([(*state, 0.0, 0.0)[:4] for state in states])
    people = begin_people(
        np.arange(1, len(mean) + 1, dtype=np.int32),
        mean,
        np.full(len(mean), 1.72),
        0.0,
        20,
        (spread, spread),
        np.random.default_rng(4),
    )
    return people.replace(age_s=np.full(len(mean), 5.0))


def test_steep_is_what_lies_nearer_than_the_camera_is_high() -> None:
    people = _people((0.0, 0.5), (0.0, 3.5), (0.0, 3.7), (-1.9, 0.0))
    assert list(seen_steeply(people, DOWN)) == [True, True, False, True]


def test_heads_leave_the_picture_before_feet_do() -> None:
    assert list(headless(_people((0.9, 0.6), (2.0, 0.6)), DOWN)) == [False, True]


def test_who_stands_behind_somebody_has_the_near_side_hidden() -> None:
    people = _people((0.9, 0.6), (1.5, 1.0), (-1.5, 1.0))
    hidden = near_side_hidden(people, silhouettes(people, DOWN, SpheroidSettings()), DOWN)
    assert list(hidden) == [False, True, False]


def test_who_walks_leans_ahead_but_not_as_published() -> None:
    people = _people((0.2, 0.1, 1.2, 0.0), (0.5, 0.9), spread=0.1)
    ahead = axes_of(people, SpheroidSettings()) - people.xy
    assert 0.02 < ahead[0, 0] < 0.1
    assert not ahead[0, 1]
    assert not ahead[1].any()
    axes, _ = hypotheses_of(people, SpheroidSettings())
    assert np.allclose(axes - people.state[..., :2], ahead[:, None])
    assert np.array_equal(axes_of(people, SpheroidSettings(paper=True)), people.xy)


def test_what_lies_before_the_floor_near_somebodys_feet_teaches_no_bodies() -> None:
    people = _people((0.5, 0.4))
    assert not body_masks(people, DOWN, SpheroidSettings()).on.any()
    far = _people((0.3, 5.0))
    on = body_masks(far, SLOPING, SpheroidSettings()).on
    rows = np.flatnonzero(on.any(axis=1))
    _, feet = SLOPING.flat_from_world(np.array([[0.3, 5.0, 0.0]]))[0]
    _, beyond = SLOPING.flat_from_world(np.array([[0.3, 6.0, 0.0]]))[0]
    assert len(rows)
    assert rows.max() < beyond < feet
