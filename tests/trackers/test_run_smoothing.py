from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from people_on_a_floor import FPS, straight, view

from tracking.geometry import View
from tracking.trackers import smooth_run, tracker_named
from tracking.trackers.shared import run_smoother
from tracking.tracks import Run
from tracking.tracks.columns import DETECTION_COLUMNS, TRACK_COLUMNS, empty
from tracking.tracks.run import Particles

VIEW = view()
CEILING = view(2.7, 90.0)
FRAMES = 100
SIDES = ("left", "top", "width", "height")
VELOCITY = (0.6, -0.4)


def walk(
    start: tuple[float, float] = (-1.0, 6.0), track: int = 1, seen_by: View = VIEW
) -> dict[str, NDArray]:
    """The rows of somebody who walks straight and is seen without error in every frame."""
    place = straight(start, VELOCITY, FRAMES)
    box = seen_by.box_of_person(place, 1.7, 0.5)
    values = {
        "frame": np.arange(FRAMES),
        "track": np.full(FRAMES, track),
        **dict(zip(SIDES, box.T, strict=True)),
        "x": place[:, 0],
        "y": place[:, 1],
        "vx": np.full(FRAMES, VELOCITY[0]),
        "vy": np.full(FRAMES, VELOCITY[1]),
        "confidence": np.ones(FRAMES),
        "visibility": np.ones(FRAMES),
        "predicted": np.zeros(FRAMES),
    }
    return {name: values[name].astype(dtype) for name, dtype in TRACK_COLUMNS.items()}


def run_of(*people: Mapping[str, NDArray], detections: Mapping[str, NDArray] | None = None) -> Run:
    joined = {name: np.concatenate([rows[name] for rows in people]) for name in TRACK_COLUMNS}
    order = np.lexsort((joined["track"], joined["frame"]))
    return Run(
        tracker="stereo-direction",
        settings={"smooth": True},
        seed=0,
        frames=(0, FRAMES),
        tracks={name: column[order] for name, column in joined.items()},
        detections=detections or empty(DETECTION_COLUMNS),
        particles=Particles(np.zeros(FRAMES + 1, np.int64), {}),
    )


def astray(rows: Mapping[str, NDArray], frames: slice) -> dict[str, NDArray]:
    """The same person only predicted in some frames, ever farther from where they are."""
    rows = {name: column.copy() for name, column in rows.items()}
    rows["predicted"][frames] = True
    drift = np.linspace(0.05, 1.0, len(rows["x"][frames]))
    rows["x"][frames] += drift
    rows["left"][frames] += 60 * drift
    rows["vx"][frames] = 1.5
    return rows


def boxes(run: Run) -> NDArray:
    return np.stack([run.tracks[name] for name in SIDES], axis=1)


def places(run: Run) -> NDArray:
    return np.stack((run.tracks["x"], run.tracks["y"]), axis=1)


def test_a_predicted_stretch_between_two_measured_ones_leads_along_the_way():
    truth = run_of(walk())
    found = smooth_run(run_of(astray(walk(), slice(40, 60))), VIEW, FPS)
    assert places(found) == pytest.approx(places(truth), abs=0.005)
    assert found.tracks["vx"] == pytest.approx(np.full(FRAMES, VELOCITY[0]), abs=0.01)
    assert boxes(found) == pytest.approx(boxes(truth), abs=2.0)


def test_ids_frames_and_what_is_predicted_stay():
    run = run_of(astray(walk(), slice(40, 60)), walk((1.0, 7.0), track=2))
    found = smooth_run(run, VIEW, FPS)
    for name in ("frame", "track", "predicted", "confidence", "visibility"):
        assert found.tracks[name].tobytes() == run.tracks[name].tobytes()
    assert {name: column.dtype for name, column in found.tracks.items()} == dict(TRACK_COLUMNS)


def test_the_run_itself_its_particles_and_detections_are_not_touched():
    run = run_of(astray(walk(), slice(40, 60)))
    before = {name: column.copy() for name, column in run.tracks.items()}
    found = smooth_run(run, VIEW, FPS)
    assert all((run.tracks[name] == column).all() for name, column in before.items())
    assert replace(found, tracks=run.tracks) == run


@pytest.mark.parametrize("name", ["stereo-colour", "stereo-direction"])
def test_a_run_as_published_stays_as_it_was_live(name: str):
    run = replace(run_of(astray(walk(), slice(40, 60))), tracker=name)
    published = replace(run, settings={"smooth": True, "paper": True})
    finish = tracker_named(name).finisher.finish
    assert finish(published, VIEW, FPS, None) is published
    assert places(finish(run, VIEW, FPS, None)) == pytest.approx(places(run_of(walk())), abs=0.005)


def test_a_clean_track_stays_as_it_is():
    run = run_of(walk())
    found = smooth_run(run, VIEW, FPS)
    assert places(found) == pytest.approx(places(run), abs=0.002)
    assert boxes(found) == pytest.approx(boxes(run), abs=1.5)


def swinging(rows: Mapping[str, NDArray], px: float) -> dict[str, NDArray]:
    """The same person, whose arm reaches out to the right twice a second."""
    rows = {name: column.copy() for name, column in rows.items()}
    rows["width"] += (px * np.sin(2 * np.pi * 2 * np.arange(FRAMES) / FPS) ** 2).astype(np.float32)
    return rows


def detections_of(*people: Mapping[str, NDArray]) -> dict[str, NDArray]:
    rows = {
        name: np.concatenate([one.get(name, np.zeros(FRAMES)) for one in people]).astype(dtype)
        for name, dtype in DETECTION_COLUMNS.items()
    }
    order = np.argsort(rows["frame"], kind="stable")
    return {name: column[order] for name, column in rows.items()}


def test_limbs_are_followed_where_nobody_else_is_near():
    person = swinging(walk(), 12.0)
    found = smooth_run(run_of(person, detections=detections_of(person)), VIEW, FPS)
    assert boxes(found)[10:-10] == pytest.approx(boxes(run_of(person))[10:-10], abs=2.0)


def test_sides_beside_somebody_else_are_drawn_to_the_outline():
    person, other = swinging(walk(), 12.0), walk((-0.7, 6.0), track=2)
    run = run_of(person, other, detections=detections_of(person, other))
    found = smooth_run(run, VIEW, FPS)
    own = found.tracks["track"] == 1
    before, after = (
        (each.tracks["left"] + each.tracks["width"] - 80 * each.tracks["x"])[own]
        for each in (run, found)
    )
    assert np.diff(after)[10:-10].std() < 0.8 * np.diff(before)[10:-10].std()


def test_a_body_that_leans_ever_differently_under_a_ceiling_camera_keeps_its_boxes():
    run = run_of(walk((-1.5, 1.0), seen_by=CEILING))
    found = smooth_run(run, CEILING, FPS)
    assert boxes(found) == pytest.approx(boxes(run), abs=6.0)


@pytest.mark.parametrize("frames", [slice(30, 31), slice(30, 33), slice(30, 35)])
def test_a_box_of_two_people_in_a_few_frames_is_drawn_to_the_outline(frames: slice):
    person = walk()
    truth = boxes(run_of(person))
    person["left"][frames] -= 50
    person["width"][frames] += 50
    found = boxes(smooth_run(run_of(person), VIEW, FPS))
    assert found == pytest.approx(truth, abs=3.0)


def test_the_swing_of_walking_stays_in_the_box():
    person = walk()
    swing = 3.0 * np.sin(np.arange(FRAMES) * (2 * np.pi / 10))
    person["left"] -= swing
    person["width"] += 2 * swing
    found = smooth_run(run_of(person), VIEW, FPS).tracks["width"]
    assert np.std(found - person["width"]) < 0.3 * np.std(2 * swing)


def test_noise_of_measured_places_is_smoothed_from_the_detections():
    random = np.random.default_rng(3)
    person = walk()
    seen = {name: person[name].copy() for name in ("frame", "track", *SIDES, "x", "y")}
    seen["x"] += random.normal(0, 0.1, FRAMES)
    seen["y"] += random.normal(0, 0.1, FRAMES)
    late = {**person, "x": person["x"] - 0.2}
    run = run_of(late, detections={**seen, "z": np.zeros(FRAMES)})
    off = np.hypot(*(places(smooth_run(run, VIEW, FPS)) - places(run_of(person))).T)
    assert off.mean() < 0.07


def test_rows_after_the_last_match_stay_to_the_last_byte():
    person = {name: column[:80].copy() for name, column in walk().items()}
    person["predicted"][60:] = True
    person["left"][60:] -= 30.0 * np.arange(20)
    run = run_of(person)
    found = smooth_run(run, VIEW, FPS)
    for name in TRACK_COLUMNS:
        assert found.tracks[name][60:].tobytes() == run.tracks[name][60:].tobytes()


def test_somebody_still_followed_when_the_footage_ends_is_kept():
    run = run_of(astray(walk(), slice(60, 100)))
    found = smooth_run(run, VIEW, FPS)
    assert found.tracks["frame"].tolist() == list(range(FRAMES))
    assert found.tracks["x"][60:].tobytes() == run.tracks["x"][60:].tobytes()


def test_people_without_a_place_on_the_floor_are_left_alone():
    nowhere = astray(walk(track=2), slice(40, 60))
    nowhere["x"][:] = nowhere["y"][:] = np.nan
    run = run_of(astray(walk(), slice(40, 60)), nowhere)
    found = smooth_run(run, VIEW, FPS)
    theirs = run.tracks["track"] == 2
    for name in TRACK_COLUMNS:
        assert found.tracks[name][theirs].tobytes() == run.tracks[name][theirs].tobytes()
    assert (
        smooth_run(run_of(nowhere), VIEW, FPS).tracks["left"].tolist() == nowhere["left"].tolist()
    )


def test_a_track_that_was_only_predicted_and_a_run_of_nobody_stay():
    ghost = run_of(astray(walk(), slice(0, 100)))
    assert smooth_run(ghost, VIEW, FPS).tracks["x"].tolist() == ghost.tracks["x"].tolist()
    nobody = replace(ghost, tracks=empty(TRACK_COLUMNS))
    assert len(smooth_run(nobody, VIEW, FPS).tracks["frame"]) == 0


def test_a_person_seen_once_stays():
    once = {name: column[50:51] for name, column in walk().items()}
    found = smooth_run(run_of(once), VIEW, FPS)
    assert found.tracks["x"] == pytest.approx(once["x"])
    assert found.tracks["vx"] == pytest.approx(once["vx"])


def test_a_path_begins_at_the_rows_given_and_leaves_them_out():
    """The run's own first places are off; without what came before it would begin there."""
    whole = walk()
    given = {name: column[:50] for name, column in whole.items()}
    late = {name: column[50:].copy() for name, column in whole.items()}
    truth = late["x"].copy()
    late["x"][:4] += 0.1
    run = replace(run_of(late), frames=(50, FRAMES))
    alone, tied = smooth_run(run, VIEW, FPS), smooth_run(run, VIEW, FPS, given)
    assert tied.tracks["frame"].tolist() == list(range(50, FRAMES))
    assert abs(tied.tracks["x"][0] - truth[0]) < 0.5 * abs(alone.tracks["x"][0] - truth[0])


def test_somebody_hidden_where_the_run_begins_walks_on_from_the_rows_given():
    whole = astray(walk(), slice(50, 70))
    given = {name: column[:50] for name, column in walk().items()}
    late = {name: column[50:] for name, column in whole.items()}
    tied = smooth_run(replace(run_of(late), frames=(50, FRAMES)), VIEW, FPS, given)
    np.testing.assert_allclose(tied.tracks["x"], walk()["x"][50:], atol=0.02)


@pytest.mark.parametrize("rows", [1, 150, 250])
def test_tracks_smoothed_some_at_a_time_are_the_same_to_the_byte(
    monkeypatch: pytest.MonkeyPatch, rows: int
):
    people = [
        astray(walk((0.7 * track - 1.0, 6.0), track), slice(30, 40 + track)) for track in (1, 2, 3)
    ]
    whole = smooth_run(run_of(*people), VIEW, FPS)
    monkeypatch.setattr(run_smoother, "_BATCH_ROWS", rows)
    parts = smooth_run(run_of(*people), VIEW, FPS)
    for name, column in whole.tracks.items():
        assert parts.tracks[name].tobytes() == column.tobytes()
