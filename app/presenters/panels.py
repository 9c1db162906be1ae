"""Track card, history and transport line in words."""

from __future__ import annotations

from datetime import datetime

import numpy as np

from app.presenters.palette import colour_of_track
from app.presenters.scenes import HistoryItem, TrackCard
from app.presenters.shown import ShownTracks
from tracking.editing import Entry, History
from tracking.tracks import TrackLabel


def track_card(tracks: ShownTracks, track: int, label: TrackLabel) -> TrackCard | None:
    """The card of a track; None where it has no rows."""
    rows = tracks.of_track(track)
    if not len(rows["frame"]):
        return None
    predicted = int(np.count_nonzero(rows["predicted"]))
    confidence = rows["confidence"][np.isfinite(rows["confidence"])]
    return TrackCard(
        track=track,
        name=label.name,
        colour=colour_of_track(track),
        first_frame=int(rows["frame"][0]),
        last_frame=int(rows["frame"][-1]),
        frames_seen=len(rows["frame"]) - predicted,
        frames_predicted=predicted,
        mean_confidence=float(confidence.mean()) if len(confidence) else float("nan"),
        attributes=tuple(label.attributes.items()),
        notes=label.notes,
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
            self._shown = tuple(self._item(entry) for entry in history if not entry.abandoned)
        return self._shown

    def _item(self, entry: Entry) -> HistoryItem:
        item = self._items.get(entry.id)
        if item is None or item.undone != entry.undone:
            when = _local(entry.time)
            item = HistoryItem(entry.id, entry.text, when, entry.author, entry.frame, entry.undone)
            self._items[entry.id] = item
        return item


class EditMarks:
    """Where each track was edited; an entry's change is read once, as a log may be long."""

    def __init__(self) -> None:
        self._tracks_of_edit: dict[int, tuple[int, ...]] = {}

    def of(self, history: History) -> dict[int, tuple[int, ...]]:
        """For each track the frames where an edit in force touched it."""
        marks: dict[int, set[int]] = {}
        for entry in history:
            if entry.undone:
                continue
            if entry.id not in self._tracks_of_edit:
                self._tracks_of_edit[entry.id] = entry.change.tracks
            for track in self._tracks_of_edit[entry.id]:
                marks.setdefault(track, set()).add(entry.frame)
        return {track: tuple(sorted(frames)) for track, frames in marks.items()}


def _local(time: str) -> str:
    """An ISO time as the user's clock shows it: today only the hour, else the day too."""
    try:
        moment = datetime.fromisoformat(time).astimezone()
    except ValueError:
        return time
    today = datetime.now().astimezone().date()
    return moment.strftime("%H:%M:%S" if moment.date() == today else "%Y-%m-%d %H:%M")
