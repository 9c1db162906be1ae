"""Tracks as KITTI's labels; see `kitti` for what they look like."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tracking.atomic_output import replacing_bytes
from tracking.formats.kitti_values import (
    PERSON,
    TYPES,
    UNKNOWN_ANGLE,
    UNKNOWN_OCCLUSION,
    UNKNOWN_PLACE,
    UNKNOWN_SIDE,
    occlusion_of,
    type_of_label,
)
from tracking.formats.number_text import (
    Block,
    chosen,
    constant,
    lines_of,
    numbers,
    short_decimals,
    whole_numbers,
)
from tracking.formats.row_rules import BOX
from tracking.formats.track_writer import Exported
from tracking.progress import Progress
from tracking.tracks import Columns

if TYPE_CHECKING:
    from tracking.geometry import View

_TYPES = [name.encode() for name in TYPES]


def export_kitti(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write tracks as KITTI's labels; results end in their score, ground truth does not.

    `truncated` is always 0: how much of a person lies outside the picture is not known, and scorers
    leave out rows where it is above 0. They leave out rows where `occluded` is 3, too: it is 3 for
    rows that do not count, and 0 where the visibility is not known.

    Places are written where camera and floor are known. How large people are and where they face is
    not. Gives the file made; raises OutputError and what `report` raises.
    """
    kinds = {
        track: TYPES.index(kind)
        for track, label in exported.labels.items()
        if (kind := type_of_label(label)) != PERSON
    }
    with replacing_bytes(path) as stream:
        for piece in exported.pieces(report):
            blocks = _blocks(piece, exported, kinds)
            if not exported.is_ground_truth(path):
                score = short_decimals(exported.confidence(piece))
                blocks.append(numbers(score, b"%d" % UNKNOWN_SIDE))
            stream.write(lines_of(blocks, b" "))
    return (path,)


def _blocks(rows: Columns, exported: Exported, kinds: dict[int, int]) -> list[Block]:
    count = len(rows["frame"])
    kind = np.zeros(count, np.int64)
    for track, number in kinds.items():
        kind[rows["track"] == track] = number
    box = np.column_stack([rows[name] for name in BOX])
    box[:, 2:] += box[:, :2]
    unknown_size = [constant(b"%d" % UNKNOWN_SIDE, count)] * 3
    angle = constant(b"%d" % UNKNOWN_ANGLE, count)
    occluded = np.where(exported.counted(rows), occlusion_of(rows["visibility"]), UNKNOWN_OCCLUSION)
    return [
        whole_numbers(rows["frame"]),
        whole_numbers(rows["track"]),
        chosen(_TYPES, kind),
        constant(b"0", count),
        whole_numbers(occluded),
        angle,
        *(numbers(side, b"%d" % UNKNOWN_SIDE) for side in box.T),
        *unknown_size,
        *(numbers(axis, b"%d" % UNKNOWN_PLACE) for axis in _in_camera(rows, exported.view)),
        angle,
    ]


def _in_camera(rows: Columns, view: View | None) -> NDArray[np.float64]:
    """(3, n) where people stand, along the camera's axes in metres; NaN where unknown."""
    count = len(rows["frame"])
    if view is None:
        return np.full((3, count), np.nan)
    rotation, centre = view.world_from_camera
    world = np.column_stack([rows["x"], rows["y"], np.zeros(count)])
    return np.asarray(((world - centre) @ rotation).T)
