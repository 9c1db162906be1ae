"""A session with particles and its recording, small, for what is done in the window."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

_SECONDS = "10"


def session_with_particles(folder: Path) -> Path:
    """Render a recording into a folder and track it; the session."""
    recording, session = folder / "recording", folder / "session.h5"
    _run("synth", str(recording), "--scene", "lobby", "--seconds", _SECONDS, "--seed", "101")
    _run("track", str(recording), "-o", str(session), "--tracker", "stereo-direction")
    return session


def _run(*words: str) -> None:
    subprocess.run([sys.executable, "-m", "app", *words], check=True)
