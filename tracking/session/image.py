"""What a session file says, written into a new one."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.editing import TOUCHED_COLUMNS, Entry, History, TouchIndex
from tracking.failure import FEATURE_NAMES, SAMPLE_COLUMNS, Samples
from tracking.message_data import kept_values
from tracking.session.findings import Finding, write_findings
from tracking.session.image_file import ImageFile
from tracking.session.label_tables import tables_of
from tracking.session.layout import (
    CHUNK_ROWS,
    FORMAT,
    RUN_TABLES,
    TABLES,
    TEXT,
    TRAJECTORY_TYPE,
    VERSION,
)
from tracking.session.reference import RecordingReference
from tracking.session.run_notes import write_notes
from tracking.session.runs import StoredRun, detections_input_rows
from tracking.session.samples import KeptSamples
from tracking.session.table_writer import Packer
from tracking.tracks import (
    Columns,
    Labels,
    ParticleColumn,
    Particles,
    Run,
    TrackTable,
    empty,
)
from tracking.tracks.growable_columns import ColumnInOrder
from tracking.translation import Message


@dataclass(frozen=True, slots=True)
class Stamps:
    """Which session and which of its saves a file is.

    Attributes:
        session: made up when the session was; stays with it.
        save, previous_save: made up at every save; "" before the first.
        included: how many steps of the journal that builds on previous_save are in the file.
        created, modified: UTC, ISO 8601. software: name and version.
    """

    session: str
    save: str
    previous_save: str
    included: int
    created: str
    modified: str
    software: str


@dataclass(frozen=True, slots=True)
class Snapshot:
    """Everything a session file says, as it was at one moment.

    Attributes:
        tracks: a snapshot of the corrected table; adopted: the run it began as, or None.
        edits: the log; touched: `TOUCHED_COLUMNS` of those of which it is known.
        runs: in memory, or still in a file they are copied from.
        newer: it was read from a file that may say more than this program knows.
        changed: it was read from a file that is not as it was saved.
        damage: what is damaged of that file, or was once, in lines for people.
        findings: the damage that was ever found of the session.
        began_as: the adopted run where it is in memory already.
        samples: what the save before made of the labels.
        colours: place in the window's palette by track; of tracks nobody looked at none is known.
    """

    stamps: Stamps
    recording: RecordingReference
    runs: tuple[Run | StoredRun, ...]
    tracks: TrackTable
    adopted: int | None
    labels: Labels
    edits: tuple[Entry, ...]
    touched: Columns
    newer: bool = False
    changed: bool = False
    damage: tuple[Message, ...] = ()
    findings: tuple[Finding, ...] = ()
    began_as: Run | None = None
    samples: KeptSamples = field(default_factory=KeptSamples)
    colours: Mapping[int, int] = field(default_factory=dict)

    def samples_now(self) -> Samples:
        """What the part labels teach the failure detector; none where that cannot be told."""
        recording = self.recording.fps, self.recording.name
        return self.samples.of(self.labels, self.tracks, self._loaded, recording)

    def _loaded(self) -> Run | None:
        if self.adopted is None or self.began_as is not None:
            return self.began_as
        run = self.runs[self.adopted]
        return run.load() if isinstance(run, StoredRun) else run

    def history(self) -> History:
        """The log, to go on with."""
        return History(self.edits, TouchIndex.from_columns(self.touched, len(self.edits)))


def empty_snapshot(stamps: Stamps, recording: RecordingReference) -> Snapshot:
    """What a session on a recording says before anything was tracked or edited."""
    nothing = empty(TOUCHED_COLUMNS)
    return Snapshot(stamps, recording, (), TrackTable(), None, Labels(), (), nothing)


def write_image(snapshot: Snapshot, image: ImageFile) -> None:
    """Write the session file. The same snapshot gives the same arrays, byte for byte.

    Raises OSError where the disk refuses.
    """
    packer = Packer(image)
    with h5py.File(image, "w") as file:
        _write_stamps(file, snapshot.stamps)
        write_findings(file, snapshot.findings)
        _write_recording(packer, file.create_group("recording"), snapshot.recording)
        runs = file.create_group("runs")
        for number, run in enumerate(snapshot.runs):
            if isinstance(run, StoredRun):
                run.copy_into(image, runs.create_group(str(number)))
            else:
                _write_run(packer, runs.create_group(str(number)), run)
        _write_detections_input(packer, file, snapshot.runs)
        columns = snapshot.tracks.in_order()
        tracks = packer.table(file, "tracks", columns)
        tracks.attrs["count"] = len(snapshot.tracks.track_ids)
        tracks.attrs["highest_track"] = snapshot.tracks.highest_track
        tracks.attrs["run"] = -1 if snapshot.adopted is None else snapshot.adopted
        _write_colours(packer, file, snapshot.colours)
        for path, rows in tables_of(snapshot.labels).items():
            packer.table(file, path, rows)
        packer.table(file, "edits", _edit_columns(snapshot.edits))
        packer.table(file, "edits/touched", snapshot.touched)
        _write_samples(packer, file, snapshot.samples_now())
        places = Trajectory(columns)
        trajectory = packer.column(file, "trajectory", places, TRAJECTORY_TYPE)
        trajectory.attrs["fps"] = snapshot.recording.fps


def _write_stamps(file: h5py.File, stamps: Stamps) -> None:
    file.attrs["format"] = FORMAT
    file.attrs["format_version"] = ".".join(map(str, VERSION))
    for name in ("software", "created", "modified", "session", "save", "previous_save"):
        file.attrs[name] = getattr(stamps, name)
    file.attrs["included_steps"] = stamps.included


def _write_recording(packer: Packer, group: h5py.Group, recording: RecordingReference) -> None:
    group.attrs["name"] = recording.name
    group.attrs["path"] = recording.path
    group.attrs["fps"] = recording.fps
    group.attrs["frame_count"] = recording.frame_count
    group.attrs["width"], group.attrs["height"] = recording.size
    group.attrs["stereo"] = recording.is_stereo
    group.attrs["own_manifest"] = recording.own_manifest
    for name in ("manifest", "calibration"):
        group.create_dataset(name, data=getattr(recording, name), dtype=h5py.string_dtype())
    sources = {
        name: [getattr(source, name) for source in recording.sources]
        for name in TABLES["recording/sources"].columns
    }
    packer.table(group, "sources", sources)


def _write_run(packer: Packer, group: h5py.Group, run: Run) -> None:
    group.attrs["tracker"] = run.tracker
    group.attrs["settings"] = json.dumps(dict(run.settings), sort_keys=True)
    group.attrs["seed"] = run.seed
    group.attrs["frames"] = np.array(run.frames, np.int64)
    group.attrs["software"] = run.software
    group.attrs["detector"] = run.detector
    group.attrs["known_tracks"] = run.known_tracks
    group.attrs["made"] = run.made
    write_notes(group, run.notes)
    for name in RUN_TABLES:
        rows: Columns | Particles = getattr(run, name)
        if isinstance(rows, Particles):
            table = packer.table(group, name, rows.columns, noisy=True)
            packer.column(table, "start", rows.start, np.dtype(np.int64))
        else:
            packer.table(group, name, _by_frame_and_track(rows))


def _by_frame_and_track(columns: Columns) -> Mapping[str, ParticleColumn]:
    """The rows sorted as the file has them; trackers give those of one frame in any order."""
    frame, track = columns["frame"], columns["track"]
    later, same = frame[1:] > frame[:-1], frame[1:] == frame[:-1]
    if bool((later | (same & (track[1:] >= track[:-1]))).all()):
        return columns
    order = np.lexsort((track, frame))
    return {name: ColumnInOrder(column.__getitem__, order) for name, column in columns.items()}


def _write_detections_input(
    packer: Packer, file: h5py.File, runs: Sequence[Run | StoredRun]
) -> None:
    rows = detections_input_rows(runs)
    if rows["run"]:
        packer.table(file, "detections_input", rows)


def _write_colours(packer: Packer, file: h5py.File, colours: Mapping[int, int]) -> None:
    tracks = sorted(colours)
    rows = {"track": tracks, "place": [colours[track] for track in tracks]}
    packer.table(file, "colours", rows)


def _write_samples(packer: Packer, file: h5py.File, samples: Samples) -> None:
    if not len(samples):
        file.create_group("samples")
        return
    texts = {name for name, dtype in SAMPLE_COLUMNS.items() if dtype == TEXT}
    columns = {
        name: samples.columns[name].tolist() if name in texts else samples.columns[name]
        for name in SAMPLE_COLUMNS
    }
    features = dict(zip(FEATURE_NAMES, samples.features.T, strict=True))
    packer.table(file, "samples", {**columns, **features})


def _edit_columns(edits: Sequence[Entry]) -> dict[str, Any]:
    columns: dict[str, Any] = {
        name: [getattr(entry, name) for entry in edits]
        if dtype == TEXT
        else np.array([getattr(entry, name) for entry in edits], dtype)
        for name, dtype in TABLES["edits"].columns.items()
        if name not in ("scope", "message")
    }
    scopes = [entry.scope.as_text if entry.scope else "" for entry in edits]
    return {**columns, "scope": scopes, "message": [kept_values(entry.text) for entry in edits]}


class Trajectory:
    """The corrected tracks as rows of the Pedestrian Dynamics Data Archive, read by slices.

    Rows without a place on the floor are left out; z is the floor's height, 0.
    """

    def __init__(self, columns: Mapping[str, ParticleColumn]) -> None:
        """`CORRECTED_COLUMNS`, sorted by frame then track."""
        self._columns = columns
        known = [
            np.isfinite(columns["x"][start : start + CHUNK_ROWS])
            & np.isfinite(columns["y"][start : start + CHUNK_ROWS])
            for start in range(0, len(columns["x"]), CHUNK_ROWS)
        ]
        self._rows = np.flatnonzero(np.concatenate(known)) if known else np.zeros(0, np.int64)

    def __len__(self) -> int:
        """How many rows have a place."""
        return len(self._rows)

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        """A stretch of them."""
        chosen = self._rows[rows]
        made = np.zeros(len(chosen), TRAJECTORY_TYPE)
        if len(chosen):
            first, stop = int(chosen[0]), int(chosen[-1]) + 1
            for name, column in (("id", "track"), ("frame", "frame"), ("x", "x"), ("y", "y")):
                made[name] = self._columns[column][first:stop][chosen - first]
        return made
