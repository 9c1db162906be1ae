"""The log of edits as a file for spreadsheets and programs."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from tracking.editing import Entry
from tracking.formats.replacing import replacing

_FIELDS = ("edit", "time", "author", "kind", "text", "frame", "tracks", "undone", "undoes")


def write_log(entries: Iterable[Entry], path: Path) -> None:
    """Write the log, oldest first: as JSON where the name ends so, else as CSV with a heading.

    Each edit says its number, time (UTC, ISO 8601), author, kind, line, frame, the tracks it
    touches, whether it is undone, and which older edit it undoes alone (0: none).

    Raises:
        OutputError: it cannot be written; what stood there before stays.
    """
    rows = [_row(entry) for entry in entries]
    with replacing(path) as stream:
        if path.suffix.lower() == ".json":
            json.dump(rows, stream, indent=1, ensure_ascii=False)
            stream.write("\n")
            return
        writer = csv.DictWriter(stream, _FIELDS, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            tracks = " ".join(str(track) for track in row["tracks"])
            text = _no_formula(row["text"]), _no_formula(row["author"])
            writer.writerow({**row, "tracks": tracks, "text": text[0], "author": text[1]})


def _row(entry: Entry) -> dict[str, Any]:
    return {
        "edit": entry.id,
        "time": entry.time,
        "author": entry.author,
        "kind": entry.kind,
        "text": entry.text,
        "frame": entry.frame,
        "tracks": list(entry.change.tracks),
        "undone": entry.undone,
        "undoes": entry.undoes,
    }


def _no_formula(text: str) -> str:
    """Text that no spreadsheet takes for a formula."""
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text
