"""Sessions to attack: made up, or of a rendered recording that is tracked."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "session"))

from made_up_sessions import make_recording, make_run

from tests.sweeps.runner import ended, forked
from tracking.pipeline import track
from tracking.recording import open_recording
from tracking.session import Session
from tracking.synthesis import render_recording

SMALL: dict[str, Any] = {"scene": "plaza", "people": 4, "size": (320, 240), "fps": 8.0}
LOBBY: dict[str, Any] = {"scene": "lobby", "tracker": "stereo-direction"}
"""With particles, in full size."""
_IMPORTED_ROWS = 12


def made_session(folder: Path) -> Path:
    """A session of made-up tracks, and a MOT file beside it to import; closed."""
    path = folder / "s.h5"
    Session.create(make_recording(folder / "recording"), [make_run()], path).close()
    boxes = "".join(f"{n + 1},7,{n}.5,20,30,60,1,-1,-1,-1\n" for n in range(_IMPORTED_ROWS))
    (folder / "tracks.txt").write_text(boxes)
    return path


def tracked_session(folder: Path, scene: str, tracker: str = "", **rendered: Any) -> Path:
    """Ten seconds of a scene, rendered into a folder, and tracked: by a fork, as threads start."""
    recording, path = folder / "recording", folder / "tracked.h5"

    def make() -> None:
        render_recording(recording, scene, 10.0, seed=3, **rendered)
        with open_recording(recording) as opened, track(opened, tracker or None) as tracking:
            for _ in tracking:
                pass
            Session.create(opened, [tracking.run()], path).close()

    if ended(forked(make)):
        raise RuntimeError("the session was not made")
    return path
