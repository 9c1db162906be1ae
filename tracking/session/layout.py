"""The session file's layout: names, column types, version. One definition to write and to read."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np

from tracking.editing.log.touch_index import TOUCHED_COLUMNS
from tracking.failure.features import FEATURE_NAMES
from tracking.failure.samples import SAMPLE_COLUMNS
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    CORRECTED_COLUMNS,
    DETECTION_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
)

FORMAT = "trackwright-session"
VERSION = (1, 5)
"""Major: older programs cannot read it. Minor: they can, and miss something."""

CHUNK_ROWS = 65_536

Types = Mapping[str, np.dtype[Any]]


def _types(**columns: type) -> Types:
    return MappingProxyType({name: np.dtype(kind) for name, kind in columns.items()})


TEXT = np.dtype(object)
"""Stands for a column of text: UTF-8 of any length."""

EDIT_COLUMNS: Types = MappingProxyType(
    {
        "id": np.dtype(np.int64),
        "time": TEXT,  # UTC, ISO 8601
        "author": TEXT,
        "kind": TEXT,
        "text": TEXT,
        "frame": np.dtype(np.int64),
        "before": TEXT,  # JSON, see tracking.editing.log.text
        "after": TEXT,
        "undone": np.dtype(np.bool_),
        "abandoned": np.dtype(np.bool_),  # undone and not to be redone
        "undoes": np.dtype(np.int64),  # the older edit that this one takes back alone; 0: none
        "scope": TEXT,  # the frames it was made for, "834:900" or "834:"; "": none
    }
)
TRACK_LABEL_COLUMNS: Types = MappingProxyType(
    {"track": np.dtype(np.int64), "name": TEXT, "attributes": TEXT, "notes": TEXT}
)
PART_LABEL_COLUMNS: Types = MappingProxyType(
    {
        "frame": np.dtype(np.int32),
        "track": np.dtype(np.int32),
        "part": np.dtype(np.uint8),  # 0 head, 1 torso, 2 hip-leg
        "on_part": np.dtype(np.bool_),  # False also where a person is unsure
        "sure": np.dtype(np.bool_),
        "left": np.dtype(np.float64),  # px of the left image as recorded, 0-based
        "top": np.dtype(np.float64),
        "width": np.dtype(np.float64),
        "height": np.dtype(np.float64),
        "source": np.dtype(np.uint8),  # of the rectangle: 0 tracker, 1 person, 2 truth
        "author": TEXT,
        "reason": TEXT,  # why it was suggested; "": it was not
    }
)
SAMPLE_TABLE: Types = MappingProxyType(
    {**SAMPLE_COLUMNS, **dict.fromkeys(FEATURE_NAMES, np.dtype(np.float64))}
)
"""What the part labels teach the failure detector, made anew at every save. Without samples the
group is empty; files before format 1.2 never have any."""
LINE_COLUMNS: Types = MappingProxyType(
    {
        "name": TEXT,
        **{name: np.dtype(np.float64) for name in ("x1", "y1", "x2", "y2")},
        "in_picture": np.dtype(np.bool_),
    }
)
"""m on the floor, or px of the left image as recorded."""
REGION_COLUMNS: Types = MappingProxyType(
    {"name": TEXT, "polygon": TEXT, "in_picture": np.dtype(np.bool_)}
)
VERDICT_COLUMNS: Types = MappingProxyType(
    {"kind": TEXT, "tracks": TEXT, "frame": np.dtype(np.int64), "decision": TEXT}
)
COLOUR_COLUMNS: Types = _types(track=np.int64, place=np.uint8)
"""The colour each track is shown in: its place in the window's palette."""
OCCLUDER_COLUMNS: Types = MappingProxyType({"name": TEXT, "polygon": TEXT})
REVIEWED_COLUMNS: Types = _types(track=np.int64, start=np.int64, end=np.int64)
SOURCE_COLUMNS: Types = MappingProxyType(
    {"source": TEXT, "size_bytes": np.dtype(np.int64), "sha256": TEXT}
)
TRAJECTORY_TYPE = np.dtype(
    [("id", np.int32), ("frame", np.int32), ("x", np.float64), ("y", np.float64), ("z", np.float64)]
)

TABLES: Mapping[str, Types] = MappingProxyType(
    {
        "recording/sources": SOURCE_COLUMNS,
        "tracks": CORRECTED_COLUMNS,
        "colours": COLOUR_COLUMNS,
        "labels": TRACK_LABEL_COLUMNS,
        "labels/parts": PART_LABEL_COLUMNS,
        "labels/occluders": OCCLUDER_COLUMNS,
        "labels/reviewed": REVIEWED_COLUMNS,
        "labels/lines": LINE_COLUMNS,
        "labels/regions": REGION_COLUMNS,
        "labels/verdicts": VERDICT_COLUMNS,
        "edits": EDIT_COLUMNS,
        "edits/touched": TOUCHED_COLUMNS,
    }
)
"""Columns of every table, by group; those of a run are in `RUN_TABLES`."""

RUN_TABLES: Mapping[str, Types] = MappingProxyType(
    {
        "tracks": TRACK_COLUMNS,
        "detections": DETECTION_COLUMNS,
        "particles": PARTICLE_COLUMNS,
        "associations": ASSOCIATION_COLUMNS,
        "parts": PART_COLUMNS,
        "signals": SIGNAL_COLUMNS,
        "part_particles": PART_PARTICLE_COLUMNS,
        "tracklets": TRACKLET_COLUMNS,
    }
)

LATER_TABLES = frozenset(
    {"labels/lines", "labels/regions", "labels/verdicts", "edits/touched", "colours"}
)
"""Tables that sessions of format 1.0 do not have; the last one came with 1.5."""

LATER_COLUMNS: Mapping[str, tuple[frozenset[str], ...]] = MappingProxyType(
    {
        "edits": (frozenset({"undoes"}), frozenset({"scope"})),
        "labels/parts": (
            frozenset({"sure", "left", "top", "width", "height", "source"}),
            frozenset({"author", "reason"}),
        ),
        "labels/lines": (frozenset({"in_picture"}),),
        "labels/regions": (frozenset({"in_picture"}),),
    }
)
"""Columns that tables of format 1.0 do not have: those that came together, all or none."""

LATER_RUN_TABLES = frozenset({"signals", "part_particles", "tracklets"})
"""Tables of a run that sessions of format 1.0 do not have; the last ones came with 1.2 and 1.3."""

LATER_RUN_COLUMNS: Mapping[str, tuple[frozenset[str], ...]] = MappingProxyType(
    {
        "parts": (frozenset({"entropy", "particles", "occluded"}),),
        "tracklets": (frozenset({"foot_v"}),),
    }
)
"""The same of a run's tables; these came with formats 1.2 and 1.4."""

PARTICLE_TABLES = ("particles", "part_particles", "tracklets")
"""Tables of a run that stay in the file, with the column `start`: an offset a frame."""
