"""What the child is asked to do, as one line of JSON."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from tracking.detections import with_relative_paths
from tracking.pipeline import Tracking, track
from tracking.recording import OpenOptions, Recording
from tracking.recording.recording_loader import open_from_manifest
from tracking.trackers import Resume, settings_from, settings_values, tracker_named
from tracking.tracks import CORRECTED_COLUMNS, DetectionsInput


@dataclass(frozen=True, slots=True)
class TrackingRequest:
    """A tracker on a recording, in values that any process understands.

    Attributes:
        folder: what the manifest's paths are relative to.
        manifest: the recording's own, with what options said of it worked in.
        tracker: name in the catalogue. settings: by their dotted names.
        seed: of all random numbers.
        frames: half-open range, None for all.
        resume: what to go on from, None to begin anew.
    """

    folder: str
    manifest: str
    tracker: str
    settings: Mapping[str, Any]
    seed: int
    frames: tuple[int, int] | None
    resume: Resume | None = None

    @classmethod
    def of(
        cls,
        recording: Recording,
        tracker: str,
        settings: Any,
        seed: int,
        frames: tuple[int, int] | None,
        resume: Resume | None = None,
    ) -> TrackingRequest:
        """The same as `pipeline.track` is given; settings None takes the tracker's defaults."""
        settings = settings or tracker_named(tracker).settings_type()
        values = settings_values(with_relative_paths(recording, settings))
        folder = str(recording.folder.resolve())
        return cls(folder, recording.manifest_text, tracker, values, seed, frames, resume)

    def as_line(self) -> bytes:
        """For the child's standard input."""
        said = {field.name: getattr(self, field.name) for field in fields(self)}
        said["resume"] = None if self.resume is None else _as_json(self.resume)
        return json.dumps(said).encode() + b"\n"

    @classmethod
    def from_line(cls, line: bytes) -> TrackingRequest:
        """What `as_line` wrote."""
        values = json.loads(line)
        frames, resume = values.pop("frames"), values.pop("resume")
        return cls(
            **values,
            frames=None if frames is None else (frames[0], frames[1]),
            resume=None if resume is None else _from_json(resume),
        )

    def open(self) -> Recording:
        """The recording, opened once more.

        It is open already in the window, which is where the user allowed what lies outside.
        """
        options = OpenOptions(allow_outside=True)
        return open_from_manifest(Path(self.folder), self.manifest, options)

    def begin(self, recording: Recording) -> Tracking:
        """Put the tracker to work on it; only its steps are asked for."""
        settings = settings_from(tracker_named(self.tracker).settings_type, self.settings)
        asked = (self.tracker, settings, self.seed, self.frames, self.resume)
        return track(recording, *asked, keep=False)


def _as_json(resume: Resume) -> dict[str, Any]:
    """Plain values; Python's JSON gives every number back as it was, NaN too."""
    said = {field.name: getattr(resume, field.name) for field in fields(resume)}
    rows = {name: column.tolist() for name, column in resume.rows.items()}
    return {**said, "rows": rows, "detections_input": [asdict(d) for d in resume.detections_input]}


def _from_json(said: dict[str, Any]) -> Resume:
    """What `_as_json` said."""
    rows = {name: np.array(said["rows"][name], t) for name, t in CORRECTED_COLUMNS.items()}
    told = tuple(DetectionsInput(**each) for each in said["detections_input"])
    frames = tuple(said["colour_frames"])
    return Resume(**{**said, "rows": rows, "colour_frames": frames, "detections_input": told})
