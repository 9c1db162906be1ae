"""The labels a change touches, and how one side of it takes the other's place."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Collection, Hashable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Protocol, TypeVar

from tracking.errors import EditError
from tracking.tracks import (
    CountingLine,
    Labels,
    Occluder,
    PartLabel,
    PartLabels,
    Region,
    ReviewedRange,
    Schema,
    TrackLabel,
    Verdict,
    VerdictKey,
)
from tracking.translation import Message, msg


class _Sortable(Hashable, Protocol):
    def __lt__(self, other: Any, /) -> bool: ...


_Label = TypeVar("_Label", bound=_Sortable)


@dataclass(frozen=True, slots=True)
class LabelState:
    """The labels that stand only on this side of a change; those it does not touch are on neither.

    Attributes:
        tracks: labels by track, the same tracks on both sides; an empty label says that there is
            none.
        occluders, reviewed, lines, regions, verdicts, parts: what stands only on this side. Logs
            of older programs name all occluders and reviewed ranges on both sides, which comes to
            the same.
        schema: the whole of it; None: the change does not touch it.
    """

    tracks: Mapping[int, TrackLabel] = field(default_factory=dict)
    occluders: tuple[Occluder, ...] = ()
    reviewed: tuple[ReviewedRange, ...] = ()
    lines: tuple[CountingLine, ...] = ()
    regions: tuple[Region, ...] = ()
    verdicts: tuple[Verdict, ...] = ()
    parts: tuple[PartLabel, ...] = ()
    schema: Schema | None = None


def apply_label_state(labels: Labels, before: LabelState, after: LabelState) -> Labels:
    """The labels with the one side in the other's place.

    Raises EditError where they are not as they were when the change was planned.
    """
    if before == after == LabelState():
        return labels
    return replace(
        _tracks_relabelled(labels, before.tracks, after.tracks),
        occluders=_exchanged(labels.occluders, before.occluders, after.occluders, msg("occluders")),
        reviewed=_exchanged(
            labels.reviewed, before.reviewed, after.reviewed, msg("reviewed ranges")
        ),
        lines=_exchanged(labels.lines, before.lines, after.lines, msg("counting lines")),
        regions=_exchanged(labels.regions, before.regions, after.regions, msg("regions")),
        verdicts=_verdicts_exchanged(labels.verdicts, before.verdicts, after.verdicts),
        parts=_parts_exchanged(labels.parts, before.parts, after.parts),
        schema=_schema_exchanged(labels.schema, before.schema, after.schema),
    )


def _tracks_relabelled(
    labels: Labels, before: Mapping[int, TrackLabel], after: Mapping[int, TrackLabel]
) -> Labels:
    if before.keys() != after.keys():
        raise EditError("the two sides of the edit name different tracks")
    for track, label in before.items():
        if labels.of_track(track) != label:
            raise EditError(
                "track {track}: its label is not what the edit was planned on", track=track
            )
    changed = labels
    for track, label in after.items():
        changed = changed.with_track(track, label)
    return changed


def _exchanged(
    present: tuple[_Label, ...], out: Iterable[_Label], into: Iterable[_Label], what: Message
) -> tuple[_Label, ...]:
    """Sorted, with some labels taken out and others put in."""
    leaving, coming = set(out), set(into)
    if leaving == coming:
        return present
    # The labels are sorted: each is found by halves, as there may be thousands of them.
    changed = list(present)
    for label in leaving:
        at = bisect_left(changed, label)
        if at == len(changed) or changed[at] != label:
            raise EditError("the {what} are not what the edit was planned on", what=what)
        del changed[at]
    for label in coming:
        at = bisect_left(changed, label)
        if at < len(changed) and changed[at] == label:
            raise EditError("the {what} are not what the edit was planned on", what=what)
        changed.insert(at, label)
    return tuple(changed)


def _verdicts_exchanged(
    present: Mapping[VerdictKey, Verdict], out: Collection[Verdict], into: Collection[Verdict]
) -> Mapping[VerdictKey, Verdict]:
    if not (out or into):
        return present
    changed = dict(present)
    _check_planned(changed.get, out, into, msg("verdict"))
    for verdict in out:
        del changed[verdict.key]
    changed.update((verdict.key, verdict) for verdict in into)
    return changed


def _parts_exchanged(
    present: PartLabels, out: Collection[PartLabel], into: Collection[PartLabel]
) -> PartLabels:
    if not (out or into):
        return present
    _check_planned(present.get, out, into, msg("part label"))
    return present.changed([label.key for label in out], into)


def _schema_exchanged(present: Schema, out: Schema | None, into: Schema | None) -> Schema:
    if out is None and into is None:
        return present
    if out is None or into is None or out != present:
        raise EditError("the schema of attributes is not what the edit was planned on")
    return into


def _check_planned(
    found: Callable[[Any], Any],
    out: Collection[Verdict] | Collection[PartLabel],
    into: Collection[Verdict] | Collection[PartLabel],
    what: Message,
) -> None:
    """Raise EditError unless what leaves is there and what comes finds its place empty."""
    leaving, coming = {label.key for label in out}, {label.key for label in into}
    wrong = len(leaving) != len(out) or len(coming) != len(into)
    wrong = wrong or any(found(label.key) != label for label in out)
    if wrong or any(found(key) is not None for key in coming - leaving):
        raise EditError("a {what} is not what the edit was planned on", what=what)
