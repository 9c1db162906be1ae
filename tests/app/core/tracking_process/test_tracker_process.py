import io
import os
import signal
import subprocess
import sys
import threading
import time
import traceback
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from patient import PATIENCE_S

sys.path.insert(0, str(Path(__file__).parents[3] / "networks"))

from small_networks import bright_rectangles, written

from app.core.tracking_process import TrackerProcess, TrackingRequest, child
from app.core.tracking_process.messages import (
    Kind,
    TrackerBug,
    packed_error,
    packed_notes,
    packed_steps,
    receive,
    unpacked_error,
    unpacked_notes,
    unpacked_steps,
)
from tracking.errors import CalibrationError, RecordingError, TrackwrightError
from tracking.pipeline import Tracking, run_of_steps, track
from tracking.recording import OpenOptions, open_recording
from tracking.trackers import Resume, parse_settings, tracker_named
from tracking.tracks import DetectionsInput, TrackTable

TRACKER = "stereo-direction"
FRAMES = (30, 42)


@pytest.fixture
def request_(tiny_recording):
    with open_recording(tiny_recording) as recording:
        return TrackingRequest.of(recording, TRACKER, None, 7, FRAMES)


def _in_this_process(recording):
    with track(recording, TRACKER, None, 7, FRAMES) as tracking:
        steps = list(tracking)
        return steps, tracking.run()


def _tables(run):
    yield from (run.tracks, run.detections, run.particles.columns, run.associations, run.signals)
    yield from (run.parts, run.part_particles.columns, run.tracklets.columns)
    yield from (run.network_boxes.columns, {"network_start": run.network_boxes.start})
    yield {"start": run.particles.start, "part_start": run.part_particles.start}
    yield {"tracklet_start": run.tracklets.start}


def _assert_same_runs(one, other):
    for mine, theirs in zip(_tables(one), _tables(other), strict=True):
        assert list(mine) == list(theirs)
        for name in mine:
            assert mine[name].dtype == theirs[name].dtype, name
            assert mine[name].tobytes() == theirs[name].tobytes(), name
    assert (one.tracker, dict(one.settings), one.seed, one.frames, one.software) == (
        other.tracker,
        dict(other.settings),
        other.seed,
        other.frames,
        other.software,
    )


def _by_child(request, recording):
    steps = [step for batch in TrackerProcess(request).batches() for step in batch]
    return run_of_steps(
        steps, request.tracker, request.settings, request.seed, steps[0].frame, recording
    )


def test_a_child_gives_the_very_run_that_tracking_in_this_process_gives(tiny_recording, request_):
    with open_recording(tiny_recording) as recording:
        _, here = _in_this_process(recording)
        assert len(here.tracks["frame"]) > 0
        _assert_same_runs(_by_child(request_, recording), here)


def test_bare_cameras_with_options_are_tracked_alike(tiny_recording, tmp_path):
    (tmp_path / "rig").mkdir()
    for name in ("left.mp4", "right.mp4", "calibration.yaml"):
        (tmp_path / "rig" / name).write_bytes((tiny_recording / name).read_bytes())
    rig = tmp_path / "rig"
    options = OpenOptions(
        left=rig / "left.mp4",
        right=rig / "right.mp4",
        calibration=(rig / "calibration.yaml",),
        height_m=6.4,
        tilt_deg=60.0,
    )
    with open_recording(rig / "left.mp4", options) as recording:
        _, here = _in_this_process(recording)
        request = TrackingRequest.of(recording, TRACKER, None, 7, FRAMES)
        assert len(here.tracks["frame"]) > 0
        _assert_same_runs(_by_child(request, recording), here)


def test_a_request_is_the_same_after_its_way_through_a_line(request_):
    assert TrackingRequest.from_line(request_.as_line()) == request_


def test_steps_are_the_same_after_their_way_through_bytes(tiny_recording):
    with open_recording(tiny_recording) as recording:
        steps, _ = _in_this_process(recording)
    for step, again in zip(steps, unpacked_steps(packed_steps(steps)), strict=True):
        assert again.frame == step.frame
        for name, column in step.particles.items():
            np.testing.assert_array_equal(again.particles[name], column)


def test_what_the_tracker_says_is_wrong_comes_across_as_the_same_error(request_):
    gone = replace(request_, folder=str(Path(request_.folder) / "gone"))
    with pytest.raises(RecordingError, match="gone"):
        list(TrackerProcess(gone).batches())


def test_a_bug_comes_across_with_its_trace():
    trace = "Traceback ...\n  in step\nZeroDivisionError: by zero\n"
    bug = unpacked_error(packed_error(ZeroDivisionError("by zero"), trace))
    assert isinstance(bug, TrackerBug)
    assert str(bug) == "ZeroDivisionError: by zero"
    assert trace in "".join(traceback.format_exception(bug))
    ours = unpacked_error(packed_error(CalibrationError("no floor", "say where"), ""))
    assert (type(ours), ours.reason, ours.to_do) == (CalibrationError, "no floor", "say where")


def test_a_child_that_dies_is_told_in_a_line(request_):
    process = TrackerProcess(replace(request_, frames=None))
    batches = process.batches()
    next(batches)
    os.kill(process.pid, signal.SIGTERM)
    with pytest.raises(TrackwrightError, match="ended by itself"):
        list(batches)


def test_stopping_ends_after_the_frame_in_work_and_keeps_what_was_tracked(request_):
    process, steps = TrackerProcess(replace(request_, frames=None)), []
    for batch in process.batches():
        steps += batch
        process.stop()
    assert [step.frame for step in steps] == list(range(len(steps)))
    assert 0 < len(steps) < 80


def test_killing_before_the_beginning_begins_nothing(request_):
    process = TrackerProcess(request_)
    process.kill()
    assert list(process.batches()) == []


PARENT = """
import sys
from app.core.tracking_process import TrackerProcess, TrackingRequest
process = TrackerProcess(TrackingRequest.from_line(sys.stdin.buffer.readline()))
for batch in process.batches():
    print(process.pid, flush=True)
    sys.stdin.read()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="asks the system by signal 0")
def test_a_child_ends_when_its_parent_is_killed(request_):
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    parent.stdin.write(replace(request_, frames=None).as_line())
    parent.stdin.flush()
    child = int(parent.stdout.readline())
    parent.kill()
    parent.wait()
    parent.stdin.close()
    parent.stdout.close()
    until_s = time.monotonic() + PATIENCE_S
    while _lives(child) and time.monotonic() < until_s:
        time.sleep(0.01)
    assert not _lives(child)


def _lives(pid):
    """A process that has ended but was not asked for by anybody (a zombie) does not live."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    state = Path(f"/proc/{pid}/stat")
    return not (state.exists() and state.read_text().rsplit(")", 1)[1].split()[0] == "Z")


@pytest.fixture
def resume(tiny_run):
    busiest = int(np.bincount(tiny_run.tracks["frame"][tiny_run.tracks["frame"] < 70]).argmax())
    return Resume.of(TrackTable(tiny_run.tracks), busiest + 1, 8.0)


def test_a_child_goes_on_from_corrected_tracks_as_this_process_does(tiny_recording, resume):
    frames = (resume.frame, resume.frame + 8)
    with open_recording(tiny_recording) as recording:
        with track(recording, TRACKER, None, 7, frames, resume) as tracking:
            list(tracking)
            here = tracking.run()
        request = TrackingRequest.of(recording, TRACKER, None, 7, frames, resume)
        steps = [step for batch in TrackerProcess(request).batches() for step in batch]
        there = run_of_steps(steps, TRACKER, request.settings, 7, frames[0], recording, resume)
        assert len(here.tracks["frame"]) > 0
        _assert_same_runs(there, here)
        assert here.known_tracks == there.known_tracks == resume.highest_track > 0


def test_what_to_go_on_from_is_the_same_after_its_way_through_a_line(request_, resume):
    resume.rows["vx"][0] = np.nan
    back = TrackingRequest.from_line(replace(request_, resume=resume).as_line()).resume
    assert (back.frame, back.colour_frames, back.highest_track, back.fps) == (
        resume.frame,
        resume.colour_frames,
        resume.highest_track,
        resume.fps,
    )
    for name, column in resume.rows.items():
        assert back.rows[name].dtype == column.dtype
        assert back.rows[name].tobytes() == column.tobytes()


def test_notes_are_the_same_on_the_other_side():
    notes = ("Lobby: no distance for what moves: are the cameras swapped?", "\u00fc")
    assert unpacked_notes(packed_notes(notes)) == notes


def test_what_there_is_to_tell_of_a_tracking_is_known_at_its_end(tiny_recording):
    with open_recording(tiny_recording) as recording:
        ground = recording.ground
    cameras = OpenOptions(
        left=tiny_recording / "right.mp4",
        right=tiny_recording / "left.mp4",
        calibration=(tiny_recording / "calibration.yaml",),
        height_m=ground.height_m,
        tilt_deg=ground.tilt_deg,
    )
    with open_recording(tiny_recording, cameras) as swapped:
        process = TrackerProcess(TrackingRequest.of(swapped, TRACKER, None, 7, None))
        for _ in process.batches():
            assert process.notes == ()
    assert "are the cameras swapped?" in process.notes[0]


def test_a_child_sends_what_was_tracked_before_a_bug(request_, monkeypatch):
    following = Tracking.__next__

    def next_step(tracking):
        if tracking.done == 2:
            raise ZeroDivisionError("by nothing")
        return following(tracking)

    monkeypatch.setattr(Tracking, "__next__", next_step)
    answers = io.BytesIO()
    with pytest.raises(ZeroDivisionError):
        child._track(request_, answers, threading.Event())
    answers.seek(0)
    sent = [payload for kind, payload in iter(lambda: receive(answers), None) if kind is Kind.STEPS]
    assert sum(len(unpacked_steps(payload)) for payload in sent) == 2


def test_the_parent_knows_which_detections_the_child_read(tiny_recording, tmp_path):
    path = tmp_path / "det.txt"
    path.write_text("1,-1,20,40,24,60,0.9\n")
    spec = tracker_named("three-part")
    settings = parse_settings(spec, {"detections.file": str(path)})
    with open_recording(tiny_recording) as recording:
        process = TrackerProcess(TrackingRequest.of(recording, "three-part", settings, 0, (0, 2)))
        assert sum(map(len, process.batches())) == 2
        with track(recording, "three-part", settings, 0, (0, 2)) as tracking:
            list(tracking)
            assert process.detections_input == tracking.run().detections_input
    assert [one.file for one in process.detections_input] == ["det.txt"]
    assert any("1 of 1 boxes" in note for note in process.notes)


def test_a_request_to_go_on_keeps_the_detections_of_the_tracks(tiny_recording, resume):
    given = (DetectionsInput("left", "det.txt", "mot", "ab", 3),)
    resume = replace(resume, detections_input=given)
    with open_recording(tiny_recording) as recording:
        request = TrackingRequest.of(recording, TRACKER, None, 7, None, resume)
    read = TrackingRequest.from_line(request.as_line()).resume
    assert read is not None
    assert read.detections_input == given


def test_a_network_runs_for_the_child_as_for_the_command_line(tiny_recording, tmp_path):
    path = written(tmp_path, bright_rectangles(8, 20), decoder="yolo", classes=["person"])
    settings = parse_settings(tracker_named("three-part"), {"detections.model": str(path)})
    with open_recording(tiny_recording) as recording:
        request = TrackingRequest.of(recording, "three-part", settings, 0, (0, 2))
        process = TrackerProcess(request)
        assert sum(map(len, process.batches())) == 2
    (used,) = process.detections_input
    assert (used.file, used.network, used.licence) == ("people.toml", "test network", "MIT")
    assert any("test network" in note for note in process.notes)


def test_the_child_tells_how_much_of_the_background_is_learnt(request_):
    told = []
    process = TrackerProcess(request_, lambda *share: told.append(share))
    next(iter(process.batches()))
    process.kill()
    assert told == [(done, told[0][1]) for done in range(told[0][1])]
    assert len(told) > 5
