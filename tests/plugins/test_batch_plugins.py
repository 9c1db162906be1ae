"""Trackers of plug-ins in a batch: workers find them, and what one does wrong is named."""

from __future__ import annotations

import json
import sqlite3
import subprocess
import sys
from contextlib import closing
from pathlib import Path

import pytest

from app.cli.plugin_package import PluginPackage, make_package
from tests.batch.walks import make_walk
from tests.installed_plugins import install_module, install_package
from tests.plugins.bad_trackers import tracker_code
from tracking.plugins import PluginKind
from tracking.session import Session

_ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def walks(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with three recordings, one with ground truth; not to be changed."""
    top = tmp_path_factory.mktemp("walks")
    for number in range(3):
        make_walk(top / f"walk{number}", number, truth=number == 0)
    return top


def run_batch(*words: object) -> tuple[int, dict, str]:
    """Exit status, what was found and stderr of a batch of two workers that sees the plug-ins."""
    command = [sys.executable, "-m", "app", "batch", *map(str, words), "--workers", "2", "--json"]
    done = subprocess.run(command, cwd=_ROOT, capture_output=True, text=True, check=False)
    assert "Traceback" not in done.stderr, done.stderr
    return done.returncode, json.loads(done.stdout or "{}"), done.stderr


def install_bad(site: Path, step: str, **asked) -> None:
    """A tracker whose step runs a line in every frame with somebody."""
    code = tracker_code(step, **asked).replace("if n < 2:", "if n < 1:")
    install_module(site, "bad", code, {(PluginKind.TRACKER.group, "bad"): "TRACKER"})


def test_a_new_tracker_works_in_a_batch_of_two_workers(
    site: Path, walks: Path, tmp_path: Path
) -> None:
    install_package(make_package(PluginPackage(PluginKind.TRACKER, "mine"), tmp_path), site)
    out = tmp_path / "out"
    asked = (walks, "-o", out, "--tracker", "mine", "--set", "memory_s=0.4", "--export", "mot")
    status, told, said = run_batch(*asked)
    assert (status, told["done"]) == (0, ["walk0", "walk1", "walk2"]), said
    with sqlite3.connect(out / "batch.sqlite") as ledger:
        workers = {worker for (worker,) in ledger.execute("SELECT worker FROM attempts")}
        before = ledger.execute("SELECT count(*) FROM attempts").fetchone()
    assert workers == {"1", "2"}
    with closing(Session.look_into(out / "walk1.h5")) as session:
        assert session.runs[0].tracker == "mine"
        assert len(session.tracks.columns()["frame"]) > 0
    assert (out / "report" / "walk0" / "report.html").is_file()
    assert (out / "export" / "mot" / "walk2.txt").is_file()
    assert "mine" in (out / "report" / "index.html").read_text()
    assert run_batch(*asked)[1]["done"] == told["done"]
    with sqlite3.connect(out / "batch.sqlite") as ledger:
        assert ledger.execute("SELECT count(*) FROM attempts").fetchone() == before


@pytest.mark.parametrize(
    ("step", "limit_s", "why"),
    [
        (
            "raise ValueError('no such person')",
            60.0,
            "raised ValueError: no such person at",
        ),
        ("tracks['left'] = np.full(n, np.nan)", 60.0, "tracks: column left holds nan"),
        ("time.sleep(600)", 3.0, "it did not answer within 3 s"),
    ],
    ids=["raises", "gives NaN", "hangs"],
)
def test_a_tracker_that_goes_wrong_is_named_in_a_line_for_each_recording(
    site: Path, walks: Path, tmp_path: Path, step: str, limit_s: float, why: str
) -> None:
    install_bad(site, step, limit_s=limit_s)
    status, told, _ = run_batch(walks, "-o", tmp_path / "out", "--tracker", "bad")
    assert (status, told["done"], len(told["failed"])) == (1, [], 3)
    for reason in told["failed"].values():
        assert reason.startswith("tracker bad (plug-in bad 1.0)")
        assert why in reason
        assert "bug in trackwright" not in reason
        assert "\n" not in reason
    with sqlite3.connect(tmp_path / "out" / "batch.sqlite") as ledger:
        assert ledger.execute("SELECT count(*) FROM attempts").fetchone() == (3,)
    assert [path.name for path in (tmp_path / "out").glob(".*")] == []


def test_a_tracker_that_ends_its_worker_fails_alone(
    site: Path, walks: Path, tmp_path: Path
) -> None:
    install_bad(site, "import os; os._exit(7)")
    out = tmp_path / "out"
    status, told, _ = run_batch(walks / "walk0", "-o", out, "--tracker", "bad")
    assert (status, list(told["failed"])) == (1, ["walk0"])
    assert "its worker died" in told["failed"]["walk0"]
    status, told, _ = run_batch(walks, "-o", out, "--tracker", "three-part")
    assert (status, len(told["done"])) == (0, 3)


def test_a_plugin_that_is_mended_is_run_again_and_only_then(
    site: Path, walks: Path, tmp_path: Path
) -> None:
    install_bad(site, "raise ValueError('no such person')")
    asked = (walks, "-o", tmp_path / "out", "--tracker", "bad")
    assert run_batch(*asked)[0] == 1
    assert "3 failed before" in run_batch(*asked)[2]
    code = site / "bad.py"
    code.write_text(code.read_text().replace("raise ValueError", "tuple"))
    status, told, _ = run_batch(*asked)
    assert (status, told["done"]) == (0, ["walk0", "walk1", "walk2"])
    with sqlite3.connect(tmp_path / "out" / "batch.sqlite") as ledger:
        before = ledger.execute("SELECT count(*) FROM attempts").fetchone()
        assert run_batch(*asked)[0] == 0
        assert ledger.execute("SELECT count(*) FROM attempts").fetchone() == before


def test_a_plugin_that_is_not_installed_any_more_is_told_before_any_work(
    site: Path, walks: Path, tmp_path: Path
) -> None:
    status, _, said = run_batch(walks, "-o", tmp_path / "out", "--tracker", "gone")
    assert status == 2
    assert "gone" in said
    assert not (tmp_path / "out").exists()
