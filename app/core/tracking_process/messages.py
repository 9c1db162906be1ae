"""What the child says: a kind, a length, and then plain bytes. Nothing is pickled."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from enum import Enum
from typing import IO, Any

import numpy as np

import tracking.errors
from tracking.errors import TrackwrightError
from tracking.message_data import message_data, message_from
from tracking.trackers import ASSOCIATION_COLUMNS, StepResult
from tracking.tracks import (
    DETECTION_COLUMNS,
    EMBEDDING_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    DetectionsInput,
)
from tracking.translation import Message

_HEAD = struct.Struct("<BQ")  # kind, bytes that follow
_LEARNING = struct.Struct("<2q")
_STEP = struct.Struct("<11q")  # frame, rows of each table
_TABLES: tuple[Mapping[str, np.dtype[Any]], ...] = (
    TRACK_COLUMNS,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    ASSOCIATION_COLUMNS,
    SIGNAL_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    TRACKLET_COLUMNS,
    NETWORK_BOX_COLUMNS,
    EMBEDDING_COLUMNS,
)


class Kind(Enum):
    """What a message says."""

    STEPS = 1
    ERROR = 2
    DONE = 3
    NOTES = 4
    DETECTIONS_INPUT = 5
    LEARNING = 6


class TrackerBug(Exception):  # noqa: N818 - a report of what went wrong in the child
    """Something nobody expected went wrong in the child.

    The text is the last line of the child's traceback; the whole of it is a note of the exception,
    which stands in logs.
    """

    @classmethod
    def of(cls, trace: str) -> TrackerBug:
        """A bug by its traceback."""
        bug = cls(next(reversed(trace.strip().splitlines()), ""))
        bug.add_note(trace)
        return bug


def send(pipe: IO[bytes], kind: Kind, payload: bytes = b"") -> None:
    """Write a message."""
    pipe.write(_HEAD.pack(kind.value, len(payload)))
    pipe.write(payload)
    pipe.flush()


def receive(pipe: IO[bytes]) -> tuple[Kind, bytes] | None:
    """The next message; None where the child has ended, also in the middle of one."""
    head = pipe.read(_HEAD.size)
    if len(head) < _HEAD.size:
        return None
    kind, size = _HEAD.unpack(head)
    payload = pipe.read(size)
    return (Kind(kind), payload) if len(payload) == size else None


def packed_steps(steps: Sequence[StepResult]) -> bytes:
    """Steps as bytes: of each its frame, the rows of its tables, then column after column."""
    return b"".join(part for step in steps for part in _packed(step))


def unpacked_steps(payload: bytes) -> tuple[StepResult, ...]:
    """What `packed_steps` packed; the columns are views into the payload."""
    steps, at = [], 0
    while at < len(payload):
        frame, *rows = _STEP.unpack_from(payload, at)
        at += _STEP.size
        tables: list[Columns] = []
        for types, count in zip(_TABLES, rows, strict=True):
            columns = {}
            for name, dtype in types.items():
                columns[name] = np.frombuffer(payload, dtype, count, at)
                at += count * dtype.itemsize
            tables.append(columns)
        steps.append(StepResult(frame, *tables))
    return tuple(steps)


def packed_learning(done: int, total: int) -> bytes:
    """How much of the background is read, as bytes."""
    return _LEARNING.pack(done, total)


def unpacked_learning(payload: bytes) -> tuple[int, int]:
    """What `packed_learning` packed."""
    done, total = _LEARNING.unpack(payload)
    return int(done), int(total)


def packed_notes(notes: Sequence[Message]) -> bytes:
    """What the user should be told of the tracking, as bytes."""
    return json.dumps([message_data(note) for note in notes]).encode()


def unpacked_notes(payload: bytes) -> tuple[Message, ...]:
    """What `packed_notes` packed."""
    return tuple(map(message_from, json.loads(payload)))


def packed_input(detections_input: Sequence[DetectionsInput]) -> bytes:
    """Which detections of another program the tracker was given, as bytes."""
    return json.dumps([asdict(each) for each in detections_input]).encode()


def unpacked_input(payload: bytes) -> tuple[DetectionsInput, ...]:
    """What `packed_input` packed."""
    return tuple(DetectionsInput(**each) for each in json.loads(payload))


def packed_error(error: Exception, trace: str) -> bytes:
    """An error as bytes: one of ours with its kind, any other one as a bug with its trace."""
    said: dict[str, Any] = {"error": "", "trace": trace}
    if isinstance(error, TrackwrightError):
        said = {
            "error": type(error).__name__,
            "reason": message_data(error.reason),
            "to_do": message_data(error.to_do),
            "option": error.option,
        }
    return json.dumps(said).encode()


def unpacked_error(payload: bytes) -> Exception:
    """The error again."""
    said = json.loads(payload)
    if not said["error"]:
        return TrackerBug.of(said["trace"])
    kind = getattr(tracking.errors, said["error"], TrackwrightError)
    error: Exception = kind(
        message_from(said["reason"]), message_from(said["to_do"]), option=said["option"]
    )
    return error


def _packed(step: StepResult) -> Iterator[bytes]:
    tables = (
        *(step.tracks, step.detections, step.particles, step.associations, step.signals),
        *(step.parts, step.part_particles, step.tracklets),
        *(step.network_boxes, step.embeddings),
    )
    firsts = (next(iter(types)) for types in _TABLES)
    rows = [len(table[first]) for table, first in zip(tables, firsts, strict=True)]
    yield _STEP.pack(step.frame, *rows)
    for table, types in zip(tables, _TABLES, strict=True):
        for name, dtype in types.items():
            yield np.ascontiguousarray(table[name], dtype).tobytes()
