"""Which parts are hidden, which are lost, and who people are resumed as."""

from __future__ import annotations

import numpy as np
import pytest
from people_of_three_blocks import (
    FPS,
    GREEN_BROWN,
    RED_BLUE,
    SIZE,
    Blocks,
    observations,
    part_box,
    walking,
)

from tracking.trackers import Resume
from tracking.trackers.three_part import ThreePartSettings
from tracking.trackers.three_part.initiation import pose_of
from tracking.trackers.three_part.occlusion import behind_others
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.poses import log_prior, pose_faults
from tracking.trackers.three_part.tracker import Camera, PartTracker
from tracking.tracks import TrackTable

STANDING = np.array([[50.0, 8, 9, 9], [50, 30, 20, 20], [50, 60, 16, 25]])
"""Inner rectangles of somebody 100 px high."""


@pytest.mark.parametrize(
    ("part", "move", "lost"),
    [
        (0, (0, 0), []),
        (0, (60, 0), [0]),
        (0, (0, 30), [0]),
        (2, (-50, 0), [2]),
        (2, (0, -40), [2]),
        (1, (80, 0), [1]),
    ],
)
def test_the_part_that_goes_with_neither_of_the_others_is_lost(part, move, lost):
    rectangles = STANDING[None].copy()
    rectangles[0, part, :2] += move
    assert np.flatnonzero(pose_faults(rectangles, np.array([100.0]))[0]).tolist() == lost


@pytest.mark.parametrize("scale", [0.5, 1.0, 3.0])
@pytest.mark.parametrize("pose", ["standing", "crouching", "bending"])
def test_standing_crouching_and_bending_are_possible_near_and_far(scale, pose):
    rectangles = STANDING[None].copy()
    if pose == "crouching":
        rectangles[0, :, 1] = 50.0, 66.0, 80.0
    elif pose == "bending":
        rectangles[0, 0, :2] += (-20.0, 12.0)
    assert not pose_faults(scale * rectangles, np.array([100.0 * scale])).any()


def test_a_body_is_less_likely_the_more_it_is_torn_apart():
    apart = np.repeat(STANDING[None], 4, axis=0)
    apart[:, 0, 0] += (0.0, 5.0, 30.0, 80.0)
    pose = np.repeat(pose_of(STANDING[None])[..., :2], 4, axis=0)
    log = log_prior(apart, pose, np.full(4, 100.0))
    assert log[0] == 0.0
    assert (np.diff(log) < 0).all()


def two_touching() -> np.ndarray:
    return np.stack((STANDING, STANDING + np.array((8.0, 6.0, 0.0, 0.0))))


def test_of_two_who_touch_the_one_who_looks_less_like_themselves_is_behind():
    alike = np.zeros((2, 3))
    alike[1] = -0.3
    level, height, nobody = np.full(2, 100.0), np.full(2, 100.0), np.zeros(2, bool)
    hidden, touching = behind_others(two_touching(), alike, level, height, nobody)
    assert touching.all()
    assert not hidden[0].any()
    assert hidden[1].all()


def test_of_two_alike_the_one_standing_lower_in_the_picture_is_in_front():
    alike, height = np.zeros((2, 3)), np.full(2, 100.0)
    hidden, _ = behind_others(
        two_touching(), alike, np.array([100.0, 115.0]), height, np.zeros(2, bool)
    )
    assert hidden[0].all()
    assert not hidden[1].any()


def test_who_is_behind_stays_so_while_both_look_about_alike():
    alike, level, height = np.zeros((2, 3)), np.full(2, 100.0), np.full(2, 100.0)
    alike[0] = 0.04
    for behind in (0, 1):
        was = np.arange(2) == behind
        hidden, _ = behind_others(two_touching(), alike, level, height, was)
        assert hidden.any(axis=1).tolist() == was.tolist()


def test_people_apart_hide_nothing_of_each_other():
    apart = two_touching()
    apart[1, :, 0] += 100.0
    hidden, touching = behind_others(
        apart, np.zeros((2, 3)), np.full(2, 100.0), np.full(2, 100.0), np.ones(2, bool)
    )
    assert not hidden.any()
    assert not touching.any()


@pytest.mark.parametrize("layout", [Layout(3, 1), Layout(3, 3), Layout(1, 1)])
def test_tracking_goes_on_with_corrected_people_under_their_ids(layout):
    person = Blocks(walking((40, 60), (2.0, 0.3)), RED_BLUE)
    late = Blocks(lambda f: (200 - f, 50.0) if f >= 40 else None, GREEN_BROWN)
    rows = corrected_rows(person, track=7, frames=30)
    resume = Resume.of(TrackTable(rows, highest_track=11), 30, FPS)
    by = PartTracker(Camera(SIZE, FPS, None), ThreePartSettings(adjust=False), layout, 0)
    seen = list(observations([person, late], 60))
    by.resume(resume, [seen[frame] for frame in resume.colour_frames])
    results = [by.step(each) for each in seen[30:]]
    assert results[0].tracks["track"].tolist() == [7]
    assert results[-1].tracks["track"].tolist() == [7, 12]
    row = results[-1].tracks
    middle = row["left"][0] + row["width"][0] / 2, row["top"][0] + row["height"][0] / 2
    torso = part_box(person, 59, 1)
    assert torso[0] < middle[0] < torso[2]
    assert abs(middle[1] - torso[3]) < 25


def corrected_rows(person: Blocks, track: int, frames: int) -> dict[str, np.ndarray]:
    """What somebody drew: the person's whole box in each frame."""
    box = np.array([(*person.left_top(frame), 32.0, 100.0) for frame in range(frames)])
    unknown = np.full(frames, np.nan)
    return {
        "frame": np.arange(frames, dtype=np.int32),
        "track": np.full(frames, track, np.int32),
        **dict(zip(("left", "top", "width", "height"), box.T, strict=True)),
        **dict.fromkeys(("x", "y", "vx", "vy"), unknown),
        "confidence": np.ones(frames, np.float32),
        "visibility": np.ones(frames, np.float32),
        "predicted": np.zeros(frames, bool),
    }
