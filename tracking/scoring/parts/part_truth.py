"""The truth of body parts beside a recording, as it is scored."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from tracking.arrays import Floats
from tracking.errors import FormatError
from tracking.scoring.parts.rows import PartTruth, Whole, by_person
from tracking.tracks import row_keys
from tracking.tracks.boxes import corners_of_boxes
from tracking.truth import TRUE_PARTS, VISIBILITY, read_true_parts, read_visibility


def read_part_truth(folder: Path, frames: int, size_px: tuple[int, int]) -> PartTruth:
    """The truth beside a recording of so many frames.

    Who is not in visibility.csv is not seen; without that file everybody is seen as a whole.

    Raises:
        FormatError: truth_parts.csv is missing, one of the two is no such table, has somebody
            twice or names a frame that the recording does not have; names the line where there
            is one.
    """
    place = folder / TRUE_PARTS
    true = read_true_parts(place)
    if len(true.frame) and int(true.frame[-1]) >= frames:
        raise FormatError(
            "{place}: frame {frame}; the recording has 0 to {frames}; use the ground truth of "
            "this recording",
            place=place,
            frame=true.frame[-1],
            frames=frames - 1,
        )
    corners = corners_of_boxes(true.box)
    frame, person, parts = by_person(true.frame, true.person, true.part, corners)
    seen = _seen(folder / VISIBILITY, frame, person)
    return PartTruth(frame, person, parts, seen, size_px)


def _seen(path: Path, frame: Whole, person: Whole) -> Floats:
    """(n,) share of each person that is seen in each frame."""
    if not path.exists():
        return np.ones(len(frame))
    true = read_visibility(path)
    known = np.append(row_keys(true.frame, true.person), -1)
    share = np.append(true.share, 0.0)
    asked = row_keys(frame, person)
    at = np.searchsorted(known[:-1], asked)
    return np.where(known[at] == asked, share[at], 0.0)
