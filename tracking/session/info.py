"""What a session holds, told without loading its tables."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tracking.errors import EditError, SessionError
from tracking.session.edited_tracks import EditedTracks
from tracking.session.hdf5 import open_readonly, text_attribute
from tracking.session.label_tables import read_labels
from tracking.session.pending_edits import may_wait, read_with_waiting
from tracking.session.reference import RecordingReference
from tracking.session.run_notes import read_notes
from tracking.session.runs import read_detections_input, read_settings
from tracking.session.session_reader import (
    check_file,
    check_version,
    read_recording,
    read_stamps,
    report_findings,
)
from tracking.trackers import changed_settings
from tracking.tracks import PART_NAMES, Labels


def describe(path: Path) -> dict[str, Any]:
    """What `trackwright info` tells of a session: plain values, ready for JSON.

    Edits that wait in the journal count, as they do when the session is opened.

    Raises SessionError as `Session.open` does.
    """
    _, damage = check_version(path)
    with _told(path) as file:
        stamps = read_stamps(file)
        damage += report_findings(file, path)
    read = read_with_waiting(path) if may_wait(path, stamps) else None
    with _told(path) as file:
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
            **(_in_file(file) if read is None else _as_opened(read.edited, read.waiting)),
            "runs": _runs(file),
            "created": text_attribute(file, "created"),
            "modified": text_attribute(file, "modified"),
            "software": text_attribute(file, "software"),
            "damage": [*damage, *(() if read is None else read.damage)],
        }


def recording_of(path: Path) -> RecordingReference:
    """The recording a session is of, told without loading its tables.

    Raises SessionError as `Session.open` does.
    """
    check_file(path)
    with open_readonly(path) as file:
        return read_recording(file["recording"])


@contextmanager
def _told(path: Path) -> Iterator[h5py.File]:
    """The file; what it says wrongly of people's labels is damage."""
    try:
        with open_readonly(path) as file:
            yield file
    except EditError as why:
        raise SessionError(
            "{path}: the session file is damaged: {why}", path=path, why=why
        ) from why


def _runs(file: h5py.File) -> list[dict[str, Any]]:
    given = read_detections_input(file)
    return [
        {
            **_run(file[f"runs/{number}"]),
            "detections_input": list(map(asdict, given.get(number, ()))),
        }
        for number in range(len(file["runs"]))
    ]


def _run(group: h5py.Group) -> dict[str, Any]:
    """A run: how it was made, with the settings that are not its tracker's defaults."""
    tracker, detector = text_attribute(group, "tracker"), text_attribute(group, "detector")
    settings = read_settings(group)
    own = "file" if settings.get("detector") else "built-in"
    return {
        "tracker": tracker,
        "frames": [int(frame) for frame in group.attrs["frames"]],
        "seed": int(group.attrs["seed"]),
        "detector": detector,
        "detector_from": own if detector else None,
        "settings": changed_settings(tracker, settings),
        "notes": list(read_notes(group)),
    }


def _in_file(file: h5py.File) -> dict[str, Any]:
    """What changes with edits, as it was saved."""
    undone = file["edits/undone"][()]
    return {
        "tracks": len(np.unique(file["tracks/track"][()])),
        "rows": len(file["tracks/track"]),
        "edits": int(np.count_nonzero(~undone)),
        "undone_edits": int(np.count_nonzero(undone)),
        "edits_waiting_in_journal": 0,
        "labels": _counted(read_labels(file)),
    }


def _as_opened(edited: EditedTracks, waiting: int) -> dict[str, Any]:
    """The same with the journal's steps."""
    undone = sum(entry.undone for entry in edited.history.entries)
    return {
        "tracks": len(edited.tracks.track_ids),
        "rows": len(edited.tracks),
        "edits": len(edited.history) - undone,
        "undone_edits": undone,
        "edits_waiting_in_journal": waiting,
        "labels": _counted(edited.labels),
    }


def _counted(labels: Labels) -> dict[str, Any]:
    """How much people said, by what it is about."""
    said = Counter((one.part, one.on_part) for one in labels.parts.values())
    answers = {"on": True, "off": False, "unsure": None}
    return {
        "parts": {
            part.replace("-", "_"): {word: said[number, on] for word, on in answers.items()}
            for number, part in enumerate(PART_NAMES)
        },
        "occluders": len(labels.occluders),
        "lines": len(labels.lines),
        "regions": len(labels.regions),
        "reviewed_ranges": len(labels.reviewed),
        "described_tracks": len(labels.tracks),
        "decided_review_items": len(labels.verdicts),
    }
