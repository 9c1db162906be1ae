"""Planners of edits that change what is said of a track. They only look; nothing changes here."""

from __future__ import annotations

from dataclasses import replace

from tracking.editing.core.change import Change, LabelState, State
from tracking.errors import EditError
from tracking.tracks import (
    LONGEST_KEY,
    LONGEST_NAME,
    LONGEST_VALUE,
    Labels,
    TrackLabel,
    TrackTable,
    check_known,
)
from tracking.translation import Message, msg

LONGEST_NOTES = 20_000
"""Characters a person may write; what a file says is read whatever its length."""


def plan_rename(
    table: TrackTable, labels: Labels, track: int, name: str, frame: int | None = None
) -> Change:
    """Name a track; "" takes the name away. frame: where to look at it, else its first."""
    name = " ".join(writable(name).split())
    _check_length(name, LONGEST_NAME, msg("track {track}: a name", track=track))
    label = replace(labels.of_track(track), name=name)
    text = (
        msg('Name {track} "{name}"', track=track, name=name)
        if name
        else msg("Delete the name of {track}", track=track)
    )
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
    key = writable(key).strip()
    if not key:
        raise EditError("track {track}: an attribute needs a name", track=track)
    _check_length(key, LONGEST_KEY, msg("track {track}: an attribute's name", track=track))
    _check_length(
        value or "", LONGEST_VALUE, msg("track {track}: an attribute's value", track=track)
    )
    attributes = dict(labels.of_track(track).attributes)
    attributes.pop(key, None)
    if value is not None:
        attributes[key] = writable(value)
    label = replace(labels.of_track(track), attributes=dict(sorted(attributes.items())))
    said, line = " ".join(key.split()), " ".join((value or "").split())
    text = (
        msg("Delete {key} of {track}", key=said, track=track)
        if value is None
        else msg("Set {key} of {track} to {value}", key=said, track=track, value=line or '""')
    )
    return _relabel(table, labels, track, label, ("attribute", text), frame)


def plan_set_notes(
    table: TrackTable, labels: Labels, track: int, notes: str, frame: int | None = None
) -> Change:
    """Write a track's notes anew."""
    _check_length(notes, LONGEST_NOTES, msg("track {track}: notes", track=track))
    label = replace(labels.of_track(track), notes=writable(notes))
    return _relabel(
        table, labels, track, label, ("notes", msg("Write notes on {track}", track=track)), frame
    )


def writable(text: str) -> str:
    """The text, refused where a file could not hold it."""
    try:
        text.encode()
    except UnicodeEncodeError:
        raise EditError("{text!r} holds half a character; type it anew", text=text) from None
    if "\0" in text:
        raise EditError("{text!r} holds a zero character; leave it out", text=text)
    return text


def _check_length(text: str, longest: int, what: str) -> None:
    if len(text) > longest:
        raise EditError(
            "{what} of {count} characters; write at most {longest}",
            what=what,
            count=len(text),
            longest=longest,
        )


def _relabel(
    table: TrackTable,
    labels: Labels,
    track: int,
    label: TrackLabel,
    kind_and_text: tuple[str, Message],
    frame: int | None,
) -> Change:
    check_known(table, track)
    old = labels.of_track(track)
    if label == old:
        raise EditError(
            "track {track}: nothing to change, its label says that already", track=track
        )
    kind, text = kind_and_text
    where = table.frame_range(track)[0] if frame is None else frame
    before = State(labels=LabelState({track: old}))
    return Change(kind, text, where, before, State(labels=LabelState({track: label})))
