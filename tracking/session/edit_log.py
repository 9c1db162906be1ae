"""The log of edits for reading elsewhere: CSV for tables, JSON with all that edits changed."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from tracking.editing import Change, Entry, History, State
from tracking.editing.log.label_text import labels_as_json
from tracking.errors import EditError
from tracking.formats.replacing import replacing

LOG_COLUMNS = (
    *("id", "time", "author", "kind", "text", "frame", "tracks"),
    *("undone", "undoes", "before", "after"),
)
Progress = Callable[[int, int], None]
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "\n")
_MOST_NAMED = 4


def write_log_csv(history: History, path: Path, progress: Progress | None = None) -> None:
    """Write the log as CSV (UTF-8), a line an edit, oldest first; what it changed in words.

    Columns are `LOG_COLUMNS`: times are UTC, frames count from 0; `undone` says what became of an
    edit that is not in force, `undoes` names the older edit that this one takes back alone. Text
    that a spreadsheet would take for a formula (it begins with = + - @ or a blank of another kind)
    stands behind an apostrophe. The file appears whole or not at all.
    Raises OutputError where it cannot be written.
    """
    with replacing(path) as stream:
        lines = csv.writer(stream, lineterminator="\n")
        lines.writerow(LOG_COLUMNS)
        for entry in _told(history, progress):
            lines.writerow([_cell(value) for value in _row(history, entry)])


def write_log_json(history: History, path: Path, progress: Progress | None = None) -> None:
    """Write the log as JSON, a list of edits with all rows and labels of both sides.

    NaN is null. The file appears whole or not at all.
    Raises OutputError where it cannot be written.
    """
    with replacing(path) as stream:
        stream.writelines(log_as_json(history, progress))


def log_as_json(history: History, progress: Progress | None = None) -> Iterator[str]:
    """The text of the JSON document, piece by piece, an edit at a time."""
    before = "["
    for entry in _told(history, progress):
        yield f"{before}\n{json.dumps(_document(history, entry), allow_nan=False)}"
        before = ","
    yield "[]\n" if before == "[" else "\n]\n"


def _told(history: History, progress: Progress | None) -> Iterator[Entry]:
    for done, entry in enumerate(history, 1):
        yield entry
        if progress is not None:
            progress(done, len(history))


def _row(history: History, entry: Entry) -> Iterable[object]:
    try:
        change = entry.change
        said = (" ".join(map(str, change.tracks)), _words(change.before), _words(change.after))
    except EditError as why:  # a damaged line does not keep the others from being read
        said = ("", str(why), str(why))
    tracks, before, after = said
    what = (entry.id, entry.time, entry.author, entry.kind, entry.text, entry.frame, tracks)
    return (*what, _fate(history, entry), entry.undoes or "", before, after)


def _cell(value: object) -> object:
    """The value as it is written; never a formula."""
    if isinstance(value, str) and value.startswith(_FORMULA):
        return f"'{value}"
    return value


def _fate(history: History, entry: Entry) -> str:
    """What became of an edit that is not in force; "" where it is."""
    if entry.abandoned:
        return "undone for good"
    if entry.undone:
        return "undone"
    taker = history.taken_back_by(entry.id)
    return f"taken back by {taker}" if taker else ""


def _words(state: State) -> str:
    """One side of an edit in a line."""
    stretches = [
        f"{track} in frames {start} to {end - 1}" for track, start, end in state.stretches.tolist()
    ]
    labels = state.labels
    said = [
        f"{track} {label.name!r} {dict(label.attributes)} {label.notes!r}"
        for track, label in labels.tracks.items()
    ]
    counted = (
        *((len(state.rows["frame"]), "rows"), (len(labels.parts), "part labels")),
        *((len(labels.reviewed), "reviewed ranges"), (len(labels.verdicts), "verdicts")),
        *((len(labels.occluders), "occluders"), (len(labels.lines), "counting lines")),
        (len(labels.regions), "regions"),
    )
    numbers = [f"{count} {what}" for count, what in counted if count]
    return "; ".join([*_few(stretches), *_few(said), *numbers])


def _few(words: list[str]) -> list[str]:
    if len(words) <= _MOST_NAMED:
        return words
    return [*words[:_MOST_NAMED], f"{len(words) - _MOST_NAMED} more"]


def _document(history: History, entry: Entry) -> dict[str, Any]:
    document: dict[str, Any] = {
        **{name: getattr(entry, name) for name in ("id", "time", "author", "kind", "text")},
        **{name: getattr(entry, name) for name in ("frame", "undone", "abandoned")},
        "undoes": entry.undoes or None,
        "taken_back_by": history.taken_back_by(entry.id) or None,
    }
    try:
        return {**document, **_sides(entry.change)}
    except EditError as why:
        return {**document, "problem": str(why)}


def _sides(change: Change) -> dict[str, Any]:
    return {
        "tracks": list(change.tracks),
        "before": _side(change.before),
        "after": _side(change.after),
    }


def _side(state: State) -> dict[str, Any]:
    rows = state.rows if len(state.rows["frame"]) else {}
    return {
        "stretches": [
            {"track": track, "start": start, "end": end}
            for track, start, end in state.stretches.tolist()
        ],
        "rows": {name: [_number(value) for value in rows[name].tolist()] for name in rows},
        "labels": labels_as_json(state.labels),
    }


def _number(value: float) -> float | None:
    """The number; None for NaN and infinity, which JSON does not know."""
    return value if math.isfinite(value) else None
