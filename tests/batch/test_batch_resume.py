"""What a batch does again, and what not: files, settings, results and truths that changed."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.batch.batches import QUICK, Counting, batch, ledger_of, leftovers
from tests.batch.walks import HEIGHT_PX, WIDTH_PX, make_damaged, make_walk, write_manifest
from tracking.batch import Cause, Limits, State
from tracking.batch.outcome import failure
from tracking.batch.task import Task
from tracking.editing import plan_delete
from tracking.geometry import Camera, StereoCalibration, write_calibration
from tracking.session import Session
from tracking.translation import msg


@pytest.fixture(scope="module")
def first(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two recordings and a finished batch of them; not to be changed."""
    top = tmp_path_factory.mktemp("first")
    walks = [make_walk(top / "a", 1), make_walk(top / "b", 2, truth=True)]
    outcomes = batch(top / "out", walks)
    assert all(outcome.is_done and outcome.people == 1 for outcome in outcomes.values())
    return top


@pytest.fixture
def top(first: Path, tmp_path: Path) -> Path:
    """A copy of it, with all times as they were."""
    return Path(shutil.copytree(first, tmp_path / "top", copy_function=shutil.copy2))


def again(top: Path, order=QUICK, **asked):
    """Which recordings were worked on, and which were tracked, when it is done again."""
    count = Counting()
    outcomes = batch(top / "out", [top / "a", top / "b"], order, count, **asked)
    return count, outcomes


@pytest.fixture
def settled(top: Path) -> Path:
    """The copy, once the ledger knows its files: copies are looked at, and nothing is tracked."""
    count, outcomes = again(top)
    assert count.tracked == []
    assert all(outcome.is_done for outcome in outcomes.values())
    return top


def test_a_finished_batch_is_not_touched_again(settled: Path) -> None:
    before = (settled / "out" / "a.h5").stat().st_mtime_ns
    count, outcomes = again(settled)
    assert count.names == []
    assert {name: outcome.state for name, outcome in outcomes.items()} == {
        "a": State.DONE,
        "b": State.DONE,
    }
    assert (settled / "out" / "a.h5").stat().st_mtime_ns == before


def change_a_byte_in_the_middle(top: Path) -> None:
    shutil.copy(top / "b" / "left" / "0012.png", top / "a" / "left" / "0012.png")


def add_a_frame(top: Path) -> None:
    shutil.copy(top / "a" / "left" / "0023.png", top / "a" / "left" / "0024.png")


def change_the_manifest(top: Path) -> None:
    path = top / "a" / "recording.toml"
    path.write_text(path.read_text().replace("10.0", "12.0"))


def remove_the_session(top: Path) -> None:
    (top / "out" / "a.h5").unlink()


def cut_the_session_short(top: Path) -> None:
    os.truncate(top / "out" / "a.h5", 1000)


def change_the_session_and_its_time_back(top: Path) -> None:
    path = top / "out" / "a.h5"
    state = path.stat()
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 0xFF
    path.write_bytes(bytes(data))
    os.utime(path, ns=(state.st_atime_ns, state.st_mtime_ns))


@pytest.mark.parametrize(
    "change",
    [
        change_a_byte_in_the_middle,
        add_a_frame,
        change_the_manifest,
        remove_the_session,
        cut_the_session_short,
        change_the_session_and_its_time_back,
    ],
)
def test_what_changed_is_tracked_again_and_only_that(
    settled: Path, change: Callable[[Path], None]
) -> None:
    change(settled)
    count, outcomes = again(settled)
    assert count.names == ["a"]
    assert count.tracked == ["a"]
    assert outcomes["a"].is_done
    with closing(Session.look_into(settled / "out" / "a.h5")) as session:
        assert len(session.tracks.columns()["frame"]) > 0


def test_files_that_are_the_same_after_all_are_not_tracked_again(settled: Path) -> None:
    for path in (settled / "a" / "left").iterdir():
        os.utime(path)
    (settled / "a" / "notes.txt").write_text("of no account")
    count, outcomes = again(settled)
    assert count.names == ["a"]
    assert count.tracked == []
    assert outcomes["a"].is_done


@pytest.mark.parametrize(
    "order",
    [
        replace(QUICK, tracker="flow"),
        replace(QUICK, seed=7),
        replace(QUICK, settings=(("people.least_height", "0.5"),)),
    ],
)
def test_other_settings_are_tracked_anew(settled: Path, order) -> None:
    count = Counting(lambda _: failure(Cause.INPUT, msg("asked")))
    batch(settled / "out", [settled / "a", settled / "b"], order, count)
    assert count.names == ["a", "b"]


def test_a_new_truth_is_scored_and_nothing_is_tracked(settled: Path) -> None:
    shutil.copy(settled / "b" / "truth.txt", settled / "a" / "truth.txt")
    count, outcomes = again(settled)
    assert (count.names, count.tracked) == (["a"], [])
    assert outcomes["a"].score is not None
    assert 0.5 < outcomes["a"].score["IDF1"] <= 1


def test_a_further_format_is_written_and_nothing_is_tracked(settled: Path) -> None:
    count, _ = again(settled, replace(QUICK, exports=("mot", "csv")))
    assert (count.names, count.tracked) == (["a", "b"], [])
    out = settled / "out"
    assert (out / "export" / "mot" / "a.txt").read_text().count("\n") > 10
    assert (out / "export" / "csv" / "b.csv").is_file()
    count, _ = again(settled, replace(QUICK, exports=("mot", "csv")))
    assert count.names == []


def test_a_page_that_is_missing_is_written_and_nothing_is_tracked(settled: Path) -> None:
    count, _ = again(settled, replace(QUICK, report=True))
    assert (count.names, count.tracked) == (["b"], [])
    assert "b" in (settled / "out" / "report" / "b" / "report.html").read_text()


def test_a_corrected_session_stays_and_counts_as_done(settled: Path) -> None:
    correct(settled / "out" / "a.h5")
    count, outcomes = again(settled)
    assert (count.names, count.tracked) == (["a"], [])
    assert outcomes["a"].is_done
    assert outcomes["a"].corrected
    assert again(settled)[0].names == []


def test_a_corrected_session_is_not_lost_to_other_settings(settled: Path) -> None:
    correct(settled / "out" / "a.h5")
    before = (settled / "out" / "a.h5").read_bytes()
    count, outcomes = again(settled, replace(QUICK, seed=7))
    assert count.tracked == ["b"]
    assert outcomes["a"].state is State.SKIPPED
    assert "--force" in outcomes["a"].why
    assert (settled / "out" / "a.h5").read_bytes() == before
    count, outcomes = again(settled)
    assert outcomes["a"].is_done
    assert count.tracked == ["b"]
    count, outcomes = again(settled, replace(QUICK, seed=7, force=True))
    assert count.tracked == ["a", "b"]


def test_a_lost_ledger_costs_no_tracking(settled: Path) -> None:
    (settled / "out" / "batch.sqlite").unlink()
    count, outcomes = again(settled)
    assert (count.names, count.tracked) == (["a", "b"], [])
    assert all(outcome.is_done for outcome in outcomes.values())


def test_a_session_of_something_else_is_replaced_only_where_nobody_worked_on_it(
    settled: Path,
) -> None:
    out = settled / "out"
    (out / "batch.sqlite").unlink()
    (out / "a.h5").unlink()
    shutil.copy(out / "b.h5", out / "a.h5")
    count, outcomes = again(settled)
    assert count.tracked == ["a"]
    assert outcomes["a"].is_done


def test_bad_input_is_tried_once_until_it_changes(tmp_path: Path) -> None:
    bad = make_damaged(tmp_path / "bad", 1)
    count = Counting()
    outcome = batch(tmp_path / "out", [bad], do=count)["bad"]
    assert (outcome.state, outcome.cause) == (State.FAILED, Cause.INPUT)
    assert "left.mp4" in outcome.why
    assert batch(tmp_path / "out", [bad], do=count)["bad"].why == outcome.why
    assert count.names == ["bad"]
    batch(tmp_path / "out", [bad], do=count, retry=True)
    assert count.names == ["bad"] * 2
    shutil.rmtree(bad)
    make_walk(bad)
    assert batch(tmp_path / "out", [bad], do=count)["bad"].is_done


@pytest.mark.parametrize("cause", [Cause.WORKER, Cause.DISK])
def test_what_may_pass_is_tried_three_times_and_again_the_next_time(
    tmp_path: Path, cause: Cause
) -> None:
    walk = make_walk(tmp_path / "walk")
    count = Counting(lambda _: failure(cause, msg("of no account")))
    assert batch(tmp_path / "out", [walk], do=count)["walk"].cause is cause
    assert count.names == ["walk"] * 3
    count = Counting()
    assert batch(tmp_path / "out", [walk], do=count)["walk"].is_done
    assert count.names == ["walk"]
    results = [attempt.result for attempt in ledger_of(tmp_path / "out")[1]]
    assert results == ["failed"] * 3 + ["done"]


def test_what_went_beyond_a_limit_is_tried_again_only_where_that_is_raised(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "walk")
    count = Counting(lambda _: failure(Cause.LIMIT, msg("it took too long")))
    for limit_s in (10.0, 10.0, 5.0, 20.0, None, None):
        batch(tmp_path / "out", [walk], do=count, limits=Limits(time_s=limit_s))
    assert len(count.names) == 3


def test_a_recording_that_was_moved_is_not_tracked_again(settled: Path) -> None:
    (settled / "elsewhere").mkdir()
    moved = [settled / "elsewhere" / "a", settled / "b"]
    (settled / "a").rename(moved[0])
    count = Counting()
    outcomes = batch(settled / "out", moved, do=count)
    assert (count.names, count.tracked) == (["a"], [])
    assert outcomes["a"].is_done


def test_a_recording_that_changes_while_it_is_tracked_is_tried_again(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "walk")
    changes = iter([True, False])

    def disturbed(task: Task):
        from tracking.batch.job import do_task

        def tell(stage: str, done: int, total: int) -> None:
            if stage == "saving" and next(changes):
                shutil.copy(walk / "left" / "0000.png", walk / "left" / "0005.png")

        return do_task(task, tell)

    count = Counting(disturbed)
    assert batch(tmp_path / "out", [walk], do=count)["walk"].is_done
    assert count.names == ["walk"] * 2
    assert leftovers(tmp_path / "out") == []


def test_files_outside_of_the_recording_are_watched(tmp_path: Path) -> None:
    walk = make_walk(tmp_path / "walk")
    shutil.move(walk / "left", tmp_path / "left")
    write_manifest(walk, "../left/*.png")
    with (walk / "recording.toml").open("a") as manifest:
        manifest.write('\n[calibration]\nfile = "../camera.yaml"\n')
    calibrate(tmp_path / "camera.yaml", 200.0)
    order = replace(QUICK, allow_outside=True)
    assert batch(tmp_path / "out", [walk], order)["walk"].is_done
    count = Counting()
    batch(tmp_path / "out", [walk], order, count)
    assert count.names == []
    calibrate(tmp_path / "camera.yaml", 210.0)
    batch(tmp_path / "out", [walk], order, count)
    assert count.tracked == ["walk"]
    shutil.copy(tmp_path / "left" / "0012.png", tmp_path / "left" / "0011.png")
    batch(tmp_path / "out", [walk], order, count)
    assert count.tracked == ["walk"] * 2


def calibrate(path: Path, focal_px: float) -> None:
    matrix = np.array([[focal_px, 0, WIDTH_PX / 2], [0, focal_px, HEIGHT_PX / 2], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), WIDTH_PX, HEIGHT_PX)
    write_calibration(path, StereoCalibration.of_one(camera))


def correct(path: Path) -> None:
    with closing(Session.open(path)) as session:
        session.apply(plan_delete(session.tracks, session.tracks.track_ids[0], 3, 5))
        session.save()
