"""Memory of the window: what a recording took is given back when it is closed."""

import subprocess
import sys
from pathlib import Path

import pytest
from patient import PATIENCE_S

_ROOT = Path(__file__).parents[3]
_FOOTAGE = _ROOT.parent / "shared" / "data" / "rendered-lobby"


@pytest.mark.skipif(sys.platform != "linux", reason="resident memory is read from /proc")
@pytest.mark.skipif(not _FOOTAGE.is_dir(), reason="there is no footage in ../shared/data")
def test_recordings_that_were_closed_take_no_memory():
    done = subprocess.run(
        [sys.executable, "-m", "tests.sweeps.open_close", "4", "--session", str(_FOOTAGE)],
        cwd=_ROOT,
        capture_output=True,
        text=True,
        timeout=PATIENCE_S * 4,
    )
    assert done.returncode == 0, done.stdout + done.stderr
