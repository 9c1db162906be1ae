"""The flow tracker over drawn footage: people found, followed, told apart and let go."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest
from flow_scenes import (
    FPS,
    clothes,
    drawn,
    floor_picture,
    flow_pair,
    frame_of,
    straight,
    tracked,
    view_of,
)
from numpy.typing import NDArray

from tracking.errors import CalibrationError
from tracking.recording import Recording
from tracking.trackers import StepResult, parse_settings, require, tracker_named
from tracking.trackers.shared.resumption import Resume
from tracking.tracks import CORRECTED_COLUMNS, TRACKLET_COLUMNS, TrackTable

VIEW = view_of()
FLOOR = floor_picture()
FRAMES = 34
Ways = Sequence[NDArray[np.float64]]


def pictures_of(ways: Ways) -> list[NDArray[np.uint8]]:
    return [
        drawn(FLOOR, VIEW, [(*way[frame], 10 + who) for who, way in enumerate(ways)])
        for frame in range(len(ways[0]))
    ]


TWO = (straight((-1.6, 4.0), (0.9, 0.1), FRAMES), straight((1.5, 5.6), (-0.8, -0.3), FRAMES))


@cache
def steps_of_two(hold: bool = True) -> list[StepResult]:
    settings = parse_settings(tracker_named("flow"), {"persistent_points": str(hold).lower()})
    return tracked(VIEW, pictures_of(TWO), settings)[0]


def places(step: StepResult) -> NDArray[np.float64]:
    return np.stack((step.tracks["x"], step.tracks["y"]), axis=1)


def test_two_people_are_two_tracks_that_stay_with_them() -> None:
    late = steps_of_two()[14:]
    for who, way in enumerate(TWO):
        ids = set()
        for step in late:
            away = np.hypot(*(places(step) - way[step.frame]).T)
            assert away.min() < 0.35, (who, step.frame)
            ids.add(int(step.tracks["track"][away.argmin()]))
        assert len(ids) == 1
    assert {len(step.tracks["track"]) for step in late} == {2}


def test_clusters_alone_find_both_people_until_they_cross() -> None:
    steps = steps_of_two(hold=False)
    for way in TWO:
        ids = set()
        for step in steps[14:20]:
            away = np.hypot(*(places(step) - way[step.frame]).T)
            assert away.min() < 0.9, step.frame
            ids.add(int(step.tracks["track"][away.argmin()]))
        assert len(ids) <= 2
    assert max(len(step.tracks["track"]) for step in steps) <= 3


def test_velocities_are_those_of_the_people() -> None:
    last = steps_of_two()[-1]
    for way in TWO:
        near = np.hypot(*(places(last) - way[-1]).T).argmin()
        pace = (way[-1] - way[0]) / (FRAMES - 1) * FPS
        found = last.tracks["vx"][near], last.tracks["vy"][near]
        np.testing.assert_allclose(found, pace, atol=0.25)


def test_boxes_hold_the_people() -> None:
    last = steps_of_two()[-1]
    for way in TWO:
        near = np.hypot(*(places(last) - way[-1]).T).argmin()
        chest = VIEW.pixel_from_world(np.array([[*way[-1], 1.2]]))[0]
        low = np.array([last.tracks["left"][near], last.tracks["top"][near]])
        size = np.array([last.tracks["width"][near], last.tracks["height"][near]])
        assert ((chest > low) & (chest < low + size)).all()


def test_tracklets_of_people_lie_on_them_with_their_last_three_positions() -> None:
    last = steps_of_two()[-1]
    assert list(last.tracklets) == list(TRACKLET_COLUMNS)
    assert (np.diff(last.tracklets["track"]) >= 0).all()
    for way in TWO:
        near = np.hypot(*(places(last) - way[-1]).T).argmin()
        own = last.tracklets["track"] == last.tracks["track"][near]
        assert own.sum() >= 5
        chest = [VIEW.pixel_from_world(np.array([[*way[k], 1.2]]))[0] for k in (-1, -2, -3)]
        shift = last.tracklets["u0"][own] - last.tracklets["u2"][own]
        assert np.median(shift) == pytest.approx(chest[0][0] - chest[2][0], abs=2.0)


def test_the_same_footage_gives_the_same_steps_byte_for_byte() -> None:
    again, _ = tracked(VIEW, pictures_of(TWO))
    for one, other in zip(steps_of_two(), again, strict=True):
        for table in ("tracks", "tracklets", "detections"):
            mine, theirs = getattr(one, table), getattr(other, table)
            assert all(mine[name].tobytes() == theirs[name].tobytes() for name in mine)


def test_somebody_who_stands_still_is_followed_on_and_has_the_same_id_after() -> None:
    walk = straight((-1.4, 4.2), (0.9, 0.0), 18)
    way = np.concatenate((walk, np.repeat(walk[-1:], 25, axis=0), walk[-1] + (walk - walk[0])))
    steps, _ = tracked(VIEW, pictures_of([way]))
    before, standing, after = steps[17], steps[40], steps[58]
    ids = [set(step.tracks["track"].tolist()) for step in (before, standing, after)]
    assert ids[0] == ids[1] == ids[2]
    assert len(ids[0]) == 1


def test_what_never_moves_is_nobody() -> None:
    standing = drawn(FLOOR, VIEW, [(0.3, 4.0, 11)])
    steps, _ = tracked(VIEW, [standing] * 20)
    assert not any(len(step.tracks["track"]) for step in steps)


def test_a_shadow_that_moves_with_its_person_is_no_second_one() -> None:
    pictures = []
    for x, y in TWO[0]:
        picture = FLOOR.copy()
        corners = np.array([[x + a, y + b, 0.0] for a in (0.2, 1.4) for b in (-0.2, 0.2)])
        left, top = VIEW.pixel_from_world(corners).min(axis=0).astype(int)
        right, bottom = VIEW.pixel_from_world(corners).max(axis=0).astype(int)
        dark = picture[top:bottom, max(left, 0) : right]
        dark[:] = (dark * 0.55).astype(np.uint8)
        pictures.append(drawn(picture, VIEW, [(x, y, 10)]))
    steps, _ = tracked(VIEW, pictures)
    assert {len(step.tracks["track"]) for step in steps[14:]} == {1}


def test_who_has_left_the_picture_is_let_go_within_a_second() -> None:
    way = straight((0.8, 4.0), (1.3, 0.0), 40)
    steps, _ = tracked(VIEW, pictures_of([way]))
    edge = VIEW.pixel_from_world(np.column_stack((way, np.full(40, 1.2))))[:, 0]
    out = int(np.flatnonzero(edge > 700)[0])
    assert any(len(step.tracks["track"]) for step in steps)
    assert not any(len(step.tracks["track"]) for step in steps[out + 10 :])


def test_who_stops_for_a_moment_behind_a_pillar_keeps_the_id() -> None:
    walk = straight((-1.5, 4.5), (1.0, 0.0), 16)
    way = np.concatenate((walk, np.repeat(walk[-1:], 7, axis=0), walk[-1] + (walk - walk[0])))
    left, right = (
        int(VIEW.pixel_from_world(np.array([[x, 4.5, 1.0]]))[0, 0]) for x in (-0.35, 0.35)
    )
    floor = FLOOR.copy()
    floor[:, left:right] = 90
    pictures = pictures_of([way])
    for picture in pictures:
        picture[:, left:right] = 90
    patient = parse_settings(
        tracker_named("flow"), {"delete_in_view_s": "3", "delete_after_s": "3"}
    )
    steps, _ = tracked(VIEW, pictures, patient, floor)
    before, after = steps[10].tracks["track"], steps[-2].tracks["track"]
    assert before.tolist() == after.tolist()
    assert len(after) == 1


def test_an_empty_scene_has_no_tracks() -> None:
    steps, tracker = tracked(VIEW, [FLOOR] * 10)
    assert not any(len(step.tracks["track"]) for step in steps)
    assert tracker.notes == ()


def test_a_camera_that_was_moved_is_told_with_its_frame_in_one_line() -> None:
    moved = np.roll(FLOOR, (12, -20), axis=(0, 1))
    _, tracker = tracked(VIEW, [FLOOR] * 15 + [moved] * 15)
    assert len(tracker.notes) == 1
    assert tracker.notes[0].startswith("frame 19: the camera was moved")
    assert tracker.notes[0].values == {"frame": 19}  # so it can be told in any language
    assert "\n" not in tracker.notes[0]


def test_tracking_goes_on_with_corrected_people_and_new_ids_are_higher() -> None:
    perception, tracker = flow_pair(VIEW)
    perception.learn([frame_of(0, FLOOR)] * 2)
    pictures = pictures_of(TWO)
    rows = {name: np.zeros(16, kind) for name, kind in CORRECTED_COLUMNS.items()}
    rows["frame"] = np.arange(16, dtype=np.int32)
    rows["track"] = np.full(16, 7, np.int32)
    rows["x"], rows["y"] = TWO[0][:16].T
    rows["width"], rows["height"] = np.full(16, 30.0), np.full(16, 90.0)
    rows["visibility"] = np.ones(16, np.float32)
    resume = Resume.of(TrackTable(rows), 16, FPS)
    looks = [perception.observe(frame_of(n, pictures[n])) for n in resume.colour_frames]
    tracker.resume(resume, looks)
    steps = [tracker.step(perception.observe(frame_of(n, pictures[n]))) for n in range(16, FRAMES)]
    for step in steps:
        own = int(np.flatnonzero(step.tracks["track"] == 7)[0])
        assert np.hypot(*(places(step)[own] - TWO[0][step.frame])) < 0.35
    assert {int(track) for track in steps[-1].tracks["track"]} == {7, 8}


def test_without_calibration_it_is_told_what_still_works(tmp_path) -> None:
    import cv2

    from tracking.recording import open_recording

    for number in range(3):
        cv2.imwrite(str(tmp_path / f"{number}.png"), clothes(number))
    (tmp_path / "recording.toml").write_text(
        'format = 1\nname = "bare"\nfps = 10.0\n[left]\nsource = "*.png"\n'
    )
    recording: Recording = open_recording(tmp_path)
    with pytest.raises(CalibrationError, match=r"flow needs one.*three-part") as told:
        require(tracker_named("flow"), recording)
    assert "\n" not in str(told.value)
    recording.close()
