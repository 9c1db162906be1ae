"""Where on the floor, or in the picture, a map's things stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.pages import Axes, Axis
from tracking.scoring.errors import ErrorTable
from tracking.scoring.report.subject import Subject
from tracking.scoring.table import ScoringTable
from tracking.translation import msg

_WIDTH, _TALLEST = 620.0, 560.0
_FAR_OUT = 2.0
"""Per cent on either side."""
_LEAST_SPAN = 2.0


@dataclass(frozen=True, slots=True, eq=False)
class GroundPlan:
    """A map's two axes, which have the same scale.

    Attributes:
        axes: of the drawing. on_floor: in metres on the floor; else pixels of the picture.
        view: (k, 2) outline of what the camera sees of the floor; empty where unknown.
    """

    axes: Axes
    on_floor: bool
    view: Floats

    def places(self, points: Floats, *, beyond: bool = False) -> Floats:
        """Where (n, 2) points are drawn; with beyond those outside of the map stand outside."""
        x = self.axes.x.places(points[:, 0], beyond=beyond)
        return np.column_stack((x, self.axes.y.places(points[:, 1], beyond=beyond)))

    def of(self, rows: ScoringTable | ErrorTable) -> Floats:
        """(n, 2) where rows stand: on the floor, or the middle of a box's lower edge."""
        return rows.position if self.on_floor else feet(rows.box)

    def beyond(self, rows: ErrorTable) -> int:
        """How many rows stand outside of the map, and are drawn on its edge."""
        points = self.of(rows)
        (left, right), (low, high) = self.axes.x.span, self.axes.y.span
        inside = (points >= [left, low]) & (points <= [right, high])
        return int((known(points) & ~inside.all(axis=1)).sum())

    @property
    def unit_length(self) -> float:
        """How long a metre or pixel is drawn."""
        low, high = self.axes.x.span
        return self.axes.x.length / (high - low)


def ground_plan(subject: Subject) -> GroundPlan | None:
    """The map of a sequence; None where neither metres nor pixels are known of its truth."""
    if known(subject.truth.position).any():
        return _floor(subject)
    if known(subject.truth.box).any():
        tables = (subject.truth, *subject.results.values())
        return _picture(subject, np.concatenate([feet(table.box) for table in tables]))
    return None


def feet(box: Floats) -> Floats:
    """(n, 2) the middle of boxes' lower edges."""
    return np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))


def known(points: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """(n,) rows without NaN."""
    return np.asarray(np.isfinite(points).all(axis=1))


def _floor(subject: Subject) -> GroundPlan:
    points = subject.truth.position[known(subject.truth.position)]
    low, high = points.min(axis=0), points.max(axis=0)
    margin = np.maximum(high - low, _LEAST_SPAN) / 2
    least, most = low - margin, high + margin
    for table in subject.results.values():
        found = table.position[known(table.position)]
        if len(found):  # but for a few that a result puts far out
            low = np.minimum(low, np.percentile(found, _FAR_OUT, axis=0)).clip(least, most)
            high = np.maximum(high, np.percentile(found, 100 - _FAR_OUT, axis=0)).clip(least, most)
    view = np.zeros((0, 2))
    if subject.footage.view is not None:
        low, high = np.minimum(low, 0.0), np.maximum(high, 0.0)
        view = subject.footage.view.field_of_view(float(np.abs([low, high]).max()) * 1.5)
    middle, span = (low + high) / 2, np.maximum(high - low, _LEAST_SPAN) * 1.1
    low, high = middle - span / 2, middle + span / 2
    titles = (msg("x on the floor, m"), msg("y on the floor, m"))
    return GroundPlan(_even(low, high, titles, upward=True), True, view)


def _picture(subject: Subject, points: Floats) -> GroundPlan:
    if subject.footage.size_px is not None:
        low, high = np.zeros(2), np.array(subject.footage.size_px, float)
    else:
        low, high = np.zeros(2), np.maximum(points[known(points)].max(axis=0), 1.0)
    titles = (msg("x in the image, px"), msg("y in the image, px"))
    return GroundPlan(_even(low, high, titles, upward=False), False, np.zeros((0, 2)))


def _even(low: Floats, high: Floats, titles: tuple[str, str], *, upward: bool) -> Axes:
    """Axes on which a metre or pixel is as long across as up."""
    across, up = (high - low).tolist()
    scale = min(_WIDTH / across, _TALLEST / up)
    x = Axis((float(low[0]), float(high[0])), scale * across)
    y = Axis((float(low[1]), float(high[1])), scale * up, upward=upward)
    return Axes(x, y, titles)
