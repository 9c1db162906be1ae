"""Labels are checked where they come in: from a person, from the log and from a session file.

Every check raises EditError in one line that says what is wrong and where.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import EditError
from tracking.tracks.body_parts import PARTS
from tracking.tracks.labels import (
    DECISIONS,
    CountingLine,
    Occluder,
    Point,
    Region,
    ReviewedRange,
    Verdict,
)
from tracking.tracks.limits import LONGEST_NAME
from tracking.tracks.part_labels import PART_SOURCES, PartLabel
from tracking.tracks.validation import LARGEST_NUMBER
from tracking.translation import joined, msg

MOST_CORNERS = 500
_FARTHEST = 1e9
"""Pixels or metres; nothing anybody draws lies farther out."""


def check_part_label(label: PartLabel) -> None:
    """Refuse a rectangle without area, an unknown part, a frame or track that cannot be."""
    _check_place(label.frame, label.track, first_track=1)
    what = msg("part label of track {track} in frame {frame}", track=label.track, frame=label.frame)
    if not 0 <= label.part < PARTS:
        raise EditError(
            "{what}: part {part} is none; 0 head, 1 torso, 2 hip-leg", what=what, part=label.part
        )
    left, top, width, height = label.box
    if not _is_near(left, top, width, height):
        raise EditError(
            "{what}: box {box} is no place; numbers within a billion are needed",
            what=what,
            box=label.box,
        )
    if not (width > 0 and height > 0):
        raise EditError(
            "{what}: box {box} is none; a positive width and height are needed",
            what=what,
            box=label.box,
        )
    if label.source not in PART_SOURCES:
        raise EditError(
            "{what}: source {source!r}; it is {sources}",
            what=what,
            source=label.source,
            sources=joined(", ", PART_SOURCES),
        )
    for field, text in (("author", label.author), ("reason", label.reason)):
        if len(text) > LONGEST_NAME or not text.isprintable():
            raise EditError(
                "{what}: its {field} is no line of text of at most {most} characters",
                what=what,
                field=field,
                most=LONGEST_NAME,
            )


def check_verdict(verdict: Verdict) -> None:
    """Refuse an unknown decision, and a review item that can be none."""
    check_name(verdict.kind, msg("the kind of a review item"))
    for track in verdict.tracks:
        _check_place(verdict.frame, track, first_track=1)
    _check_place(verdict.frame, 0, first_track=0)
    if verdict.decision not in DECISIONS:
        raise EditError(
            "decision {decision!r}; it is one of {decisions}",
            decision=verdict.decision,
            decisions=joined(", ", DECISIONS),
        )


def check_occluder(occluder: Occluder) -> None:
    """Refuse what is no polygon. Edges may cross: it is drawn in a picture, not measured."""
    _check_polygon(occluder.polygon, msg("occluder {name!r}", name=occluder.name))


def check_line(line: CountingLine) -> None:
    """Refuse a line without length or with an end that is no place."""
    what = msg("counting line {name!r}", name=line.name)
    check_name(line.name, msg("a counting line"))
    _check_corners((line.start, line.end), what)
    if line.start == line.end:
        raise EditError("{what} has no length; draw it from one place to another", what=what)


def check_region(region: Region) -> None:
    """Refuse what is no polygon, and one whose edges cross: what lies in it could not be said."""
    what = msg("region {name!r}", name=region.name)
    check_name(region.name, "a region")
    _check_polygon(region.polygon, what)
    if _edges_cross(np.asarray(region.polygon, float)):
        raise EditError(
            "{what}: its edges cross or touch; draw it without crossing them", what=what
        )


def check_reviewed(seen: ReviewedRange) -> None:
    """Refuse an empty range and a track that cannot be."""
    if not 0 <= seen.start < seen.end <= LARGEST_NUMBER:
        raise EditError(
            "frames {start} to {end}: the range is empty or begins before frame 0",
            start=seen.start,
            end=seen.end,
        )
    _check_place(seen.start, seen.track, first_track=0)


def check_name(name: str, what: str) -> None:
    """Refuse no name, and one nobody could read or a file could not hold."""
    if not name.strip():
        raise EditError("{what} needs a name; type one", what=what)
    if len(name) > LONGEST_NAME:
        raise EditError(
            "{what}: a name of {count} characters; at most {most}",
            what=what,
            count=len(name),
            most=LONGEST_NAME,
        )


def _check_place(frame: int, track: int, first_track: int) -> None:
    if not first_track <= track <= LARGEST_NUMBER:
        raise EditError(
            "track {track} in a label: ids are {first_track} to {largest}",
            track=track,
            first_track=first_track,
            largest=LARGEST_NUMBER,
        )
    if not 0 <= frame <= LARGEST_NUMBER:
        raise EditError(
            "frame {frame} in a label: frames are 0 to {largest}",
            frame=frame,
            largest=LARGEST_NUMBER,
        )


def _check_polygon(polygon: Sequence[Point], what: str) -> None:
    if len(polygon) < 3:
        raise EditError("{what}: a polygon of three or more corners is needed", what=what)
    if len(polygon) > MOST_CORNERS:
        raise EditError(
            "{what} has {count} corners; draw it with at most {most}",
            what=what,
            count=len(polygon),
            most=MOST_CORNERS,
        )
    _check_corners(polygon, what)


def _check_corners(corners: Sequence[Point], what: str) -> None:
    for corner in corners:
        if len(corner) != 2 or not _is_near(*corner):
            raise EditError(
                "{what}: corner {corner} is no place; two finite numbers are needed",
                what=what,
                corner=corner,
            )


def _is_near(*numbers: float) -> bool:
    return all(math.isfinite(number) and abs(number) <= _FARTHEST for number in numbers)


def _edges_cross(corners: NDArray[np.float64]) -> bool:
    """Whether two edges of a closed polygon (n, 2) meet elsewhere than at their common corner."""
    start, end = corners, np.roll(corners, -1, axis=0)
    along = end - start
    if bool((along == 0).all(axis=1).any()):
        return True
    # side[i, j]: on which side of edge i's line the start of edge j lies.
    to = start[None] - start[:, None]
    side = np.sign(along[:, None, 0] * to[..., 1] - along[:, None, 1] * to[..., 0])
    parted = side * np.roll(side, -1, axis=1) <= 0
    crossing = parted & parted.T & ~_flat_apart(side, start, end)
    number = np.arange(len(corners))
    apart = np.abs(number[:, None] - number[None])
    neighbours = (apart <= 1) | (apart == len(corners) - 1)
    if bool((crossing & ~neighbours).any()):
        return True
    before = np.roll(along, 1, axis=0)
    turn = before[:, 0] * along[:, 1] - before[:, 1] * along[:, 0]
    back = (before * along).sum(axis=1) < 0
    return bool(((turn == 0) & back).any())


def _flat_apart(
    side: NDArray[np.float64],
    start: NDArray[np.float64],
    end: NDArray[np.float64],
) -> NDArray[np.bool_]:
    """(n, n) whether two edges lie on one line without meeting."""
    low, high = np.minimum(start, end), np.maximum(start, end)
    beside = ((high[:, None] < low[None]) | (high[None] < low[:, None])).any(axis=-1)
    flat: NDArray[np.bool_] = (side == 0) & (np.roll(side, -1, axis=1) == 0) & beside
    return flat


LABEL_CHECKS: Mapping[str, Callable[[Any], None]] = MappingProxyType(
    {
        "occluders": check_occluder,
        "reviewed": check_reviewed,
        "lines": check_line,
        "regions": check_region,
        "verdicts": check_verdict,
        "parts": check_part_label,
    }
)
"""By the field of `Labels` that they stand in: each raises EditError for what is no label."""
