from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from tracking.errors import CalibrationError, RecordingError, SettingsError
from tracking.formats import read_mot
from tracking.pipeline import track
from tracking.recording import OpenOptions, Recording, open_recording
from tracking.scoring import BoxMatch, ScoringTable, score
from tracking.synthesis import render_recording
from tracking.trackers import TRACKERS, Resume, best_tracker, parse_settings, tracker_named
from tracking.tracks import Run, TrackTable

FAST = parse_settings(TRACKERS["stereo-joint"], {"particles": "100"})


@pytest.fixture(scope="module")
def rendered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("recordings") / "square"
    render_recording(folder, "square", 6.0, 4, 11)
    return folder


@pytest.fixture(scope="module")
def recording(rendered: Path) -> Recording:
    with open_recording(rendered) as opened:
        yield opened


@pytest.fixture(scope="module")
def whole(recording: Recording) -> Run:
    with track(recording, settings=FAST) as tracking:
        assert [step.frame for step in tracking] == list(range(recording.frame_count))
        return tracking.run()


def arrays(run: Run) -> dict[str, bytes]:
    tables = {
        "t": run.tracks,
        "d": run.detections,
        "p": run.particles.columns,
        "a": run.associations,
        "s": run.signals,
    }
    named = {f"{t}.{name}": column for t, table in tables.items() for name, column in table.items()}
    return {name: column.tobytes() for name, column in named.items()}


def test_people_in_a_rendered_scene_are_found_where_they_are(whole: Run, rendered: Path):
    truth = ScoringTable.from_columns(read_mot(rendered / "truth.txt"), dont_cares=True)
    result = score(truth, ScoringTable.from_columns(whole.tracks), BoxMatch(0.5)).as_json()
    assert result["people_kept"] == result["people_detected"] > 0
    assert result["position_error_m"]["mean"] < 0.2
    assert result["MOTA"] > 0.7


def test_the_same_seed_gives_the_same_run_byte_for_byte(recording: Recording, whole: Run):
    with track(recording, settings=FAST) as tracking:
        list(tracking)
        assert arrays(tracking.run()) == arrays(whole)


def test_particles_of_every_frame_belong_to_the_people_of_that_frame(whole: Run):
    assert len(whole.particles.start) == whole.frames[1] + 1
    filtered: dict[int, list[int]] = {}
    for frame in range(*whole.frames):
        particles = whole.particles.of_frame(frame)
        followed = np.unique(particles["track"]).tolist()
        assert len(particles["x"]) == 100 * len(followed)
        for person in followed:
            filtered.setdefault(person, []).append(frame)
    for person in np.unique(whole.tracks["track"]).tolist():
        told = whole.tracks["frame"][whole.tracks["track"] == person]
        # A finished run tells of people before and after they were followed, too.
        first, last = filtered[person][0], filtered[person][-1]
        assert set(told[(told >= first) & (told <= last)].tolist()) <= set(filtered[person])


def test_without_smoothing_a_run_is_what_the_steps_said(recording: Recording):
    raw = parse_settings(TRACKERS["stereo-joint"], {"particles": "100", "smooth": "false"})
    with track(recording, settings=raw, frames=(40, 80)) as tracking:
        steps = list(tracking)
        run = tracking.run()
    assert run.settings["smooth"] is False
    for name, column in run.tracks.items():
        assert column.tobytes() == b"".join(step.tracks[name].tobytes() for step in steps)


def test_smoothing_changes_the_run_but_not_its_steps(recording: Recording):
    with track(recording, settings=FAST, frames=(40, 80)) as tracking:
        steps = list(tracking)
        before = [step.tracks["x"].tobytes() for step in steps]
        run = tracking.run()
        assert arrays(tracking.run()) == arrays(run)
    assert run.settings["smooth"] is True
    assert run.tracks["x"].tobytes() != b"".join(before)
    assert [step.tracks["x"].tobytes() for step in steps] == before


def test_swapped_cameras_are_told(recording: Recording, rendered: Path):
    cameras = OpenOptions(
        left=rendered / "right.mp4",
        right=rendered / "left.mp4",
        calibration=(rendered / "calibration.yaml",),
        height_m=recording.ground.height_m,
        tilt_deg=recording.ground.tilt_deg,
    )
    with open_recording(rendered, cameras) as swapped, track(swapped, settings=FAST) as tracking:
        assert tracking.notes == ()
        list(tracking)
        assert "are the cameras swapped?" in tracking.notes[0]


def test_a_changed_setting_that_leaves_no_distance_is_told_first(recording: Recording):
    texts = {"particles": "100", "stereo.nearest_m": "20", "people.body_width_m": "0.6"}
    settings = parse_settings(TRACKERS["stereo-joint"], texts)
    with track(recording, settings=settings) as tracking:
        list(tracking)
    (note,) = tracking.notes
    assert "Nearest is 20 m, is that right? If so, are the cameras swapped" in note
    assert "Body" not in note


def test_cameras_in_their_places_give_no_note(recording: Recording):
    with track(recording, settings=FAST, frames=(40, 60)) as tracking:
        list(tracking)
        assert tracking.notes == ()


def test_closing_keeps_what_was_tracked_so_far(recording: Recording):
    tracking = track(recording, settings=FAST)
    for _ in range(5):
        next(tracking)
    tracking.close()
    assert list(tracking) == []
    assert tracking.run().frames == (0, 5)
    assert tracking.observation is not None
    assert tracking.observation.frame == 4


def test_a_range_is_tracked_with_frame_numbers_of_the_recording(recording: Recording):
    with track(recording, settings=FAST, frames=(60, 70)) as tracking:
        assert [step.frame for step in tracking] == list(range(60, 70))
        run = tracking.run()
    assert run.frames == (60, 70)
    assert set(run.detections["frame"].tolist()) <= set(range(60, 70))
    assert len(run.particles.start) == recording.frame_count + 1


def test_a_range_that_starts_with_people_in_view_sees_them_at_once(
    recording: Recording, whole: Run
):
    busiest = int(np.bincount(whole.tracks["frame"]).argmax())
    with track(recording, settings=FAST, frames=(busiest, busiest + 8)) as tracking:
        *_, last = tracking
    seen = whole.detections["frame"] == busiest + 7
    assert len(last.tracks["track"]) >= np.count_nonzero(seen & (whole.detections["track"] > 0)) - 1


def test_nothing_tracked_is_an_empty_run(recording: Recording):
    run = track(recording, settings=FAST).run()
    assert run.frames == (0, 0)
    assert all(len(column) == 0 for column in run.tracks.values())


def test_a_run_knows_how_it_was_made(whole: Run):
    assert (whole.tracker, whole.seed, whole.settings["particles"]) == ("stereo-joint", 0, 100)
    assert whole.software.startswith("trackwright ")


@pytest.mark.parametrize("frames", [(5, 5), (-1, 5), (0, 10**6), (9, 3)])
def test_a_range_outside_the_recording_is_refused(recording: Recording, frames: tuple[int, int]):
    with pytest.raises(SettingsError, match="choose a range within 0:120"):
        track(recording, frames=frames)


def test_an_unknown_tracker_is_refused_with_what_there_is():
    with pytest.raises(SettingsError, match="tracker sort is unknown: available are"):
        tracker_named("sort")


def test_one_camera_is_tracked_by_body_parts_and_not_in_stereo(rendered: Path):
    with open_recording(rendered / "left.mp4") as alone:
        assert best_tracker(alone) == "three-part"
        with pytest.raises(RecordingError, match=r"one camera.*; choose three-part"):
            track(alone, "stereo-direction")


def test_a_tracker_that_times_its_stages_tells_them_beside_the_others(rendered: Path):
    with open_recording(rendered / "left.mp4") as alone, track(alone, frames=(0, 2)) as tracking:
        list(tracking)
    spent_s = tracking.stage_s
    inner = [spent_s[f"tracker_{name}"] for name in ("filters", "failures", "births", "boxes")]
    assert 0 < sum(inner) <= spent_s["tracker"]


def test_two_cameras_without_calibration_are_tracked_by_one(rendered: Path, tmp_path: Path):
    for side in ("left.mp4", "right.mp4"):
        shutil.copy(rendered / side, tmp_path / side)
    cameras = OpenOptions(left=tmp_path / "left.mp4", right=tmp_path / "right.mp4")
    with open_recording(tmp_path, cameras) as bare:
        assert best_tracker(bare) == "three-part"
        with pytest.raises(CalibrationError, match="has no calibration"):
            track(bare, "stereo-direction")


@pytest.fixture(scope="module")
def resume(recording: Recording, whole: Run) -> Resume:
    return Resume.of(TrackTable(whole.tracks, highest_track=40), 70, recording.fps)


@pytest.fixture(scope="module")
def again(recording: Recording, resume: Resume) -> Run:
    with track(recording, settings=FAST, resume=resume) as tracking:
        assert [step.frame for step in tracking] == list(range(70, recording.frame_count))
        return tracking.run()


def test_tracking_again_without_corrections_finds_the_same_people(whole: Run, again: Run):
    late = whole.tracks["frame"] >= 70
    before = ScoringTable.from_columns({n: c[late] for n, c in whole.tracks.items()})
    result = score(before, ScoringTable.from_columns(again.tracks), BoxMatch(0.5))
    assert result.identity.idf1 > 0.97
    known = set(whole.tracks["track"][whole.tracks["frame"] == 69].tolist())
    assert known <= set(again.tracks["track"].tolist())
    assert (again.frames, again.known_tracks, whole.known_tracks) == ((70, 120), 40, 0)


def test_tracking_again_with_the_same_seed_is_the_same_to_the_byte(
    recording: Recording, resume: Resume, again: Run
):
    with track(recording, settings=FAST, resume=resume) as tracking:
        list(tracking)
        assert arrays(tracking.run()) == arrays(again)


def test_tracking_again_leaves_no_jump_where_it_begins(whole: Run, again: Run):
    for person in np.unique(again.tracks["track"][again.tracks["frame"] == 70]):
        ends = []
        for run, frame in ((whole, 69), (again, 70)):
            row = (run.tracks["frame"] == frame) & (run.tracks["track"] == person)
            ends.append(np.hypot(run.tracks["x"][row], run.tracks["y"][row]))
        assert len(ends[0]) == len(ends[1]) == 1
        assert abs(ends[0] - ends[1]) < 0.2


def test_a_range_that_does_not_begin_where_to_go_on_is_refused(
    recording: Recording, resume: Resume
):
    with pytest.raises(SettingsError, match="do not begin at frame 70, where to go on"):
        track(recording, frames=(60, 90), resume=resume)
