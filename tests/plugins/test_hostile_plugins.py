"""Plug-ins that go wrong at work are named, and lose nothing."""

from __future__ import annotations

import signal
import time
from pathlib import Path

import numpy as np
import pytest
from bad_trackers import WRONG_STEPS, tracker_code

from app.__main__ import run as run_command
from app.cli.plugins import find_plugins
from app.core.tracking_process import TrackerProcess, TrackingRequest
from tests.installed_plugins import install_module
from tracking.detections import Footage, read_detections
from tracking.detections.catalogue import picture_detector
from tracking.errors import FormatError, PluginError, TrackwrightError
from tracking.geometry import Camera, Ground, View
from tracking.networks.network_detections import named_detector
from tracking.pipeline import track
from tracking.plugins import PluginKind, failed_drawing, offers
from tracking.recording import open_recording
from tracking.session import Session
from tracking.trackers import TRACKERS, Bodies

GROUP = PluginKind.TRACKER.group


def _install(site: Path, code: str) -> None:
    install_module(site, "bad", code, {(GROUP, "bad"): "TRACKER"})
    offers.look_again()


def _all_steps(clip: Path) -> int:
    with open_recording(clip) as recording, track(recording, "bad") as work:
        return sum(1 for _ in work)


def _request(clip: Path) -> TrackingRequest:
    with open_recording(clip) as recording:
        return TrackingRequest.of(recording, "bad", None, 0, None)


def test_a_tracker_of_a_plugin_without_fault_works(site: Path, clip: Path) -> None:
    _install(site, tracker_code())
    assert _all_steps(clip) == 32


@pytest.mark.parametrize("case", WRONG_STEPS)
def test_a_step_that_goes_wrong_names_the_plugin_and_the_frame(
    site: Path, clip: Path, case: str
) -> None:
    step, said = WRONG_STEPS[case]
    _install(site, tracker_code(step))
    with pytest.raises(PluginError) as caught:
        _all_steps(clip)
    text = str(caught.value)
    assert text.startswith("tracker bad (plug-in bad 1.0)")
    assert said in text
    assert "pip uninstall bad" in text
    assert "\n" not in text


def test_a_plugin_that_cannot_begin_is_named(site: Path, clip: Path) -> None:
    _install(site, tracker_code(build="raise OSError('no such weights')"))
    with pytest.raises(PluginError, match=r"raised OSError: no such weights at bad\.py:"):
        _all_steps(clip)


def test_the_frames_until_then_are_kept_in_a_session_of_their_own(
    site: Path, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _install(site, tracker_code("raise ValueError('stop')"))
    out = tmp_path / "s.h5"
    assert run_command(["track", str(clip), "-o", str(out), "--tracker", "bad"]) == 1
    said = capsys.readouterr().err.splitlines()[-1]
    assert "tracker bad (plug-in bad 1.0) raised ValueError: stop at bad.py:" in said
    assert not out.exists()
    (kept,) = tmp_path.glob("*.h5")
    with_part = Session.look_into(kept)
    first, stop = with_part.runs[0].frames
    assert first == 0 < stop < 32
    with_part.close()


def test_a_step_that_hangs_is_ended_by_the_command(
    site: Path, clip: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if not hasattr(signal, "setitimer"):
        pytest.skip("this system has no timer that interrupts")
    _install(site, tracker_code("time.sleep(600)", limit_s=2.0))
    words = ["track", str(clip), "-o", str(tmp_path / "s.h5"), "--tracker", "bad"]
    assert run_command(words) == 1
    assert "tracker bad (plug-in bad 1.0): it did not answer within 2 s" in capsys.readouterr().err


def test_a_step_that_hangs_is_ended_by_the_window_with_what_came_before(
    site: Path, clip: Path
) -> None:
    _install(site, tracker_code("time.sleep(600)", limit_s=4.0))
    batches = TrackerProcess(_request(clip)).batches()
    steps = list(next(batches))
    with pytest.raises(PluginError, match="did not answer within 4 s"):
        steps += [step for batch in batches for step in batch]
    assert steps[0].frame == 0


def test_a_plugin_that_takes_all_memory_is_ended_in_its_own_process(
    site: Path, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TRACKWRIGHT_PLUGIN_MEMORY_MB", "1024")
    _install(site, tracker_code("HELD.extend(np.ones(1 << 24) for _ in range(200))"))
    with pytest.raises(TrackwrightError, match=r"tracker bad \(plug-in bad 1.0\)"):
        list(TrackerProcess(_request(clip)).batches())


def test_a_plugin_that_ends_its_process_is_named(site: Path, clip: Path) -> None:
    _install(site, tracker_code("import os; os._exit(9)"))
    with pytest.raises(TrackwrightError, match=r"tracker bad \(plug-in bad 1.0\) ended by itself"):
        list(TrackerProcess(_request(clip)).batches())


@pytest.mark.parametrize("drawn", ["1 / 0", "None", "np.zeros((3, 5))", "'outlines'"])
def test_an_overlay_that_fails_draws_nothing_and_is_told(site: Path, drawn: str) -> None:
    _install(site, tracker_code(outlines=drawn))
    draw = TRACKERS["bad"].overlays.outlines
    assert draw is not None
    view = View(Camera(np.eye(3), np.zeros(0), 64, 48), Ground(2.0, 30.0))
    found = draw(view, None, Bodies(np.zeros((2, 2)), np.ones(2)), 20)
    assert found.shape == (2, 20, 2)
    assert np.isnan(found).all()
    told = failed_drawing(PluginKind.TRACKER, "bad")
    assert told is not None
    assert "tracker bad (plug-in bad 1.0)" in str(told)


def test_a_finisher_that_hangs_is_given_up_on(site: Path, clip: Path) -> None:
    code = tracker_code(limit_s=1.0).replace(
        "settings_type=Settings,",
        "settings_type=Settings, finisher=Finisher(extend_in_pixels=lambda *_: time.sleep(5)),",
    )
    code = code.replace(
        "people: PeopleSettings = stage(PeopleSettings)",
        "people: PeopleSettings = stage(PeopleSettings)\n"
        "    smooth: bool = setting(True, '', None, 'Smooth')",
    )
    _install(site, "from tracking.trackers.linking import Finisher\n" + code)
    began_s = time.monotonic()
    with open_recording(clip) as recording, track(recording, "bad", frames=(0, 4)) as work:
        for _ in work:
            pass
        if recording.view is None:
            with pytest.raises(PluginError, match="did not answer within 1 s"):
                work.run()
    assert time.monotonic() - began_s < 60


DETECTOR = """
import numpy as np
from types import SimpleNamespace
from tracking.detections.detector import DetectorSpec
class Bad:
    def find(self, picture):
        return SimpleNamespace(box={box}, score={score})
    def close(self): pass
DETECTOR = DetectorSpec("bad", "Bad", Bad)
"""


@pytest.mark.parametrize(
    ("box", "score", "said"),
    [
        ("np.full((1, 4), np.nan)", "np.ones(1)", "a box or a score that is no number"),
        ("np.ones((2, 3))", "np.ones(2)", "boxes of shape"),
        ("np.ones((2, 4))", "np.ones(3)", "scores of shape"),
        ("np.array([[0, 0, -1, 5.0]])", "np.ones(1)", "negative width or height"),
        ("1 / 0", "0", "raised ZeroDivisionError"),
    ],
)
def test_a_detector_that_gives_no_boxes_is_named(
    site: Path, box: str, score: str, said: str
) -> None:
    code = DETECTOR.format(box=box, score=score)
    install_module(site, "bad", code, {(PluginKind.DETECTOR.group, "bad"): "DETECTOR"})
    offers.look_again()
    spec = picture_detector("bad")
    assert spec is not None
    with pytest.raises(PluginError, match="detector bad") as caught:
        spec.open().find(np.zeros((48, 64, 3), np.uint8))
    assert said in str(caught.value)


def test_a_file_that_nobody_knows_is_told_of_with_what_a_plugin_did_wrong(
    site: Path, tmp_path: Path
) -> None:
    install_module(site, "bad", "1 / 0", {(PluginKind.DETECTOR.group, "bad"): "DETECTOR"})
    offers.look_again()
    boxes = tmp_path / "boxes.txt"
    boxes.write_text("0 0.5 0.5 0.1 0.3\n")
    with pytest.raises(FormatError, match="give MOT text, COCO JSON or a folder") as caught:
        read_detections(boxes, Footage(10, (64, 48)))
    assert "detector bad (plug-in bad 1.0) raised ZeroDivisionError" in str(caught.value)


def test_a_name_too_long_for_a_file_is_no_detector_of_a_plugin(clip: Path) -> None:
    with open_recording(clip) as recording:
        assert named_detector(recording, "n" * 300) is None


def test_the_list_of_plugins_says_which_do_not_work(
    site: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    _install(site, "1 / 0")
    (wrong,) = [one for one in find_plugins() if one.error is not None]
    assert (wrong.offer.name, wrong.package) == ("bad", "bad 1.0")
    assert run_command(["plugins"]) == 0
    assert "bad DOES NOT WORK: tracker bad (plug-in bad 1.0) raised" in capsys.readouterr().out
