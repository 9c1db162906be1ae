"""A session as the bytes of an HDF5 file, built in memory: nothing on disk can break it."""

from __future__ import annotations

import io
import json
import zlib
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.editing import Entry
from tracking.session.layout import (
    CHUNK_ROWS,
    EDIT_COLUMNS,
    FORMAT,
    OCCLUDER_COLUMNS,
    PART_LABEL_COLUMNS,
    REVIEWED_COLUMNS,
    RUN_TABLES,
    SOURCE_COLUMNS,
    TEXT,
    TRACK_LABEL_COLUMNS,
    TRAJECTORY_TYPE,
    VERSION,
    Types,
)
from tracking.session.reference import RecordingReference
from tracking.session.runs import StoredRun
from tracking.tracks import (
    CORRECTED_COLUMNS,
    PARTICLE_COLUMNS,
    Columns,
    Labels,
    Run,
    TrackTable,
    empty,
)

_COMPRESSION = 1
"""gzip's quickest level: with bytes shuffled, higher ones gain a few percent at twice the time."""


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
        edits: the log. runs: in memory, or still in a file they are copied from.
        newer: it was read from a file that may say more than this program knows.
    """

    stamps: Stamps
    recording: RecordingReference
    runs: tuple[Run | StoredRun, ...]
    tracks: TrackTable
    adopted: int | None
    labels: Labels
    edits: tuple[Entry, ...]
    newer: bool = False


def build_image(snapshot: Snapshot) -> memoryview:
    """The bytes of the session file. The same snapshot gives the same arrays, byte for byte."""
    image = io.BytesIO()
    with h5py.File(image, "w") as file:
        _write_stamps(file, snapshot.stamps)
        _write_recording(file.create_group("recording"), snapshot.recording)
        runs = file.create_group("runs")
        for number, run in enumerate(snapshot.runs):
            if isinstance(run, StoredRun):
                run.copy_into(runs, str(number))
            else:
                _write_run(runs.create_group(str(number)), run)
        columns = snapshot.tracks.columns()
        tracks = _write_table(file, "tracks", CORRECTED_COLUMNS, columns)
        tracks.attrs["highest_track"] = snapshot.tracks.highest_track
        tracks.attrs["run"] = -1 if snapshot.adopted is None else snapshot.adopted
        _write_labels(file, snapshot.labels)
        _write_table(file, "edits", EDIT_COLUMNS, _edit_columns(snapshot.edits))
        file.create_group("samples")
        _write_trajectory(file, columns, snapshot.recording.fps)
    return image.getbuffer()


def _write_stamps(file: h5py.File, stamps: Stamps) -> None:
    file.attrs["format"] = FORMAT
    file.attrs["format_version"] = ".".join(map(str, VERSION))
    for name in ("software", "created", "modified", "session", "save", "previous_save"):
        file.attrs[name] = getattr(stamps, name)
    file.attrs["included_steps"] = stamps.included


def _write_recording(group: h5py.Group, recording: RecordingReference) -> None:
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
        name: [getattr(source, name) for source in recording.sources] for name in SOURCE_COLUMNS
    }
    _write_table(group, "sources", SOURCE_COLUMNS, sources)


def _write_run(group: h5py.Group, run: Run) -> None:
    group.attrs["tracker"] = run.tracker
    group.attrs["settings"] = json.dumps(dict(run.settings), sort_keys=True)
    group.attrs["seed"] = run.seed
    group.attrs["frames"] = np.array(run.frames, np.int64)
    group.attrs["software"] = run.software
    group.attrs["detector"] = run.detector
    group.attrs["known_tracks"] = run.known_tracks
    tables: Mapping[str, Columns] = {
        "tracks": run.tracks,
        "detections": run.detections,
        "associations": run.associations,
        "parts": run.parts,
        "signals": run.signals,
    }
    for name, columns in tables.items():
        types = RUN_TABLES[name]
        _write_table(group, name, types, _by_frame_and_track(columns or empty(types)))
    whole = {name: np.asarray(run.particles.columns[name]) for name in PARTICLE_COLUMNS}
    particles = _write_table(group, "particles", PARTICLE_COLUMNS, whole)
    _write_column(particles, "start", np.asarray(run.particles.start, np.int64))


def _by_frame_and_track(columns: Columns) -> Columns:
    """The rows sorted as the file has them; trackers give those of one frame in any order."""
    frame, track = columns["frame"], columns["track"]
    later, same = frame[1:] > frame[:-1], frame[1:] == frame[:-1]
    if bool((later | (same & (track[1:] >= track[:-1]))).all()):
        return columns
    order = np.lexsort((track, frame))
    return {name: column[order] for name, column in columns.items()}


def _write_labels(file: h5py.File, labels: Labels) -> None:
    tracks = labels.tracks
    columns = {
        "track": np.array(list(tracks), np.int64),
        "name": [label.name for label in tracks.values()],
        "attributes": [json.dumps(dict(label.attributes)) for label in tracks.values()],
        "notes": [label.notes for label in tracks.values()],
    }
    group = _write_table(file, "labels", TRACK_LABEL_COLUMNS, columns)
    _write_table(group, "parts", PART_LABEL_COLUMNS, empty(PART_LABEL_COLUMNS))
    occluders = {
        "name": [item.name for item in labels.occluders],
        "polygon": [json.dumps(item.polygon) for item in labels.occluders],
    }
    _write_table(group, "occluders", OCCLUDER_COLUMNS, occluders)
    reviewed = {
        name: np.array([getattr(seen, name) for seen in labels.reviewed], np.int64)
        for name in REVIEWED_COLUMNS
    }
    _write_table(group, "reviewed", REVIEWED_COLUMNS, reviewed)


def _edit_columns(edits: Sequence[Entry]) -> dict[str, Any]:
    return {
        name: [getattr(entry, name) for entry in edits]
        if dtype == TEXT
        else np.array([getattr(entry, name) for entry in edits], dtype)
        for name, dtype in EDIT_COLUMNS.items()
    }


def _write_trajectory(file: h5py.File, columns: Columns, fps: float) -> None:
    """The layout of the Pedestrian Dynamics Data Archive; z is the floor's height, 0."""
    known = np.isfinite(columns["x"]) & np.isfinite(columns["y"])
    rows = np.zeros(int(np.count_nonzero(known)), TRAJECTORY_TYPE)
    for name, column in (("id", "track"), ("frame", "frame"), ("x", "x"), ("y", "y")):
        rows[name] = columns[column][known]
    _write_column(file, "trajectory", rows)
    file["trajectory"].attrs["fps"] = fps


def _write_table(
    parent: h5py.Group, name: str, types: Types, columns: Mapping[str, Any]
) -> h5py.Group:
    group = parent.create_group(name)
    for column, dtype in types.items():
        if dtype == TEXT:
            _write_text(group, column, columns[column])
        else:
            _write_column(group, column, np.asarray(columns[column], dtype))
    return group


def _write_text(group: h5py.Group, name: str, texts: Sequence[str]) -> None:
    dtype = h5py.string_dtype()
    group.create_dataset(
        name, data=np.array(texts, object) if texts else None, dtype=dtype, shape=(len(texts),)
    )


def _write_column(group: h5py.Group, name: str, values: NDArray[Any]) -> None:
    """A column in pieces of `CHUNK_ROWS`, bytes shuffled, then packed by gzip.

    Packed here, not by the HDF5 library: so it takes all cores, and reading other files does not
    wait, as the library does one thing at a time.
    """
    if not len(values):
        group.create_dataset(name, data=values)
        return
    rows = min(CHUNK_ROWS, len(values))
    dataset = group.create_dataset(
        name,
        shape=values.shape,
        dtype=values.dtype,
        chunks=(rows,),
        compression="gzip",
        compression_opts=_COMPRESSION,
        shuffle=True,
    )
    if len(values) == rows:
        dataset.id.write_direct_chunk((0,), _packed(values, rows))
        return
    starts = range(0, len(values), rows)
    with ThreadPoolExecutor() as pool:
        pieces = pool.map(lambda start: _packed(values[start : start + rows], rows), starts)
        for start, piece in zip(starts, pieces, strict=True):
            dataset.id.write_direct_chunk((start,), piece)


def _packed(values: NDArray[Any], rows: int) -> bytes:
    """What the library's shuffle and gzip filters make of a piece; the last one is filled up."""
    padded = np.zeros(rows, values.dtype)
    padded[: len(values)] = values
    if padded.itemsize == 1:
        return zlib.compress(padded.tobytes(), _COMPRESSION)
    by_byte = padded.view(np.uint8).reshape(rows, padded.itemsize)
    return zlib.compress(by_byte.T.tobytes(), _COMPRESSION)
