"""The runner of the sweeps: which runs it does, what it prints, and how it ends."""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[1]
SWEEP = """
import sys
from tests.sweeps.runner import sweep

def attack(worker):
    for number in worker.numbers:
        worker.count("runs")
        worker.count("grown", -1)
        worker.count("drawn", worker.chance().randrange(1000))
        if number == 7:
            raise ValueError("seven")
        if number % 3 == 2:
            yield f"{number} is bad"

sys.exit(sweep(attack, 6))
"""


def swept(folder: Path, *words: str) -> tuple[int, list[str], dict]:
    """The exit status, the lines printed, and what the last one says."""
    script = folder / "odd.py"
    script.write_text(SWEEP)
    ended = subprocess.run(
        [sys.executable, script, *words],
        env={"PYTHONPATH": str(ROOT), "PATH": ""},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    lines = ended.stdout.splitlines()
    return ended.returncode, lines, json.loads(lines[-1])


def test_all_workers_do_their_share_and_violations_fail(tmp_path: Path) -> None:
    status, lines, told = swept(tmp_path)
    assert (status, told["counts"]["runs"], told["violations"]) == (1, 6, 2)
    assert sorted(line for line in lines if "is bad" in line) == [
        "VIOLATION run 2: 2 is bad",
        "VIOLATION run 5: 5 is bad",
    ]
    assert "  again: python -m tests.sweeps.odd --resume 5 --runs 1" in lines
    assert lines[-2].startswith("| `python -m tests.sweeps.odd` | whole, ")
    assert told["counts"]["grown"] == -6


def test_a_run_seen_again_alone_is_the_same(tmp_path: Path) -> None:
    alone = [swept(tmp_path, "--resume", str(number), "--runs", "1")[2] for number in range(3)]
    together = swept(tmp_path, "3", "--workers", "1")[2]["counts"]
    assert sum(each["counts"]["drawn"] for each in alone) == together["drawn"]
    other = swept(tmp_path, "3", "--seed", "2")[2]["counts"]
    assert other["drawn"] != together["drawn"]


def test_without_violations_the_status_is_zero(tmp_path: Path) -> None:
    assert swept(tmp_path, "--runs", "2")[0] == 0


def test_an_error_of_the_sweep_is_a_violation_of_its_run(tmp_path: Path) -> None:
    status, lines, told = swept(tmp_path, "--resume", "6", "--runs", "2")
    assert (status, told["violations"], told["resume"]) == (1, 1, 7)
    assert "VIOLATION run 7: Traceback (most recent call last):" in lines
    assert "ValueError: seven" in lines


def test_a_sweep_whose_time_is_up_says_where_to_go_on(tmp_path: Path) -> None:
    status, lines, told = swept(tmp_path, "--seconds", "0", "--resume", "4")
    assert (status, told["resume"], told["counts"]) == (0, 4, {})
    assert "whole" not in lines[-2]
