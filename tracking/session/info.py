"""What a session holds, told without loading its tables."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from tracking.session.hdf5 import opened, text_attribute
from tracking.session.reading import check_file, read_recording
from tracking.session.store import has_waiting_journal


def describe(path: Path) -> dict[str, Any]:
    """What `trackwright info` tells of a session: plain values, ready for JSON.

    Raises SessionError as `Session.open` does.
    """
    check_file(path)
    with opened(path) as file:
        recording = read_recording(file["recording"])
        undone = file["edits/undone"][()]
        return {
            "kind": "session",
            "path": str(path),
            "name": recording.name,
            "recording": recording.path,
            "frames": recording.frame_count,
            "fps": recording.fps,
            "size": list(recording.size),
            "stereo": recording.is_stereo,
            "calibrated": bool(recording.calibration),
            "duration_s": recording.frame_count / recording.fps if recording.fps else 0.0,
            "tracks": len(np.unique(file["tracks/track"][()])),
            "rows": len(file["tracks/track"]),
            "edits": int(np.count_nonzero(~undone)),
            "undone_edits": int(np.count_nonzero(undone)),
            "edits_waiting_in_journal": has_waiting_journal(path),
            "runs": [
                {
                    "tracker": text_attribute(file[f"runs/{number}"], "tracker"),
                    "frames": [int(frame) for frame in file[f"runs/{number}"].attrs["frames"]],
                    "seed": int(file[f"runs/{number}"].attrs["seed"]),
                }
                for number in range(len(file["runs"]))
            ],
            "created": text_attribute(file, "created"),
            "modified": text_attribute(file, "modified"),
            "software": text_attribute(file, "software"),
        }
