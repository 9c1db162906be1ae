"""What a bag holds; of large ones it is kept in the user's cache, to open them again at once."""

from __future__ import annotations

import hashlib
import io
import json
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray
from platformdirs import user_cache_path

from tracking.atomic_output import replace_with
from tracking.errors import OutputError

_FORMAT = 1
_LEAST_MESSAGES = 5_000
"""Bags of fewer are read anew as fast."""
_MOST_KEPT, _MOST_BYTES = 64, 1 << 30
_SIDES = ("left", "right", "depth")


@dataclass(frozen=True, slots=True, eq=False)
class BagContents:
    """What a bag holds, of its left camera, its right one, and depth, in this order.

    Attributes:
        topics: "" where there is none. sizes: width and height px; None where there is none.
        stamps_ns: (n,) each, not decreasing. tables: (3, n) each: the stamps, and where the
            program finds each message.
        in_metres: depth is in metres, and needs no scale.
        recorded_times: times are those of recording, not the cameras' own.
        calibrations: camera_info in YAML: of both cameras, of the left one, or of none.
    """

    topics: tuple[str, ...]
    sizes: tuple[tuple[int, int] | None, ...]
    stamps_ns: tuple[NDArray[np.int64], ...]
    in_metres: bool
    recorded_times: bool
    calibrations: tuple[str, ...]
    tables: tuple[NDArray[np.int64], ...]


def contents_of(head: Mapping[str, Any], tables: Sequence[NDArray[np.int64]]) -> BagContents:
    """The contents that a head tells; ValueError, KeyError or TypeError where it is none."""
    topics = tuple(str(topic) for topic in head["topics"])
    sizes = tuple((int(one[0]), int(one[1])) if one else None for one in head["sizes"])
    if not len(topics) == len(sizes) == len(tables) == len(_SIDES):
        raise ValueError("not three topics")
    if any(table.ndim != 2 or table.shape[0] != 3 for table in tables):
        raise ValueError("no tables of messages")
    return BagContents(
        topics,
        sizes,
        tuple(table[0] for table in tables),
        head["in_metres"] is True,
        head["recorded_times"] is True,
        tuple(str(text) for text in head["calibrations"]),
        tuple(tables),
    )


def known_contents(path: Path, topics: Sequence[str]) -> BagContents | None:
    """What is kept of a bag that was opened before, and has not changed since; None: nothing."""
    try:
        place = _place(path, topics)
        if not place.is_file() or place.stat().st_size > _MOST_BYTES:
            return None
        with place.open("rb") as file, np.load(file, allow_pickle=False) as kept:
            head = json.loads(bytes(kept["head"]).decode())
            tables = [np.asarray(kept[side], np.int64) for side in _SIDES]
        return contents_of(head, tables)
    except (OSError, ValueError, KeyError, TypeError, EOFError, BadZipFile, zlib.error):
        return None


def keep_contents(path: Path, topics: Sequence[str], contents: BagContents) -> None:
    """Keep what a large bag holds; where that fails, it is read anew the next time."""
    if sum(table.shape[1] for table in contents.tables) < _LEAST_MESSAGES:
        return
    head = {
        "topics": contents.topics,
        "sizes": contents.sizes,
        "in_metres": contents.in_metres,
        "recorded_times": contents.recorded_times,
        "calibrations": contents.calibrations,
    }
    held = io.BytesIO()
    told = np.frombuffer(json.dumps(head).encode(), np.uint8)
    tables = dict(zip(_SIDES, contents.tables, strict=True))
    np.savez(held, head=told, **tables)  # type: ignore[arg-type]
    try:
        place = _place(path, topics)
        place.parent.mkdir(parents=True, exist_ok=True)
        replace_with(place, held.getvalue())
        kept = sorted(place.parent.glob("*.npz"), key=lambda one: one.stat().st_mtime)
        for old in kept[:-_MOST_KEPT]:
            old.unlink(missing_ok=True)
    except (OSError, OutputError):
        return


def _place(path: Path, topics: Sequence[str]) -> Path:
    """Where a bag's contents are kept: another name where its files or the topics differ."""
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    stats = [(file.name, file.stat().st_size, file.stat().st_mtime_ns) for file in files]
    key = json.dumps([_FORMAT, str(path.resolve()), stats, list(topics)])
    name = hashlib.sha256(key.encode()).hexdigest()[:32]
    return user_cache_path("trackwright", appauthor=False) / "bags" / f"{name}.npz"
