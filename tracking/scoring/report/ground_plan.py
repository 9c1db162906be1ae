"""Where on the floor, or in the picture, a map's things stand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.pages import Axes, Axis
from tracking.scoring.errors import ErrorTable
from tracking.scoring.report.subject import Subject
from tracking.scoring.table import Floats, ScoringTable

_WIDTH, _TALLEST = 620.0, 560.0
_REACH_M = 30.0
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

    def places(self, points: Floats) -> Floats:
        """Where (n, 2) points are drawn."""
        return np.column_stack((self.axes.x.places(points[:, 0]), self.axes.y.places(points[:, 1])))

    def of(self, rows: ScoringTable | ErrorTable) -> Floats:
        """(n, 2) where rows stand: on the floor, or the middle of a box's lower edge."""
        return rows.position if self.on_floor else feet(rows.box)

    @property
    def unit_length(self) -> float:
        """How long a metre or pixel is drawn."""
        low, high = self.axes.x.span
        return self.axes.x.length / (high - low)


def ground_plan(subject: Subject) -> GroundPlan | None:
    """The map of a sequence; None where neither metres nor pixels are known of its truth."""
    tables = (subject.truth, *subject.results.values())
    if known(subject.truth.position).any():
        return _floor(subject, np.concatenate([table.position for table in tables]))
    if known(subject.truth.box).any():
        return _picture(subject, np.concatenate([feet(table.box) for table in tables]))
    return None


def feet(box: Floats) -> Floats:
    """(n, 2) the middle of boxes' lower edges."""
    return np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))


def known(points: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """(n,) rows without NaN."""
    return np.asarray(np.isfinite(points).all(axis=1))


def _floor(subject: Subject, points: Floats) -> GroundPlan:
    points = points[known(points)]
    # A result may put somebody far out: the map is of where nearly everybody stands.
    low, high = np.percentile(points, 0.5, axis=0), np.percentile(points, 99.5, axis=0)
    view = np.zeros((0, 2))
    if subject.footage.view is not None:
        low, high = np.minimum(low, 0.0), np.maximum(high, 0.0)
        view = subject.footage.view.field_of_view(_REACH_M)
    middle, span = (low + high) / 2, np.maximum(high - low, _LEAST_SPAN) * 1.1
    low, high = middle - span / 2, middle + span / 2
    titles = ("x on the floor, m", "y on the floor, m")
    return GroundPlan(_even(low, high, titles, upward=True), True, view)


def _picture(subject: Subject, points: Floats) -> GroundPlan:
    if subject.footage.size_px is not None:
        low, high = np.zeros(2), np.array(subject.footage.size_px, float)
    else:
        low, high = np.zeros(2), np.maximum(points[known(points)].max(axis=0), 1.0)
    titles = ("x in the picture, px", "y in the picture, px")
    return GroundPlan(_even(low, high, titles, upward=False), False, np.zeros((0, 2)))


def _even(low: Floats, high: Floats, titles: tuple[str, str], *, upward: bool) -> Axes:
    """Axes on which a metre or pixel is as long across as up."""
    across, up = (high - low).tolist()
    scale = min(_WIDTH / across, _TALLEST / up)
    x = Axis((float(low[0]), float(high[0])), scale * across)
    y = Axis((float(low[1]), float(high[1])), scale * up, upward=upward)
    return Axes(x, y, titles)
