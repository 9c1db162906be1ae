"""Planners of edits that change labels. They only look; nothing changes here."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tracking.editing.change import Change, LabelState, State
from tracking.errors import EditError
from tracking.tracks import (
    Labels,
    Occluder,
    ReviewedRange,
    TrackLabel,
    TrackTable,
    check_known,
)


def plan_rename(
    table: TrackTable, labels: Labels, track: int, name: str, frame: int | None = None
) -> Change:
    """Name a track; "" takes the name away. frame: where to look at it, else its first."""
    name = " ".join(_writable(name).split())
    label = replace(labels.of_track(track), name=name)
    text = f'Name {track} "{name}"' if name else f"Take the name of {track} away"
    return _relabel(table, labels, track, label, ("rename", text), frame)


def plan_set_attribute(
    table: TrackTable,
    labels: Labels,
    track: int,
    key: str,
    value: str | None,
    frame: int | None = None,
) -> Change:
    """Set one of a track's own fields; None takes it away."""
    key = _writable(key).strip()
    if not key:
        raise EditError(f"track {track}: an attribute needs a name")
    attributes = dict(labels.of_track(track).attributes)
    attributes.pop(key, None)
    if value is not None:
        attributes[key] = _writable(value)
    label = replace(labels.of_track(track), attributes=dict(sorted(attributes.items())))
    text = f"Take {key} of {track} away" if value is None else f"Set {key} of {track} to {value}"
    return _relabel(table, labels, track, label, ("attribute", text), frame)


def plan_set_notes(
    table: TrackTable, labels: Labels, track: int, notes: str, frame: int | None = None
) -> Change:
    """Write a track's notes anew."""
    label = replace(labels.of_track(track), notes=_writable(notes))
    return _relabel(table, labels, track, label, ("notes", f"Write notes on {track}"), frame)


def plan_occluders(labels: Labels, occluders: Sequence[Occluder], frame: int = 0) -> Change:
    """Set all occluders of the picture.

    Raises EditError for a polygon with less than three corners or a corner that is no number.
    """
    for occluder in occluders:
        corners = np.asarray(occluder.polygon, float)
        _writable(occluder.name)
        if corners.ndim != 2 or len(corners) < 3 or not np.isfinite(corners).all():
            raise EditError(f"occluder {occluder.name!r}: a polygon of three or more is needed")
    new = tuple(occluders)
    if new == labels.occluders:
        raise EditError("the occluders are what they were; nothing to change")
    return Change(
        "occluders",
        f"Set {len(new)} occluders",
        frame,
        State(labels=LabelState(occluders=labels.occluders)),
        State(labels=LabelState(occluders=new)),
    )


def plan_mark_reviewed(labels: Labels, track: int, start: int, end: int) -> Change:
    """Say that a track (0: all) was looked at in frames start to end and is right."""
    if not 0 <= start < end:
        raise EditError(f"frames {start} to {end}: the range is empty or begins before frame 0")
    new = _joined([*labels.reviewed, ReviewedRange(track, start, end)])
    if new == labels.reviewed:
        raise EditError(f"frames {start} to {end - 1} are marked as reviewed already")
    who = f"track {track}" if track else "all tracks"
    return Change(
        "reviewed",
        f"Mark {who} as reviewed in frames {start} to {end - 1}",
        start,
        State(labels=LabelState(reviewed=labels.reviewed)),
        State(labels=LabelState(reviewed=new)),
    )


def _writable(text: str) -> str:
    """The text, refused where a file could not hold it."""
    try:
        text.encode()
    except UnicodeEncodeError:
        raise EditError(f"{text!r} holds half a character; type it anew") from None
    if "\0" in text:
        raise EditError(f"{text!r} holds a zero character; leave it out")
    return text


def _joined(ranges: Sequence[ReviewedRange]) -> tuple[ReviewedRange, ...]:
    """Sorted, with ranges of one track that touch made one."""
    joined: list[ReviewedRange] = []
    for seen in sorted(ranges):
        last = joined[-1] if joined else None
        if last is not None and last.track == seen.track and seen.start <= last.end:
            joined[-1] = replace(last, end=max(last.end, seen.end))
        else:
            joined.append(seen)
    return tuple(joined)


def _relabel(
    table: TrackTable,
    labels: Labels,
    track: int,
    label: TrackLabel,
    kind_and_text: tuple[str, str],
    frame: int | None,
) -> Change:
    check_known(table, track)
    old = labels.of_track(track)
    if label == old:
        raise EditError(f"track {track}: nothing to change, its label says that already")
    kind, text = kind_and_text
    where = table.frame_range(track)[0] if frame is None else frame
    before = State(labels=LabelState({track: old}))
    return Change(kind, text, where, before, State(labels=LabelState({track: label})))
