"""Recordings whose right camera is late, ahead, or late and dark for a time, are tracked."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.benchmarks.stereo.troubles import Trouble, troubled
from tracking.people import Observation, StereoPerception
from tracking.pipeline import track
from tracking.recording import StereoFrame, open_recording
from tracking.synthesis import render_recording
from tracking.synthesis.disturbances import Disturbances
from tracking.trackers import TRACKERS, Resume, parse_settings
from tracking.tracks import Run, TrackTable

FAST = parse_settings(TRACKERS["stereo-joint"], {"particles": "100"})
LATE = Trouble("late and dark", lag=12, dark=True, start_s=2.5, end_s=2.9)
AHEAD = Trouble("ahead", lag=-8)
FRAMES, GOES_ON_AT = 80, 44
NEAR_M = 0.15


@dataclass(frozen=True)
class Tracked:
    run: Run
    notes: tuple[str, ...]

    def people(self, frame: int) -> NDArray[np.float64]:
        """(n, 2) m, where people were detected in a frame."""
        rows = self.run.detections["frame"] == frame
        return np.column_stack([self.run.detections[name][rows] for name in ("x", "y")])

    def followed(self, frames: range) -> int:
        """Rows of tracks in some frames."""
        return int(np.isin(self.run.tracks["frame"], frames).sum())


def agreeing(one: Tracked, other: Tracked, frames: range) -> float:
    """Share of the people detected in one that were detected at the same places in the other."""
    near = [
        np.hypot(*(one.people(n)[:, None] - other.people(n)[None]).T).min(axis=0, initial=9)
        < NEAR_M
        for n in frames
    ]
    return float(np.concatenate(near).mean())


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Six people, in view from the first frame on."""
    made = tmp_path_factory.mktemp("recordings") / "square"
    begun = Disturbances(begin_s=8.0)
    return render_recording(made, "square", 4.0, 6, 6012, size=(320, 240), disturbances=begun)


def tracked(folder: Path, resume: Resume | None = None) -> Tracked:
    with (
        open_recording(folder) as recording,
        track(recording, settings=FAST, resume=resume) as tracking,
    ):
        first = resume.frame if resume is not None else 0
        assert [step.frame for step in tracking] == list(range(first, FRAMES))
        return Tracked(tracking.run(), tracking.notes)


@pytest.fixture(scope="module")
def sound(folder: Path) -> Tracked:
    return tracked(folder)


@pytest.fixture(scope="module")
def ahead(folder: Path) -> Tracked:
    return tracked(troubled(folder, AHEAD))


@pytest.fixture(scope="module")
def late(folder: Path) -> Tracked:
    return tracked(troubled(folder, LATE))


def test_a_camera_that_is_ahead_makes_no_difference(sound: Tracked, ahead: Tracked) -> None:
    assert agreeing(sound, ahead, range(8, FRAMES)) > 0.7
    assert sound.notes == ()
    assert ahead.notes == (
        "the left camera is 8 frames late: images of the same instant are paired",
    )


def test_a_camera_that_is_late_and_fails_for_a_time_is_of_use_otherwise(
    sound: Tracked, late: Tracked
) -> None:
    assert agreeing(sound, late, range(38)) > 0.7
    assert agreeing(sound, late, range(46, FRAMES - LATE.lag)) > 0.7
    failed, lagged = late.notes
    assert "shows nothing new in frames 38 to 45:" in failed
    assert lagged == "the right camera is 12 frames late: images of the same instant are paired"


@pytest.mark.parametrize("frames", [range(38, 46), range(FRAMES - LATE.lag, FRAMES)])
def test_frames_without_a_right_picture_are_followed_by_the_left_one(
    sound: Tracked, late: Tracked, frames: range
) -> None:
    assert late.followed(frames) > 0.8 * sound.followed(frames)


def test_a_lag_that_recording_toml_tells_wrong_is_not_believed(folder: Path) -> None:
    wrong = shutil.copytree(folder, folder.with_name("wrong"))
    manifest = wrong / "recording.toml"
    text = manifest.read_text().replace("[right]\n", "[right]\nlag = 30\n")
    manifest.write_text(text)
    with open_recording(wrong) as recording, track(recording, settings=FAST) as tracking:
        assert recording.right_lag == 30
        next(tracking)
        assert tracking.notes == (
            "neither camera is late: images of the same instant are paired; recording.toml says "
            "30: leave `lag` out to have it looked for",
        )


def test_tracking_that_goes_on_in_the_middle_is_paired_from_its_first_frame_on(
    folder: Path, ahead: Tracked, monkeypatch: pytest.MonkeyPatch
) -> None:
    lags: dict[int, int | None] = {}
    observe = StereoPerception.observe

    def noted(self: StereoPerception, frame: StereoFrame) -> Observation:
        lags[frame.number] = frame.right_lag
        return observe(self, frame)

    monkeypatch.setattr(StereoPerception, "observe", noted)
    with open_recording(folder) as recording:
        before = TrackTable(ahead.run.tracks, highest_track=20)
        resume = Resume.of(before, GOES_ON_AT, recording.fps)
    again = tracked(troubled(folder, AHEAD), resume)
    assert set(resume.colour_frames) <= set(lags)
    assert {lag for frame, lag in lags.items() if frame >= -AHEAD.lag} == {AHEAD.lag}
    assert agreeing(ahead, again, range(GOES_ON_AT, FRAMES)) > 0.95
    known = ahead.run.tracks["track"][ahead.run.tracks["frame"] == GOES_ON_AT - 1]
    assert np.isin(known, again.run.tracks["track"]).all()
