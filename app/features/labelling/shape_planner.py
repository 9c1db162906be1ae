"""Planning what is drawn: occluders, counting lines and regions, all in one way."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from app.core.scenes.labels import Tool
from tracking.editing import Change, plan_lines, plan_occluders, plan_regions
from tracking.tracks import CountingLine, Labels, Occluder, Region

Corners = Sequence[tuple[float, float]]
_Points = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class _Kind:
    """How one kind of thing is drawn.

    Attributes:
        word: begins its first name. of: all there are.
        drawn: one of a name and its corners. reshaped: the same with other corners.
        plan: sets all of them.
    """

    word: str
    of: Callable[[Labels], tuple[Any, ...]]
    drawn: Callable[[str, _Points], Any]
    reshaped: Callable[[Any, _Points], Any]
    plan: Callable[[Labels, Sequence[Any], int], Change]


_KINDS = {
    Tool.OCCLUDERS: _Kind(
        "occluder",
        lambda labels: labels.occluders,
        Occluder,
        lambda item, points: replace(item, polygon=points),
        plan_occluders,
    ),
    Tool.LINES: _Kind(
        "line",
        lambda labels: labels.lines,
        lambda name, points: CountingLine(name, points[0], points[-1]),
        lambda item, points: replace(item, start=points[0], end=points[-1]),
        plan_lines,
    ),
    Tool.REGIONS: _Kind(
        "region",
        lambda labels: labels.regions,
        Region,
        lambda item, points: replace(item, polygon=points),
        plan_regions,
    ),
}


def shapes_of_tool(tool: Tool | None, labels: Labels) -> tuple[Any, ...]:
    """What was drawn with a tool; nothing of the others."""
    return _KINDS[tool].of(labels) if tool in _KINDS else ()


def corners_of(item: Occluder | CountingLine | Region) -> _Points:
    """The corners of something drawn, or the ends of a line."""
    return (item.start, item.end) if isinstance(item, CountingLine) else item.polygon


def places_of_shapes(tool: Tool, labels: Labels, *, in_picture: bool) -> dict[int, _Points]:
    """By number, the corners of what was drawn with a tool in the picture, or on the floor."""
    return {
        number: corners_of(item)
        for number, item in enumerate(shapes_of_tool(tool, labels))
        if (tool is Tool.OCCLUDERS or item.in_picture) is in_picture
    }


def plan_drawn(
    tool: Tool, labels: Labels, corners: Corners, frame: int, *, in_picture: bool = False
) -> Change:
    """Add what was drawn, under a name nothing else of its kind bears.

    in_picture: a line or a region lies in the left picture, not on the floor.
    """
    kind = _KINDS[tool]
    there = kind.of(labels)
    name = _free_name(kind.word, [item.name for item in there])
    new = kind.drawn(name, _points(corners))
    if tool is not Tool.OCCLUDERS:
        new = replace(new, in_picture=in_picture)
    return kind.plan(labels, (*there, new), frame)


def plan_reshaped(tool: Tool, labels: Labels, number: int, corners: Corners, frame: int) -> Change:
    """Give something drawn other corners."""
    items = list(_KINDS[tool].of(labels))
    items[number] = _KINDS[tool].reshaped(items[number], _points(corners))
    return _KINDS[tool].plan(labels, items, frame)


def plan_renamed(tool: Tool, labels: Labels, number: int, name: str, frame: int) -> Change:
    """Give something drawn another name."""
    items = list(_KINDS[tool].of(labels))
    items[number] = replace(items[number], name=name)
    return _KINDS[tool].plan(labels, items, frame)


def plan_taken_away(tool: Tool, labels: Labels, number: int, frame: int) -> Change:
    """Take something drawn away."""
    items = _KINDS[tool].of(labels)
    return _KINDS[tool].plan(labels, items[:number] + items[number + 1 :], frame)


def _points(corners: Corners) -> _Points:
    return tuple((float(one), float(other)) for one, other in corners)


def _free_name(word: str, taken: Sequence[str]) -> str:
    number = 1
    while f"{word} {number}" in taken:
        number += 1
    return f"{word} {number}"
