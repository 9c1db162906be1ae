"""What stands on the lanes: where tracks begin and end, keyframes, edits, swaps, review items."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen, QPolygonF

from app.core.look.theme import Theme
from app.core.plots.axis import TimeAxis
from app.core.scenes import Lane, MarkKind, TimelineMark

_APART_PX = 4.0
_CROWDED_PX, _DOT_PX = 14.0, 2.0
_REACH = 0.24  # of a lane's height, from a mark's middle to its border
_END, _SERIF_PX = 0.74, 3.0


def draw_ends(
    painter: QPainter,
    lane: Lane,
    row: QRectF,
    axis: TimeAxis,
    tracked: tuple[int, int],
    theme: Theme,
) -> None:
    """Brackets where the track was born and where it died, not where the tracking ended."""
    if not len(lane.spans):
        return
    first, end = int(lane.spans[0, 0]), int(lane.spans[-1, 1])
    painter.setPen(QPen(theme.track(lane.colour), 1.6))
    half = _END * row.height() / 2
    for frame, inwards, there in (
        (first, _SERIF_PX, first > tracked[0]),
        (end, -_SERIF_PX, end < tracked[1]),
    ):
        x = axis.x_of(frame)
        if there and axis.left - _SERIF_PX <= x <= axis.left + axis.width + _SERIF_PX:
            top, bottom = row.center().y() - half, row.center().y() + half
            lines = [QLineF(x, top, x, bottom), QLineF(x, top, x + inwards, top)]
            painter.drawLines([*lines, QLineF(x, bottom, x + inwards, bottom)])


def draw_keyframes(
    painter: QPainter, lane: Lane, row: QRectF, axis: TimeAxis, theme: Theme
) -> None:
    """A small square at every row a person made; where they crowd, dots below the bar."""
    places = _places(lane.keyframes + 0.5, axis)
    if not places:
        return
    crowded = len(places) > 1 and (places[-1] - places[0]) / (len(places) - 1) < _CROWDED_PX
    side = _DOT_PX if crowded else max(3.0, 0.24 * row.height())
    middle = row.center().y() + (0.36 * row.height() if crowded else 0.0)
    painter.setPen(Qt.PenStyle.NoPen if crowded else QPen(theme.sunken, 1.0))
    painter.setBrush(theme.text)
    painter.drawRects([QRectF(x - side / 2, middle - side / 2, side, side) for x in places])


def shown_marks(lane: Lane) -> list[TimelineMark]:
    """The marks of a lane that are drawn: a keyframe shows by its own that it was edited."""
    made = set(lane.keyframes.tolist())
    return [mark for mark in lane.marks if mark.kind is not MarkKind.EDIT or mark.frame not in made]


def draw_marks(
    painter: QPainter,
    marks: Iterable[TimelineMark],
    row: QRectF,
    axis: TimeAxis,
    theme: Theme,
) -> None:
    """Diamonds where it was edited, crosses where it was swapped, triangles where to look."""
    frames: dict[MarkKind, list[float]] = {}
    for mark in marks:
        frames.setdefault(mark.kind, []).append(_stands_at(mark))
    reach = max(3.0, _REACH * row.height())
    for kind, draw in _DRAWN.items():
        if kind in frames:
            places = _places(np.array(frames[kind], np.float64), axis)
            draw(painter, [QPointF(x, row.center().y()) for x in places], reach, theme)


def mark_at(marks: Iterable[TimelineMark], x: float, axis: TimeAxis) -> TimelineMark | None:
    """The mark nearest to a place on the screen, within reach of the mouse."""
    near = [
        (abs(axis.left + (_stands_at(mark) - axis.start) * axis.px_per_frame - x), at, mark)
        for at, mark in enumerate(marks)
    ]
    best = min(near, default=None)
    return best[2] if best is not None and best[0] <= _APART_PX + 1 else None


def _stands_at(mark: TimelineMark) -> float:
    """In its frame's middle, as keyframes; a swap stands between two frames."""
    return mark.frame + (0.5 if mark.kind is MarkKind.EDIT else 0.0)


def _places(frames: NDArray[np.floating], axis: TimeAxis) -> list[float]:
    """Where ascending frames in view lie; of those that would cover each other the first."""
    xs = axis.left + (frames - axis.start) * axis.px_per_frame
    xs = xs[(xs >= axis.left - _APART_PX) & (xs <= axis.left + axis.width + _APART_PX)]
    _, first = np.unique(xs // _APART_PX, return_index=True)
    places: list[float] = xs[first].tolist()
    return places


def _draw_diamonds(painter: QPainter, at: list[QPointF], reach: float, theme: Theme) -> None:
    shape = QPolygonF(
        [QPointF(0, -reach), QPointF(reach, 0), QPointF(0, reach), QPointF(-reach, 0)]
    )
    painter.setPen(QPen(theme.sunken, 1.2))
    painter.setBrush(theme.text)
    for place in at:
        painter.drawPolygon(shape.translated(place))


def _draw_crosses(painter: QPainter, at: list[QPointF], reach: float, theme: Theme) -> None:
    one, other = QPointF(reach, reach), QPointF(reach, -reach)
    lines = [QLineF(place - arm, place + arm) for place in at for arm in (one, other)]
    for colour, width in ((theme.sunken, 5.0), (theme.text, 2.2)):
        painter.setPen(QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
        painter.drawLines(lines)


def _draw_triangles(painter: QPainter, at: list[QPointF], reach: float, theme: Theme) -> None:
    """They hang from the lane's upper edge."""
    top, side = -2.0 * reach, 1.1 * reach
    shape = QPolygonF([QPointF(-side, top), QPointF(side, top), QPointF(0, -0.1 * reach)])
    painter.setPen(QPen(theme.sunken, 1.2))
    painter.setBrush(theme.warning)
    for place in at:
        painter.drawPolygon(shape.translated(place))


_DRAWN: dict[MarkKind, Callable[[QPainter, list[QPointF], float, Theme], None]] = {
    MarkKind.EDIT: _draw_diamonds,
    MarkKind.SWAP: _draw_crosses,
    MarkKind.REVIEW_ITEM: _draw_triangles,
}
