"""Planners of what is drawn into the picture and on the floor: occluders, lines, regions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Literal, TypeVar

from tracking.editing.core.change import Change, LabelState, State
from tracking.editing.labels.track_labels import writable
from tracking.errors import EditError
from tracking.tracks import (
    CountingLine,
    Labels,
    Occluder,
    Region,
    check_line,
    check_name,
    check_occluder,
    check_region,
)
from tracking.translation import Message, msg

_Drawn = TypeVar("_Drawn", Occluder, CountingLine, Region)
_CALLED = {
    "occluders": (msg("occluder"), msg("occluders")),
    "lines": (msg("counting line"), msg("counting lines")),
    "regions": (msg("region"), msg("regions")),
}
"""What one is called, and several."""


def plan_occluders(labels: Labels, occluders: Sequence[Occluder], frame: int = 0) -> Change:
    """Set all occluders of the picture. frame: where to look at it.

    Raises EditError for a polygon with less than three corners or a corner that is no number, a
    missing name, and a name given twice.
    """
    return _plan(labels, "occluders", occluders, check_occluder, frame)


def plan_lines(labels: Labels, lines: Sequence[CountingLine], frame: int = 0) -> Change:
    """Set all counting lines. frame: where to look at it.

    Raises EditError for a line without length or name, an end that is no number, a name given
    twice.
    """
    return _plan(labels, "lines", lines, check_line, frame)


def plan_regions(labels: Labels, regions: Sequence[Region], frame: int = 0) -> Change:
    """Set all regions. frame: where to look at it.

    Raises EditError for a polygon with less than three corners, a corner that is no number or
    edges that cross, a missing name, and a name given twice.
    """
    return _plan(labels, "regions", regions, check_region, frame)


def _plan(
    labels: Labels,
    kind: Literal["occluders", "lines", "regions"],
    wanted: Sequence[_Drawn],
    check: Callable[[_Drawn], None],
    frame: int,
) -> Change:
    """Set all labels of a kind, which is a field of `Labels` and of `LabelState`."""
    what, several = _CALLED[kind]
    out, into = _exchange(getattr(labels, kind), wanted, check, what, several)
    sides: list[dict[str, Any]] = [{kind: out}, {kind: into}]
    before, after = (State(labels=LabelState(**side)) for side in sides)
    return Change(kind, _text(out, into, what, several), frame, before, after)


def _exchange(
    present: Sequence[_Drawn],
    wanted: Sequence[_Drawn],
    check: Callable[[_Drawn], None],
    what: Message,
    several: Message,
) -> tuple[tuple[_Drawn, ...], tuple[_Drawn, ...]]:
    """What leaves and what comes, sorted; EditError where it is nonsense or nothing."""
    new = [replace(item, name=" ".join(writable(item.name).split())) for item in wanted]
    names = [item.name for item in new]
    for item in new:
        check(item)
        check_name(item.name, msg("the {what}", what=what))
        if names.count(item.name) > 1:
            raise EditError(
                "two {several} are called {name!r}; give each a name of its own",
                several=several,
                name=item.name,
            )
    out = tuple(sorted(set(present) - set(new)))
    into = tuple(sorted(set(new) - set(present)))
    if not (out or into):
        raise EditError("the {several} are what they were; nothing to change", several=several)
    return out, into


def _text(
    out: Sequence[_Drawn], into: Sequence[_Drawn], what: Message, several: Message
) -> Message:
    """What is done in words: one thing by its name, several by their number."""
    if len(into) == 1 and not out:
        return msg('Draw {what} "{name}"', what=what, name=into[0].name)
    if len(out) == 1 and not into:
        return msg('Delete {what} "{name}"', what=what, name=out[0].name)
    if len(out) == len(into) == 1:
        if out[0].name == into[0].name:
            return msg('Change {what} "{name}"', what=what, name=into[0].name)
        return msg(
            'Put {what} "{name}" in place of "{out_name}"',
            what=what,
            name=into[0].name,
            out_name=out[0].name,
        )
    return msg(
        "Change {several}: {count} drawn, {count_out} deleted",
        several=several,
        count=len(into),
        count_out=len(out),
    )
