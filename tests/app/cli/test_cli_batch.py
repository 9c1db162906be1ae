"""The command `batch`, as it is typed."""

from __future__ import annotations

import json
import os
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command_line import Trackwright

from tests.batch.walks import make_damaged, make_walk
from tests.page_reader import Reader

_ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def walks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with two recordings, one with ground truth; not to be changed."""
    top = tmp_path_factory.mktemp("walks")
    make_walk(top / "day1" / "walk", 1, truth=True)
    make_walk(top / "day2" / "walk", 2)
    return top


@pytest.fixture
def top(walks: Path, tmp_path: Path) -> Path:
    """A copy of it, to which something bad is added."""
    top = Path(shutil.copytree(walks, tmp_path / "walks"))
    make_damaged(top / "bad", 1)
    (top / "empty").mkdir()
    return top


def test_a_batch_tells_what_became_of_each(
    trackwright: Trackwright, top: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    asked = ("batch", top, top / "none", "-o", out, "--workers", "2", "--export", "mot", "--json")
    status, said, _ = trackwright(*asked)
    told = json.loads(said)
    assert status == 3
    assert told["done"] == ["day1-walk", "day2-walk"]
    assert set(told["failed"]) == {"bad", str(top / "none")}
    assert "left.mp4" in told["failed"]["bad"]
    assert set(told["skipped"]) == {str(top / "empty")}
    assert {path.name for path in out.iterdir()} == {
        *("day1-walk.h5", "day2-walk.h5", "batch.sqlite", "report", "export"),
    }
    assert (out / "export" / "mot" / "day1-walk.txt").is_file()
    page = Reader((out / "report" / "index.html").read_text()).said
    assert {"bad", "day1-walk", "day2-walk", str(top / "none"), str(top / "empty")} <= set(page)
    assert (out / "report" / "day1-walk" / "report.html").is_file()
    with sqlite3.connect(out / "batch.sqlite") as ledger:
        states = dict(ledger.execute("SELECT name, state FROM recordings"))
    assert states == {"day1-walk": "done", "day2-walk": "done", "bad": "failed"}
    assert json.loads(trackwright(*asked)[1])["done"] == told["done"]
    status, said, _ = trackwright(
        "score", out / "day1-walk.h5", "--truth", top / "day1/walk", "--json"
    )
    assert json.loads(said)["IDF1"] > 0.5


def test_exit_statuses_tell_all_some_and_none(
    trackwright: Trackwright, top: Path, walks: Path, tmp_path: Path
) -> None:
    status, said, _ = trackwright("batch", top / "bad", "-o", tmp_path / "none")
    assert status == 1
    assert "failed: bad: " in said
    assert "0 of 1 recording done" in said
    assert trackwright("batch", walks / "day2" / "walk", "-o", tmp_path / "all")[0] == 0


@pytest.mark.parametrize(
    "words",
    [
        ("--tracker", "nosuch"),
        ("--tracker", "three-part", "--set", "nosuch=3"),
        ("--set", "nonsense"),
        ("--set", "nosuch=3"),
        ("--export", "nosuch"),
        ("--shard", "3/2"),
        ("--workers", "0"),
        ("--seed", "-1"),
    ],
)
def test_what_is_wrongly_asked_for_leaves_nothing_behind(
    trackwright: Trackwright, walks: Path, tmp_path: Path, words: tuple[str, ...]
) -> None:
    assert trackwright("batch", walks, "-o", tmp_path / "out", *words)[0] == 2
    assert not (tmp_path / "out").exists()


def test_nothing_named_is_told(trackwright: Trackwright, tmp_path: Path) -> None:
    status, _, told = trackwright("batch", "-o", tmp_path / "out")
    assert status == 1
    assert "no recordings are named" in told


def test_shards_make_the_same_as_one(trackwright: Trackwright, walks: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    asked = ("batch", walks, "-o", out, "--workers", "1", "--json")
    first = json.loads(trackwright(*asked, "--shard", "1/2")[1])
    second = json.loads(trackwright(*asked, "--shard", "2/2")[1])
    assert (first["done"], second["done"]) == (["day1-walk"], ["day2-walk"])
    with sqlite3.connect(out / "batch.sqlite") as ledger:
        assert len(ledger.execute("SELECT * FROM recordings").fetchall()) == 2
        before = ledger.execute("SELECT count(*) FROM attempts").fetchone()
    assert json.loads(trackwright(*asked)[1])["done"] == ["day1-walk", "day2-walk"]
    with sqlite3.connect(out / "batch.sqlite") as ledger:
        assert ledger.execute("SELECT count(*) FROM attempts").fetchone() == before


def test_shards_call_a_recording_one_name_also_after_another_is_added(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    top, out = tmp_path / "walks", tmp_path / "out"
    make_walk(top / "b" / "walk", 1)
    make_walk(top / "c" / "other", 2)
    asked = ("batch", top, "-o", out, "--workers", "1", "--no-pages", "--json")
    for shard in ("1/2", "2/2"):
        trackwright(*asked, "--shard", shard)
    make_walk(top / "a" / "walk", 3)
    for shard in ("1/2", "2/2"):
        trackwright(*asked, "--shard", shard)
    with sqlite3.connect(out / "batch.sqlite") as ledger:
        named = ledger.execute("SELECT path, name FROM recordings ORDER BY path").fetchall()
    places = [str(top / part) for part in ("a/walk", "b/walk", "c/other")]
    assert named == list(zip(places, ("a-walk", "walk", "other"), strict=True))


def test_the_script_of_an_array_job_is_one_that_a_shell_reads(walks: Path, tmp_path: Path) -> None:
    words = ("batch", str(walks), "-o", str(tmp_path / "a b"), "--job-array", "8")
    said = subprocess.run(
        [sys.executable, "-m", "app", *words], cwd=_ROOT, capture_output=True, text=True, check=True
    ).stdout
    assert "#SBATCH --array=1-8" in said
    assert '--shard "$SLURM_ARRAY_TASK_ID/8"' in said
    assert "--job-array" not in said
    assert f"'{tmp_path}/a b'" in said
    subprocess.run(["bash", "-n"], input=said, text=True, check=True)
    assert not (tmp_path / "a b").exists()


@pytest.mark.skipif(os.name == "nt", reason="interrupts are sent otherwise there")
def test_ctrl_c_ends_cleanly_and_the_same_command_goes_on(
    trackwright: Trackwright, walks: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    words = ["batch", str(walks), "-o", str(out), "--workers", "1"]
    program = subprocess.Popen(
        [sys.executable, "-m", "app", *words], cwd=_ROOT, stderr=subprocess.PIPE, text=True
    )
    while not (out / ".batch.state").exists():  # recordings are worked on
        assert program.poll() is None
        time.sleep(0.05)
    program.send_signal(signal.SIGINT)
    _, told = program.communicate(timeout=60)
    assert program.returncode == 130
    assert "the same command goes on" in told
    assert told.endswith("interrupted; nothing half-done was kept\n")
    assert [path.name for path in out.iterdir() if path.name.startswith(".")] == []
    assert trackwright(*words)[0] == 0


def test_two_batches_do_not_work_in_one_folder(
    trackwright: Trackwright, walks: Path, tmp_path: Path
) -> None:
    from tracking.batch import Shard, batch_folder

    out = tmp_path / "out"
    for shard in (None, Shard(1, 2)):
        with batch_folder(out, shard):
            status, _, told = trackwright("batch", walks, "-o", out)
        assert status == 1
        assert "another batch works in" in told


def test_a_ledger_of_something_else_is_not_written_to(
    trackwright: Trackwright, walks: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    with sqlite3.connect(out / "batch.sqlite") as other:
        other.execute("CREATE TABLE mine (a)")
    before = (out / "batch.sqlite").read_bytes()
    status, _, told = trackwright("batch", walks, "-o", out)
    assert status == 1
    assert "is no ledger of a batch" in told
    assert (out / "batch.sqlite").read_bytes() == before
    (out / "batch.sqlite").write_bytes(b"no database at all" * 100)
    assert trackwright("batch", walks, "-o", out)[0] == 1


def test_detections_are_taken_by_a_pattern(
    trackwright: Trackwright, walks: Path, tmp_path: Path
) -> None:
    top = Path(shutil.copytree(walks, tmp_path / "walks"))
    shutil.copy(top / "day1" / "walk" / "truth.txt", top / "day1" / "walk" / "det.txt")
    status, said, _ = trackwright(
        *("batch", top, "-o", tmp_path / "out", "--workers", "1", "--json", "--no-pages"),
        *("--detections", "det.txt", "--set", "detections.use=only"),
    )
    told = json.loads(said)
    assert status == 3
    assert told["done"] == ["day1-walk"]
    assert "no detections are at" in told["failed"]["day2-walk"]


def said_in_one_place(*words: object) -> str:
    """What a batch says where one reader sees stdout and stderr."""
    command = [sys.executable, "-m", "app", "batch", *map(str, words)]
    return subprocess.run(
        command, cwd=_ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    ).stdout


def test_a_failure_is_told_once_to_one_reader(
    trackwright: Trackwright, top: Path, tmp_path: Path
) -> None:
    asked = (top / "bad", top / "none", "-o", tmp_path / "out")
    said = said_in_one_place(*asked)
    assert said.count("failed: bad: ") == 1
    assert said.count("failed: " + str(top / "none")) == 1
    assert "0 of 2 recordings done" in said
    assert said_in_one_place(*asked).count("failed: bad: ") == 1
    _, said, told = trackwright("batch", *asked, "--retry")
    assert (said.count("failed: bad: "), told.count("failed: bad: ")) == (1, 1)


def test_what_failed_before_is_told_not_to_be_tried_again(
    trackwright: Trackwright, top: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    trackwright("batch", top / "bad", "-o", out)
    _, _, told = trackwright("batch", top / "bad", top / "day2", "-o", out, "--no-pages")
    assert told.startswith("1 failed before and is left alone; --retry tries it again")
    again = trackwright("batch", top / "bad", "-o", out)[2]
    assert again == "1 failed before and is left alone; --retry tries it again\n"
