"""What libraries are told by the environment that the program makes."""

from __future__ import annotations

import os
import subprocess
import sys

VARIABLES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")
PROBE = f"""
import os, sys
import app.__main__ as program
early = "numpy" not in sys.modules
program.run = lambda _: print(early, *(os.environ[name] for name in {VARIABLES}))
program.main()
"""


CUT_IMAGE = """
import app.__main__ as program

def decode(_):
    import cv2, numpy as np
    noise = np.random.default_rng(0).integers(0, 255, (48, 64, 3), np.uint8)
    cv2.imdecode(cv2.imencode(".png", noise)[1][:900], cv2.IMREAD_COLOR)

program.run = decode
program.main()
"""


def begun(**environment: str) -> list[str]:
    """Whether NumPy is yet to be imported when the program begins, and what it will read then."""
    kept = {name: value for name, value in os.environ.items() if name not in VARIABLES}
    done = subprocess.run(
        [sys.executable, "-c", PROBE],
        env={**kept, **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.split()


def test_the_program_has_numpy_work_with_one_thread() -> None:
    assert begun() == ["True", "1", "1"]


def test_who_asks_for_more_threads_has_them() -> None:
    assert begun(OPENBLAS_NUM_THREADS="2") == ["True", "2", "1"]


def test_opencv_s_own_warnings_stay_away_from_ours() -> None:
    """OpenCV writes to the file descriptor, past Python."""
    kept = {name: value for name, value in os.environ.items() if name != "OPENCV_LOG_LEVEL"}
    words = [sys.executable, "-c", CUT_IMAGE]
    assert "WARN" in _told(words, {**kept, "OPENCV_LOG_LEVEL": "WARNING"})
    assert _told(words, kept) == ""


def _told(words: list[str], environment: dict[str, str]) -> str:
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
    return done.stderr
