"""The log of edits for reading elsewhere: CSV for tables, JSON with all that edits changed."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

from tracking.atomic_output import replacing
from tracking.cells import CsvWriter, cell_of
from tracking.editing import Change, Entry, History, LabelState, State
from tracking.errors import EditError
from tracking.progress import Progress
from tracking.session.edit_words import in_words
from tracking.tracks import PART_NAMES, PartLabel
from tracking.translation import msg

LOG_COLUMNS = (
    *("id", "time", "author", "kind", "text", "frame", "frames", "tracks"),
    *("undone", "undoes", "before", "after"),
)


def write_log_csv(history: History, path: Path, progress: Progress | None = None) -> None:
    """Write the log as CSV (UTF-8), a line an edit, oldest first; what it changed in words.

    Columns are `LOG_COLUMNS`: times are UTC, frames count from 0; `frames` is the range
    an edit was made for, "834:900" half-open, "834:" from there on. `undone` says what became of an
    edit that is not in force, `undoes` names the older edit that this one takes back alone. No
    text is a formula to a spreadsheet (see `cell_of`). The file appears whole or not at all.
    Raises OutputError where it cannot be written.
    """
    with replacing(path) as stream:
        lines = CsvWriter(stream)
        lines.writerow(LOG_COLUMNS)
        for entry in _told(history, progress):
            lines.writerow(map(cell_of, _row(history, entry)))


def write_log_json(history: History, path: Path, progress: Progress | None = None) -> None:
    """Write the log as JSON, a list of edits with all rows and labels of both sides.

    Labels are objects of named fields, ranges are half-open, NaN is null.
    The file appears whole or not at all.
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
        tracks, sides = " ".join(map(str, change.tracks)), (change.before, change.after)
        said = (tracks, in_words(*sides), in_words(*reversed(sides)))
    except EditError as why:  # a damaged line does not keep the others from being read
        said = ("", str(why), str(why))
    tracks, before, after = said
    what = (entry.id, entry.time, entry.author, entry.kind, entry.text, entry.frame)
    frames = entry.scope.as_text if entry.scope else ""
    return (*what, frames, tracks, _fate(history, entry), entry.undoes or "", before, after)


def _fate(history: History, entry: Entry) -> str:
    """What became of an edit that is not in force; "" where it is."""
    if entry.abandoned:
        return "undone for good"
    if entry.undone:
        return "undone"
    taker = history.taken_back_by(entry.id)
    return msg("undone by {taker}", taker=taker) if taker else ""


def _document(history: History, entry: Entry) -> dict[str, Any]:
    document: dict[str, Any] = {
        **{name: getattr(entry, name) for name in ("id", "time", "author", "kind", "text")},
        **{name: getattr(entry, name) for name in ("frame", "undone", "abandoned")},
        "scope": asdict(entry.scope) if entry.scope else None,
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
        "labels": _labels(state.labels),
    }


def _labels(labels: LabelState) -> dict[str, Any]:
    """Every label as an object of named fields; kinds of which there are none are left out."""
    groups = ("occluders", "reviewed", "lines", "regions", "verdicts")
    said: dict[str, Any] = {
        "tracks": {str(track): asdict(label) for track, label in labels.tracks.items()},
        **{name: [asdict(one) for one in getattr(labels, name)] for name in groups},
        "parts": [_part(label) for label in labels.parts],
    }
    return {name: group for name, group in said.items() if group}


def _part(label: PartLabel) -> dict[str, Any]:
    box = dict(zip(("left", "top", "width", "height"), label.box, strict=True))
    fields = {name: value for name, value in asdict(label).items() if name != "box"}
    return {**fields, "part": PART_NAMES[label.part], **box}


def _number(value: float) -> float | None:
    """The number; None for NaN and infinity, which JSON does not know."""
    return value if math.isfinite(value) else None
