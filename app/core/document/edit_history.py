"""Track card, history and transport line in words."""

from __future__ import annotations

from datetime import datetime

import numpy as np

from app.core.i18n import date_text, tr
from app.core.scenes import Colour, HistoryItem, MarkKind, TimelineMark, TrackCard
from app.core.tracks.track_reader import TrackReader
from tracking.editing import Change, Entry, History
from tracking.tracks import Source, TrackLabel


def track_card(
    tracks: TrackReader,
    track: int,
    label: TrackLabel,
    colour: Colour,
    others: tuple[int, ...] = (),
) -> TrackCard | None:
    """The card of a track, with who is selected beside it; None where it has no rows."""
    rows = tracks.of_track(track)
    if not len(rows["frame"]):
        return None
    predicted = rows["predicted"].astype(np.bool_)
    occluded = (rows["visibility"] == 0.0) & ~predicted
    interpolated = rows.get("source", np.zeros(len(predicted))) == Source.INTERPOLATED
    interpolated &= ~(predicted | occluded)
    unseen = predicted | occluded | interpolated
    confidence = rows["confidence"][np.isfinite(rows["confidence"])]
    return TrackCard(
        track=track,
        name=label.name,
        colour=colour,
        first_frame=int(rows["frame"][0]),
        last_frame=int(rows["frame"][-1]),
        frames_seen=int(np.count_nonzero(~unseen)),
        frames_predicted=int(np.count_nonzero(predicted)),
        mean_confidence=float(confidence.mean()) if len(confidence) else float("nan"),
        attributes=tuple(label.attributes.items()),
        notes=label.notes,
        others=others,
        frames_interpolated=int(np.count_nonzero(interpolated)),
        frames_occluded=int(np.count_nonzero(occluded)),
    )


class HistoryList:
    """The log as the panel shows it; as a log may be long, only what changed is made anew."""

    def __init__(self) -> None:
        self._state: tuple[int, int, int] | None = None
        self._items: dict[int, HistoryItem] = {}
        self._shown: tuple[HistoryItem, ...] = ()

    def of(self, history: History) -> tuple[HistoryItem, ...]:
        """All edits, oldest first; those that cannot be redone any more are left out."""
        undo, redo = history.next_undo, history.next_redo
        state = (len(history), undo.id if undo else 0, redo.id if redo else 0)
        if state != self._state:
            self._state = state
            self._shown = tuple(
                self._item(entry, history.taken_back_by(entry.id))
                for entry in history
                if not entry.abandoned
            )
        return self._shown

    def _item(self, entry: Entry, taken_by: int) -> HistoryItem:
        item = self._items.get(entry.id)
        if item is None or (item.undone, item.taken_by) != (entry.undone, taken_by):
            item = HistoryItem(
                edit=entry.id,
                text=tr(entry.text),
                when=local_time(entry.time),
                author=entry.author,
                frame=entry.frame,
                undone=entry.undone,
                kind=entry.kind,
                taken_by=taken_by,
            )
            self._items[entry.id] = item
        return item


class EditMarks:
    """Where each track was edited; only what changed in a log that may be long is made anew."""

    def __init__(self) -> None:
        self._in_force: dict[int, bool] = {}
        self._marks_of_edit: dict[int, tuple[TimelineMark, ...]] = {}
        self._marks: dict[int, dict[int, TimelineMark]] = {}  # by track, then edit

    def of(self, history: History) -> dict[int, tuple[TimelineMark, ...]]:
        """For each track the marks of the edits in force that touched it, by frame."""
        there = {entry.id for entry in history.in_force}
        for entry in history:
            in_force = entry.id in there
            if self._in_force.get(entry.id, False) != in_force:
                self._in_force[entry.id] = in_force
                self._put(entry, in_force)
        return {
            track: tuple(sorted(marks.values(), key=lambda mark: mark.frame))
            for track, marks in self._marks.items()
            if marks
        }

    def _put(self, entry: Entry, in_force: bool) -> None:
        """Put the marks of an entry in, or take them out; its change is read once."""
        if entry.id not in self._marks_of_edit:
            kind = MarkKind.SWAP if entry.kind == "swap" else MarkKind.EDIT
            change = entry.change
            first, said = _first_frames(change), tr(entry.text)
            self._marks_of_edit[entry.id] = tuple(
                TimelineMark(kind, max(entry.frame, first.get(track, 0)), track, said)
                for track in change.tracks
            )
        for mark in self._marks_of_edit[entry.id]:
            if in_force:
                self._marks.setdefault(mark.track, {})[entry.id] = mark
            else:
                self._marks[mark.track].pop(entry.id)


def _first_frames(change: Change) -> dict[int, int]:
    """Where an edit first touches each track: one of many tracks may begin later than the edit."""
    touched: list[tuple[int, int]] = []
    for side in (change.before, change.after):
        touched += [(track, start) for track, start, _ in side.stretches.tolist()]
        tracks, at = np.unique(side.rows["track"], return_index=True)
        touched += zip(tracks.tolist(), side.rows["frame"][at].tolist(), strict=True)
        touched += [(label.track, label.frame) for label in side.labels.parts]
        touched += [(seen.track, seen.start) for seen in side.labels.reviewed]
    first: dict[int, int] = {}
    for track, frame in touched:
        first[track] = min(frame, first.get(track, frame))
    return first


def local_time(time: str) -> str:
    """An ISO time as the user's clock shows it: today only the hour, else the day too."""
    try:
        moment = datetime.fromisoformat(time).astimezone()
    except ValueError:
        return time
    today = datetime.now().astimezone().date()
    if moment.date() == today:
        return moment.strftime("%H:%M:%S")
    return f"{date_text(moment)} {moment:%H:%M}"
