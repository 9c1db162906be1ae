"""The session file's layout: tables, column types, version.

One definition to check a file by, to write it and to read it.
"""

from __future__ import annotations

import re
from collections.abc import Container, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from tracking.editing.log.touch_index import TOUCHED_COLUMNS
from tracking.failure.core.features import EVIDENCE_NAMES, FEATURE_NAMES
from tracking.failure.core.samples import SAMPLE_COLUMNS
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    CORRECTED_COLUMNS,
    DETECTION_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_EVIDENCE,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Types,
    column_types,
)

FORMAT = "trackwright-session"
VERSION = (1, 8)
"""Major: older programs cannot read it. Minor: they can, and miss something."""

CHUNK_ROWS = 65_536

TEXT = np.dtype(object)
"""Stands for a column of text: UTF-8 of any length."""


@dataclass(frozen=True, slots=True)
class Table:
    """A group of columns that are equally long.

    Attributes:
        columns: dtype by name.
        later: columns that files of format 1.0 do not have: those that came together.
        is_later: whether files of format 1.0 do not have the table.
        by_frame: it stays in the file, and its column `start` has an offset a frame.
    """

    columns: Types
    later: tuple[frozenset[str], ...] = ()
    is_later: bool = False
    by_frame: bool = False

    def columns_in(self, held: Container[str]) -> Types:
        """The columns that a table must have: of those that came together later all or none."""
        missing = {
            column
            for together in self.later
            if not any(name in held for name in together)
            for column in together
        }
        return {name: dtype for name, dtype in self.columns.items() if name not in missing}


def _later(*columns: str) -> frozenset[str]:
    return frozenset(columns)


TRAJECTORY_TYPE = np.dtype(
    [("id", np.int32), ("frame", np.int32), ("x", np.float64), ("y", np.float64), ("z", np.float64)]
)

SAMPLES = Table(
    column_types(**SAMPLE_COLUMNS, **dict.fromkeys(FEATURE_NAMES, np.float64)),
    (_later(*EVIDENCE_NAMES),),
)
"""What the part labels teach the failure detector, made anew at every save. Without samples the
group is empty; files before format 1.2 never have any."""

TABLES: Mapping[str, Table] = MappingProxyType(
    {
        "recording/sources": Table(column_types(source=TEXT, size_bytes=np.int64, sha256=TEXT)),
        "tracks": Table(CORRECTED_COLUMNS),
        # The colour each track is shown in: its place in the window's palette. Came with 1.5.
        "colours": Table(column_types(track=np.int64, place=np.uint8), is_later=True),
        "labels": Table(column_types(track=np.int64, name=TEXT, attributes=TEXT, notes=TEXT)),
        "labels/parts": Table(
            column_types(
                frame=np.int32,
                track=np.int32,
                part=np.uint8,  # 0 head, 1 torso, 2 hip-leg
                on_part=np.bool_,  # False also where a person is unsure
                sure=np.bool_,
                left=np.float64,  # px of the left image as recorded, 0-based
                top=np.float64,
                width=np.float64,
                height=np.float64,
                source=np.uint8,  # of the rectangle: 0 tracker, 1 person, 2 truth
                author=TEXT,
                reason=TEXT,  # why it was suggested; "": it was not
            ),
            (
                _later("sure", "left", "top", "width", "height", "source"),
                _later("author", "reason"),
            ),
        ),
        "labels/occluders": Table(column_types(name=TEXT, polygon=TEXT)),
        "labels/reviewed": Table(column_types(track=np.int64, start=np.int64, end=np.int64)),
        "labels/lines": Table(  # m on the floor, or px of the left image as recorded
            column_types(
                name=TEXT,
                **dict.fromkeys(("x1", "y1", "x2", "y2"), np.float64),
                in_picture=np.bool_,
            ),
            (_later("in_picture"),),
            is_later=True,
        ),
        "labels/regions": Table(
            column_types(name=TEXT, polygon=TEXT, in_picture=np.bool_),
            (_later("in_picture"),),
            is_later=True,
        ),
        "labels/verdicts": Table(
            column_types(kind=TEXT, tracks=TEXT, frame=np.int64, decision=TEXT), is_later=True
        ),
        # Which attributes people have, in the order they are shown. Came with 1.8.
        "labels/schema": Table(
            column_types(
                name=TEXT,
                type=TEXT,  # choice, yes-no, number, text
                choices=TEXT,  # JSON
                default=TEXT,  # shown where nothing is said; "": none
                required=np.bool_,
                least=np.float64,  # of a number; NaN: any
                most=np.float64,
                step=np.float64,
            ),
            is_later=True,
        ),
        "edits": Table(
            column_types(
                id=np.int64,
                time=TEXT,  # UTC, ISO 8601
                author=TEXT,
                kind=TEXT,
                text=TEXT,  # English
                frame=np.int64,
                before=TEXT,  # JSON, see tracking.editing.log.text
                after=TEXT,
                undone=np.bool_,
                abandoned=np.bool_,  # undone and not to be redone
                undoes=np.int64,  # the older edit that this one takes back alone; 0: none
                scope=TEXT,  # the frames it was made for, "834:900" or "834:"; "": none
                message=TEXT,  # JSON, see tracking.message_data.kept_values; came with 1.6
            ),
            (_later("undoes"), _later("scope"), _later("message")),
        ),
        "edits/touched": Table(TOUCHED_COLUMNS, is_later=True),
        # Where there are any. Came with 1.6.
        "detections_input": Table(
            column_types(
                run=np.int64,
                camera=TEXT,
                file=TEXT,
                format=TEXT,
                fingerprint=TEXT,
                count=np.int64,
                network=TEXT,
                decoder=TEXT,
                licence=TEXT,
            ),
            (_later("network", "decoder", "licence"),),
            is_later=True,
        ),
    }
)
"""Every table, by group; those of a run are in `RUN_TABLES`."""

RUN_TABLES: Mapping[str, Table] = MappingProxyType(
    {
        "tracks": Table(TRACK_COLUMNS),
        "detections": Table(DETECTION_COLUMNS),
        "associations": Table(ASSOCIATION_COLUMNS),
        "parts": Table(  # the first ones came with 1.2, the evidence with 1.7
            PART_COLUMNS, (_later("entropy", "particles", "occluded"), _later(*PART_EVIDENCE))
        ),
        "signals": Table(SIGNAL_COLUMNS, is_later=True),
        "particles": Table(PARTICLE_COLUMNS, by_frame=True),
        "part_particles": Table(PART_PARTICLE_COLUMNS, is_later=True, by_frame=True),  # 1.2
        # 1.3; the column came with 1.4
        "tracklets": Table(TRACKLET_COLUMNS, (_later("foot_v"),), is_later=True, by_frame=True),
        "network_boxes": Table(NETWORK_BOX_COLUMNS, is_later=True, by_frame=True),  # 1.7
    }
)
"""Tables of a run by their names, which are those of `Run`, in the order they are written."""


def table_at(path: str) -> Table:
    """The table at an HDF5 path such as `/labels/parts` or `/runs/0/tracks`."""
    of_run = re.fullmatch(r"/runs/\d+/(\w+)", path)
    if of_run:
        return RUN_TABLES[of_run[1]]
    return SAMPLES if path == "/samples" else TABLES[path.lstrip("/")]
