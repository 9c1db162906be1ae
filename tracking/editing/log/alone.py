"""Planner of undoing one old edit alone, while later ones stay."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from tracking.editing.core.change import Change
from tracking.editing.log.edit_footprint import differing_fields
from tracking.editing.log.history import History
from tracking.errors import EditError
from tracking.tracks import Labels, TrackLabel

UNDO = "undo"
"""The kind of a change that takes one old edit back."""
_LONGEST_TEXT = 200


def plan_undo_alone(history: History, labels: Labels, number: int) -> Change:
    """Take one edit of the log back, and leave in force what was done after it.

    The tables and labels are then what they would be had all edits in force been made but that
    one. Raises EditError that names the later edit which stands on it (see
    `History.why_not_alone`).
    """
    why = history.why_not_alone(number)
    if why:
        raise EditError(why)
    entry = history.entry(number)
    old = entry.change.inverse
    before, after = _as_labelled_now(old.before.labels.tracks, old.after.labels.tracks, labels)
    text = f"Undo edit {number} alone: {entry.text}"
    if len(text) > _LONGEST_TEXT:
        text = f"{text[: _LONGEST_TEXT - 1]}…"
    return Change(
        UNDO,
        text,
        entry.frame,
        replace(old.before, labels=replace(old.before.labels, tracks=before)),
        replace(old.after, labels=replace(old.after.labels, tracks=after)),
        entry.scope,
    )


def _as_labelled_now(
    before: Mapping[int, TrackLabel], after: Mapping[int, TrackLabel], labels: Labels
) -> tuple[dict[int, TrackLabel], dict[int, TrackLabel]]:
    """Both sides with the fields the change does not touch as they are now."""
    now = {track: labels.of_track(track) for track in before}
    return now, {track: _with_fields(now[track], before[track], after[track]) for track in now}


def _with_fields(now: TrackLabel, before: TrackLabel, after: TrackLabel) -> TrackLabel:
    """The label of now with those fields of after in which it differs from before."""
    fields = set(differing_fields(before, after))
    attributes = {
        key: value for key, value in now.attributes.items() if f"attribute {key}" not in fields
    }
    said = {key: value for key, value in after.attributes.items() if f"attribute {key}" in fields}
    return TrackLabel(
        after.name if "name" in fields else now.name,
        dict(sorted({**attributes, **said}.items())),
        after.notes if "notes" in fields else now.notes,
    )
