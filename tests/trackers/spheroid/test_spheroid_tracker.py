"""The spheroid tracker on people who are spheroids."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from people_of_one_colour import (
    BLUE,
    FPS,
    Body,
    built,
    floor_picture,
    followed,
    frames_of,
    places,
    standing,
    straight,
    view,
)

from tracking.errors import SettingsError
from tracking.recording.frame import StereoFrame
from tracking.trackers import Resume
from tracking.trackers.spheroid import SpheroidSettings
from tracking.trackers.spheroid.filter_steps import predict, weigh_hypotheses
from tracking.trackers.spheroid.hypotheses import begin_people
from tracking.trackers.spheroid.support import should_keep
from tracking.trackers.spheroid.weights import is_taken
from tracking.tracks.table import TrackTable

BARREL = (-0.2, 0.05, 0.0, 0.0, 0.0)
CAMERA = np.array([0.0, 0.0, 2.4])


def _with_absence(path: np.ndarray, begin: int, end: int) -> np.ndarray:
    gone = path.copy()
    gone[:begin] = gone[end:] = np.nan
    return gone


@pytest.mark.parametrize(
    ("height_m", "tilt", "start", "distortion"),
    [
        (3.6, 90.0, (-1.0, -0.3), ()),
        (3.6, 90.0, (-1.0, 0.2), BARREL),
        (4.0, 40.0, (-1.0, 4.2), ()),
        (2.5, 12.0, (-1.0, 5.0), BARREL),
    ],
    ids=["straight down", "down through a lens", "sloping", "nearly level through a lens"],
)
def test_somebody_who_walks_is_followed_on_the_floor(
    height_m: float, tilt: float, start: tuple[float, float], distortion: tuple[float, ...]
) -> None:
    seen_by = view(height_m, tilt, distortion)
    path = straight(start, (0.8, 0.1), 40)
    results = followed(seen_by, frames_of(seen_by, [Body(path)]))
    assert {tuple(result.tracks["track"]) for result in results[8:]} == {(1,)}
    errors = [np.hypot(*(places(results[k])[0] - path[k])) for k in range(12, 40)]
    # Half a pixel of the smoothed edge is 2 cm here straight below and 10 cm at the level camera;
    # feet, which these bodies have not, are looked for by the sloping one.
    assert np.mean(errors) < {90.0: 0.05, 40.0: 0.12, 12.0: 0.2}[tilt]


def test_a_spheroid_of_the_papers_size_stands_still_within_a_few_centimetres() -> None:
    seen_by = view()
    body = Body(standing((0.9, 0.6), 45), height_m=1.8)
    results = followed(seen_by, frames_of(seen_by, [body]), paper=True)
    mean = np.mean([places(result)[0] for result in results[15:]], axis=0)
    assert np.hypot(*(mean - (0.9, 0.6))) < 0.05
    assert all(result.signals["height_m"][0] == np.float32(1.8) for result in results[15:])


def test_a_body_height_is_learnt() -> None:
    seen_by = view(4.0, 40.0)
    frames = 60
    tall = Body(straight((-1.2, 4.5), (0.3, 0.0), frames), height_m=1.88)
    small = Body(straight((1.0, 4.0), (-0.1, 0.1), frames), BLUE, height_m=1.55)
    last = followed(seen_by, frames_of(seen_by, [tall, small]))[-1]
    by_x = np.argsort(last.tracks["x"])
    found = last.signals["height_m"][by_x]
    assert np.allclose(found, (1.88, 1.55), atol=0.14)
    assert found[0] - found[1] > 0.2


def test_people_who_cross_keep_their_tracks() -> None:
    seen_by = view(4.0, 40.0)
    one = straight((-1.3, 4.2), (1.0, 0.0), 45)
    other = straight((1.3, 4.9), (-1.0, 0.0), 45)
    results = followed(seen_by, frames_of(seen_by, [Body(one), Body(other, BLUE)]))
    first, last = results[9], results[-1]
    assert sorted(first.tracks["track"]) == sorted(last.tracks["track"]) == [1, 2]
    for result, k in ((first, 9), (last, 44)):
        left = int(np.argmin(result.tracks["x"]))
        owner = result.tracks["track"][left]
        assert (owner == first.tracks["track"][np.argmin(first.tracks["x"])]) == (k == 9)


def test_a_group_that_comes_in_together_is_taken_apart() -> None:
    seen_by = view(4.0, 40.0)
    group = [Body(standing((x, 4.5 + 0.15 * k), 14)) for k, x in enumerate((-0.6, 0.0, 0.6))]
    last = followed(seen_by, frames_of(seen_by, group))[-1]
    assert len(last.tracks["track"]) == 3
    assert np.allclose(np.sort(last.tracks["x"]), (-0.6, 0.0, 0.6), atol=0.15)


def test_who_leaves_ends_and_a_scene_without_people_has_no_tracks() -> None:
    seen_by = view()
    path = _with_absence(straight((0.0, 0.0), (1.4, 0.0), 60), 0, 60)
    results = followed(seen_by, frames_of(seen_by, [Body(path)]))
    assert len(results[10].tracks["track"]) == 1
    assert len(results[-1].tracks["track"]) == 0


def test_a_hypothesis_where_somebody_else_stands_counts_nothing() -> None:
    settings = SpheroidSettings(paper=True)
    random = np.random.default_rng(1)
    mean = np.array([[0.0, 0.0, 0.0, 0.0], [0.8, 0.0, 0.0, 0.0]])
    track = np.array([1, 2], np.int32)
    people = begin_people(track, mean, np.full(2, 1.8), 0.0, 200, (0.3, 0.1), random)
    close = is_taken(people, settings)
    apart = np.hypot(people.state[0, :, 0] - 0.8, people.state[0, :, 1])
    assert np.array_equal(close[0], apart < 0.5)
    log_weight = np.where(close, -np.inf, 0.0)
    assert (weigh_hypotheses(people, log_weight).weight[close] == 0.0).all()


def test_who_is_spread_too_wide_is_let_go() -> None:
    settings = SpheroidSettings(paper=True)
    random = np.random.default_rng(2)
    mean = np.zeros((1, 4))
    people = begin_people(np.ones(1, np.int32), mean, np.array([1.8]), 0.0, 300, (0.1, 0.2), random)
    assert should_keep(people, settings).all()
    for _ in range(200):
        people = weigh_hypotheses(
            predict(people, 1 / FPS, settings, random, CAMERA), np.zeros((1, 300))
        )
    assert people.spread[0] > settings.widest_spread_m
    assert not should_keep(people, settings).any()


def test_hypotheses_whose_heights_change_keep_head_or_feet_where_they_were() -> None:
    settings, random = SpheroidSettings(process_noise_m=0.0), np.random.default_rng(3)
    mean = np.array([[3.0, 6.0, 0.0, 0.0]])
    people = begin_people(np.ones(1, np.int32), mean, np.array([1.7]), 0.1, 400, (0, 0), random)
    later = predict(people, 1 / FPS, settings, random, CAMERA)
    heads = later.state[0, :, :2] / (CAMERA[2] - later.tall[0, :, None])
    same_head = np.isclose(heads, mean[0, :2] / (CAMERA[2] - 1.7), rtol=1e-4).all(axis=1)
    same_feet = np.isclose(later.state[0, :, :2], mean[0, :2]).all(axis=1)
    assert (same_head | same_feet).all()
    assert 0.2 < same_head.mean() < 0.4


def test_no_ghost_stays_where_somebody_stood_when_the_scene_began() -> None:
    seen_by = view()
    frames = round(FPS * 9)
    path = standing((0.6, 0.2), frames)
    path[int(FPS * 3) :] = np.nan
    footage = frames_of(seen_by, [Body(path)])
    results = followed(seen_by, footage, learn=footage[:3])
    assert len(results[round(FPS * 8)].tracks["track"]) == 0
    assert all(len(result.tracks["track"]) == 0 for result in results[round(FPS * 8) :])


def test_the_same_seed_gives_the_same_bytes() -> None:
    seen_by = view()
    footage = frames_of(seen_by, [Body(straight((-1.0, 0.1), (0.7, 0.1), 20))])
    one, again, other = (followed(seen_by, footage, seed)[-1] for seed in (5, 5, 6))
    for name, column in one.particles.items():
        assert column.tobytes() == again.particles[name].tobytes()
    assert one.particles["x"].tobytes() != other.particles["x"].tobytes()


def test_a_camera_that_moves_is_told_and_one_that_does_not_is_not() -> None:
    seen_by = view()
    frames = round(FPS * 4)
    body = Body(straight((-1.2, 0.1), (0.6, 0.0), frames))
    turning = [(0.0, 0.0)] * 20 + [(0.9 * k, 0.3 * k) for k in range(frames - 20)]
    for shifts, told in ((None, False), (turning, True)):
        perception, tracker = built(seen_by)
        for frame in frames_of(seen_by, [body], shifts=shifts):
            tracker.step(perception.observe(replace(frame, number=frame.number + 500)))
        assert bool(tracker.notes) == told
    (note,) = tracker.notes
    still_at, moved_at = map(int, re.findall(r"between frames (\d+) and (\d+):", note)[0])
    assert 510 < still_at < moved_at < 500 + frames
    assert f"--frames 500:{still_at + 1}" in note


def test_light_that_is_dimmed_makes_nobody() -> None:
    seen_by = view()
    floor = floor_picture()
    frames = [
        StereoFrame(k, k / FPS, floor if k < 15 else (floor * 0.8).astype(np.uint8), None)
        for k in range(45)
    ]
    results = followed(seen_by, frames)
    assert all(len(result.tracks["track"]) == 0 for result in results)


def test_people_of_a_correction_are_followed_on_with_their_tracks() -> None:
    seen_by = view()
    one = Body(straight((-1.2, 0.4), (0.8, 0.0), 40))
    other = Body(straight((1.2, -0.4), (-0.8, 0.0), 40), BLUE)
    footage = frames_of(seen_by, [one, other])
    first = followed(seen_by, footage[:20])
    names = ("frame", "track", "left", "top", "width", "height", "x", "y", "vx", "vy")
    names += ("confidence", "visibility", "predicted")
    rows = {name: np.concatenate([step.tracks[name] for step in first]) for name in names}
    rows["track"] = np.where(rows["track"] == 1, 4, 7).astype(np.int32)
    resume = Resume.of(TrackTable(rows), 20, FPS)
    perception, tracker = built(seen_by)
    tracker.resume(resume, [perception.observe(footage[k]) for k in resume.colour_frames])
    results = [tracker.step(perception.observe(frame)) for frame in footage[20:]]
    assert all(list(result.tracks["track"]) == [4, 7] for result in results)
    owner = rows["track"][rows["frame"] == 19][np.argmin(rows["x"][rows["frame"] == 19])]
    where = float(results[0].tracks["x"][list(results[0].tracks["track"]).index(owner)])
    assert abs(where - min(one.path[20, 0], other.path[20, 0])) < 0.15


def test_what_is_drawn_as_hiding_people_proves_nothing() -> None:
    seen_by = view(4.0, 40.0)
    path = straight((-1.2, 4.5), (0.9, 0.0), 40)
    footage = frames_of(seen_by, [Body(path)])
    pillar = slice(150, 175)
    for frame in footage:
        frame.left[:, pillar] = (90, 90, 90)
    empty = floor_picture()
    empty[:, pillar] = (90, 90, 90)
    perception, tracker = built(seen_by, learn=[StereoFrame(0, 0.0, empty, None)])
    hidden = perception.flat.covered.copy()
    hidden[:, pillar] = False
    tracker._counted = hidden
    results = [tracker.step(perception.observe(frame)) for frame in footage]
    assert {tuple(result.tracks["track"]) for result in results[8:]} == {(1,)}


def test_heights_and_ramps_that_make_no_sense_are_refused() -> None:
    with pytest.raises(SettingsError, match=r"initial_height_m: 1\.2 is not between"):
        SpheroidSettings(initial_height_m=1.2)
    with pytest.raises(SettingsError, match="setting occluders"):
        SpheroidSettings(occluders="[[1]]")


def test_boxes_enclose_what_is_seen_of_people() -> None:
    seen_by = view(4.0, 40.0)
    path = straight((-0.8, 4.5), (0.5, 0.0), 25)
    footage = frames_of(seen_by, [Body(path)])
    last = followed(seen_by, footage)[-1]
    drawn = np.abs(footage[-1].left.astype(int) - floor_picture()).max(axis=2) > 12
    rows, columns = np.flatnonzero(drawn.sum(axis=1) > 2), np.flatnonzero(drawn.sum(axis=0) > 2)
    left, top, width, height = (last.tracks[n][0] for n in ("left", "top", "width", "height"))
    assert np.allclose((left, top), (columns[0], rows[0]), atol=4)
    assert np.allclose((left + width, top + height), (columns[-1], rows[-1]), atol=4)
