"""Trackers that go on from corrected tracks."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest
from people_on_a_floor import FPS, Errors, Walker, observations, straight, view

from tracking.errors import SettingsError
from tracking.trackers import Resume, StepResult
from tracking.trackers.stereo.colour import HalvesOfFirstFrames, StereoColourSettings
from tracking.trackers.stereo.direction import MiddleUpdated, StereoDirectionSettings
from tracking.trackers.stereo.tracker import StereoTracker
from tracking.tracks import CORRECTED_COLUMNS, Columns, TrackTable

CUT = 60
QUIET = Errors(noise_m=0.02)


def direction_tracker(seed: int = 0) -> StereoTracker:
    settings = StereoDirectionSettings(particles=200)
    return StereoTracker(view(), settings, MiddleUpdated(settings), seed)


def colour_tracker(seed: int = 0) -> StereoTracker:
    settings = StereoColourSettings(particles=200)
    return StereoTracker(view(), settings, HalvesOfFirstFrames(settings), seed)


both_trackers = pytest.mark.parametrize("tracker", [direction_tracker, colour_tracker])


def rows_of(people: dict[int, Walker], frames: range) -> dict[str, np.ndarray]:
    """Corrected rows of people who are where they are."""
    there = sorted(
        (frame, track)
        for track, walker in people.items()
        for frame in frames
        if np.isfinite(walker.path[frame]).all()
    )
    rows = {name: np.zeros(len(there), dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    place = np.array([people[track].path[frame] for frame, track in there])
    rows["frame"][:], rows["track"][:] = np.array(there).T
    rows["x"][:], rows["y"][:] = place.T
    for name, side in zip(
        ("left", "top", "width", "height"), view().box_of_person(place, 1.7, 0.5).T, strict=True
    ):
        rows[name][:] = side
    rows["vx"][:] = rows["vy"][:] = np.nan
    rows["confidence"][:] = rows["visibility"][:] = 1.0
    return rows


def table_of(people: dict[int, Walker], frames: range, highest: int = 0) -> TrackTable:
    return TrackTable(rows_of(people, frames), highest_track=highest)


def again(
    make: Callable[[int], StereoTracker],
    table: TrackTable,
    walkers: Sequence[Walker],
    seed: int = 0,
    cut: int = CUT,
) -> list[StepResult]:
    """What the tracker finds from the cut on."""
    seen = list(observations(walkers, 1, QUIET))
    resume = Resume.of(table, cut, FPS)
    tracker = make(seed)
    tracker.resume(resume, (seen[frame] for frame in resume.colour_frames))
    return [tracker.step(each) for each in seen[cut:]]


def track_at(result: StepResult, place: np.ndarray) -> int:
    away = np.hypot(result.tracks["x"] - place[0], result.tracks["y"] - place[1])
    assert away.min() < 0.3
    return int(result.tracks["track"][away.argmin()])


CROSSING = [
    Walker(straight((-3, 6), (1, 0), 140), 2),
    Walker(straight((3, 6.5), (-1, 0), 140), 9),
]


@both_trackers
def test_people_go_on_under_their_corrected_ids_from_the_first_frame(tracker):
    people = {41: CROSSING[0], 7: CROSSING[1]}
    results = again(tracker, table_of(people, range(140)), CROSSING)
    for frame, result in enumerate(results, CUT):
        assert result.tracks["track"].tolist() == [7, 41]
        for track, walker in people.items():
            assert track_at(result, walker.path[frame]) == track


@both_trackers
def test_the_velocity_of_rows_without_one_is_that_of_the_walk(tracker):
    first = again(tracker, table_of({1: CROSSING[0]}, range(140)), CROSSING[:1])[0]
    assert first.tracks["vx"][0] == pytest.approx(1.0, abs=0.15)
    assert first.tracks["vy"][0] == pytest.approx(0.0, abs=0.15)


def test_rows_that_have_a_velocity_go_on_with_it():
    rows = rows_of({1: CROSSING[0]}, range(CUT))
    rows["vx"][:], rows["vy"][:] = 0.9, 0.0
    people = resumed_people(TrackTable(rows), CROSSING[:1])
    np.testing.assert_array_equal(people.velocity, [[0.9, 0.0]])


def resumed_people(table: TrackTable, walkers: Sequence[Walker]):
    seen = list(observations(walkers, 1, QUIET))
    resume = Resume.of(table, CUT, FPS)
    tracker = direction_tracker()
    tracker.resume(resume, (seen[frame] for frame in resume.colour_frames))
    assert tracker._people is not None
    return tracker._people


@both_trackers
def test_somebody_new_gets_an_id_above_the_highest_ever_used(tracker):
    late = Walker(np.where(np.arange(140)[:, None] < 90, np.nan, straight((0, 4), (0, 0.2), 140)))
    table = table_of({3: CROSSING[0]}, range(CUT), highest=20)
    results = again(tracker, table, [CROSSING[0], late])
    assert results[-1].tracks["track"].tolist() == [3, 21]


@both_trackers
def test_the_same_seed_goes_on_to_the_same_bytes(tracker):
    table = table_of({1: CROSSING[0], 2: CROSSING[1]}, range(CUT))
    one, two, other = (again(tracker, table, CROSSING, seed)[-1] for seed in (4, 4, 5))
    for name, column in one.particles.items():
        assert column.tobytes() == two.particles[name].tobytes()
    assert one.particles["x"].tobytes() != other.particles["x"].tobytes()


@both_trackers
def test_swapped_tracks_stay_as_the_person_put_them_right(tracker):
    """Whose colours they are is learnt from before the cut, not from who is nearest."""
    table = table_of({1: CROSSING[1], 2: CROSSING[0]}, range(CUT))
    last = again(tracker, table, CROSSING)[-1]
    assert track_at(last, CROSSING[0].path[-1]) == 2
    assert track_at(last, CROSSING[1].path[-1]) == 1


def test_colours_are_those_of_the_detections_where_the_person_stood():
    table = table_of({1: CROSSING[0], 2: CROSSING[1]}, range(CUT))
    people = resumed_people(table, CROSSING)
    assert people.track.tolist() == [1, 2]
    assert people.colour[:, 0].argmax(axis=1).tolist() == [2, 9]


def test_good_views_from_earlier_tell_more_than_bad_ones_of_late():
    """Of late somebody of another colour stood in front, so that only they were seen."""
    hidden = Walker(straight((0, 8), (0, 0), CUT), 2)
    front = Walker(straight((0, 8.05), (0, 0), CUT), 9)
    rows = rows_of({1: hidden}, range(CUT))
    late = rows["frame"] >= CUT - 25
    rows["visibility"][late] = 0.2
    seen = [*list(observations([hidden], 1, QUIET))[: CUT - 25]]
    seen += list(observations([front], 1, QUIET))[CUT - 25 :]
    resume = Resume.of(TrackTable(rows), CUT, FPS)
    assert min(resume.colour_frames) < CUT - 25
    tracker = direction_tracker()
    tracker.resume(resume, (seen[frame] for frame in resume.colour_frames))
    assert tracker._people.colour[0, 0].argmax() == 2


@both_trackers
def test_somebody_hidden_is_started_where_the_table_says(tracker):
    walker = Walker(straight((-2, 7), (0.5, 0), 140), 4)
    rows = rows_of({5: walker}, range(CUT + 30))
    unseen = rows["frame"] >= CUT - 10
    rows["predicted"][unseen], rows["visibility"][unseen] = True, 0.0
    unseen_path = walker.path.copy()
    unseen_path[CUT - 10 : CUT + 5] = np.nan
    results = again(tracker, TrackTable(rows), [replace(walker, path=unseen_path)])
    assert results[0].tracks["predicted"].tolist() == [True]
    assert track_at(results[0], walker.path[CUT]) == 5
    assert results[-1].tracks["track"].tolist() == [5]


@both_trackers
def test_somebody_in_a_gap_who_comes_back_is_waited_for(tracker):
    walker = Walker(straight((-2, 7), (0.5, 0), 140), 4)
    people = rows_of({5: walker}, range(140))
    there = (people["frame"] < CUT - 8) | (people["frame"] >= CUT + 8)
    table = TrackTable({name: column[there] for name, column in people.items()})
    gap = walker.path.copy()
    gap[CUT - 8 : CUT + 8] = np.nan
    results = again(tracker, table, [replace(walker, path=gap)])
    assert results[-1].tracks["track"].tolist() == [5]


def test_somebody_who_ended_before_is_not_followed_on():
    table = table_of({1: CROSSING[0], 2: Walker(CROSSING[1].path[: CUT - 1])}, range(CUT - 1))
    table = TrackTable(joined(table.columns(), rows_of({1: CROSSING[0]}, range(CUT - 1, CUT))))
    assert np.unique(Resume.of(table, CUT, FPS).rows["track"]).tolist() == [1]


def joined(one: Columns, other: Columns) -> dict[str, np.ndarray]:
    return {name: np.concatenate([one[name], other[name]]) for name in CORRECTED_COLUMNS}


def test_rows_drawn_without_metres_are_placed_below_their_box():
    rows = rows_of({1: CROSSING[0]}, range(CUT))
    rows["x"][-3:] = rows["y"][-3:] = np.nan
    people = resumed_people(TrackTable(rows), CROSSING[:1])
    np.testing.assert_allclose(people.position, [CROSSING[0].path[CUT - 1]], atol=0.3)


@both_trackers
def test_nobody_in_the_table_is_nobody_to_go_on_with(tracker):
    results = again(tracker, TrackTable(), CROSSING)
    assert results[0].tracks["track"].tolist() == []
    assert results[-1].tracks["track"].tolist() == [1, 2]


def test_there_is_nothing_to_go_on_from_before_the_first_frame():
    with pytest.raises(SettingsError, match="frame 0: nothing stands before it"):
        Resume.of(TrackTable(), 0, FPS)


def test_only_the_rows_that_are_needed_are_kept():
    standing = Walker(straight((0, 6), (0, 0), 2000))
    table = table_of({1: standing}, range(2000))
    resume = Resume.of(table, 1500, FPS)
    assert len(resume.rows["frame"]) == 40
    assert resume.colour_frames == tuple(range(1480, 1500))
    assert resume.last(0.5)["frame"].tolist() == list(range(1490, 1500))
