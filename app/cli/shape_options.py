"""Lines and regions as they are typed: NAME:x1,y1:x2,y2 and NAME:x,y:x,y:x,y..."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

import typer

from tracking.errors import EditError
from tracking.recording.region_of_interest import Outline, checked_outlines
from tracking.tracks import CountingLine, Region, check_line, check_region
from tracking.translation import count_msg, msg, tr

_Drawn = TypeVar("_Drawn", CountingLine, Region)
_Corners = tuple[tuple[float, float], ...]


def line_of(text: str, *, in_picture: bool) -> CountingLine:
    """A line of what was typed. Raises BadParameter where it is none."""
    option = "--picture-line" if in_picture else "--line"
    name, corners = _parted(text, option)
    if len(corners) != 2:
        ends = count_msg(len(corners), "{n} end", "{n} ends")
        raise _misuse(
            msg("{text!r} has {ends}; type NAME:x1,y1:x2,y2", text=text, ends=ends), option
        )
    line = CountingLine(name, corners[0], corners[1], in_picture)
    return _checked(line, check_line, option)


def region_of(text: str, *, in_picture: bool) -> Region:
    """A region of what was typed. Raises BadParameter where it is none."""
    option = "--picture-region" if in_picture else "--region"
    name, corners = _parted(text, option)
    return _checked(Region(name, corners, in_picture), check_region, option)


def outlines_from(texts: Sequence[str], option: str) -> tuple[Outline, ...]:
    """Outlines x,y:x,y:x,y of what was typed. Raises BadParameter where one is none."""
    found = []
    for text in texts:
        corners = [_corner(part) for part in text.split(":")]
        known = tuple(corner for corner in corners if corner is not None)
        if len(known) < len(corners):
            raise _misuse(
                msg("{text!r} is no outline; type x,y:x,y:x,y in pixels", text=text), option
            )
        found.append(known)
    outlines = checked_outlines(found)
    if isinstance(outlines, tuple):
        return outlines
    raise _misuse(tr(outlines), option)


def refuse_repeated(drawn: Sequence[CountingLine] | Sequence[Region], what: str) -> None:
    """Raises BadParameter where a name stands twice: results are told by name.

    Args:
        what: "line" or "region", by which the options are called.
    """
    names: set[str] = set()
    for item in drawn:
        if item.name in names:
            option = f"--picture-{what}" if item.in_picture else f"--{what}"
            raise _misuse(
                msg("{name!r} is named twice; give each a name of its own", name=item.name), option
            )
        names.add(item.name)


def _parted(text: str, option: str) -> tuple[str, _Corners]:
    """The name, which may hold colons, and the corners behind it."""
    name, *parts = text.split(":")
    corners: list[tuple[float, float]] = []
    for part in reversed(parts):
        corner = _corner(part)
        if corner is None:
            break
        corners.insert(0, corner)
    name = ":".join([name, *parts[: len(parts) - len(corners)]])
    if not corners:
        raise _misuse(
            msg("{text!r} has no corners; type NAME:x,y:x,y with numbers", text=text), option
        )
    if "," in name and len(corners) < len(parts):
        raise _misuse(
            msg("{text!r}: {corner!r} is no corner x,y", text=text, corner=name.rpartition(":")[2]),
            option,
        )
    return name.strip(), tuple(corners)


def _corner(part: str) -> tuple[float, float] | None:
    numbers = part.split(",")
    try:
        x, y = map(float, numbers)
    except ValueError:
        return None
    return x, y


def _checked(item: _Drawn, check: Callable[[_Drawn], None], option: str) -> _Drawn:
    try:
        check(item)
    except EditError as error:
        raise _misuse(tr(error.message), option) from error
    return item


def _misuse(message: str, option: str) -> typer.BadParameter:
    return typer.BadParameter(message, param_hint=option)
