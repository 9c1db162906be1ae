"""Part rectangles, curves and failures as the views are given them."""

from dataclasses import replace

import numpy as np
import pytest
import run_with_parts
import two_people
from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.tracks.frame_state import FrameState
from app.core.tracks.live_tracks import LiveTracks
from app.core.tracks.session_tracks import SessionTracks
from app.features.parts.failures import PartFailures, first_failures
from app.features.parts.part_views import curves_of, curves_scene, part_boxes, verdict_text
from tracking.tracks import PART_COLUMNS


@pytest.fixture(scope="module")
def run():
    return run_with_parts.with_parts(two_people.run())


@pytest.fixture
def tracks(run):
    return SessionTracks(two_people.table(), run)


def _same(ids):
    return lambda _: {one: one for one in ids}


@pytest.mark.parametrize(
    ("failed", "occluded", "score", "said"),
    [
        (False, False, -0.001, "torso: on, +0.00"),
        (False, False, -0.5, "torso: on, -0.50"),
        (True, False, 1.25, "torso: off, +1.25"),
        (True, False, -3.43, "torso: off, by rule"),
        (True, False, float("nan"), "torso: off, by rule"),
        (False, False, float("nan"), "torso: not judged"),
        (False, True, float("nan"), "torso: hidden"),
    ],
)
def test_a_verdict_is_said_in_words_and_figures(failed, occluded, score, said):
    assert verdict_text(1, failed, occluded, score) == said


def test_the_selected_persons_parts_are_drawn_last_the_chosen_one_on_top(tracks):
    first, second = tracks.ids[:2]
    boxes = part_boxes(FrameState(50, tracks, selected=first), 2)
    assert [box.track for box in boxes] == [second] * 3 + [first] * 3
    assert boxes[-1].part == 2
    assert [box.chosen for box in boxes] == [False] * 5 + [True]


def test_a_rectangle_that_is_not_known_is_left_out(run):
    parts = {name: column.copy() for name, column in run.parts.items()}
    parts["cx"][parts["part"] == 0] = np.nan
    tracks = SessionTracks(two_people.table(), replace(run, parts=parts))
    assert {box.part for box in part_boxes(FrameState(50, tracks), 0)} == {1, 2}


def test_curves_say_the_figures_of_the_frame_and_what_to_do_without_any(tracks):
    track = tracks.ids[0]
    curves = curves_of(tracks.parts_of_track(track))
    scene = curves_scene(FrameState(50, tracks, selected=track), curves, 0, 200, 20.0)
    at = int(np.searchsorted(curves[0].frames, 50))
    assert f"score {curves[0].score[at]:+.2f}" in scene.said[0]
    assert f"{curves[0].particles[at]:.0f} particles" in scene.said[0]
    nobody = curves_scene(FrameState(50, tracks), (), 0, 200, 20.0)
    assert nobody.message.startswith("Click a person")
    whole = curves_scene(FrameState(50, tracks, selected=track), (), 0, 200, 20.0)
    assert "three-part" in whole.message


def test_a_tracker_at_work_gives_the_parts_it_has_found_so_far(run):
    live = LiveTracks()
    steps = [_with_parts(step, run) for step in two_people.steps()]
    track = int(run.parts["track"][0])
    live.extend(steps[:60])
    early = live.parts_of_track(track)
    live.extend(steps[60:])
    mine = run.parts["track"] == track
    for name in PART_COLUMNS:
        wanted = run.parts[name][mine]
        assert np.array_equal(early[name], wanted[run.parts["frame"][mine] < 60])
        assert np.array_equal(live.parts_of_track(track)[name], wanted)
    assert np.array_equal(live.parts(70)["track"], steps[70].parts["track"])


def _with_parts(step, run):
    here = run.parts["frame"] == step.frame
    return replace(step, parts={name: column[here] for name, column in run.parts.items()})


@given(
    st.lists(
        st.tuples(st.integers(0, 12), st.integers(1, 2), st.integers(0, 2), st.booleans()),
        unique_by=lambda row: row[:3],
        max_size=40,
    )
)
@settings(deadline=None)
def test_a_failure_begins_where_the_part_had_not_failed_in_the_frame_before(rows):
    parts = _columns(rows)
    begins = first_failures(parts)
    found = {tuple(int(parts[n][row]) for n in ("frame", "track", "part")) for row in begins}
    bad = {row[:3] for row in rows if row[3]}
    assert found == {one for one in bad if (one[0] - 1, *one[1:]) not in bad}


@given(
    st.lists(
        st.tuples(st.integers(0, 12), st.integers(1, 2), st.integers(0, 2), st.booleans()),
        unique_by=lambda row: row[:3],
        max_size=40,
    )
)
@settings(deadline=None)
def test_walking_on_visits_every_failure_once_and_back_again(rows):
    failures = PartFailures(_columns(rows))
    ids, forward, last = _same((1, 2)), [], None
    frame = -1
    while (last := failures.walk(frame, 1, ids, 0, last)) is not None:
        forward.append(last)
        frame = last.frame
    assert len(forward) == len(failures)
    assert forward == sorted(forward, key=lambda one: one.frame)
    back, last = [], forward[-1] if forward else None
    while last is not None:
        back.append(last)
        last = failures.walk(last.frame, -1, ids, 0, last)
    assert back == forward[::-1]


def test_failures_of_somebody_who_was_taken_out_are_passed_over():
    failures = PartFailures(_columns([(3, 1, 0, True), (5, 2, 1, True)]))
    assert failures.walk(0, 1, lambda _: {2: 7}).track == 7
    assert failures.walk(0, 1, lambda _: {2: 7}, track=1) is None


def _columns(rows):
    """`PART_COLUMNS` of (frame, track, part, failed), by frame."""
    ordered = sorted(rows)
    made = {name: np.zeros(len(ordered), kind) for name, kind in PART_COLUMNS.items()}
    for at, name in enumerate(("frame", "track", "part", "failed")):
        made[name][:] = [row[at] for row in ordered]
    return made


def test_a_failure_the_detector_had_not_told_is_one_by_rule(run, tracks):
    parts = {name: column.copy() for name, column in run.parts.items()}
    parts["score"][:] = np.where(parts["failed"], -3.43, -1.0)
    told = PartFailures(parts).walk(-1, 1, _same(tracks.ids))
    assert told.by_rule
    parts["score"][parts["failed"]] = 0.4
    assert not PartFailures(parts).walk(-1, 1, _same(tracks.ids)).by_rule


@pytest.mark.parametrize(
    ("score", "said"),
    [(-3.43, ": score -3.43 in the run, off by rule"), (float("nan"), ": off by rule")],
)
def test_the_figures_say_that_a_rule_called_a_part_failed(run, score, said):
    parts = {name: column.copy() for name, column in run.parts.items()}
    parts["score"][:] = score
    tracks = SessionTracks(two_people.table(), replace(run, parts=parts))
    track = tracks.ids[0]
    curves = curves_of(tracks.parts_of_track(track))
    part = next(number for number, curve in enumerate(curves) if curve.failed.any())
    frame = int(curves[part].frames[curves[part].failed][0])
    scene = curves_scene(FrameState(frame, tracks, selected=track), curves, part, 200, 20.0)
    assert said in scene.said[part]
