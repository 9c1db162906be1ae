"""The columns of the tables of a run, with their types: one definition for memory and file."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

Columns = Mapping[str, NDArray[Any]]
"""One 1-D array per column, all of equal length."""
Types = Mapping[str, np.dtype[Any]]
"""Of columns, by name, in order."""


def column_types(**types: type | np.dtype[Any]) -> Types:
    """The types of a table's columns."""
    return MappingProxyType({name: np.dtype(kind) for name, kind in types.items()})


TRACK_COLUMNS = column_types(
    frame=np.int32,  # from 0
    track=np.int32,  # positive, stable, never renumbered
    left=np.float64,  # px of the left image as recorded, 0-based
    top=np.float64,
    width=np.float64,
    height=np.float64,
    x=np.float64,  # m on the floor
    y=np.float64,
    vx=np.float64,  # m/s on the floor
    vy=np.float64,
    confidence=np.float32,  # 0 to 1
    visibility=np.float32,  # 0 to 1
    predicted=np.bool_,  # True: no detection matched in this frame
)

CORRECTED_COLUMNS = column_types(**TRACK_COLUMNS, source=np.uint8)
"""A run's columns and where a row comes from: see `Source`."""

DETECTION_COLUMNS = column_types(
    frame=np.int32,
    left=np.float64,
    top=np.float64,
    width=np.float64,
    height=np.float64,
    x=np.float64,
    y=np.float64,
    z=np.float64,
    track=np.int32,  # the track it was matched with; 0: none
)

PARTICLE_COLUMNS = column_types(
    track=np.int32,
    x=np.float32,  # m on the floor
    y=np.float32,
    weight=np.float32,  # sums to 1 over a person's particles
)

PART_COLUMNS = column_types(
    frame=np.int32,
    track=np.int32,
    part=np.uint8,  # 0 head, 1 torso, 2 hip-leg
    cx=np.float64,  # px of the left image as recorded
    cy=np.float64,
    width=np.float64,
    height=np.float64,
    vx=np.float64,  # px a frame
    vy=np.float64,
    failed=np.bool_,  # the failure detector's verdict, before any adjustment
    score=np.float64,  # of the detector, above 0: failed; NaN: not judged
    entropy=np.float32,  # of the weights, 1: all alike; NaN: not filtered
    particles=np.int32,  # how many this frame; 0: not filtered
    occluded=np.bool_,  # motion only, the colours learnt are frozen
    # What speaks for the part being there; NaN: not measured. Lengths in heights of the person.
    support=np.float32,  # share of the rectangle on foreground that may be the person's
    above=np.float32,  # the same of a strip above the rectangle
    below=np.float32,
    beside=np.float32,  # the mean of two strips to either side
    likeness=np.float32,  # to the part's colours as learnt over its life, 0 to 1
    change=np.float32,  # of the likeness to its colours of late, against the usual one
    offset=np.float32,  # from where the person's other parts take it
    spread=np.float32,  # standard deviation of the particles' middles
)

PART_EVIDENCE = ("support", "above", "below", "beside", "likeness", "change", "offset", "spread")
"""The columns of evidence in `PART_COLUMNS`."""

PART_PARTICLE_COLUMNS = column_types(
    track=np.int32,
    part=np.uint8,
    u=np.float32,  # px of the left image as recorded: a rectangle's centre
    v=np.float32,
    weight=np.float32,  # sums to 1 over a part's particles that are kept
)

TRACKLET_COLUMNS = column_types(
    track=np.int32,  # 0: of nobody who is followed
    u0=np.float32,  # px of the left image as recorded: in this frame
    v0=np.float32,
    u1=np.float32,  # a step before
    v1=np.float32,
    u2=np.float32,  # two steps before
    v2=np.float32,
    foot_v=np.float32,  # where the foreground below it ends; NaN: not known
)
"""Points followed in the picture, with their last positions."""

NETWORK_BOX_COLUMNS = column_types(
    camera=np.uint8,  # 0 left, 1 right
    left=np.float32,  # px of that camera's image as recorded, 0-based
    top=np.float32,
    width=np.float32,
    height=np.float32,
    score=np.float32,  # 0 to 1
)
"""People that a network found in the images of one instant."""

EMBEDDING_PART = 16
"""Numbers of an embedding in a row of its table: columns are of one number each."""
EMBEDDING_COLUMNS = column_types(
    frame=np.int32,
    track=np.int32,
    part=np.uint16,  # 0: the first `EMBEDDING_PART` numbers, and so on
    **dict.fromkeys((f"v{n}" for n in range(EMBEDDING_PART)), np.float16),
)
"""What an appearance network says of tracks now and then, for linking; no session holds it."""

ASSOCIATION_COLUMNS = column_types(
    frame=np.int32,
    track=np.int32,
    distance=np.float64,  # costs per cue; NaN where the cue was not used
    colour=np.float64,
    direction=np.float64,
    total=np.float64,
    margin=np.float64,  # total cost of the next best choice less this one's
)

SIGNAL_COLUMNS = column_types(
    frame=np.int32,
    track=np.int32,
    height_m=np.float32,  # of the detection matched alone; NaN: none
    upper_l=np.float32,  # CIELAB of the upper body: mean lightness, 0 to 100
    upper_a=np.float32,  # green to red
    upper_b=np.float32,  # blue to yellow
    lower_l=np.float32,  # the same of the lower body
    lower_a=np.float32,
    lower_b=np.float32,
    spread_m=np.float32,  # of the particles, along their longest direction
    split=np.float32,  # how clearly the particles are two clusters: 0 to 1
)
"""What a run noticed of each of its tracks' rows; differences in it tell people apart."""

CLOTHES = ("upper_l", "upper_a", "upper_b", "lower_l", "lower_a", "lower_b")
"""The signals that are colours."""


class Source:
    """Values of the corrected table's `source` column."""

    TRACKER = 0
    PERSON = 1
    INTERPOLATED = 2


def empty(columns: Types) -> dict[str, NDArray[Any]]:
    """No rows of the given columns."""
    return {name: np.zeros(0, dtype) for name, dtype in columns.items()}


def typed(values: Columns, columns: Types) -> dict[str, NDArray[Any]]:
    """The values in the columns' order and types."""
    return {name: np.ascontiguousarray(values[name], dtype) for name, dtype in columns.items()}


def merged_rows(*tables: Columns) -> tuple[dict[str, NDArray[Any]], NDArray[np.intp]]:
    """The rows of tables with the columns of the first, sorted by frame, then track.

    Returns them, and for each the row it was, counted through one table after the other.
    """
    whole = {name: np.concatenate([table[name] for table in tables]) for name in tables[0]}
    order = np.lexsort((whole["track"], whole["frame"]))
    return {name: column[order] for name, column in whole.items()}, order


SIDES = ("left", "top", "width", "height")
"""The columns of a box, px."""
Rows = slice | NDArray[np.bool_] | NDArray[np.intp]


def box_columns(box: NDArray[np.float64]) -> Columns:
    """`left, top, width, height` of boxes (n, 4)."""
    return dict(zip(SIDES, box.T, strict=True))


def boxes_of(columns: Columns, rows: Rows = slice(None)) -> NDArray[Any]:
    """(n, 4) left, top, width, height px of rows of a table."""
    return np.stack([columns[name][rows] for name in SIDES], axis=1)


def places_of(columns: Columns, rows: Rows = slice(None)) -> NDArray[Any]:
    """(n, 2) m on the floor of rows of a table."""
    return np.stack((columns["x"][rows], columns["y"][rows]), axis=1)
