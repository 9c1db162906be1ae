"""What a session holds, told without loading its tables."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tracking.session.edited import Edited
from tracking.session.hdf5 import opened, text_attribute
from tracking.session.reading import check_file, read_recording
from tracking.session.waiting import read_with_waiting


def describe(path: Path) -> dict[str, Any]:
    """What `trackwright info` tells of a session: plain values, ready for JSON.

    Edits that wait in the journal count, as they do when the session is opened.

    Raises SessionError as `Session.open` does.
    """
    check_file(path)
    waiting = read_with_waiting(path)
    with opened(path) as file:
        recording = read_recording(file["recording"])
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
            **(_in_file(file) if waiting is None else _as_opened(*waiting)),
            "runs": [
                {
                    "tracker": text_attribute(file[f"runs/{number}"], "tracker"),
                    "frames": [int(frame) for frame in file[f"runs/{number}"].attrs["frames"]],
                    "seed": int(file[f"runs/{number}"].attrs["seed"]),
                    "detector": text_attribute(file[f"runs/{number}"], "detector"),
                }
                for number in range(len(file["runs"]))
            ],
            "created": text_attribute(file, "created"),
            "modified": text_attribute(file, "modified"),
            "software": text_attribute(file, "software"),
        }


def _in_file(file: h5py.File) -> dict[str, int]:
    """What changes with edits, as it was saved."""
    undone = file["edits/undone"][()]
    return {
        "tracks": len(np.unique(file["tracks/track"][()])),
        "rows": len(file["tracks/track"]),
        "edits": int(np.count_nonzero(~undone)),
        "undone_edits": int(np.count_nonzero(undone)),
        "edits_waiting_in_journal": 0,
    }


def _as_opened(edited: Edited, waiting: int) -> dict[str, int]:
    """The same with the journal's steps."""
    undone = sum(entry.undone for entry in edited.history.entries)
    return {
        "tracks": len(edited.tracks.track_ids),
        "rows": len(edited.tracks),
        "edits": len(edited.history) - undone,
        "undone_edits": undone,
        "edits_waiting_in_journal": waiting,
    }
