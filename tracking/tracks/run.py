"""What a tracker found in a recording: immutable once made."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.tracks.columns import (
    ASSOCIATION_COLUMNS,
    EMBEDDING_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    Types,
    empty,
)
from tracking.translation import Message


class ParticleColumn(Protocol):
    """A column that may be in memory or still in a file: an array, or what reads like one."""

    def __len__(self) -> int:
        """The number of rows."""

    def __getitem__(self, rows: slice, /) -> NDArray[Any]:
        """A stretch of rows."""


@dataclass(frozen=True, slots=True)
class Particles:
    """The particles of consecutive frames, one frame's after the other's.

    Attributes:
        start: (frames + 1,) int64; the particles of frame i (counted from the recording's first
            frame) are the rows start[i] to start[i + 1].
        columns: `PARTICLE_COLUMNS`, `PART_PARTICLE_COLUMNS` where they are of parts,
            `TRACKLET_COLUMNS` or `NETWORK_BOX_COLUMNS`; of a run read from a session they stay in
            the file and are read as they are asked for, by slices. `numpy.asarray` reads a whole
            one.
    """

    start: NDArray[np.int64]
    columns: Mapping[str, ParticleColumn]

    @classmethod
    def none(cls, columns: Types) -> Particles:
        """No particles in any frame, with these columns."""
        return cls(np.zeros(1, np.int64), empty(columns))

    def of_frame(self, frame: int) -> dict[str, NDArray[Any]]:
        """The columns of one frame's particles; empty where the frame was not tracked."""
        if not 0 <= frame < len(self.start) - 1:
            return {name: column[0:0] for name, column in self.columns.items()}
        rows = slice(int(self.start[frame]), int(self.start[frame + 1]))
        return {name: column[rows] for name, column in self.columns.items()}


@dataclass(frozen=True, slots=True)
class DetectionsInput:
    """A file of another program's detections that a tracker saw people by.

    Attributes:
        camera: "left" or "right"; "" of a network, which looks at all that the tracker does.
        file: its name. format: "mot", "coco", "yolo" or "network".
        fingerprint: SHA-256 of all its bytes, in hex; of a network: of its TOML and then its ONNX.
        count: how many boxes it has, or found.
        network, decoder, licence: of a network, as its TOML says; "" of a file.
    """

    camera: str
    file: str
    format: str
    fingerprint: str
    count: int
    network: str = ""
    decoder: str = ""
    licence: str = ""

    def is_among(self, known: Iterable[DetectionsInput]) -> bool:
        """Whether one of them is the same boxes of the same camera, whatever their file's name."""
        return any(
            (one.camera, one.fingerprint) == (self.camera, self.fingerprint) for one in known
        )


@dataclass(frozen=True, slots=True)
class Run:
    """One tracker's result over a recording (or a stretch of it), never changed by edits.

    Every table has all its columns, also where it has no rows.

    Attributes:
        tracker: name in the catalogue.
        settings: the settings in force, as plain JSON values.
        seed: of the random numbers.
        frames: half-open range of frames that were tracked.
        tracks, detections: `TRACK_COLUMNS` and `DETECTION_COLUMNS`, sorted by frame.
        particles: what the overhead view shows.
        associations: per matched pair the columns frame, track, distance, colour, direction,
            total, margin (total cost of the next best choice less this one's); NaN where a cue was
            not used.
        parts: `PART_COLUMNS` of a tracker that follows parts; empty from others.
        part_particles: in the picture, of such a tracker; see `PART_PARTICLE_COLUMNS`.
        tracklets: `TRACKLET_COLUMNS`, of a tracker that follows points; held as particles are.
        network_boxes: `NETWORK_BOX_COLUMNS`, of a run that a network found people for; held as
            particles are.
        embeddings: `EMBEDDING_COLUMNS`, until the run is finished; no finished run has them.
        signals: `SIGNAL_COLUMNS`, a row for each row of the tracks; empty in runs of programs that
            did not notice them, and in imported ones.
        software: name and version that made it.
        detector: fingerprint of the failure detector, "" where none was used.
        known_tracks: of a run that tracked again from corrected tracks: the highest id there was;
            ids up to it are those of the corrected tracks. 0: a run with ids of its own.
        made: when it was added to a session: UTC, ISO 8601; "" where nobody knows.
        notes: what the user was told of the tracking, a line each.
        detections_input: the files of another program's detections it was given; none if none.
    """

    tracker: str
    settings: Mapping[str, Any]
    seed: int
    frames: tuple[int, int]
    tracks: Columns
    detections: Columns
    particles: Particles
    associations: Columns = field(default_factory=partial(empty, ASSOCIATION_COLUMNS))
    parts: Columns = field(default_factory=partial(empty, PART_COLUMNS))
    signals: Columns = field(default_factory=partial(empty, SIGNAL_COLUMNS))
    part_particles: Particles = field(
        default_factory=partial(Particles.none, PART_PARTICLE_COLUMNS)
    )
    tracklets: Particles = field(default_factory=partial(Particles.none, TRACKLET_COLUMNS))
    embeddings: Columns = field(default_factory=partial(empty, EMBEDDING_COLUMNS))
    network_boxes: Particles = field(default_factory=partial(Particles.none, NETWORK_BOX_COLUMNS))
    software: str = ""
    detector: str = ""
    known_tracks: int = 0
    made: str = ""
    notes: tuple[Message, ...] = ()
    detections_input: tuple[DetectionsInput, ...] = ()
