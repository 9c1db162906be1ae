"""What boxes of another program's detector say of hypotheses."""

from __future__ import annotations

import numpy as np

from tracking.filtering import associate
from tracking.geometry import Ellipses, FlatView
from tracking.trackers.spheroid.hypotheses import Floats
from tracking.tracks.boxes import boxes_of_corners, corners_of_boxes, corners_through, overlaps

_ERROR = 0.07
"""Standard deviation of a box's ends, in heights of the box."""
_MOST = 9.0
"""Squared deviations beyond which a box is just not that person's."""
_SAME = 0.3
"""Intersection over union from which on a box may be somebody's."""


def box_log_weights(seen: Ellipses, own: Ellipses, boxes: Floats) -> Floats:
    """(people, N) logarithms of likelihoods of the box of each person, who has one at most.

    Args:
        seen: (people, N) silhouettes of the hypotheses. own: (people,) of the estimates.
        boxes: (n, 4) left, top, width, height flat px, each of one person.
    """
    gains = np.zeros(seen.shape)
    if not len(boxes) or not len(gains):
        return gains
    (left, right), (top, bottom) = own.columns(), own.rows()
    expected = np.nan_to_num(np.column_stack((left, top, right - left, bottom - top)))
    overlap = overlaps(expected[:, None], boxes)
    pairs = associate(1.0 - overlap, overlap >= _SAME, 1.0)
    person, box = pairs.track, boxes[pairs.detection][..., None]
    half = np.sqrt(seen.vv[person])
    off = (
        seen.u[person] - box[:, 0] - box[:, 2] / 2,
        seen.v[person] - half - box[:, 1],
        seen.v[person] + half - box[:, 1] - box[:, 3],
    )
    squared = sum((each / (_ERROR * box[:, 3])) ** 2 for each in off)
    gains[person] = -0.5 * np.fmin(squared, _MOST)
    return gains


def flat_boxes(boxes: Floats, flat: FlatView) -> Floats:
    """(n, 4) left, top, width, height flat px of boxes (n, 4) px as recorded."""
    corners = corners_of_boxes(boxes)
    return boxes_of_corners(
        corners_through(lambda sides: [flat.flat_from_recorded(side) for side in sides], corners)
    )
