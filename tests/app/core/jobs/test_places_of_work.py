"""Every place where work begins off the window's thread stands in the list of work, or says why."""

from __future__ import annotations

import ast
from pathlib import Path

import app

_HOUSE = Path(app.__file__).parent
_JOBS = ("Job", "LatestJob")
_OTHER = (
    *("Thread", "QThread", "QThreadPool", "QProcess", "Process", "Popen", "child_program.begin"),
    *("TrackerProcess", "ReaderProcess", "BatchProcess"),
)
_SHOWS_ITSELF = {
    ("core/widgets/work.py", "Job"): "Work keeps the line, with the file that comes of it",
    ("core/jobs/latest_job.py", "Job"): "LatestJob keeps one line for all it does",
    ("features/review/review_search.py", "Job"): "one line for searching and measuring",
    ("features/review/strip_search.py", "LatestJob"): "three small pictures, a moment",
    ("features/setup/controller.py", "LatestJob"): "a picture of the cameras; the draft on disk",
    ("features/setup/calibration_page.py", "LatestJob"): "one rectified picture, a moment",
    ("features/project/controller.py", "Job"): "looks for new files every few seconds",
    ("shell/drops.py", "LatestJob"): "the first bytes of what was dropped",
}
"""Jobs with `listed=False`, and why."""
_SERVICES = {
    "core/jobs/jobs.py": "the thread of every job",
    "core/playback/frames.py": "reads the frames that are shown, as long as a recording is open",
    "core/playback/late_camera.py": "looks along for a late camera, as long as a recording is open",
    "core/playback/thumbnails.py": "small pictures of the overview, as long as one is open",
    "core/tracking_process/child.py": "hears Stop in the tracker's process",
    "core/tracking_process/parent.py": "the tracker's process: see shell/listed_work.py",
    "core/tracking_process/step_watch.py": "looks whether the tracker's process still works",
    "features/pictures/overlay_maker.py": "overlays of the frame that is shown",
    "features/project/batch_process.py": "the batch's process: see shell/listed_work.py",
    "features/project/batch_watch.py": "the batch at work: see shell/listed_work.py",
    "features/project/controller.py": "the process of the job that reads recordings",
    "features/runs/live_tracker.py": "the tracker at work: see shell/listed_work.py",
}
"""Threads and processes of their own, and why no job runs them."""


def _calls(names: tuple[str, ...]):
    """Every call of one of these names in the window: file below `app`, name, call."""
    for file in sorted(_HOUSE.rglob("*.py")):
        if file.is_relative_to(_HOUSE / "cli"):
            continue
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.Call):
                called = ast.unparse(node.func)
                name = called.split(".")[-1]
                if name in names or called in names:
                    yield file.relative_to(_HOUSE).as_posix(), name, node


def _is_listed(call: ast.Call) -> bool:
    said = {one.arg: ast.unparse(one.value) for one in call.keywords}
    return said.get("listed", "True") != "False"


def test_every_job_stands_in_the_list_unless_it_says_why_not():
    unlisted = {(file, name) for file, name, call in _calls(_JOBS) if not _is_listed(call)}
    assert unlisted == set(_SHOWS_ITSELF)


def test_a_job_that_is_listed_has_a_title_for_people():
    bare = [
        (file, call.args[0].value)
        for file, _, call in _calls(_JOBS)
        if _is_listed(call) and isinstance(call.args[0], ast.Constant)
    ]
    assert bare == []


def test_every_other_thread_and_process_is_known():
    assert {file for file, _, _ in _calls(_OTHER)} == set(_SERVICES)


def test_there_are_as_many_places_as_one_would_think():
    """The walk above finds them: were it blind, it would agree with everything."""
    assert len({file for file, _, _ in _calls(_JOBS)}) > 18
