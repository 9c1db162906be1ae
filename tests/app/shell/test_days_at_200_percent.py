"""The days of work on a 4K screen at 200 %, in a process of their own: Qt scales from its start."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

DAYS = Path(__file__).with_name("test_days_of_work.py")
ROOT = Path(__file__).parents[3]
SCREEN = {
    "name": "4K",
    "x": 0,
    "y": 0,
    "width": 3840,
    "height": 2160,
    "logicalDpi": 96,
    "logicalBaseDpi": 96,
    "dpr": 1.0,
}


@pytest.mark.slow
def test_the_days_are_worked_at_200_percent_by_keys_and_by_mouse(tmp_path: Path) -> None:
    place = tmp_path / "screen.json"
    place.write_text(json.dumps({"screens": [SCREEN]}))
    scaled = {
        **{name: value for name, value in os.environ.items() if not name.startswith("PYTEST")},
        "QT_QPA_PLATFORM": f"offscreen:configfile={place}",
        "QT_SCALE_FACTOR": "2",
    }
    asked = [sys.executable, "-m", "pytest", str(DAYS), "-k", "keys or mouse"]
    asked += ["-p", "no:cacheprovider", "--basetemp", str(tmp_path / "inner")]
    done = subprocess.run(asked, env=scaled, cwd=ROOT, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout[-4000:]
    assert " passed" in done.stdout, done.stdout
    assert "skipped" not in done.stdout
