"""Strips of people's outlines that range gives to somebody else."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.people.plan_view import SurfacePoints
from tracking.people.runs import Places, Runs
from tracking.people.silhouettes import Labels

_NARROW = 3
"""Places across that a strip has at most: so far the matching window reaches over an outline."""
_TIMES = 2
"""Whose outline it is, is at least so many times as wide there."""
_SMALL = 0.15
"""Of the largest piece of a region, that a piece apart from it has at most."""
_ALONG = 0.2
"""Share of what surrounds a piece that is somebody else's, if it belongs to them."""
_RING = np.ones((3, 3), np.uint8)


def without_seams(owner: Places, points: SurfacePoints, shape: tuple[int, int]) -> Places:
    """The owners of points, strips along somebody's outline given back to them.

    Block matching sees a little of what lies behind an outline, too, and ranges the outline in
    between: where somebody else stands there, the strip would be theirs, and they would seem to
    reach to the far side of the one before them. A strip is told by being narrow, with somebody
    wider on one side and nobody on the other, or by being cut off from whom it was given to.

    Args:
        owner: (n,) of `assign_points`. points: of the grid. shape: rows and columns of the grid.
    """
    labels = np.zeros(shape, np.uint8)
    labels.ravel()[points.pixel] = owner + 1
    runs = Runs.along(labels)
    left, right = runs.beside()
    before, behind = runs.label[left], runs.label[right]
    # A run that ends with its row is its own neighbour: nobody is there.
    before[before == runs.label], behind[behind == runs.label] = 0, 0
    strip = (runs.label > 0) & ((before == 0) != (behind == 0)) & (runs.length <= _NARROW)
    strip &= runs.length[np.where(before > 0, left, right)] >= _TIMES * runs.length
    label = np.where(strip, before | behind, runs.label)
    meeting = (label > 0) & (label[left] > 0) & (label != label[left])
    if not (strip.any() or meeting.any()):
        return owner
    met = np.concatenate((label[meeting], label[left[meeting]]))
    mended = np.repeat(label, runs.length).reshape(shape)
    _join_pieces(mended, np.unique(met))
    return mended.ravel().take(points.pixel).astype(np.intp) - 1


def _join_pieces(labels: Labels, some: Labels) -> None:
    """Give small pieces of some labels, apart from the rest, to whom they lie along."""
    # With nobody all round the picture, nothing that surrounds a piece lies outside.
    padded = np.asarray(
        cv2.copyMakeBorder(labels, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=(0.0,)), np.uint8
    )
    for label in some.tolist():
        own = (padded == label).view(np.uint8)
        left, top, width, height = cv2.boundingRect(own)
        inside = np.s_[top - 1 : top + height + 1, left - 1 : left + width + 1]
        _, pieces, stats, _ = cv2.connectedComponentsWithStats(own[inside], connectivity=8)
        area = stats[1:, cv2.CC_STAT_AREA]
        for piece in np.flatnonzero(area <= _SMALL * area.max(initial=0)) + 1:
            x, y, across, down = stats[piece, :4]
            near = np.s_[y - 1 : y + down + 1, x - 1 : x + across + 1]
            _join(padded[inside][near], pieces[near] == piece, label)
    labels[:] = padded[1:-1, 1:-1]


def _join(around: Labels, piece: NDArray[np.bool_], label: int) -> None:
    """Give a piece to whom it touches most, if it touches them along enough of its outline.

    Args:
        around: labels of the piece and of one place more to all sides. piece: where it is.
        label: its own so far.
    """
    own = piece.view(np.uint8)
    theirs = around[cv2.dilate(own, _RING) > own]
    touched = np.bincount(theirs, minlength=label + 1)
    touched[0] = touched[label] = 0
    most = touched.argmax()
    if touched[most] > _ALONG * len(theirs):
        around[piece] = most
